"""Random cells in twins: one with a planted flaw, one with it mended. `twins(seed)` gives the text of both cell files.

Ten kinds by turns, ten seeds apart FMI 2.0 and 3.0 by turns. The robots are robots.c. The flaw is in one place, which the two texts differ in.
"""

import math
import random
import re

WALL, HIGH = 0.05, 2.3
KINDS = ["mat too narrow", "field too short", "stop too late", "gap in the fence", "fence too low", "door that restarts", "door not wired",
         "strip that restarts", "second robot not wired", "slot between mats"]


def rectangle(x0, y0, x1, y1):
    return [[x0, y0], [x1, y0], [x1, y1], [x0, y1]]


def around(ex, ey, sides):
    """A rectangle beyond the half extents by so much at -x, -y, +x, +y."""
    return rectangle(-ex - sides[0], -ey - sides[1], ex + sides[2], ey + sides[3])


def sensor(name, kind, zone, variable, delay):
    what = f"polygon_m = {[[round(v, 3) for v in p] for p in zone]}" if kind not in ("interlocked_door", "light_curtain") else \
        f"line_m = {[[round(v, 3) for v in p] for p in zone]}, heights_m = [0, 2.2]"
    return (f'[[sensor]]\nname = "{name}"\nkind = "{kind}"\nvariable = "{variable}"\nactive = false\n'
            + (f"delay_ms = {delay}\n" if delay else "") + f"zone = {{ {what} }}\n")


def box(name, x0, y0, x1, y1, height):
    return (f'[[obstacle]]\nname = "{name}"\ncentre_m = [{(x0 + x1) / 2:.4f}, {(y0 + y1) / 2:.4f}, {height / 2:.4f}]\n'
            f"size_m = [{x1 - x0:.4f}, {y1 - y0:.4f}, {height:.4f}]\n")


def fence(fx, fy, height=HIGH, opening=None):
    """Four panels whose inner faces are at +-fx, +-fy; an opening (from, to) in the one at -y."""
    w, text = WALL, ""
    if opening:
        text += box("front left", -fx - w, -fy - w, opening[0], -fy, height) + box("front right", opening[1], -fy - w, fx + w, -fy, height)
    else:
        text += box("front", -fx - w, -fy - w, fx + w, -fy, height)
    return (text + box("back", -fx - w, fy, fx + w, fy + w, height) + box("left", -fx - w, -fy, -fx, fy, height)
            + box("right", fx, -fy, fx + w, fy, height))


class Robot:
    """A beam that slides or a bar that turns, at half extents ex, ey about its middle (0, y)."""

    def __init__(self, rng, number, fast, y=0.0, high=False):
        self.number, self.y = number, y
        self.height = rng.choice([0.75, 0.85, 0.95]) if high else rng.choice([0.4, 0.5, 0.7, 0.85])
        self.speed = rng.uniform(1.7, 2.6) if fast else rng.uniform(0.75, 0.98)
        self.slides = rng.random() < 0.6
        thick = 0.05
        if self.slides:
            half, swing = rng.uniform(0.15, 0.3), rng.uniform(0.15, 0.3)
            self.ex, self.ey, self.core = swing + thick, half + thick, ([0, -half, 0], [0, half, 0])
            self.swing, lever = swing, 1.0
        else:
            length = rng.uniform(0.3, 0.45)
            self.swing = rng.uniform(0.5, 1.2)
            self.ex = self.ey = length + thick
            self.core, lever = ([0, 0, 0], [length, 0, 0]), length + thick
        self.thick = thick
        self.period = max(int(2 * math.pi * self.swing * lever / self.speed * 1000 / 20) * 20, 200)
        self.begin = rng.choice([0.0, 1.0, 2.0, 4.0])
        self.middle = 0.0 if self.slides else rng.choice([-1.57, -1.57, -0.8, 0.6])
        self.reaction, self.ramp = rng.choice([20, 40, 60, 80]), rng.choice([60, 100, 140])

    def stop_s(self):
        return (self.reaction + self.ramp) / 1000

    def text(self):
        n = self.number
        value = f'position = {{ variable = "r{n}.q", unit = "m" }}\nspeed = {{ variable = "r{n}.qd", unit = "m/s" }}' if self.slides else \
            f'angle = {{ variable = "r{n}.q", unit = "rad" }}\nspeed = {{ variable = "r{n}.qd", unit = "rad/s" }}'
        return f"""[[robot]]
name = "R{n}"
base = {{ xyz_m = [0, {self.y}, {self.height}] }}
moving_mass_kg = 40
payload_kg = 3
[[robot.joint]]
name = "axis"
axis = {[1, 0, 0] if self.slides else [0, 0, 1]}
{value}
[[robot.link]]
name = "bar"
joint = "axis"
capsule = {{ from_m = {[round(v, 3) for v in self.core[0]]}, to_m = {[round(v, 3) for v in self.core[1]]}, radius_m = {self.thick} }}
"""

    def parameters(self, heeds, latched=True, restart=0, reaction=None):
        n = self.number
        return (f'"r{n}.middle" = {self.middle}\n"r{n}.swing" = {self.swing:.4f}\n"r{n}.begin" = {self.begin}\n"r{n}.period_ms" = {self.period}\n'
                f'"r{n}.reaction_ms" = {reaction or self.reaction}\n"r{n}.ramp_ms" = {self.ramp}\n"r{n}.restart_ms" = {restart}\n'
                f'"r{n}.heeds" = {heeds}\n"r{n}.latched" = {str(latched).lower()}\n')


