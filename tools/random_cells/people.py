"""What people do in the random cells, and what hits them: written from the method page of the book, sharing nothing with the program.

Many people at once, as arrays over people (M): places (M, 2), headings (M), postures (M). The measures of the body and the limits are those
of tools/second_opinion, which were written in the same way. Here are, besides: fences of any height, over which people bend and reach; bends
that end before an obstacle; doors; arms.
"""

import sys
import tomllib
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "second_opinion"))
from toy import BENDS, HIP, PARTS, REGIONS, ROOM, SPEED, in_polygon, turn  # noqa: E402

POSTURES = list(BENDS)
UPPER, FORE, HAND = 0.30, 0.32, 0.23
UPPER_RADIUS, FORE_RADIUS, ELBOW = 0.055, 0.045, 0.06
SHOULDER = np.array([0.0, 0.19, 0.48])
ARM_REGIONS = {"upper arm": (3, 30e3, 300), "lower arm": (2, 40e3, 320), "hand": (0.6, 75e3, 270)}
HAND_SPEED = 2.0


def nearest(a, b, c, d):
    """The nearest points of segments a-b and c-d, each (M, 3) or broadcast to it: on each, and how far."""
    u, v, w = b - a, d - c, a - c
    uu, uv, vv, uw, vw = (u * u).sum(-1), (u * v).sum(-1), (v * v).sum(-1), (u * w).sum(-1), (v * w).sum(-1)
    best = None
    with np.errstate(all="ignore"):
        det = uu * vv - uv * uv
        inside = np.where(det > 1e-12, np.clip((uv * vw - vv * uw) / det, 0, 1), 0)
        for s in (inside, np.zeros_like(det), np.ones_like(det), None, 1):
            if s is None or isinstance(s, int):
                t = np.full_like(det, 0.0 if s is None else 1.0)
                s = np.where(uu > 0, np.clip((t * uv - uw) / np.where(uu > 0, uu, 1), 0, 1), 0)
            else:
                t = np.where(vv > 0, np.clip((vw + s * uv) / np.where(vv > 0, vv, 1), 0, 1), 0)
            p, q = a + s[..., None] * u, c + t[..., None] * v
            far = ((p - q) ** 2).sum(-1)
            if best is None:
                best = [p, q, far]
            else:
                nearer = far < best[2]
                best = [np.where(nearer[..., None], p, best[0]), np.where(nearer[..., None], q, best[1]), np.where(nearer, far, best[2])]
    return best[0], best[1], np.sqrt(best[2])


def to_box(a, b, box, rounds=34):
    """How far segments a-b (..., 3) are from an upright box: the distance along a segment is convex."""
    middle, half = box
    low, high = np.zeros(a.shape[:-1]), np.ones(a.shape[:-1])

    def far(t):
        return np.linalg.norm(np.maximum(np.abs(a + t[..., None] * (b - a) - middle) - half, 0), axis=-1)

    for _ in range(rounds):
        third = (high - low) / 3
        left = far(low + third) <= far(high - third)
        high, low = np.where(left, high - third, high), np.where(left, low, low + third)
    return np.minimum(far((low + high) / 2), np.minimum(far(np.zeros_like(low)), far(np.ones_like(low))))


