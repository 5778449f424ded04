"""The independent search: explicit walks of many people at once, steered at what robots sweep, through openings and up to fences.

Two kinds of walks. *Free* ones go anywhere at up to 1.6 m/s, with any heading in each step, from floor to which a way leads unseen: what a
scan from anywhere speaks of. *Sequences* are made of the 36 actions of 0.2 s, from the start in the cell file: what a scan from the start
speaks of. Sensors are read from their bodies, and the FMU is stepped by FMPy with what they tell.

A hit is told with its walk. It is `sure` if body contacts stay ones wherever else within 10 mm, and those of arms if they are deeper, and
farther from obstacles, than a scan promises to find: only such a hit refutes an answer. The FMU's history of it is run again in a fresh
instance and has to give the same to the last bit.
"""

import heapq

import numpy as np

from people import HAND_SPEED, POSTURES, SPEED, Arms, People

SPACING = 0.05
WALKS = ["stop", "forward", "left45", "left90", "right45", "right90"]
TURNS = np.array([0, 0, 1, 2, -1, -2])


class Floor:
    """A lattice of places: where there is room, where people come from unseen, and how far it is from there to goals."""

    def __init__(self, cell, half=2.8):
        self.cell, self.half = cell, half
        n = int(2 * half / SPACING)
        self.axis = -half + (np.arange(n) + 0.5) * SPACING
        x, y = np.meshgrid(self.axis, self.axis, indexing="ij")
        self.places = np.stack([x, y], -1)
        flat = self.places.reshape(-1, 2)
        self.room = (cell.room(flat) >= 0.145).reshape(n, n)
        unseen = np.zeros(len(flat), bool)
        for heading in np.arange(8) * np.pi / 4:
            unseen |= ~People(cell, flat, np.full(len(flat), heading), np.zeros(len(flat), int)).readings().any(1)
        self.nobody = unseen.reshape(n, n) & self.room
        self.unseen = self.joined(self.nobody)

    def joined(self, mask):
        """What is joined to the edge of the lattice."""
        reached = np.zeros_like(mask)
        reached[[0, -1], :] = mask[[0, -1], :]
        reached[:, [0, -1]] = mask[:, [0, -1]]
        while True:
            more = reached.copy()
            more[1:] |= reached[:-1]
            more[:-1] |= reached[1:]
            more[:, 1:] |= reached[:, :-1]
            more[:, :-1] |= reached[:, 1:]
            more &= mask
            if (more == reached).all():
                return reached
            reached = more

    def joined_by(self, mask, times):
        """What is no more than so many cells from a mask."""
        for _ in range(times):
            more = mask.copy()
            more[1:] |= mask[:-1]
            more[:-1] |= mask[1:]
            more[:, 1:] |= mask[:, :-1]
            more[:, :-1] |= mask[:, 1:]
            mask = more
        return mask

    def index(self, places):
        return np.clip(((places + self.half) / SPACING).astype(int), 0, len(self.axis) - 1)

    def distance(self, goal):
        """How far it is to walk to a goal, m; where no way leads, as the crow flies and 100 m."""
        far = np.linalg.norm(self.places - goal, axis=-1) + 100.0
        begin = tuple(self.index(np.asarray(goal)))
        if not self.room[begin]:
            free = np.argwhere(self.room)
            begin = tuple(free[np.linalg.norm(self.places[tuple(free.T)] - goal, axis=1).argmin()])
        best, queue = {begin: 0.0}, [(0.0, begin)]
        n = len(self.axis)
        while queue:
            d, (i, j) = heapq.heappop(queue)
            if d > best[i, j]:
                continue
            far[i, j] = d
            for di in (-1, 0, 1):
                for dj in (-1, 0, 1):
                    k = (i + di, j + dj)
                    if (di or dj) and 0 <= k[0] < n and 0 <= k[1] < n and self.room[k]:
                        e = d + SPACING * (1.4142 if di and dj else 1)
                        if e < best.get(k, np.inf):
                            best[k] = e
                            heapq.heappush(queue, (e, k))
        return far


