"""A second opinion on `fmi-hazard scan --from anywhere`: what brute.py and walks.py share.

Everything here was written from the method page of the book, by somebody who had not read the Rust, and shares nothing with it: the
person (legs, trunk and head; no arms), mats and scanner fields, walls, and the rule which contact is too hard. The FMU is run by
FMPy; its states are saved and brought back by FMPy as well, and `Fmu.plain` runs a history of inputs again in a fresh instance
without that.

Only small cells can be read: one robot of joints in a row, links of one capsule each, mats and scanner fields, boxes that stand upright
and reach from the floor to above the head, a median man.
"""

import argparse
import json
import shutil
import subprocess
import tomllib
from pathlib import Path

import fmpy
import numpy as np
from fmpy.fmi2 import FMU2Slave

SPEED = 1.6  # m/s, ISO 13855
STEP_S = 0.02
WAY = SPEED * STEP_S
FOOT = 0.09
HIP = 0.92
ROOM = 0.14  # radius of the capsule that stops a walk

# Part, in the trunk's frame or not, ends of its core, radius.
PARTS = [
    ("head", True, (0, 0, 0.72), (0, 0, 0.72), 0.105),
    ("neck", True, (0, 0, 0.52), (0, 0, 0.62), 0.06),
    ("upper chest", True, (0, 0.08, 0.40), (0, -0.08, 0.40), 0.13),
    ("lower chest", True, (0, 0.08, 0.25), (0, -0.08, 0.25), 0.14),
    ("abdomen", True, (0, 0, 0.12), (0, 0, 0.12), 0.13),
    ("pelvis", False, (0, 0.07, 0.95), (0, -0.07, 0.95), 0.14),
    ("thigh", False, (0, FOOT, 0.49), (0, FOOT, 0.85), 0.08),
    ("thigh", False, (0, -FOOT, 0.49), (0, -FOOT, 0.85), 0.08),
    ("lower leg", False, (0, FOOT, 0.055), (0, FOOT, 0.49), 0.055),
    ("lower leg", False, (0, -FOOT, 0.055), (0, -FOOT, 0.49), 0.055),
]
# Region: effective mass kg, spring N/m, limit N. None: no moving robot may touch it.
REGIONS = {
    "skull": None, "face": None, "throat": None,
    "neck": (1.2, 50e3, 290), "back": (40, 35e3, 420), "chest": (40, 25e3, 280), "abdomen": (40, 10e3, 220),
    "pelvis": (40, 25e3, 360), "thigh": (75, 50e3, 440), "lower leg": (75, 60e3, 250),
}
BENDS = {"upright": (0, 0), "forward": (1, 0), "left": (0, 1), "right": (0, -1), "forward-left": (1, 1), "forward-right": (1, -1)}


def turn(axis, angle):
    """Rotation matrix about an axis."""
    x, y, z = np.asarray(axis, float) / np.linalg.norm(axis)
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross


def in_polygon(points, polygon):
    """Which of the points (..., 2) lie in a polygon: crossings of a ray."""
    x, y = points[..., 0], points[..., 1]
    inside = np.zeros(x.shape, bool)
    corners = np.asarray(polygon, float)
    for (ax, ay), (bx, by) in zip(corners, np.roll(corners, -1, 0)):
        if ay != by:
            inside ^= ((ay > y) != (by > y)) & (x < (bx - ax) * (y - ay) / (by - ay) + ax)
    return inside


