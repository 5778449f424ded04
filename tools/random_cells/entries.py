"""Walks of many entries: in, out, in again, in cells whose stops restart by themselves.

Each person has a list of places to go to, and at each a reason to stay: for so long, until the robot stands, begins to go or goes as before.
Places are what the robot sweeps, floor before the edges of what sensors see, floor behind them on which nobody is seen, edges, and where
sensors see people. Some shuffle to and fro there, so that a sensor tells for a step or two at a time.

robots.c is computed here for all people at once, since each has a history of their own. What decides is FMPy: a hit is `sure` only if a
fresh FMU, given its readings, does so, and of each search some whole histories are run again and have to be the same.
"""

import numpy as np

from people import People
from search import SPACING, Search

LEGS = 24
# What to do at a place: stay for so long, until the robot stands, begins to go again, goes as before; or to turn on the way there, as soon as
# nobody is seen and the robot is about to go.
FOR, STANDS, BEGINS, GOES, CLEAR = range(5)


def distances(floor, goals):
    """How far it is to walk to each goal, m; where no way leads, as the crow flies and 100 m."""
    n, room = len(floor.axis), np.pad(floor.room, 1)
    far = np.full((len(goals), n + 2, n + 2), np.inf)
    free = np.argwhere(floor.room)
    for k, goal in enumerate(goals):
        i, j = free[np.linalg.norm(floor.axis[free] - goal, axis=1).argmin()] + 1
        far[k, i, j] = 0.0
    while True:
        less = far.copy()
        for axis in (1, 2):
            for by in (1, -1):
                np.minimum(less, np.roll(less, by, axis) + SPACING, out=less)
        for by in ((1, 1), (1, -1), (-1, 1), (-1, -1)):
            np.minimum(less, np.roll(far, by, (1, 2)) + SPACING * 2**0.5, out=less)
        less[:, ~room] = np.inf
        if (less == far).all():
            break
        far = less
    far = far[:, 1:-1, 1:-1]
    crow = np.linalg.norm(floor.places[None] - np.asarray(goals)[:, None, None], axis=-1)
    return np.where(np.isfinite(far), far, crow + 100.0)