class Chain:
    """FMU and response times: what the FMU gets is what sensors told some steps ago."""

    def __init__(self, cell, fmu):
        self.cell, self.fmu = cell, fmu
        self.numbers, self.all, self.next, self.of = {}, [], {}, {}
        self.start = self.number(fmu.start, (tuple((False,) * d for d in cell.delays), (False,) * len(cell.delays)))

    def number(self, state, lines):
        if (state, lines) not in self.numbers:
            self.numbers[state, lines] = len(self.all)
            self.all.append((state, lines))
        return self.numbers[state, lines]

    def after(self, state, reading):
        if (state, reading) not in self.next:
            inner, (lines, held) = self.all[state]
            told = tuple(now or was for now, was in zip(reading, held))
            held = tuple(now and latched for now, latched in zip(told, self.cell.latched))
            lines = tuple(line + (now,) for line, now in zip(lines, told))
            after = self.fmu.after(inner, tuple(line[0] for line in lines))
            self.next[state, reading] = self.number(after, (tuple(line[1:] for line in lines), held))
        return self.next[state, reading]

    def delayed(self, history):
        """What the FMU gets of a history of readings."""
        latched = [[any(h[s] for h in history[: n + 1]) if self.cell.latched[s] else history[n][s] for s in range(len(self.cell.delays))]
                   for n in range(len(history))]
        history = latched
        return [tuple(history[n - d][s] if n >= d else False for s, d in enumerate(self.cell.delays)) for n in range(len(history))]

    def links(self, state):
        inner = self.all[state][0]
        if inner not in self.of:
            links = self.cell.links(self.fmu.values[inner])
            self.of[inner] = links, self.cell.fastest(links)
        return self.of[inner]


