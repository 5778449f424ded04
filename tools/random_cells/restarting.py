"""Random cells whose stops restart by themselves, in twins. `twins(seed)` gives the kind and the text of both cell files.

Eleven kinds by turns, FMI 2.0 and 3.0 by turns. The robot goes on when nobody is seen, or some time later, in both twins. In the flawed one
somebody can be where the robot comes when it has gone on: they closed a door behind themselves, stepped over a strip, wait in a hole, come again at once. In the
repaired one they are seen wherever the robot gets, or it gets nowhere near. Reaction, ramp and period are no multiples of the step as a rule.
"""

import math
import random

from generate import WALL, Robot, around, cell, fence, rectangle, sensor

KINDS = ["door without reset", "strip with floor behind", "ring with floor inside", "curtain with floor behind", "restart after a time",
         "deaf while it restarts", "muted while people walk in", "seam that is told late", "hole between two mats", "robot within reach",
         "deaf after some stops"]
UNTIL = 4.0


class Restarting(Robot):
    """A robot that goes on by itself."""

    def __init__(self, rng, fast=False):
        super().__init__(rng, 1, fast)
        if not self.slides:
            # Its tip is in front where it is fastest.
            self.middle = -1.57
        if rng.random() < 0.7:
            lever = 1.0 if self.slides else self.ex
            self.period = max(int(2 * math.pi * self.swing * lever / self.speed * 1000), 200)
        self.reaction, self.ramp = rng.choice([20, 30, 40, 55, 60, 73, 80]), rng.choice([50, 60, 70, 90, 100, 125, 137])
        self.restart = rng.choice([0, 0, 20, 40, 90, 100, 250])

    def wired(self, heeds, restart=None, mutes=0, mute=0, deaf=0, hears=0):
        """Its parameters."""
        more = f'"r1.mutes" = {mutes}\n"r1.mute_ms" = {mute}\n' if mutes else ""
        more += f'"r1.deaf_ms" = {deaf}\n' if deaf else ""
        more += f'"r1.hears" = {hears}\n' if hears else ""
        return self.parameters(heeds, latched=False, restart=self.restart if restart is None else restart) + more

    def right(self, delay, beyond=0.35):
        """How far from it people have to be seen at the latest."""
        return 1.6 * (self.stop_s() + delay / 1000 + 0.06) + beyond


def written(seed, which, robot, parts, parameters, start, bends=False):
    return cell(f"{seed}-{which}", 10 * (seed % 2), [robot], parts, parameters, start, UNTIL, bends)


class Room:
    """A fence with an opening at -y, so far away that who comes through it is seen in time."""

    def __init__(self, rng, robot, delay, side=None):
        self.fx = robot.ex + (rng.uniform(0.3, 0.45) if side is None else side)
        self.fy = robot.ey + robot.right(delay, 0.45) + rng.uniform(0.0, 0.1)
        self.half = min(rng.uniform(0.35, 0.45), self.fx)
        self.fence = fence(self.fx, self.fy, opening=(-self.half, self.half))
        self.start = (0.0, -self.fy - rng.uniform(0.9, 1.1), 90)
        self.line = [[-self.half, -self.fy - WALL / 2], [self.half, -self.fy - WALL / 2]]

    def floor(self, out=0.12):
        """All floor inside, and some before the opening."""
        return rectangle(-self.fx, -self.fy - out, self.fx, self.fy)

    def strip(self, depth):
        return rectangle(-self.half - 0.6, -self.fy - depth, self.half + 0.6, -self.fy + 0.05)


def plane(name, kind, line, variable, delay):
    """A door or a light curtain."""
    return sensor(name, "interlocked_door", line, variable, delay).replace("interlocked_door", kind)


def doors(rng, seed, kind):
    """An opening with a door, a curtain or a strip, through which one comes to where nobody is seen; or to a mat or a field that sees them."""
    robot, delay = Restarting(rng), rng.choice([0, 0, 20, 35])
    room, depth = Room(rng, robot, delay), rng.uniform(0.3, 0.4)
    strip = kind == "strip with floor behind" or kind == "restart after a time" and rng.random() < 0.4
    what = "light_curtain" if kind == "curtain with floor behind" else "interlocked_door"
    restart = rng.choice([300, 410, 600, 1000, 1500]) if kind == "restart after a time" else None
    field, other = rng.choice(["mat", "scanner_field"]), kind == "curtain with floor behind" and rng.random() < 0.7

    def twin(which):
        mended = which == "repaired"
        zone = rectangle(-max(room.fx, room.half + 0.6), -room.fy - depth, max(room.fx, room.half + 0.6), room.fy) if mended else room.strip(depth)
        parts = room.fence + (sensor("strip", "mat", zone, "s1", delay) if strip else plane("way in", what, room.line, "s1", delay))
        if mended and not strip:
            parts += sensor("presence", field, room.floor(), "s2" if other else "s1", delay)
        return written(seed, which, robot, parts, robot.wired(3 if other else 1, restart), room.start)
    return twin