class Drives:
    """robots.c for many people: whole numbers as there, one row a robot."""

    def __init__(self, cell, number):
        self.is_ = []
        for robot in cell.robots:
            r = robot["joint"][0]["speed"]["variable"][1]
            names = ("middle", "swing", "begin", "period_ms", "reaction_ms", "ramp_ms", "restart_ms", "heeds", "mutes", "mute_ms", "deaf_ms", "hears", "latched")
            self.is_.append({n: cell.parameters.get(f"r{r}.{n}", 0) for n in names})
        shape = (len(self.is_), number)
        self.progress, self.override = np.zeros(shape, np.int64), np.full(shape, 1000)
        self.wanted, self.free, self.muted, self.deaf, self.stops = (np.zeros(shape, int) for _ in range(5))
        self.tripped = np.zeros(shape, bool)

    def step(self, clear, milliseconds):
        """So long with inputs (M, 3)."""
        for r, p in enumerate(self.is_):
            wired = lambda mask: np.array([mask >> s & 1 for s in range(3)], bool)  # noqa: B023, E731
            first, others = ~clear[:, 0] & bool(p["heeds"] & 1), (~clear & wired(p["heeds"] & 6)).any(1)
            mutes, by = (~clear & wired(p["mutes"])).any(1), -(-1000 // p["ramp_ms"]) if p["ramp_ms"] else 1000
            for _ in range(milliseconds):
                self.muted[r] = np.where(mutes, np.minimum(self.muted[r] + 1, p["mute_ms"]), 0)
                seen = others | first & ~(mutes & (self.muted[r] < p["mute_ms"]))
                deaf = self.deaf[r] > 0
                self.deaf[r] -= deaf
                seen &= ~deaf
                if p["hears"]:
                    new = seen & ~self.tripped[r]
                    seen &= ~new | (self.stops[r] < p["hears"])
                    self.stops[r] += new & seen
                self.free[r] = np.where(seen, 0, np.minimum(self.free[r] + 1, p["restart_ms"]))
                goes = ~seen & self.tripped[r] & (self.free[r] >= p["restart_ms"]) & (not p["latched"])
                self.tripped[r] = (self.tripped[r] | seen) & ~goes
                self.deaf[r] = np.where(goes, p["deaf_ms"], self.deaf[r])
                self.wanted[r] = np.where(self.tripped[r], np.minimum(self.wanted[r] + 1, p["reaction_ms"]), 0)
                stops = self.tripped[r] & (self.wanted[r] >= p["reaction_ms"])
                self.override[r] = np.clip(self.override[r] + np.where(stops, -by, by), 0, 1000)
                self.progress[r] = (self.progress[r] + self.override[r]) % (p["period_ms"] * 1000)

    def outputs(self):
        """q and qd of each robot (M, 2 robots)."""
        rows = []
        for p, progress, override in zip(self.is_, self.progress, self.override):
            angle = 2 * np.pi * progress / (p["period_ms"] * 1000) + p["begin"]
            rate = 2 * np.pi * override / 1000 / (p["period_ms"] / 1000)
            rows += [p["middle"] + p["swing"] * np.sin(angle), p["swing"] * np.cos(angle) * rate]
        return np.stack(rows, -1)


class Entries(Search):
    """Walks of many entries in one cell."""

    def __init__(self, cell, fmu, until_s, seed):
        assert len(cell.planes) <= 1 and not any(cell.latched)
        super().__init__(cell, fmu, until_s, seed, goals=8)
        self.inputs = np.array([int(s["variable"][1]) - 1 for s in cell.sensors])
        self.places()

    def places(self):
        """Where people go: what is swept, and floor of each kind to which a way leads."""
        floor, rng = self.floor, self.rng
        outside = np.argwhere(floor.unseen)
        reached = distances(floor, [floor.places[tuple(outside[rng.integers(len(outside))])]])[0] < 100
        nobody, seen = floor.nobody & reached, reached & ~floor.nobody
        near_seen, near_nobody = floor.joined_by(seen, 2), floor.joined_by(nobody, 2)
        kinds = [floor.unseen & floor.joined_by(seen, 6), nobody & ~floor.unseen, nobody & near_seen, seen & near_nobody, seen]
        chosen, self.kinds = [self.goals], [np.arange(len(self.goals))]
        middle = np.linalg.norm(floor.places - self.swept[0], axis=-1)
        for mask, most in zip(kinds, (6, 8, 6, 6, 4)):
            # Near the robot rather than anywhere.
            cells = np.argwhere(mask & (middle < self.swept[1] + 2.0))
            weight = 1 / (0.2 + middle[tuple(cells.T)] ** 2)
            pick = cells[rng.choice(len(cells), min(most, len(cells)), False, weight / weight.sum())] if len(cells) else cells
            self.kinds.append(np.arange(len(pick)) + sum(map(len, chosen)))
            chosen.append(floor.axis[pick].reshape(-1, 2))
        self.goals = np.concatenate(chosen)
        self.fields = distances(floor, self.goals)

    def plans(self, number):
        """Lists of places with what to do there."""
        rng = self.rng
        swept, before, behind, edge, within, seen = self.kinds
        behind = behind if len(behind) else edge
        patterns = [[within, before, swept], [within, before] * 3 + [swept], [before, swept], [behind, swept], [before, within, before, within, swept],
                    [before, behind, swept], [behind, edge, swept], [edge, within, edge, within, swept], [before, seen, behind, swept],
                    [np.arange(len(self.goals))]]
        where = np.empty((number, LEGS), int)
        for k in range(number):
            pattern, near = patterns[rng.integers(len(patterns))], rng.random() < 0.6
            for leg, of in enumerate((pattern * LEGS)[:LEGS]):
                of = of if len(of) else edge if len(edge) else swept
                # Some step in and out at one place, others somewhere else each time.
                if near and leg % len(pattern):
                    where[k, leg] = of[np.linalg.norm(self.goals[of] - self.goals[where[k, leg - 1]], axis=1).argmin()]
                else:
                    where[k, leg] = rng.choice(of)
        shape, straight = (number, LEGS), rng.random((number, 1)) < 0.3
        why = np.where(rng.random(shape) < 0.6, FOR, rng.integers(4, size=shape))
        why = np.where(np.isin(where, before) & (rng.random(shape) < 0.5), CLEAR, why)
        stay = rng.choice([0, 1, 2, 4, 7, 10, 15, 30, 60, 150], shape, p=[0.2, 0.1, 0.1, 0.1, 0.1, 0.12, 0.1, 0.08, 0.06, 0.04])
        stay = np.where((why != FOR) & (rng.random(shape) < 0.7), 0, stay)
        shuffle = np.where(rng.random(shape) < 0.5, 0, rng.integers(1, 13, shape))
        pace = np.where(straight | (rng.random(shape) < 0.7), 1.0, rng.uniform(0.2, 1.0, shape))
        return where, why, stay, shuffle, pace

    def many(self, number, seconds):
        """Such walks; the first hit of each person, and all that was done."""
        rng, everybody = self.rng, np.arange(number)
        where, why, stay, shuffle, pace = self.plans(number)
        leg, stayed, stuck = np.zeros(number, int), np.full(number, -1), np.zeros(number, int)
        self.goal = where[:, 0]
        at = self.begin(number)
        before = at + 1.0
        wait = rng.integers(0, 100, number) * (rng.random(number) < 0.5)
        style, bias, sway = rng.integers(5, size=number), rng.normal(0, 0.1, number), rng.uniform(0, 2 * np.pi, number)

        def choose(n, at, seen, drives):
            nonlocal leg, stayed, stuck, before
            straight = self.goals[self.goal] - at
            far = np.linalg.norm(straight, axis=1)
            stuck = np.where(np.linalg.norm(at - before, axis=1) < 0.1 * self.way, stuck + 1, 0)
            before = at.copy()
            stayed = np.where(stayed >= 0, stayed + 1, np.where((far < 0.04) | (stuck > 12), 0, -1))
            least, reason = stay[everybody, leg], why[everybody, leg]
            override, tripped = drives.override[0], drives.tripped[0]
            begins = ~tripped & (override < 1000)
            ready = np.choose(reason, [np.ones(number, bool), override == 0, begins, ~tripped & (override == 1000), begins])
            onward = (stayed >= 0) & (n >= wait) & ((stayed >= least) & ready | (stayed > 150)) | (reason == CLEAR) & begins & ~seen
            leg, stayed, stuck = np.where(onward, (leg + 1) % LEGS, leg), np.where(onward, -1, stayed), np.where(onward, 0, stuck)
            self.goal = where[everybody, leg]
            angle, rhythm = self.onward(at) + bias * (far > 0.3), shuffle[everybody, leg]
            sways = (stayed >= 0) & (rhythm > 0)
            angle = np.where(sways, sway + np.pi * (n // np.maximum(rhythm, 1) % 2), angle)
            way = np.where(n < wait, 0.0, np.where(sways, self.way, np.where(stayed >= 0, 0.0, np.minimum(self.way * pace[everybody, leg], far))))
            looks = np.choose(style, [angle, np.arctan2(*straight.T[::-1]), angle + np.pi / 2, sway, rng.uniform(0, 2 * np.pi, number)])
            return way, angle, looks

        return self.go(at, choose, number, round(seconds / self.cell.step_s))

    def go(self, at, choose, number, steps):
        """Walks with a drive for each person; of each the first hit: (person, step, ratio, what), and all that was done. Where they go in a
        step may follow from what the robot does in it: any walk counts."""
        cell, drives, rng = self.cell, Drives(self.cell, number), self.rng
        heading, posture = rng.uniform(0, 2 * np.pi, number), np.zeros(number, int)
        alive, since, records, hits, self.outputs = np.ones(number, bool), np.zeros(number, int), [], [], []
        for n in range(steps):
            if cell.bends and n % 8 == 0:
                posture = np.where(rng.random(number) < 0.4, 0, rng.integers(6, size=number))
            reading = People(cell, at, heading, posture if cell.planes else np.zeros(number, int)).readings()
            if n == 0:
                alive = ~reading.any(1) & cell.free(at)
            if cell.planes:
                since = np.where(since > 0, since + 1, reading[:, cell.planes[0]].astype(int))
            records.append((at.copy(), heading.copy(), posture.copy(), reading))
            clear = np.ones((number, 3), bool)
            for k, (late, number_of) in enumerate(zip(cell.delays, self.inputs)):
                if n >= late:
                    clear[:, number_of] &= ~records[n - late][3][:, k]
            drives.step(clear, round(cell.step_s * 1000))
            self.outputs.append(drives.outputs())
            way, angle, looks = choose(n, at, reading.any(1), drives)
            at = self.walk(at, way, angle)
            for who, ratio, what in self.contacts(at, heading, posture, self.outputs[-1], alive, since):
                alive[who] = False
                hits.append((int(who), n, ratio, what))
            heading = looks
        self.begun = ~records[0][3].any(1) & cell.free(records[0][0])
        return hits, records, at

    def gathered(self, values):
        """Links of many outputs as arrays over people, and how fast they are."""
        links, fastest = [], np.zeros(len(values))
        for k, robot in enumerate(self.cell.robots):
            q, qd = values[:, 2 * k], values[:, 2 * k + 1]
            at, axis, capsule = np.array(robot["base"]["xyz_m"], float), np.array(robot["joint"][0]["axis"], float), robot["link"][0]["capsule"]
            ends = [np.array(capsule[e], float) for e in ("from_m", "to_m")]
            if "position" in robot["joint"][0]:
                c, d = (at + axis * q[:, None] + e for e in ends)
                v0, omega = axis * qd[:, None], np.zeros((len(q), 3))
            else:
                assert list(axis) == [0, 0, 1]
                cos, sin = np.cos(q), np.sin(q)
                c, d = (at + np.stack([cos * x - sin * y, sin * x + cos * y, np.full(len(q), z)], -1) for x, y, z in ends)
                omega = axis * qd[:, None]
                v0 = -np.cross(omega, at)
            links.append((c, d, capsule["radius_m"], v0, omega))
            ends = np.max([np.linalg.norm(v0 + np.cross(omega, p), axis=1) for p in (c, d)], 0)
            fastest = np.maximum(fastest, ends + np.linalg.norm(omega, axis=1) * capsule["radius_m"])
        return links, fastest

    def wanted(self, records, who, n):
        """The outputs of a fresh FMU after each step of a walk: they have to be those that were computed."""
        history = [tuple(map(bool, r[3][who])) for r in records[: n + 1]]
        plain = np.array(self.chain.fmu.plain(self.chain.delayed(history)))[:, : 2 * len(self.cell.robots)]
        told = np.array([values[who] for values in self.outputs[: n + 1]])
        assert np.abs(plain - told).max() < 1e-9, "the FMU does something else than what was computed"
        return plain

    def sure(self, hit, records, last, margin):
        self.wanted(records, hit[0], hit[1])
        return super().sure(hit, records, last, margin)

    def entries(self, records, who, n):
        """How often it is that a sensor begins to tell of somebody."""
        told = np.array([r[3][who].any() for r in records[: n + 1]])
        return int((told[1:] & ~told[:-1]).sum())


def searched(search, rounds, margin=0.045):
    """Rounds of (people, seconds): how many walk, hit, surely; entries; the first sure hit by time; histories that were run again."""
    found = {"walks": 0, "hits": 0, "sure": 0, "entries": 0, "most_entries": 0, "seconds": 0.0, "again": 0, "first": None}
    for number, seconds in rounds:
        hits, records, last = search.many(number, seconds)
        begun = np.nonzero(search.begun)[0]
        come = [search.entries(records, who, len(records) - 1) for who in begun]
        found["walks"] += len(begun)
        found["hits"] += len(hits)
        found["entries"] += sum(come)
        found["most_entries"] = max([found["most_entries"], *come])
        found["seconds"] += len(begun) * seconds
        for who in begun[:: max(len(begun) // 3, 1)][:3]:
            search.wanted(records, who, len(records) - 1)
            found["again"] += 1
        earliest, worst = sorted(hits, key=lambda h: h[1])[:12], sorted(hits, key=lambda h: -h[2])[:12]
        for hit in dict.fromkeys(earliest + worst):
            if search.sure(hit, records, last, margin):
                found["sure"] += 1
                if found["first"] is None or (hit[1] + 1) * search.cell.step_s < found["first"]["at_s"]:
                    found["first"] = search.told(hit, records, last) | {"entries": search.entries(records, hit[0], hit[1])}
    return found