class Search:
    """Walks in one cell."""

    def __init__(self, cell, fmu, until_s, seed, goals=12):
        self.cell, self.chain, self.rng = cell, Chain(cell, fmu), np.random.default_rng(seed)
        self.steps, self.way = round(until_s / cell.step_s), SPEED * cell.step_s
        self.floor, self.arms = Floor(cell), Arms(self.rng)
        state, self.path = self.chain.start, []
        for _ in range(self.steps):
            state = self.chain.after(state, (False,) * len(cell.sensors))
            self.path.append([c[:2] + t * (d - c)[:2] for c, d, *_ in self.chain.links(state)[0] for t in (0.0, 0.5, 1.0)])
        self.path = np.array(self.path)
        self.goals = [self.path[self.rng.integers(self.steps), self.rng.integers(self.path.shape[1])] for _ in range(goals)]
        self.fields = np.array([self.floor.distance(goal) for goal in self.goals])
        self.goals = np.array(self.goals)
        self.swept = self.path.reshape(-1, 2).mean(0), np.ptp(self.path.reshape(-1, 2), axis=0).max() / 2 + 0.05
        self.deadly = cell.safe["upper arm"]

    def begin(self, number):
        """Who walks where: free walks; a third from the start in the cell file."""
        rng = self.rng
        self.goal = rng.integers(len(self.goals), size=number)
        unseen = np.argwhere(self.floor.unseen)
        at = np.empty((number, 2))
        for g in range(len(self.goals)):
            who = np.nonzero(self.goal == g)[0]
            far = self.fields[g][tuple(unseen.T)]
            far = np.where(far >= 100, far - 100, far)
            weight = np.where(far < SPEED * self.steps * self.cell.step_s + 0.2, 1.0, 1e-6) / (0.05 + far**1.5)
            pick = unseen[rng.choice(len(unseen), len(who), p=weight / weight.sum())]
            at[who] = self.floor.axis[pick] + rng.uniform(-0.02, 0.02, (len(who), 2))
        from_file = rng.random(number) < 0.33
        at[from_file] = self.cell.start[0]
        return at

    def away(self, at):
        """How far it is to their goals."""
        i = self.floor.index(at)
        far = self.fields[self.goal, i[:, 0], i[:, 1]]
        return np.where(far >= 100, far - 100, far)

    def onward(self, at, around=16):
        """Directions in which the goal comes nearest."""
        angles = np.arange(around) * 2 * np.pi / around + self.rng.uniform(0, 2 * np.pi / around)
        best, towards = np.full(len(at), np.inf), np.zeros(len(at))
        for angle in angles:
            there = at + 0.11 * np.array([np.cos(angle), np.sin(angle)])
            i = self.floor.index(there)
            far = np.where(self.floor.room[i[:, 0], i[:, 1]], self.fields[self.goal, i[:, 0], i[:, 1]], np.inf)
            towards, best = np.where(far < best, angle, towards), np.minimum(far, best)
        straight = self.goals[self.goal] - at
        near = (np.linalg.norm(straight, axis=1) < 0.2) | ~np.isfinite(best)
        return np.where(near, np.arctan2(straight[:, 1], straight[:, 0]), towards)

    def walk(self, at, way, angle):
        """Where they are after a step: around corners as far as there is room."""
        move = np.stack([np.cos(angle), np.sin(angle)], -1) * way[:, None] * (1 - 1e-9)
        stays = np.ones(len(at), bool)
        for part in ([1, 1], [1, 0], [0, 1]):
            there = at + move * part
            ok = stays & self.cell.free(there)
            at, stays = np.where(ok[:, None], there, at), stays & ~ok
        return at

    def free(self, number):
        """Free walks; the first hits."""
        rng, steps = self.rng, self.steps
        at = self.begin(number)
        kind = rng.integers(4, size=number)  # rush, meet, hesitate, in and out
        home = at.copy()
        wait = rng.integers(0, max(steps // 2, 1), number) * (rng.random(number) < 0.7)
        when = rng.integers(steps, size=number)
        wait = np.where(kind == 1, np.clip(when - self.away(at) / self.way, 0, steps), wait)
        flips = rng.integers(2, max(4, steps // 2), (number, 4)).cumsum(1)
        style = rng.integers(4, size=number)  # looks where they go, at the goal, sideways, anywhere
        bias = rng.normal(0, 0.15, number)
        heading = rng.uniform(0, 2 * np.pi, number)
        posture = np.zeros(number, int)
        pace = np.ones(number)

        def choose(n, at):
            nonlocal heading, posture, pace
            angle = self.onward(at) + bias
            back = (kind == 3) & (((n - wait)[:, None] >= flips).sum(1) % 2 == 1)
            homeward = home - at
            angle = np.where(back, np.arctan2(homeward[:, 1], homeward[:, 0]), angle)
            change = (kind == 2) & (rng.random(number) < 0.08)
            pace = np.where(change, rng.choice([0.0, 0.3, 1.0, 1.0], number), pace)
            way = np.where(n < wait, 0.0, self.way * pace)
            straight = self.goals[self.goal] - at
            looks = np.choose(style, [angle, np.arctan2(straight[:, 1], straight[:, 0]), angle + np.pi / 2, heading])
            heading = looks
            if self.cell.bends and n % 8 == 0:
                posture = np.where(rng.random(number) < 0.4, 0, rng.integers(len(POSTURES), size=number))
            return heading, posture, way, angle, True

        return self.run(at, choose, number, self.steps)

    def sequences(self, number):
        """Sequences of actions from the start in the cell file; the first hits."""
        rng, an_action = self.rng, round(0.2 / self.cell.step_s)
        self.goal = rng.integers(len(self.goals), size=number)
        at = np.repeat(self.cell.start[0][None], number, 0)
        eighths, going = np.zeros(number, int), np.zeros(number)
        posture = np.zeros(number, int)
        calm = rng.random(number) < 0.5

        def choose(n, at):
            nonlocal eighths, going, posture
            if n % an_action == 0:
                wanted = self.onward(at)
                now = self.cell.start[1] + (eighths[:, None] + TURNS) * np.pi / 4
                off = np.abs((now - wanted[:, None] + np.pi) % (2 * np.pi) - np.pi)
                off[:, 0] = 9
                action = np.where(rng.random(number) < 0.75, off.argmin(1), rng.integers(len(WALKS), size=number))
                action = np.where(calm & (rng.random(number) < 0.3), 0, action)
                eighths, going = eighths + TURNS[action], np.where(action == 0, 0.0, self.way)
                posture = np.where(rng.random(number) < 0.4, 0, rng.integers(len(POSTURES), size=number)) if self.cell.bends else posture
                going_on[:] = True
            angle = self.cell.start[1] + eighths * np.pi / 4
            there = at + np.stack([np.cos(angle), np.sin(angle)], -1) * going[:, None]
            going_on[~self.cell.free(there)] = False
            return angle, posture, np.where(going_on, going, 0.0), angle, False

        going_on = np.ones(number, bool)
        return self.run(at, choose, number, min(self.steps, an_action * self.cell.actions))

    def run(self, at, choose, number, steps):
        """Walks; of each person the first hit: (person, step, ratio, what), and all that was done."""
        cell, chain = self.cell, self.chain
        state, alive = np.full(number, chain.start), np.ones(number, bool)
        since = np.zeros(number, int)
        records, hits = [], []
        for n in range(steps):
            heading, posture, way, angle, slides = choose(n, at)
            people = People(cell, at, heading, posture if cell.planes else np.zeros(number, int))
            reading = people.readings()
            if n == 0:
                alive = ~reading.any(1) & cell.free(at)
            if cell.planes:
                since = np.where(since > 0, since + 1, reading[:, cell.planes[0]].astype(int))
            code = reading @ (1 << np.arange(len(cell.sensors))) if cell.sensors else np.zeros(number, int)
            pairs, which = np.unique(np.stack([state, code], 1), axis=0, return_inverse=True)
            after = [chain.after(int(s), tuple(bool(c >> b & 1) for b in range(len(cell.sensors)))) for s, c in pairs]
            state = np.array(after)[which.reshape(-1)]
            records.append((at.copy(), heading.copy(), posture.copy(), reading))
            if slides:
                at = self.walk(at, way, angle)
            else:
                at = at + np.stack([np.cos(angle), np.sin(angle)], -1) * way[:, None]
            for who, ratio, what in self.contacts(at, heading, posture, state, alive, since):
                alive[who] = False
                hits.append((int(who), n, ratio, what))
        return hits, records, at

    def gathered(self, states):
        """Links of many states as arrays over people."""
        kinds, which = np.unique(states, return_inverse=True)
        which = which.reshape(-1)
        all_of = [self.chain.links(int(s)) for s in kinds]
        links = []
        for k in range(len(self.cell.robots)):
            one = [of[0][k] for of in all_of]
            links.append((np.array([o[0] for o in one])[which], np.array([o[1] for o in one])[which], one[0][2],
                          np.array([o[3] for o in one])[which], np.array([o[4] for o in one])[which]))
        return links, np.array([of[1] for of in all_of])[which]

    def contacts(self, at, heading, posture, state, alive, since):
        """Who is hit now."""
        cell = self.cell
        near = np.nonzero(alive & (np.linalg.norm(at - self.swept[0], axis=1) < self.swept[1] + (1.9 if cell.bends else 1.3)))[0]
        if not len(near):
            return
        links, fastest = self.gathered(state[near])
        moving = fastest > (self.cell.slowest if not cell.bends else 1e-3)
        near, links = near[moving], [tuple(v[moving] if isinstance(v, np.ndarray) else v for v in link) for link in links]
        fastest = fastest[moving]
        most = 80 if cell.bends and cell.walls else 100_000
        if len(near) > most:
            pick = np.sort(self.rng.permutation(len(near))[:most])
            near, fastest, links = near[pick], fastest[pick], [tuple(v[pick] if isinstance(v, np.ndarray) else v for v in link) for link in links]
        if not len(near):
            return
        people = People(cell, at[near], heading[near], posture[near])
        depths = None
        if cell.planes:
            k = since[near]
            inside = People(cell, at[near], heading[near], posture[near]).readings()[:, cell.planes[0]]
            depths = np.where(inside, HAND_SPEED * (k + 1) * cell.step_s, np.inf)
        hit, worst = people.hit(links, depths)
        for k in np.nonzero(hit)[0]:
            yield near[k], float(worst[k]), "body"
        if cell.planes:
            return
        fast = np.nonzero(~hit & (fastest > self.deadly))[0]
        for k in self.rng.permutation(fast)[:8]:
            for link in links:
                one = tuple(v[k] if isinstance(v, np.ndarray) else v for v in link)
                found = self.arms.hits(people, k, one, 0.0, self.rng, 1500)
                if found:
                    yield near[k], found[1], found[0]
                    break

    def sure(self, hit, records, last, margin):
        """Whether a hit is one that no scan may miss; and the history of readings repeats itself in a fresh instance."""
        who, n, _, what = hit
        history = [tuple(map(bool, r[3][who])) for r in records[: n + 1]]
        state = self.chain.start
        for reading in history:
            state = self.chain.after(state, reading)
        plain = self.chain.fmu.plain(self.chain.delayed(history))[-1]
        assert plain == self.chain.fmu.values[self.chain.all[state][0]], "a fresh FMU does something else"
        place = records[n + 1][0][who] if n + 1 < len(records) else last[who]
        heading, posture = records[n][1][who], records[n][2][who]
        # The walk is one that people can walk: not seen at first, no faster than 1.6 m/s, room all along.
        ways = np.array([r[0][who] for r in records[: n + 1]] + [place])
        assert not any(history[0]) and self.cell.free(ways).all()
        assert np.linalg.norm(np.diff(ways, axis=0), axis=1).max() <= self.way + 1e-9
        links = self.chain.links(state)[0]
        if what == "body":
            around = np.array([place + r * np.array([np.cos(t), np.sin(t)])
                               for r in (0, 0.005, 0.0101) for t in np.linspace(0, 2 * np.pi, 32, endpoint=False)])
            people = People(self.cell, around, np.full(len(around), heading), np.full(len(around), posture))
            wide = [tuple(np.broadcast_to(v, (len(around), 3)) if isinstance(v, np.ndarray) else v for v in link) for link in links]
            depths = None
            if self.cell.planes:
                seen = [r[self.cell.planes[0]] for r in history]
                k = n + 1 - seen.index(True) if True in seen else 0
                # Who is near the plane may be in it: then what is deep does not count.
                y = self.cell.plane(self.cell.planes[0])[1]
                inside = np.abs(around[:, 1] - y) < (1.2 if self.cell.bends else 0.25)
                depths = np.where(inside, HAND_SPEED * (k + 1) * self.cell.step_s - 0.02, np.inf)
            return bool(people.hit(wide, depths)[0].all())
        people = People(self.cell, place[None], np.array([heading]), np.array([posture]))
        return any(self.arms.hits(people, 0, link, margin) for link in links)

    def told(self, hit, records, last):
        """A hit with its walk."""
        who, n, ratio, what = hit
        place = records[n + 1][0][who] if n + 1 < len(records) else last[who]
        steps = [[round(m * self.cell.step_s, 3), *np.round(r[0][who], 5).tolist(), round(float(np.degrees(r[1][who])) % 360, 3),
                  POSTURES[r[2][who]], r[3][who].astype(int).tolist()] for m, r in enumerate(records[: n + 1])]
        return {"at_s": round((n + 1) * self.cell.step_s, 3), "ratio": round(ratio, 3), "what": what, "place": np.round(place, 5).tolist(), "walk": steps}
