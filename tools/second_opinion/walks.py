"""Random walks against `fmi-hazard scan --from anywhere` in small cells.

    walks.py BINARY FOLDER CELL UNTIL_S [--walks 100000] [--seed 1] [--bends] [--told FILE]

People begin at random where no sensor reports them and to which a way leads unseen, and walk at any places and angles, no grid:

    wander   straight legs to random places at random speeds up to 1.6 m/s, with waits
    rush     wait near the edge of the zones, then straight to some place near the robot at 1.6 m/s
    in-out   rush in, back out, in again, turning at random moments
    edge     dance about the edge of the zones, then rush
    keen     rush to where the robot will be: a random point of its path, arriving when it does
    guided   rush from where a zone is nearest to a cell that fmi-hazard tells, or one beside it

Headings have nothing to do with where they walk, half of the time, and may change in every step. Sensors are read from the feet, and
the FMU is stepped by FMPy with what they tell, each (state, inputs) once; of a sample of the walks that end in harm the whole history is
run again in a fresh instance and compared to the last bit.

Each pose of trunk, head and legs in which somebody is hit too hard must lie in a cell of `floor` or `open_m`. What does not is looked at
10 mm around, printed, and the exit code is 1. How many poses were harmful is told, and how many of these while a sensor had reported
the person: without them nothing was tested.
"""

import sys
import time
from pathlib import Path

import numpy as np

from brute import Grid, fastest
from toy import BENDS, STEP_S, WAY, Cell, Chain, Fmu, Person, Told, arguments, scan, surely_hit

KINDS = ["wander", "rush", "in-out", "edge", "keen", "guided"]
BATCH = 20_000