def open_floor(rng, seed, kind):
    """A zone on open floor: with a hole in which nobody is seen, or large enough for a controller that hears at once and no other."""
    fast = rng.random() < 0.3
    bends = rng.random() < 0.3 and not fast
    robot, delay = Restarting(rng, fast), rng.choice([0, 0, 20, 50])
    right = robot.right(delay, 1.35 if fast else 1.0 if bends else 0.35) + rng.uniform(0.02, 0.12)
    what, hole = rng.choice(["mat", "scanner_field"]), rng.uniform(0.38, 0.5)
    right = max(right, hole + 0.3)
    x, y = robot.ex + right, robot.ey + right
    start = (rng.uniform(-0.2, 0.2), -y - rng.uniform(0.2, 0.3), 90)
    deaf, hears = int(right / 1.6 * 1000 + rng.uniform(150, 350)), rng.choice([1, 2, 3, 4])
    hx, hy = robot.ex + hole, robot.ey + hole
    ring = {"front": rectangle(-x, -y, x, -hy), "back": rectangle(-x, hy, x, y), "left": rectangle(-x, -y, -hx, y), "right": rectangle(hx, -y, x, y)}

    def twin(which):
        flawed = which == "flawed"
        if flawed and kind == "ring with floor inside":
            parts = "".join(sensor(name, what, zone, "s1", delay) for name, zone in ring.items())
        else:
            parts = sensor("zone", what, around(robot.ex, robot.ey, [right] * 4), "s1", delay)
        more = {"deaf while it restarts": {"deaf": deaf}, "deaf after some stops": {"hears": hears}}.get(kind, {}) if flawed else {}
        return written(seed, which, robot, parts, robot.wired(1, **more), start, bends)
    return twin


def muted(rng, seed, kind):
    """A curtain or door that is not heeded while somebody stands on a mat through which one walks in; a field inside is heeded, or there is none."""
    robot, delay = Restarting(rng), rng.choice([0, 0, 20])
    room, what = Room(rng, robot, delay), rng.choice(["light_curtain", "interlocked_door"])
    mute, field = rng.choice([1500, 2000, 3000]), rng.choice(["mat", "scanner_field"])
    mat = rectangle(-room.half - 0.1, -room.fy - rng.uniform(0.6, 0.8), room.half + 0.1, -room.fy + rng.uniform(0.3, 0.4))

    def twin(which):
        mended = which == "repaired"
        parts = room.fence + plane("way in", what, room.line, "s1", delay) + sensor("muting", "mat", mat, "s2", 0)
        if mended:
            parts += sensor("presence", field, room.floor(), "s3", delay)
        return written(seed, which, robot, parts, robot.wired(5 if mended else 1, mutes=2, mute=mute), room.start)
    return twin


def late(rng, seed, kind):
    """A strip before a field: between them the robot goes on, and the field is told late, or is not."""
    robot, delay = Restarting(rng), rng.choice([0, 20])
    robot.restart = rng.choice([0, 0, 20, 40])
    room, depth, more = Room(rng, robot, delay), rng.uniform(0.3, 0.4), rng.choice([700, 850, 1000])

    def twin(which):
        strip = sensor("strip", "mat", room.strip(depth), "s1", delay)
        field = sensor("field", "scanner_field", room.floor(0.0), "s2", delay + (more if which == "flawed" else 0))
        return written(seed, which, robot, room.fence + strip + field, robot.wired(3), room.start)
    return twin


def hole(rng, seed, kind):
    """Two mats with an input each, and before the robot a hole between them to which one gets over either; or they cover it."""
    fast = rng.random() < 0.3
    robot, delay = Restarting(rng, fast), rng.choice([0, 20, 35])
    right = robot.right(delay, 1.35 if fast else 0.35) + rng.uniform(0.2, 0.3)
    x, y, at = robot.ex + right, robot.ey + right, rng.uniform(-0.1, 0.1)
    wide, inner = rng.uniform(0.2, 0.28), -robot.ey - 0.02
    outer, start = max(inner - rng.uniform(0.4, 0.5), -y + 0.2), (at, -y - rng.uniform(0.2, 0.3), 90)

    def twin(which):
        parts = ""
        for name, variable, side in (("left", "s1", -1), ("right", "s2", 1)):
            seam, edge, far = at - side * 0.05, at + side * wide, side * x
            notch = [[seam, outer], [edge, outer], [edge, inner], [seam, inner]] if which == "flawed" else []
            zone = [[far, -y], [seam, -y], *notch, [seam, y], [far, y]]
            parts += sensor(name, "mat", zone, variable, delay)
        return written(seed, which, robot, parts, robot.wired(3), start)
    return twin


def reached(rng, seed, kind):
    """A door behind which the robot restarts: people get to it there, or a fence of its own is between."""
    robot, delay, away = Restarting(rng), rng.choice([0, 20, 35]), rng.uniform(0.22, 0.3)
    room = Room(rng, robot, delay, side=away + WALL + rng.uniform(0.45, 0.6))
    inner = fence(robot.ex + away, robot.ey + away).replace('name = "', 'name = "inner ')

    def twin(which):
        parts = room.fence + (inner if which == "repaired" else "") + plane("door", "interlocked_door", room.line, "s1", delay)
        return written(seed, which, robot, parts, robot.wired(1), room.start)
    return twin


MAKERS = [doors, doors, open_floor, doors, doors, open_floor, muted, late, hole, reached, open_floor]


def twins(seed):
    """Kind and both texts; the same seed gives the same."""
    rng = random.Random(f"restarting cells {seed}")
    kind = KINDS[seed % len(KINDS)]
    twin = MAKERS[seed % len(KINDS)](rng, seed, kind)
    return kind, twin("flawed"), twin("repaired")