class Cell:
    """What is read of a cell file."""

    def __init__(self, path):
        self.path = Path(path)
        text = tomllib.loads(self.path.read_text())
        self.robots, self.fmi = text["robot"], int(text["fmu"][6])
        self.read(text)
        for middle, half in self.walls:
            assert middle[2] - half[2] <= 1e-3 and 2 * half[2] > 0.25
        self.planes = [k for k, s in enumerate(self.sensors) if s["kind"] in ("interlocked_door", "light_curtain")]
        self.limited(self.robots[0]["moving_mass_kg"] / 2 + self.robots[0]["payload_kg"])

    def read(self, text):
        """What is read of any cell."""
        self.name, self.sensors, self.parameters = text["name"], text.get("sensor", []), text.get("parameters", {})
        self.step_s = text.get("time", {}).get("step_s", 0.02)
        self.delays = [int(np.ceil(s.get("delay_ms", 0) / (self.step_s * 1000) - 1e-9)) for s in self.sensors]
        human = text["human"]
        self.angles = np.radians([human.get("bend_forward_deg", 45.0), human.get("bend_lateral_deg", 30.0)])
        self.bends = bool(self.angles.any())
        self.start = np.array(human["start"]["xy_m"], float), np.radians(human["start"]["heading_deg"])
        self.actions = text.get("search", {}).get("actions", 8)
        self.walls = [(np.array(box["centre_m"], float), np.array(box["size_m"], float) / 2) for box in text.get("obstacle", [])]
        self.latched = [s.get("latched", False) for s in self.sensors]

    def limited(self, mass):
        """The fastest that each region may be hit by an effective mass."""
        self.safe = {n: 1e-3 if g is None else g[2] / np.sqrt(g[1] / (1 / g[0] + 1 / mass)) for n, g in {**REGIONS, **ARM_REGIONS}.items()}
        self.slowest = min(v for n, v in self.safe.items() if v > 1e-3)

    def plane(self, k):
        """A door as a box without thickness, and the direction from front to behind; its ends are along x."""
        (x0, y0), (x1, y1) = self.sensors[k]["zone"]["line_m"]
        assert y0 == y1
        low, high = self.sensors[k]["zone"]["heights_m"]
        box = np.array([(x0 + x1) / 2, y0, (low + high) / 2]), np.array([abs(x1 - x0) / 2, 0.0, (high - low) / 2])
        return box, y0, 1.0 if self.start[0][1] < y0 else -1.0

    def free(self, places):
        """Where a person has room."""
        return self.room(places) >= ROOM + 1e-6

    def room(self, places):
        far = np.full(places.shape[:-1], np.inf)
        for middle, half in self.walls:
            far = np.minimum(far, np.linalg.norm(np.maximum(np.abs(places - middle[:2]) - half[:2], 0), axis=-1))
        return far

    def links(self, values):
        """Links of the robots: ends of the core, radius, velocity as (v0, omega): v = v0 + omega x p."""
        links = []
        for robot in self.robots:
            of = 2 * (int(robot["joint"][0]["speed"]["variable"][1]) - 1)
            q, qd = values[of], values[of + 1]
            at, axis, capsule = np.array(robot["base"]["xyz_m"], float), np.array(robot["joint"][0]["axis"], float), robot["link"][0]["capsule"]
            ends = [np.array(capsule[e], float) for e in ("from_m", "to_m")]
            if "position" in robot["joint"][0]:
                links.append((*(at + axis * q + e for e in ends), capsule["radius_m"], axis * qd, np.zeros(3)))
            else:
                links.append((*(at + turn(axis, q) @ e for e in ends), capsule["radius_m"], -np.cross(axis * qd, at), axis * qd))
        return links

    def fastest(self, links):
        return max(max(np.linalg.norm(v0 + np.cross(w, p)) for p in (c, d)) + np.linalg.norm(w) * r for c, d, r, v0, w in links)