class Walkers:
    """Where people want to go."""

    def __init__(self, rng, cell, chain, grid, told, steps, number):
        self.rng, self.cell, self.steps, self.number = rng, cell, steps, number
        self.kind = rng.integers(len(KINDS), size=number)
        corners = [p for s in cell.sensors for p in s["zone"]["polygon_m"]] or [(0, 0)]
        self.low, self.high = np.min(corners, 0), np.max(corners, 0)
        begin = grid.places[grid.mask(grid.start)]
        spacing = grid.axis[1] - grid.axis[0]
        # Half begin just outside of a zone, the others anywhere.
        mask = grid.mask(grid.start)
        seen = ~mask & grid.mask(grid.free)
        close = np.zeros_like(mask)
        far = int(0.12 / spacing)
        for up, right in ((0, far), (0, -far), (far, 0), (-far, 0)):
            close |= np.roll(seen, (up, right), (0, 1))
        close &= mask
        edge = grid.places[close] if close.any() else begin
        pick = np.where(rng.random(number)[:, None] < 0.5, begin[rng.integers(len(begin), size=number)],
                        edge[rng.integers(len(edge), size=number)])
        pick = np.where(np.isin(self.kind, [1, 2, 3, 4, 5])[:, None], edge[rng.integers(len(edge), size=number)], pick)
        self.at = pick + rng.uniform(-0.5, 0.5, (number, 2)) * spacing
        self.heading = rng.uniform(0, 2 * np.pi, number)
        self.turned = rng.choice([0, 0, np.pi / 2, -np.pi / 2, np.nan], number)
        self.restless = rng.random(number) < 0.3
        # What the robot does while it sees nobody: where somebody may want to meet it.
        state, path = chain.start, []
        for _ in range(steps):
            state = chain.after(state, (False,) * len(cell.sensors))
            links = chain.links(state)
            path.append([[(c + t * (d - c))[:2] for t in (0.3, 0.7, 1.0)] for c, d, _, _, _ in links])
        self.path = np.array(path).reshape(steps, -1, 2)
        when = rng.integers(steps, size=number)
        point = self.path[when, rng.integers(self.path.shape[1], size=number)]
        self.goal = point + rng.normal(0, 0.15, (number, 2))
        if len(told.all):
            beside = told.all[rng.integers(len(told.all), size=number)] + rng.uniform(-1.5, 1.5, (number, 2)) * told.half
            self.goal = np.where((self.kind == 5)[:, None], beside, self.goal)
        self.wait = rng.integers(0, steps, number)
        needs = np.linalg.norm(self.goal - self.at, axis=1) / WAY
        meet = np.maximum(when + rng.integers(-2, 12, number) - needs, 0)
        self.wait = np.where(self.kind == 4, meet, self.wait).astype(int)
        self.speed = np.where(self.kind == 0, rng.uniform(0.1, 1, number), 1.0)
        self.flips = rng.integers(1, max(2, steps // 2), (number, 3)).cumsum(1)
        self.home = self.at.copy()

    def step(self, n):
        """The headings of this step, and where people want to be at its end."""
        rng, kind = self.rng, self.kind
        # A new leg now and then.
        new = (kind == 0) & (rng.random(self.number) < 0.06)
        if new.any():
            self.goal[new] = rng.uniform(self.low - 0.5, self.high + 0.5, (int(new.sum()), 2))
            self.speed[new] = rng.choice([0, 1, 1], int(new.sum())) * rng.uniform(0.2, 1, int(new.sum()))
        goal = self.goal.copy()
        out = (kind == 2) & (((n - self.wait)[:, None] >= self.flips).sum(1) % 2 == 1)
        goal[out] = self.home[out]
        dance = (kind == 3) & (n < self.wait)
        goal[dance] = self.home[dance] + rng.normal(0, 0.15, (int(dance.sum()), 2))
        waits = (n < np.maximum(self.wait, 1)) & np.isin(kind, [1, 2, 4, 5])
        way = goal - self.at
        far = np.linalg.norm(way, axis=1)
        way *= (np.minimum(far, self.speed * WAY) / np.maximum(far, 1e-12))[:, None]
        way[waits] = 0
        towards = np.arctan2(way[:, 1], way[:, 0]) + self.turned
        restless = rng.uniform(0, 2 * np.pi, self.number)
        self.heading = np.where(np.isnan(self.turned) | waits, self.heading, towards)
        heading = np.where(self.restless, restless, self.heading)
        there = self.at + way * (1 - 1e-12)
        return heading, np.where(self.cell.free(there)[:, None], there, self.at)


def main():
    parser = arguments(__doc__)
    parser.add_argument("--walks", type=int, default=100_000)
    parser.add_argument("--seed", type=int, default=1)
    given = parser.parse_args()
    cell = Cell(given.cell)
    assert not (given.bends and cell.walls)
    folder = Path(given.folder) / Path(given.cell).stem
    folder.mkdir(parents=True, exist_ok=True)
    told = Told(given.told or scan(given.binary, given.cell, max(given.until_s, 1.0), folder / "scan"))
    begun = time.time()
    chain = Chain(Fmu(cell, folder / "fmu"), cell.delays)
    grid = Grid(cell, 0.016, 2.2, 16)
    readings = [tuple(bool(c >> b & 1) for b in range(len(cell.sensors))) for c in range(1 << len(cell.sensors))]
    chain.merge(readings, round(given.until_s / STEP_S), 30_000)
    rng = np.random.default_rng(given.seed)
    steps = round(given.until_s / STEP_S)
    bodies = {name: Person(cell, name) for name in (BENDS if given.bends else ["upright"])}
    low = all(max(c[2], d[2]) + thick < 1.2 for c, d, thick, _, _ in chain.links(chain.start))
    slowest = min(safe for safe in cell.safe.values() if safe > 1e-3 or not low)
    kinds = {kind: [0, 0, 0] for kind in KINDS}  # walks, harmful poses, of people whom a sensor had reported
    missed, again, walked, cells = [], 0, 0, set()
    for _ in range(-(-given.walks // BATCH)):
        people = Walkers(rng, cell, chain, grid, told, steps, min(BATCH, given.walks))
        state = np.full(people.number, chain.start)
        alive, seen = np.ones(people.number, bool), np.zeros(people.number, bool)
        records = []
        for n in range(steps):
            heading, there = people.step(n)
            reading = cell.readings(people.at, heading)
            for _ in range(8 if n == 0 else 0):
                # Who begins turns to where nobody sees them, if they can.
                seen_at_once = reading.any(1)
                heading = np.where(seen_at_once, rng.uniform(0, 2 * np.pi, people.number), heading)
                reading = cell.readings(people.at, heading)
            if n == 0:
                people.heading = np.where(np.isnan(people.turned), heading, people.heading)
                # Who is seen when the FMU starts is another matter.
                alive = ~reading.any(1) & cell.free(people.at)
            seen |= reading.any(1)
            code = reading @ (1 << np.arange(len(cell.sensors))) if len(cell.sensors) else np.zeros(people.number, int)
            pairs, which = np.unique(np.stack([state, code], 1), axis=0, return_inverse=True)
            after = np.array([chain.after(int(s), tuple(bool(c >> b & 1) for b in range(len(cell.sensors)))) for s, c in pairs])
            state = after[which.reshape(-1)]
            records.append((people.at.copy(), heading, reading))
            people.at = there
            walked += int(alive.sum())
            near = alive & (np.linalg.norm(people.at - people.path.mean((0, 1)), axis=1)
                            < np.ptp(people.path.reshape(-1, 2), axis=0).max() + max(b.reach for b in bodies.values()) + 0.1)
            for s in np.unique(state[near]):
                links = chain.links(int(s))
                if fastest(links) <= slowest:
                    continue
                k = np.nonzero(near & (state == s))[0]
                for name, body in bodies.items():
                    hit = k[body.hit(people.at[k], heading[k], links)]
                    if not len(hit):
                        continue
                    for kind in np.unique(people.kind[hit]):
                        kinds[KINDS[kind]][1] += int((people.kind[hit] == kind).sum())
                        kinds[KINDS[kind]][2] += int(seen[hit][people.kind[hit] == kind].sum())
                    cells.update(map(tuple, np.floor(people.at[hit] / 0.02).astype(int)))
                    history = [r[2] for r in records]
                    if again < 300:
                        one = [tuple(map(bool, r[hit[0]])) for r in history]
                        assert chain.fmu.plain(chain.delayed(one))[-1] == chain.fmu.values[chain.all[int(s)][0]]
                        again += 1
                    for person in hit[~told.holds(people.at[hit])]:
                        sure = surely_hit(body, people.at[person], heading[person], links)
                        missed.append((sure, name, n, people.at[person].copy(), [(r[0][person], r[1][person], r[2][person]) for r in records]))
        for number, kind in enumerate(KINDS):
            kinds[kind][0] += int((alive & (people.kind == number)).sum())
    sure = [m for m in missed if m[0]]
    total = np.array(list(kinds.values())).sum(0)
    print(f"{Path(given.cell).stem}: {told.verdict}, {len(told.floor)} cells of floor, {len(told.open)} open; {time.time() - begun:.0f} s")
    print(f"  {total[0]} walks, {walked} steps, {len(chain.all)} states of the FMU; {total[1]} harmful poses in {len(cells)} squares of 20 mm, "
          f"{total[2]} of them of people who had been seen; {again} histories run again by a fresh FMU, equal to the last bit")
    print("  walks, harmful, seen: " + ", ".join(f"{kind} {'/'.join(map(str, of))}" for kind, of in kinds.items()))
    print(f"  not told: {len(missed)} poses; harmful 10 mm around as well: {len(sure)}")
    for _, name, n, at, steps_of in sure[:3]:
        print(f"  MISSED {name} at {at} after {(n + 1) * STEP_S:.2f} s")
        for m, (place, heading, reading) in enumerate(steps_of):
            print(f"    {m * STEP_S:.2f} s  ({place[0]:.4f}, {place[1]:.4f}) m  {np.degrees(heading) % 360:.1f} deg  {tuple(map(bool, reading))}")
    sys.exit(1 if sure else 0)


if __name__ == "__main__":
    main()
