"""Complete searches from random beginnings against what `fmi-hazard scan --from anywhere` told of the same cell.

    lattice.py BINARY CELL ANYWHERE_JSON [--begins 20] [--actions 3] [--seed 1]

A beginning is a place to which people come unseen, a heading, and a moment after the start of the FMU, all at random: half of the places
are within 1 m of a square that was told, hit or open, the others within 2 m of what robots sweep. Beginnings at which a sensor reports the
person are left out. From each `scan --from start --strategy exhaustive` looks at every sequence of so many actions of 0.2 s that ends
within the time that was looked at from anywhere.

Where so few places are unseen, or have room, that hardly any beginning can be used, it gives up after a number of tries, says so, and tells of
those that it looked at; the exit code is 2 if there are none.

Of each hazard that it finds the place at the contact must lie in a square of `floor` or `open_m`. What is promised is no more than that:
arms less deep than `arm_tolerance_m` and bodies less deep than `body_tolerance_m` may be missed, and are told as tolerated. Anything
else that is not told is MISSED, with the cell file that shows it, and the exit code is 1.
"""

import argparse
import json
import os
import random
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ACTION_S = 0.2
# Random places that are tried for one beginning, and beginnings that are tried for each that is asked for.
PLACES, BEGINNINGS = 200_000, 20


def inside(at, rectangles, by=0.0):
    """Whether a place is in one of the rectangles, or no farther from one than so."""
    x, y = at
    return any(a - by <= x <= c + by and b - by <= y <= d + by for a, b, c, d in rectangles)


class Told:
    """What was told from anywhere."""

    def __init__(self, path):
        told = json.loads(Path(path).read_text())
        self.until_s, self.verdict = told["until_s"], told["verdict"]
        self.body_m, self.arm_m = told["body_tolerance_m"], told["arm_tolerance_m"]
        half = told["cell_m"] / 2 + 1e-9
        square = lambda at: [at[0] - half, at[1] - half, at[0] + half, at[1] + half]
        self.floor = [square(cell["xy_m"]) for cell in told["floor"]]
        self.open = [square(at) for at in told["open_m"]]
        assert not told.get("not_looked_at"), "the scan ended early"
        ground = told["ground"]
        self.unseen = ground["unseen_m"]
        # Nothing is swept where nobody can be hit: then anywhere will do.
        around = ground["swept_m"] or self.unseen
        self.around = [min(r[0] for r in around) - 2, min(r[1] for r in around) - 2,
                       max(r[2] for r in around) + 2, max(r[3] for r in around) + 2]

    def beginning(self, rng, longest_s, step_s):
        """A place, a heading in degrees, and a moment; nothing where hardly any place is unseen."""
        for _ in range(PLACES):
            near = self.floor + self.open
            if near and rng.random() < 0.5:
                a, b, c, d = rng.choice(near)
                at = rng.uniform(a - 1, c + 1), rng.uniform(b - 1, d + 1)
            else:
                at = rng.uniform(self.around[0], self.around[2]), rng.uniform(self.around[1], self.around[3])
            if inside(at, self.unseen):
                latest = round((self.until_s - longest_s) / step_s)
                return at, rng.uniform(0, 360), rng.randint(0, max(latest, 0)) * step_s
        return None


def complete(binary, cell, folder, actions, beginning):
    """The record of a complete search from there; nothing where nobody can be, or is seen."""
    (x, y), heading, begins = beginning
    text = (f"extends = {json.dumps(os.path.relpath(cell, folder))}\nname = \"lattice\"\n[human]\nfrom = \"start\"\nstart = {{ xy_m = [{x!r}, {y!r}], "
            f"heading_deg = {heading!r} }}\nother_starts = []\nstart_area = []\nbegins_s = [{begins:.6f}]\n[search]\nactions = {actions}\n")
    (folder / "cell.toml").write_text(text)
    command = [binary, "scan", folder / "cell.toml", "--from", "start", "--strategy", "exhaustive", "--no-advice", "--quiet", "--out",
               folder / "out"]
    run = subprocess.run(command, capture_output=True, text=True)
    if run.returncode == 2 and ("obstacle" in run.stderr or "room" in run.stderr):
        return None, text
    # 4: nothing was found of people whom nobody ever saw, say.
    assert run.returncode in (0, 1, 4), text + run.stdout + run.stderr
    scan = json.loads((folder / "out/scan.json").read_text())
    assert scan["certificate"]["complete"], scan["certificate"]
    return (None if "reports at once" in run.stderr else scan), text


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("binary", type=lambda path: str(Path(path).resolve()))
    parser.add_argument("cell", type=lambda path: Path(path).resolve())
    parser.add_argument("told", type=Told)
    parser.add_argument("--begins", type=int, default=20)
    parser.add_argument("--actions", type=int, default=3)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--step-s", type=float, default=0.02, help="the cell's communication step")
    given = parser.parse_args()
    told, rng, begun = given.told, random.Random(given.seed), time.time()
    assert given.actions * ACTION_S <= told.until_s, "less was looked at than the actions take"
    looked = left = hazards = sequences = in_floor = in_open = tolerated = seen = 0
    missed, gave_up = [], None
    with tempfile.TemporaryDirectory() as folder:
        while looked < given.begins:
            beginning = told.beginning(rng, given.actions * ACTION_S, given.step_s)
            if beginning is None:
                gave_up = f"of {PLACES} random places none is unseen"
                break
            if left >= BEGINNINGS * given.begins:
                gave_up = f"{left} beginnings are seen or have no room"
                break
            scan, text = complete(given.binary, given.cell, Path(folder), given.actions, beginning)
            if scan is None:
                left += 1
                continue
            looked += 1
            sequences += int(scan["certificate"]["sequences"])
            for hazard in scan["hazards"]:
                hazards += 1
                seen += any(sensor["person_detected"] for sensor in hazard["sensors"])
                at = hazard["person_xy_m"]
                if inside(at, told.floor):
                    in_floor += 1
                elif inside(at, told.open):
                    in_open += 1
                elif -hazard["distance_m"] <= (told.arm_m if hazard["arm"] else told.body_m):
                    tolerated += 1
                else:
                    missed.append((hazard, text))
    print(f"{given.cell.parent.name}/{given.cell.stem}: {told.verdict}; {looked} beginnings ({left} others seen or without room), {sequences} sequences "
          f"of {given.actions} actions, {time.time() - begun:.0f} s")
    print(f"  {hazards} hazards, {seen} of them of people whom a sensor reported; {in_floor} told, {in_open} in open, {tolerated} tolerated, "
          f"{len(missed)} MISSED")
    if gave_up:
        print(f"  gave up after {looked} of {given.begins} beginnings: {gave_up}")
    for hazard, text in missed[:5]:
        keys = ("body_region", "robot_link", "ratio", "distance_m", "time_s", "person_xy_m", "person_heading_deg", "actions")
        print(f"  MISSED {json.dumps({key: hazard[key] for key in keys})}\n{text}")
    sys.exit(1 if missed else 0 if looked else 2)


if __name__ == "__main__":
    main()