class People:
    """Bodies at places, with headings and postures."""

    def __init__(self, cell, places, headings, postures):
        self.cell, self.places, self.number = cell, places, len(places)
        self.cos, self.sin = np.cos(headings), np.sin(headings)
        self.postures = postures
        self.share = np.full(len(places), 16)
        self.trunk = np.broadcast_to(np.eye(3), (len(places), 3, 3)).copy()
        bent = postures != 0
        if cell.bends and bent.any():
            self.trunk[bent] = self.bent(np.nonzero(bent)[0])

    @staticmethod
    def rotation(angles, posture, share):
        forward, left = np.array(list(BENDS.values())[posture]) * angles * share / 16
        return turn([1, 0, 0], -left) @ turn([0, 1, 0], forward)

    def world(self, points, who=slice(None)):
        """Points in the frame of the feet (m, 3) or (3,) in the world, of those people."""
        c, s, at = self.cos[who], self.sin[who], self.places[who]
        p = np.broadcast_to(points, (len(c), 3))
        return np.stack([at[:, 0] + c * p[:, 0] - s * p[:, 1], at[:, 1] + s * p[:, 0] + c * p[:, 1], p[:, 2]], -1)

    def of_trunk(self, point, who=slice(None), trunk=None):
        """A point of the trunk in the world."""
        return self.world(np.array([0, 0, HIP]) + (self.trunk[who] if trunk is None else trunk) @ np.asarray(point, float), who)

    def bent(self, who):
        """How the trunks of these people are turned: as far as obstacles leave room, in sixteenths."""
        found = np.empty((len(who), 3, 3))
        for posture in np.unique(self.postures[who]):
            k = np.nonzero(self.postures[who] == posture)[0]
            those = who[k]
            share = np.full(len(k), 16)
            near = self.cell.room(self.places[those]) < 1.2
            if near.any():
                share[near] = self.cut(those[near], posture)
            self.share[those] = share
            found[k] = np.array([self.rotation(self.cell.angles, posture, s) for s in range(17)])[share]
        return found

    def cut(self, who, posture):
        """The last sixteenth before the first at which head, neck, chest or one of three lines overlaps an obstacle."""
        shapes = [(a, b, r) for name, _, a, b, r in PARTS if name in ("head", "neck", "upper chest", "lower chest")]
        middle = (0, 0, SHOULDER[2])
        shapes += [(middle, SHOULDER, 0.0), (middle, SHOULDER * [1, -1, 1], 0.0), ((0, 0, 0), (0, 0, 0.72), 0.0)]
        share, rotations = np.full(len(who), 16), [self.rotation(self.cell.angles, posture, k) for k in range(17)]
        radius = np.array([r for _, _, r in shapes])[:, None]
        # Ends of (shape, sixteenth, person); the first sixteenth is upright.
        ends = [np.array([[self.of_trunk(shape[e], who, turned) for turned in rotations] for shape in shapes]) for e in (0, 1)]
        for wall in self.cell.walls:
            far = to_box(*ends, wall, 24)
            held = np.where((radius > 0) & (far[:, 0] - radius < -1e-9), 0.0, radius)[:, None]
            out = (far[:, 0] <= 0)[:, None]
            into = ~out & np.where(held > 0, far - held < -1e-9, far <= 0)
            first = into[:, 1:].any(0)
            share = np.minimum(share, np.where(first.any(0), first.argmax(0), 16))
        return share

    def part(self, part, who=slice(None)):
        """Both ends of the core of a part of the body."""
        _, of_trunk, a, b, _ = part
        return (self.of_trunk(a, who), self.of_trunk(b, who)) if of_trunk else (self.world(a, who), self.world(b, who))

    def readings(self):
        """What each sensor tells (M, sensors)."""
        left = np.stack([-self.sin, self.cos], -1) * 0.09
        told = np.zeros((self.number, len(self.cell.sensors)), bool)
        for k, sensor in enumerate(self.cell.sensors):
            if k in self.cell.planes:
                box, y, _ = self.cell.plane(k)
                near = np.nonzero(np.abs(self.places[:, 1] - y) < (1.2 if self.cell.bends else 0.3))[0]
                if len(near):
                    a, b = (np.array(ends) for ends in zip(*(self.part(part, near) for part in PARTS)))
                    told[near, k] = (to_box(a, b, box) <= np.array([[part[4]] for part in PARTS])).any(0)
            else:
                zone = sensor["zone"]["polygon_m"]
                told[:, k] = in_polygon(self.places + left, zone) | in_polygon(self.places - left, zone)
        return told

    def walled(self, a, b, radius, c, d):
        """Whether a wall keeps a part a-b from a link c-d."""
        kept = np.zeros(len(a), bool)
        for middle, half in self.cell.walls:
            across = int(np.argmin(half))
            others = [k for k in range(3) if k != across]
            sides = [np.sign(p[:, across] - middle[across]) for p in (a, b, c, d)]
            apart = (sides[0] == sides[1]) & (sides[2] == sides[3]) & (sides[0] == -sides[2])
            depth = np.minimum(np.abs(a[:, across] - middle[across]), np.abs(b[:, across] - middle[across]))
            circle = np.sqrt(np.maximum(radius**2 - depth**2, 0))
            within = np.ones(len(a), bool)
            for k in others:
                for p in (a, b):
                    within &= np.abs(p[:, k] - middle[k]) + circle <= half[k]
            kept |= apart & within
        return kept

    def hit(self, links, depths=None):
        """Which people are hit too hard at trunk, head or legs by links: lists of arrays over people. `depths`: how deep behind a plane a
        contact counts (M), for those who are in it."""
        hit = np.zeros(self.number, bool)
        worst = np.zeros(self.number)
        for part in PARTS:
            name, _, _, _, radius = part
            pa, pb = self.part(part)
            for c, d, thick, v0, omega in links:
                on_body, on_link, far = nearest(pa, pb, c, d)
                touch = np.nonzero((far <= radius + thick) & (far > 1e-6))[0]
                if not len(touch):
                    continue
                k = touch[~self.walled(pa[touch], pb[touch], radius, c[touch], d[touch])]
                n = (on_body[k] - on_link[k]) / far[k, None]
                point = on_link[k] + thick * n
                speed = np.linalg.norm(v0[k] + np.cross(omega[k], point), axis=-1)
                ratio = speed / self.limits(name, on_body[k] - radius * n, k)
                counts = ratio > 1 + 1e-9
                if depths is not None:
                    (_, y, side), limit = self.cell.plane(self.cell.planes[0]), depths[k]
                    counts &= side * (point[:, 1] - y) <= limit
                hit[k] |= counts
                worst[k] = np.where(counts, np.maximum(worst[k], ratio), worst[k])
        return hit, worst

    def limits(self, name, points, who):
        """The safe speed at points of the body's surface."""
        safe = self.cell.safe
        if name in ("pelvis", "thigh", "lower leg"):
            return np.full(len(points), safe[name])
        dx, dy = (points[:, :2] - self.places[who]).T
        c, s = self.cos[who], self.sin[who]
        own = np.stack([c * dx + s * dy, c * dy - s * dx, points[:, 2] - HIP], -1)
        x, y, z = np.einsum("mij,mi->mj", self.trunk[who], own).T
        if name == "head":
            return np.full(len(points), safe["face"])
        if name == "neck":
            return np.where(x >= 0, safe["throat"], safe["neck"])
        back = (x < 0) | ((np.abs(y) > 0.1445) if name == "upper chest" else False)
        return np.where(back, safe["back"], np.where(z >= 0.20, safe["chest"], safe["abdomen"]))