class Cell:
    """What is read of a cell file."""

    def __init__(self, path):
        path = Path(path)
        text = tomllib.loads(path.read_text())
        self.fmu = path.parent / text["fmu"]
        [self.robot] = text["robot"]
        self.sensors = text.get("sensor", [])
        self.inputs, self.parameters = text.get("inputs", {}), text.get("parameters", {})
        assert all(s["kind"] in ("mat", "scanner_field") for s in self.sensors)
        assert text.get("time", {}).get("step_s", STEP_S) == STEP_S
        self.delays = [int(np.ceil(s.get("delay_ms", 0) / (STEP_S * 1000) - 1e-9)) for s in self.sensors]
        human = text["human"]
        assert not {"sex", "percentile", "radii_m", "floor_m"} & set(human)
        self.angles = np.radians([human.get("bend_forward_deg", 45.0), human.get("bend_lateral_deg", 30.0)])
        self.walls = []
        for box in text.get("obstacle", []):
            middle, half = np.array(box["centre_m"]), np.array(box["size_m"]) / 2
            assert middle[2] - half[2] <= 0 and middle[2] + half[2] >= 2 and "rpy_deg" not in box
            self.walls.append((middle[:2], half[:2]))
        mass = self.robot["moving_mass_kg"] / 2 + self.robot["payload_kg"]
        # The speed above which a contact is too hard, by region.
        self.safe = {name: 1e-3 if given is None else given[2] / np.sqrt(given[1] / (1 / given[0] + 1 / mass))
                     for name, given in REGIONS.items()}

    def outputs(self):
        """The FMU outputs that tell of the robot."""
        of = [(j.get("angle") or j.get("position"), j["speed"]) for j in self.robot["joint"]]
        return [given["variable"] for pair in of for given in pair]

    def readings(self, places, headings):
        """What each sensor tells of people at these places (M, 2) with these headings (M): (M, sensors), true where it reports them."""
        left = np.stack([-np.sin(headings), np.cos(headings)], -1) * FOOT
        told = [in_polygon(places + left, s["zone"]["polygon_m"]) | in_polygon(places - left, s["zone"]["polygon_m"])
                for s in self.sensors]
        return np.stack(told, -1) if told else np.zeros((len(places), 0), bool)

    def free(self, places):
        """Where a person has room."""
        free = np.ones(places.shape[:-1], bool)
        for middle, half in self.walls:
            beyond = np.maximum(np.abs(places - middle) - half, 0)
            free &= np.hypot(beyond[..., 0], beyond[..., 1]) >= ROOM + 1e-6
        return free

    def links(self, values):
        """The robot's links: ends of the core, radius, and the velocity of a point as (v0, omega): v = v0 + omega x p."""
        base = self.robot.get("base", {})
        assert "rpy_deg" not in base
        at, rotation, links = np.array(base.get("xyz_m", [0, 0, 0]), float), np.eye(3), []
        v0, omega = np.zeros(3), np.zeros(3)
        for number, joint in enumerate(self.robot["joint"]):
            value, speed = values[2 * number: 2 * number + 2]
            origin = joint.get("origin", {})
            assert "rpy_deg" not in origin
            at = at + rotation @ np.array(origin.get("xyz_m", [0, 0, 0]), float)
            axis = rotation @ (np.array(joint["axis"], float) / np.linalg.norm(joint["axis"]))
            if "angle" in joint:
                angle = value + np.radians(joint["angle"].get("offset_deg", 0))
                v0, omega = v0 + np.cross(at, axis * speed), omega + axis * speed
                rotation = turn(axis, angle) @ rotation
            else:
                at, v0 = at + axis * value, v0 + axis * speed
            for link in self.robot["link"]:
                if link["joint"] == joint["name"]:
                    ends = [at + rotation @ np.array(link["capsule"][end], float) for end in ("from_m", "to_m")]
                    links.append((*ends, link["capsule"]["radius_m"], v0.copy(), omega.copy()))
        return links


class Fmu:
    """The FMU as a table of transitions between numbered states; each is stepped once, from a state that was brought back."""

    def __init__(self, cell, folder):
        self.cell = cell
        self.folder = fmpy.extract(str(cell.fmu), unzipdir=str(Path(folder).resolve()))
        self.description = fmpy.read_model_description(self.folder)
        self.variables = {v.name: v for v in self.description.modelVariables}
        self.slave = self.fresh()
        self.told = [self.variables[name].valueReference for name in cell.outputs()]
        self.numbers, self.saved, self.values, self.steps, self.next = {}, [], [], [], {}
        self.start = self.number(0)

    def fresh(self):
        """A new instance, initialised with nobody seen."""
        slave = FMU2Slave(guid=self.description.guid, unzipDirectory=self.folder, instanceName="toy",
                          modelIdentifier=self.description.coSimulation.modelIdentifier)
        slave.instantiate()
        slave.setupExperiment(startTime=0.0)
        for name, value in {**self.cell.parameters, **self.cell.inputs}.items():
            self.set(slave, name, value)
        self.sense(slave, [False] * len(self.cell.sensors))
        slave.enterInitializationMode()
        slave.exitInitializationMode()
        return slave

    def set(self, slave, name, value):
        variable = self.variables[name]
        {"Real": slave.setReal, "Integer": slave.setInteger, "Boolean": slave.setBoolean}[variable.type](
            [variable.valueReference], [value])

    def sense(self, slave, reading):
        for sensor, detected in zip(self.cell.sensors, reading):
            self.set(slave, sensor["variable"], bool(sensor["active"]) == bool(detected))

    def number(self, step):
        """The number of the state in which the instance is."""
        state = self.slave.getFMUstate()
        key = (step, self.slave.serializeFMUstate(state))
        if key in self.numbers:
            self.slave.freeFMUstate(state)
            return self.numbers[key]
        self.numbers[key] = len(self.saved)
        self.saved.append(state)
        self.values.append(tuple(self.slave.getReal(self.told)))
        self.steps.append(step)
        return self.numbers[key]

    def after(self, state, reading):
        """The state after a step with these readings."""
        if (state, reading) not in self.next:
            self.slave.setFMUstate(self.saved[state])
            self.sense(self.slave, reading)
            self.slave.doStep(self.steps[state] * STEP_S, STEP_S)
            self.next[state, reading] = self.number(self.steps[state] + 1)
        return self.next[state, reading]

    def plain(self, history):
        """The outputs after each step of a history of readings, from a fresh instance that no state is brought back to."""
        slave, values = self.fresh(), []
        for step, reading in enumerate(history):
            self.sense(slave, reading)
            slave.doStep(step * STEP_S, STEP_S)
            values.append(tuple(slave.getReal(self.told)))
        slave.terminate()
        slave.freeInstance()
        return values


