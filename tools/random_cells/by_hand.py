"""The walks of entries.py in cells of which arithmetic says what happens: `by_hand.py FOLDER`.

In all of them a bar of 0.5 m slides to and fro 0.85 m above the floor, at 1 m/s at most: arms may be hit at 1.06 m/s. What it hits first of who
walks up to it is the pelvis (0.14 m before and behind the middle, 0.21 m beside it), which may be hit at 0.6 m/s.

Door: from the last place at which a body is not in the plane to the first behind it people walk 0.28 m, 0.175 s, and begin unseen. The robot
stands after 0.12 s of that, and goes on R after the door is clear: nobody is hit before 0.16 s + R, and some are soon after. The bar is too far away to be met
before it stands: 1.2 m.

Deaf: a zone ends S = 1 m before the bar. When it goes on, somebody may stand at the edge. Sideways their pelvis touches the bar after
0.82 m (0.07 + (0.19^2 - 0.1^2)^0.5 = 0.23 m from the axis of the bar, which ends at 0.2 m), and the robot is slower than 0.6 m/s after deaf + reaction +
0.4 ramp = deaf + 0.08 s: they are hit if 1.6 (deaf + 0.08) > 0.82, deaf > 0.43 s. Half of a step less is still harmless; to be there in time
one must turn in the very step in which the robot goes on, and meet the bar in the middle of its way.

Deaf after some stops: who is hit has come once more often than the robot hears.
"""

import random
import shutil
import sys
from pathlib import Path

import fmu as fmus
from entries import Entries, searched
from generate import around, cell, fence, rectangle, sensor
from people import Cell
from restarting import Restarting, plane

PERIOD = 1257


def bar():
    robot = Restarting(random.Random(1))
    robot.slides, robot.height, robot.swing, robot.core, robot.thick = True, 0.85, 0.2, ([0, -0.2, 0], [0, 0.2, 0]), 0.05
    robot.ex = robot.ey = 0.25
    robot.middle, robot.begin, robot.period, robot.reaction, robot.ramp = 0.0, 0.0, PERIOD, 40, 100
    return robot


def door(restart):
    robot, y = bar(), -1.725
    parts = fence(0.7, 1.7, opening=(-0.4, 0.4)) + plane("door", "interlocked_door", [[-0.4, y], [0.4, y]], "s1", 0)
    return cell("door", 0, [robot], parts, robot.wired(1, restart), (0.0, -2.4, 90), 4.0, False)


def zone(fmi, restart=0, **more):
    robot = bar()
    parts = sensor("zone", "mat", around(0.25, 0.25, [1.0] * 4), "s1", 0)
    return cell("zone", 10 * (fmi - 2), [robot], parts, robot.wired(1, restart, **more), (0.0, -1.5, 90), 4.0, False)


def filled(restart):
    """The door with a mat behind it."""
    return door(restart).replace("[human]", sensor("mat", "mat", rectangle(-0.7, -1.8, 0.7, 1.7), "s1", 0) + "[human]")


CELLS = {
    "a door that restarts after 1 s": (door(1000), [(400, 4.0)], lambda f: f["sure"] and 1.16 <= f["first"]["at_s"] <= 1.9),
    "a door that restarts after 3.9 s, in 4 s": (door(3900), [(400, 4.0)], lambda f: not f["hits"]),
    "a door that restarts after 3.9 s, in 10 s": (door(3900), [(400, 10.0)], lambda f: f["sure"] and f["first"]["at_s"] >= 4.06),
    "a door with a mat behind": (filled(0), [(400, 10.0)], lambda f: not f["hits"]),
    "deaf for 0.42 s": (zone(3, deaf=420), [(1500, 10.0)], lambda f: not f["hits"]),
    "deaf for 0.54 s": (zone(3, deaf=540), [(1500, 10.0)], lambda f: f["sure"]),
    "deaf for 0.54 s, latched": (zone(2, deaf=540).replace("latched\" = false", "latched\" = true"), [(600, 10.0)], lambda f: not f["hits"]),
    "deaf after 4 stops": (zone(2, hears=4), [(600, 10.0)], lambda f: f["sure"] and f["first"]["entries"] >= 5),
    "never deaf": (zone(2), [(600, 10.0)], lambda f: not f["hits"]),
}


def main():
    folder, wrong = Path(sys.argv[1]).resolve(), 0
    fmus.build(folder / "fmu")
    (folder / "cells").mkdir(exist_ok=True)
    for fmi in (2, 3):
        shutil.copy(folder / f"fmu/robots{fmi}.fmu", folder / "cells")
    for number, (name, (text, rounds, right)) in enumerate(CELLS.items()):
        file = folder / "cells" / f"hand-{number}.toml"
        file.write_text(text)
        of = Cell(file)
        fmu = fmus.Fmu(folder / "fmu", of.fmi, of.parameters, [s["variable"] for s in of.sensors], of.step_s)
        found = searched(Entries(of, fmu, 4.0, number), rounds)
        fmu.close()
        wrong += not right(found)
        first = found["first"] and (found["first"]["at_s"], found["first"]["ratio"], found["first"]["entries"])
        print(f"{'as' if right(found) else 'NOT as'} by hand: {name}: {found['walks']} walks, {found['hits']} hits, {found['sure']} sure, first {first}", flush=True)
    return wrong


if __name__ == "__main__":
    sys.exit(main())