class Arms:
    """Random poses of arms within the limits of the joints, in the frame of the trunk."""

    def __init__(self, rng, number=20_000):
        a = np.radians(rng.uniform(-10, 170, number * 3))
        f, r = rng.uniform(-80, 180, number * 3), rng.uniform(-130, 180, number * 3)
        e = np.radians(rng.uniform(0, 150, number * 3))
        ad = np.degrees(a)
        fits = (f >= -60 + ad / 3) & (f <= 170 - ad / 6)
        fits &= (r >= -60 + 7 * ad / 9 - f / 9 + 2 * ad * f / 810) & (r <= 90 + 4 * ad / 9 - 5 * f / 9 + 5 * ad * f / 810)
        a, f, r, e = a[fits][:number], np.radians(f[fits][:number]), np.radians(r[fits][:number]), e[fits][:number]
        self.arms = []
        for m in (1, -1):
            upper = self.turned(0, m * a) @ self.turned(1, -f)
            fore = upper @ self.turned(2, -m * r) @ self.turned(1, -e)
            elbow = upper @ np.array([0, 0, -UPPER])
            self.arms.append((m, elbow, elbow + fore @ np.array([0, 0, -FORE])))

    @staticmethod
    def turned(axis, angles):
        """Rotations about x, y or z."""
        c, s = np.cos(angles), np.sin(angles)
        out = np.zeros((len(angles), 3, 3))
        i, j = [(1, 2), (2, 0), (0, 1)][axis]
        out[:, axis, axis] = 1
        out[:, i, i], out[:, j, j], out[:, i, j], out[:, j, i] = c, c, -s, s
        return out

    def hits(self, people, who, link, margin=0.0, rng=None, poses=4000):
        """Whether an arm of one person is hit too hard by a link, at least so deep and so far from obstacles; which part, and how hard."""
        cell, (c, d, thick, v0, omega) = people.cell, link
        one = np.array([who])
        best = None
        for m, elbows, wrists in self.arms:
            pick = rng.integers(len(elbows), size=min(poses, len(elbows))) if rng is not None else slice(None)
            shoulder = SHOULDER * [1, m, 1]
            joint, middle = people.of_trunk(shoulder, one), people.of_trunk((0, 0, SHOULDER[2]), one)
            if any(to_box(middle, joint, wall)[0] <= margin for wall in cell.walls):
                continue
            rotation = self.turned(2, np.array([np.arctan2(people.sin[who], people.cos[who])]))[0] @ people.trunk[who]
            elbow, wrist = joint + elbows[pick] @ rotation.T, joint + wrists[pick] @ rotation.T
            full = lambda p: np.broadcast_to(p, elbow.shape)
            for name, a, b, radius in (("hand", wrist, wrist, HAND), ("lower arm", elbow + (wrist - elbow) * ELBOW / FORE, wrist, FORE_RADIUS),
                                       ("upper arm", full(joint), elbow, UPPER_RADIUS)):
                on_arm, on_link, far = nearest(a, b, full(c), full(d))
                k = np.nonzero((far <= radius + thick - margin) & (far > thick + 1e-3))[0]
                if not len(k):
                    continue
                point = on_link[k] + (on_arm[k] - on_link[k]) * (thick / far[k])[:, None]
                ratio = np.linalg.norm(v0 + np.cross(omega, point), axis=-1) / cell.safe[name]
                keep = np.argsort(-ratio)[:60]
                keep = keep[ratio[keep] > 1 + 1e-9]
                for i in keep if not cell.walls else self.unwalled(cell, keep, k, joint, elbow, wrist, point, name, margin):
                    if best is None or ratio[i] > best[1]:
                        best = (name, float(ratio[i]), float(radius + thick - far[k[i]]))
                    break
        return best

    @staticmethod
    def unwalled(cell, keep, k, joint, elbow, wrist, point, name, margin):
        """Which of these poses are free of obstacles."""
        if not len(keep):
            return keep
        e, w, p = elbow[k[keep]], wrist[k[keep]], point[keep]
        j = np.broadcast_to(joint, e.shape)
        free = np.ones(len(keep), bool)
        for wall in cell.walls:
            free &= to_box(j, e, wall) > margin
            free &= to_box(j + (e - j) * 0.075 / UPPER, e, wall) >= UPPER_RADIUS + margin
            free &= to_box(e, w, wall) >= FORE_RADIUS + margin
            if name == "hand":
                free &= to_box(w, p, wall) > margin
        return keep[free]