class Chain:
    """FMU and response times: what the FMU gets is what sensors told some steps ago."""

    def __init__(self, fmu, delays):
        self.fmu, self.delays = fmu, delays
        self.numbers, self.all, self.next = {}, [], {}
        self.start = self.number(fmu.start, tuple((False,) * d for d in delays))

    def number(self, state, lines):
        if (state, lines) not in self.numbers:
            self.numbers[state, lines] = len(self.all)
            self.all.append((state, lines))
        return self.numbers[state, lines]

    def after(self, state, reading):
        if (state, reading) not in self.next:
            inner, lines = self.all[state]
            lines = tuple(line + (now,) for line, now in zip(lines, reading))
            arrives = tuple(line[0] for line in lines)
            self.next[state, reading] = self.number(self.fmu.after(inner, arrives), tuple(line[1:] for line in lines))
        return self.next[state, reading]

    def merge(self, readings, steps, most=200_000):
        """Takes states for one whose outputs are the same, now and after whatever readings, until so many steps; nothing, if there
        are too many states to go through."""
        levels = [[self.start]]
        for _ in range(steps):
            levels.append(list({self.after(state, r): None for state in levels[-1] for r in readings}))
            if sum(map(len, levels)) > most:
                return False
        same, all_of_class = {}, {}
        for n, level in reversed(list(enumerate(levels))):
            for state in level:
                after = () if n == steps else tuple(same[self.next[state, r]] for r in readings)
                key = (n, self.fmu.values[self.all[state][0]], after)
                same[state] = all_of_class.setdefault(key, state)
        self.next = {key: same[state] for key, state in self.next.items()}
        return True

    def delayed(self, history):
        """What the FMU gets of a history of readings."""
        return [tuple(history[n - d][s] if n >= d else False for s, d in enumerate(self.delays)) for n in range(len(history))]

    def links(self, state):
        return self.fmu.cell.links(self.fmu.values[self.all[state][0]])


def nearest(a, b, c, d):
    """The nearest points of segments a-b (M, 3) and c-d (3): on each, where they are nearest."""
    u, v, w = b - a, d - c, a - c
    uu, uv, vv = (u * u).sum(-1), u @ v, v @ v
    uw, vw = (u * w).sum(-1), w @ v
    with np.errstate(all="ignore"):
        best = None
        # Inside of both, and the four ends against the other segment.
        det = uu * vv - uv * uv
        s = np.where(det > 1e-12, np.clip((uv * vw - vv * uw) / det, 0, 1), 0)
        tries = [(s, None), (np.zeros_like(uw), None), (np.ones_like(uw), None), (None, 0.0), (None, 1.0)]
        for s, t in tries:
            if t is None:
                t = np.clip(np.where(vv > 0, (vw + s * uv) / (vv or 1), 0), 0, 1)
            else:
                t = np.full_like(uw, t)
                s = np.where(uu > 0, np.clip((t * uv - uw) / np.where(uu > 0, uu, 1), 0, 1), 0)
            p, q = a + s[:, None] * u, c + t[:, None] * v
            far = ((p - q) ** 2).sum(-1)
            if best is None:
                best = [p, q, far]
            else:
                nearer = far < best[2]
                best = [np.where(nearer[:, None], p, best[0]), np.where(nearer[:, None], q, best[1]), np.where(nearer, far, best[2])]
    return best[0], best[1], np.sqrt(best[2])


