#!/usr/bin/env python3
"""The independent search in a cell of any robot of joints in a row: for what advice says of the examples.

    tools/random_cells/example.py CELL FMU UNTIL_S [--walks 3000] [--seed 1] [--set PARAMETER=VALUE ...]

The FMU is of FMI 2.0, with states that are saved; sensors are mats and fields; links are capsules. A payload that changes counts as it is: the
walks are searched once with the limits for the least payload, and once with those for the greatest while that is carried. Printed are the
walks and sequences, how many of them meet somebody too hard, how many surely (as `search.py` has it), and the first of those.
"""

import argparse
import json
import tempfile
from pathlib import Path

import fmpy
import numpy as np
import tomllib

from fmu import Fmu
from people import Cell, turn
from search import Search

# Where nobody is, m.
AWAY = np.array([0.0, 0.0, 500.0])


def roll_pitch_yaw(degrees):
    """The rotation of a cell file's rpy_deg: about the fixed x, then y, then z."""
    roll, pitch, yaw = np.radians(degrees)
    return turn([0, 0, 1], yaw) @ turn([0, 1, 0], pitch) @ turn([1, 0, 0], roll)


def placed(table):
    """Rotation and place of a base or an origin."""
    table = table or {}
    return roll_pitch_yaw(table.get("rpy_deg", [0, 0, 0])), np.array(table.get("xyz_m", [0, 0, 0]), float)


class Example(Cell):
    """A cell with one robot of joints in a row."""

    def __init__(self, path, outputs):
        text = tomllib.loads(Path(path).read_text())
        self.path, self.robot, self.outputs = Path(path), text["robot"][0], outputs
        self.robots, self.inputs, self.planes = self.robot["link"], text.get("inputs", {}), []
        self.read(text)
        self.carries = None

    def carrying(self, payload_kg, only):
        """From now on limits are those for this payload; links count only while it is carried, if so asked."""
        self.limited(self.robot["moving_mass_kg"] / 2 + payload_kg)
        self.carries = payload_kg if only else None

    def value(self, values, name):
        return values[self.outputs.index(name)]

    def payload(self, values):
        return self.robot.get("payload_kg") if "payload_kg" in self.robot else self.value(values, self.robot["payload"]["variable"])

    def links(self, values):
        rotation, at = placed(self.robot.get("base"))
        velocity, omega = np.zeros(3), np.zeros(3)
        frames = {}
        for joint in self.robot["joint"]:
            turned, moved = placed(joint.get("origin"))
            step = rotation @ moved
            velocity, at, rotation = velocity + np.cross(omega, step), at + step, rotation @ turned
            axis = rotation @ (np.array(joint["axis"], float) / np.linalg.norm(joint["axis"]))
            omega = omega + axis * self.value(values, joint["speed"]["variable"])
            rotation = rotation @ turn(joint["axis"], self.value(values, joint["angle"]["variable"]))
            frames[joint["name"]] = rotation, at, velocity, omega
        here = AWAY if self.carries is not None and abs(self.payload(values) - self.carries) > 1e-9 else np.zeros(3)
        links = []
        for link in self.robot["link"]:
            turned, at, velocity, omega = frames[link["joint"]]
            ends = [here + at + turned @ np.array(link["capsule"][e], float) for e in ("from_m", "to_m")]
            # v = v0 + omega x p.
            links.append((*ends, link["capsule"]["radius_m"], velocity - np.cross(omega, at), omega))
        return links


class ExampleFmu(Fmu):
    """The FMU of an example."""

    def __init__(self, file, cell, parameters):
        self.description = fmpy.read_model_description(str(file))
        folder, model = fmpy.extract(str(file), unzipdir=tempfile.mkdtemp()), self.description.coSimulation.modelIdentifier
        self.instance = {"guid": self.description.guid, "unzipDirectory": folder, "instanceName": "example", "modelIdentifier": model}
        self.fmi, self.step_s, self.cell = 2, cell.step_s, cell
        self.known = {v.name: (v.name, v.valueReference, v.type, v.causality, None) for v in self.description.modelVariables}
        self.told = [self.known[name][1] for name in cell.outputs]
        self.parameters, self.sensors = {**cell.parameters, **cell.inputs, **parameters}, [s["variable"] for s in cell.sensors]
        self.begin()

    def sense(self, slave, reading):
        for sensor, detected in zip(self.cell.sensors, reading):
            self.set(slave, sensor["variable"], detected == sensor["active"])


def outputs_of(path):
    robot = tomllib.loads(Path(path).read_text())["robot"][0]
    names = [joint[key]["variable"] for joint in robot["joint"] for key in ("angle", "speed")]
    return names + ([robot["payload"]["variable"]] if "payload" in robot else [])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("cell")
    parser.add_argument("fmu")
    parser.add_argument("until", type=float)
    parser.add_argument("--walks", type=int, default=3000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--set", action="append", default=[])
    arguments = parser.parse_args()
    cell = Example(arguments.cell, outputs_of(arguments.cell))
    fmu = ExampleFmu(arguments.fmu, cell, {name: json.loads(value) for name, value in (one.split("=") for one in arguments.set)})
    state, payloads = fmu.start, set()
    for _ in range(round(arguments.until / cell.step_s)):
        state = fmu.after(state, (False,) * len(cell.sensors))
        payloads.add(round(cell.payload(fmu.values[state]), 9))
    for payload in sorted({min(payloads), max(payloads)}):
        cell.carrying(payload, payload != min(payloads))
        search = Search(cell, fmu, arguments.until, arguments.seed)
        for kind, walk, margin in (("free", search.free, 0.045), ("sequences", search.sequences, 0.025)):
            hits, records, last = walk(arguments.walks)
            sure = [hit for hit in hits if search.sure(hit, records, last, margin)]
            first = search.told(sure[0], records, last) if sure else None
            print(json.dumps({"payload_kg": payload, "walks": kind, "of": arguments.walks, "hits": len(hits), "sure": len(sure),
                              "worst": round(max((hit[2] for hit in hits), default=0), 3), "first": first and {k: first[k] for k in ("at_s", "ratio", "what", "place")}}), flush=True)


if __name__ == "__main__":
    main()