def cell(name, seed, robots, parts, parameters, start, until, bends):
    bent = "" if bends else "bend_forward_deg = 0\nbend_lateral_deg = 0\n"
    return f"""schema = 1
name = "{name}"
fmu = "robots{2 + seed // 10 % 2}.fmu"
{"".join(r.text() for r in robots)}{parts}[human]
start = {{ xy_m = [{start[0]:.3f}, {start[1]:.3f}], heading_deg = {start[2]} }}
{bent}[search]
actions = {round(until / 0.2)}
[parameters]
{parameters}"""


def watched(rng, seed, kind):
    """Cells with a mat or a field around one robot: its size, or how late it stops."""
    fast = rng.random() < 0.3 and kind != "stop too late"
    bends = rng.random() < 0.5 and not fast and kind != "stop too late"
    robot = Robot(rng, 1, fast)
    what = "scanner_field" if kind == "field too short" or kind == "stop too late" and rng.random() < 0.5 else "mat"
    delay = rng.choice([0, 0, 20, 50])
    beyond = 1.35 if fast else 1.0 if bends else 0.35
    right = 1.6 * (robot.stop_s() + delay / 1000 + 0.06) + beyond + rng.uniform(0.02, 0.12)
    sides, late = [right] * 4, {}
    if kind == "stop too late":
        # The place of the flaw is the response time of the sensor or the reaction of the controller.
        more = rng.choice([400, 500, 600])
        late = {"delay": delay + more} if rng.random() < 0.5 else {"reaction": robot.reaction + more}
        bad = sides
    else:
        bad = list(sides)
        # The side at -y is where people come from in the cell file.
        for side in rng.choice([[1], [1, 2], [0, 1], [0, 1, 2, 3]]):
            bad[side] = rng.uniform(0.0, 0.1)
    until = rng.choice([1.0, 1.2, 1.4]) + (0.4 if fast and kind == "stop too late" else 0.0)
    start = (rng.uniform(-0.2, 0.2), -robot.ey - right - rng.uniform(0.15, 0.3), 90)
    if kind == "stop too late":
        until = max(until, round((right + 0.5) / 1.6 / 0.2 + 1.5) * 0.2)
        until = min(until, 2.0)

    def twin(which):
        flawed = which == "flawed"
        parts = sensor("zone", what, around(robot.ex, robot.ey, bad if flawed else sides), "s1", late.get("delay", delay) if flawed else delay)
        return cell(f"{seed}-{which}", seed, [robot], parts, robot.parameters(1, reaction=late.get("reaction") if flawed else None),
                    start, until, bends)
    return twin


def fenced(rng, seed, kind):
    """Cells with a fence: a gap in it, or too low."""
    low = kind == "fence too low"
    fast = low or rng.random() < 0.4
    bends = low or rng.random() < 0.3
    robot = Robot(rng, 1, fast, high=low)
    away = rng.uniform(0.08, 0.2) if low else rng.uniform(0.2, 0.5)
    fx, fy = robot.ex + away, robot.ey + away
    height = rng.uniform(0.75, 1.05)
    width = rng.uniform(0.55, 0.85)
    at = rng.uniform(-0.5, 0.5) * max(2 * fx - width, 0)
    gap = (max(at - width / 2, -fx), min(at + width / 2, fx))
    until = rng.choice([0.6, 0.8]) if low else rng.choice([0.8, 1.0, 1.2])
    start = (sum(gap) / 2 if not low else 0.0, -fy - rng.uniform(0.3, 0.45), 90)

    def twin(which):
        flawed = which == "flawed"
        parts = fence(fx, fy, height) if low and flawed else fence(fx, fy, opening=gap if flawed and not low else None)
        return cell(f"{seed}-{which}", seed, [robot], parts, robot.parameters(0), start, until, bends)
    return twin