class Person:
    """The body without arms, in one posture."""

    def __init__(self, cell, posture):
        self.cell = cell
        forward, left = np.array(BENDS[posture]) * cell.angles
        # Rx(-s) Ry(f), s to the left.
        self.bend = turn([1, 0, 0], -left) @ turn([0, 1, 0], forward)
        hip = np.array([0, 0, HIP])
        self.parts = []
        for name, of_trunk, a, b, radius in PARTS:
            a, b = np.array(a, float), np.array(b, float)
            if of_trunk:
                a, b = hip + self.bend @ a, hip + self.bend @ b
            if of_trunk or posture == "upright":
                self.parts.append((name, a, b, radius))
        self.reach = max(np.hypot(*end[:2]) + radius for _, a, b, radius in self.parts for end in (a, b))

    def hit(self, places, headings, links):
        """Which people at these places (M, 2) with these headings (M) are hit too hard by links."""
        hit = np.zeros(len(places), bool)
        cos, sin = np.cos(headings), np.sin(headings)

        def placed(point):
            return np.stack([places[:, 0] + cos * point[0] - sin * point[1], places[:, 1] + sin * point[0] + cos * point[1],
                             np.full(len(places), point[2])], -1)

        for name, a, b, radius in self.parts:
            for c, d, thick, v0, omega in links:
                pa, pb = placed(a), placed(b)
                on_body, on_link, far = nearest(pa, pb, c, d)
                touch = (far <= radius + thick) & (far > 1e-9) & ~hit
                for middle, half in self.cell.walls:
                    # No part beyond a wall counts, however the wall ends: that loses some contacts, and adds none.
                    axis = int(half[1] < half[0])
                    sides = [np.sign(point[..., axis] - middle[axis]) for point in (pa, pb, c, d)]
                    touch &= ~((sides[0] == sides[1]) & (sides[2] == sides[3]) & (sides[0] == -sides[2]))
                if not touch.any():
                    continue
                k = np.nonzero(touch)[0]
                n = (on_body[k] - on_link[k]) / far[k, None]
                speed = np.linalg.norm(v0 + np.cross(omega, on_link[k] + thick * n), axis=-1)
                hit[k] = speed > self.limits(name, on_body[k] - radius * n, places[k], cos[k], sin[k]) * (1 + 1e-9)
        return hit

    def limits(self, name, points, places, cos, sin):
        """The safe speed at points of the body's surface."""
        safe = self.cell.safe
        if name in ("pelvis", "thigh", "lower leg"):
            return np.full(len(points), safe[name])
        dx, dy = (points[:, :2] - places).T
        own = np.stack([cos * dx + sin * dy, cos * dy - sin * dx, points[:, 2] - HIP], -1) @ self.bend
        x, y, z = own.T
        if name == "head":
            return np.full(len(points), safe["face"])
        if name == "neck":
            return np.where(x >= 0, safe["throat"], safe["neck"])
        front = np.where(z >= 0.20, safe["chest"], safe["abdomen"])
        back = (x < 0) | ((np.abs(y) > 0.1445) if name == "upper chest" else False)
        return np.where(back, safe["back"], front)


def surely_hit(person, place, heading, links, by_m=0.0101):
    """Whether somebody is hit here and wherever else within 10 mm: nothing less is claimed not to be missed."""
    around = [np.array(place) + r * np.array([np.cos(t), np.sin(t)])
              for r in (0, 0.5 * by_m, by_m) for t in np.linspace(0, 2 * np.pi, 32, endpoint=False)]
    return bool(person.hit(np.array(around), np.full(len(around), heading), links).all())


class Told:
    """What fmi-hazard told: cells of the floor where somebody is hit, and those that are open."""

    def __init__(self, path):
        told = json.loads(Path(path).read_text())
        self.half = told["cell_m"] / 2
        self.floor = np.array([f["xy_m"] for f in told["floor"]]).reshape(-1, 2)
        self.open = np.array(told["open_m"]).reshape(-1, 2)
        self.all = np.concatenate([self.floor, self.open])
        self.verdict, self.hazards, self.changes = told["verdict"], told["hazards"], told["changes"]
        assert not told.get("not_looked_at"), "the scan ended early"

    def holds(self, places):
        """Which places lie in one of the cells."""
        held = np.zeros(len(places), bool)
        for at in self.all:
            held |= np.abs(places - at).max(-1) <= self.half + 1e-9
        return held


def arguments(about):
    """What both scripts are given; they add their own."""
    parser = argparse.ArgumentParser(description=about.split("\n")[0])
    parser.add_argument("binary")
    parser.add_argument("folder")
    parser.add_argument("cell")
    parser.add_argument("until_s", type=float)
    parser.add_argument("--bends", action="store_true", help="all six postures; not in cells with walls")
    parser.add_argument("--told", help="an anywhere.json that is there already")
    return parser


def scan(binary, cell, until_s, out, more=()):
    """Runs fmi-hazard; the file with what it told."""
    out = Path(out)
    shutil.rmtree(out, ignore_errors=True)
    command = [str(Path(binary).resolve()), "scan", str(cell), "--from", "anywhere", "--until", f"{until_s}s", "--out", str(out), *more]
    run = subprocess.run(command, capture_output=True, text=True)
    [file] = list(out.rglob("anywhere.json")) or [None]
    assert file, run.stdout + run.stderr
    return file