def doors(rng, seed, kind):
    """A fence with an opening that a door or a strip of mat watches: it restarts by itself, or stops nothing."""
    robot = Robot(rng, 1, False)
    delay = rng.choice([0, 20, 40])
    reach = 1.6 * (robot.stop_s() + delay / 1000 + 0.06) + 0.45
    fx, fy = robot.ex + rng.uniform(0.25, 0.4), robot.ey + reach + rng.uniform(0.0, 0.1)
    half = min(rng.uniform(0.35, 0.45), fx)
    restart = rng.choice([0, 40, 100])
    strip = kind == "strip that restarts"
    until = rng.choice([1.4, 1.6, 2.0] if strip else [1.0, 1.2])
    depth = rng.uniform(0.3, 0.4)
    start = (0.0, -fy - (depth if strip else 0) - rng.uniform(0.3, 0.4), 90)

    def twin(which):
        flawed = which == "flawed"
        parts = fence(fx, fy, opening=(-half, half))
        if strip:
            parts += sensor("strip", "mat", rectangle(-half - 0.6, -fy - depth, half + 0.6, -fy + 0.05), "s1", delay)
        else:
            parts += sensor("door", "interlocked_door", [[-half, -fy - WALL / 2], [half, -fy - WALL / 2]], "s1", delay)
        dead = flawed and kind == "door not wired"
        again = flawed and not dead
        return cell(f"{seed}-{which}", seed, [robot], parts,
                    robot.parameters(0 if dead else 1, latched=not again, restart=restart if again else 0), start, until, False)
    return twin


def two(rng, seed, kind):
    """Two robots, each with a zone of its own that overlaps the other's; both have to heed both."""
    robots = [Robot(rng, 1, False, -0.6), Robot(rng, 2, False, 0.6)]
    ex = max(r.ex for r in robots)
    delay = rng.choice([0, 20, 40])
    right = 1.6 * (max(r.stop_s() for r in robots) + delay / 1000 + 0.06) + 0.35 + rng.uniform(0.02, 0.1)
    what = rng.choice(["mat", "scanner_field"])
    x, ends = ex + right, (-0.6 - robots[0].ey - right, 0.6 + robots[1].ey + right)
    until = rng.choice([1.0, 1.2, 1.4])
    start = (0.0, ends[1] + rng.uniform(0.15, 0.3), 270)
    heeds = rng.choice([0, 1])

    def twin(which):
        flawed = which == "flawed"
        parts = sensor("A", what, rectangle(-x, ends[0], x, 0.1), "s1", delay) + sensor("B", what, rectangle(-x, -0.1, x, ends[1]), "s2", delay)
        return cell(f"{seed}-{which}", seed, robots, parts, robots[0].parameters(3) + robots[1].parameters(heeds if flawed else 3), start, until, False)
    return twin


def slot(rng, seed, kind):
    """Two mats with floor between them that neither sees; or one overlaps the other."""
    robot = Robot(rng, 1, False)
    right = 1.6 * (robot.stop_s() + 0.06) + 0.35 + rng.uniform(0.02, 0.12)
    width = rng.uniform(0.26, 0.5)
    at = rng.uniform(-0.15, 0.15)
    x, y = robot.ex + right, robot.ey + right
    until = rng.choice([1.0, 1.2])
    start = (at, -y - rng.uniform(0.15, 0.3), 90)

    def twin(which):
        half = width / 2 if which == "flawed" else -0.05
        parts = sensor("left", "mat", rectangle(-x, -y, at - half, y), "s1", 0) + sensor("right", "mat", rectangle(at + half, -y, x, y), "s1", 0)
        return cell(f"{seed}-{which}", seed, [robot], parts, robot.parameters(1), start, until, False)
    return twin


MAKERS = [watched, watched, watched, fenced, fenced, doors, doors, doors, two, slot]


def from_farther(text, by):
    """The cell with people who begin so much farther away, and so much later, m: as far as that, changes leave room for them."""
    x, y, heading = (float(v) for v in re.search(r"xy_m = \[(\S+), (\S+)\], heading_deg = (\d+)", text).groups())
    text = text.replace(f"[{x:.3f}, {y:.3f}], heading", f"[{x:.3f}, {y + (by if heading == 270 else -by):.3f}], heading")
    actions = int(re.search(r"actions = (\d+)", text)[1])
    return text.replace(f"actions = {actions}", f"actions = {actions + math.ceil(by / 1.6 / 0.2)}")


def twins(seed):
    """Kind and both texts; the same seed gives the same."""
    rng = random.Random(f"random cells {seed}")
    kind = KINDS[seed % len(KINDS)]
    twin = MAKERS[seed % len(KINDS)](rng, seed, kind)
    return kind, twin("flawed"), twin("repaired")
