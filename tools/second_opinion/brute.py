"""Brute force against `fmi-hazard scan --from anywhere` in small cells.

    brute.py BINARY FOLDER CELL UNTIL_S [--grid-mm 8] [--headings 16] [--half-m 2] [--bends] [--told FILE]

People stand on a grid and go, in every communication step, to any grid point within 1.6 m/s x 20 ms, with any of so many headings, which
they may change before each step; they begin where no sensor reports them, joined to the edge of the grid by such places. Everything that
can be come to is kept: for each instant and each state of the FMU (and of what sensors' response times hold back) the set of grid points,
as bits of one large number. So each (history of the FMU, time, place, heading) that a walk on the grid can lead to is looked at, and
whether trunk, head or legs are hit too hard then.

That such a place is hazardous must be told by fmi-hazard: it lies in a cell of `floor`, or of `open_m`. What is not told is looked at
again 10 mm around, which is how deep a contact must be to be claimed; what remains is printed with a walk, whose FMU outputs a fresh
instance repeats. The exit code is then 1. Told as well is how far beyond hazardous grid points the cells of `floor` and `open_m` are.

Arms are not looked at: choose cells in which no arm can be hit too hard, or read only what is missed.
"""

import sys
import time
from pathlib import Path

import numpy as np

from toy import BENDS, STEP_S, WAY, Cell, Chain, Fmu, Person, Told, arguments, scan, surely_hit


class Grid:
    """Grid points, and sets of them as bits of a number; rows are padded, so that nothing comes round their ends."""

    def __init__(self, cell, spacing, half, headings):
        self.reach = int(WAY / spacing + 1e-9)
        n = int(half / spacing)
        # Not symmetrical about the axes: no point lies just on an edge that somebody wrote down.
        self.axis = (np.arange(-n, n + 1) + 0.3217) * spacing
        self.width = len(self.axis) + self.reach
        x, y = np.meshgrid(self.axis, self.axis)
        self.places = np.stack([x, y], -1)
        self.headings = (np.arange(headings) + 0.137) * 2 * np.pi / headings
        self.free = self.bits(cell.free(self.places))
        rows, columns = np.indices(x.shape)
        border = np.minimum(np.minimum(rows, columns), len(self.axis) - 1 - np.maximum(rows, columns)) == 0
        # For each heading the points at which somebody has such readings.
        self.with_readings = []
        flat = self.places.reshape(-1, 2)
        for heading in self.headings:
            told = cell.readings(flat, np.full(len(flat), heading)).reshape(*x.shape, len(cell.sensors))
            kinds = np.unique(told.reshape(-1, len(cell.sensors)), axis=0)
            self.with_readings.append({tuple(map(bool, k)): self.bits((told == k).all(-1)) & self.free for k in kinds})
        unseen = 0
        for sets in self.with_readings:
            unseen |= sets.get((False,) * len(cell.sensors), 0)
        self.start = unseen & self.bits(border)
        while (more := self.step(self.start) & unseen) != self.start:
            self.start = more

    def bits(self, mask):
        """A mask of the grid as a number."""
        padded = np.zeros((mask.shape[0], self.width), np.uint8)
        padded[:, : mask.shape[1]] = mask
        return int.from_bytes(np.packbits(padded.reshape(-1), bitorder="little").tobytes(), "little")

    def mask(self, bits):
        """A number as a mask of the grid."""
        n = len(self.axis)
        raw = bits.to_bytes((n * self.width + 7) // 8, "little")
        return np.unpackbits(np.frombuffer(raw, np.uint8), bitorder="little")[: n * self.width].reshape(n, self.width)[:, :n].astype(bool)

    def step(self, bits):
        """All that a step leads to."""
        if not bits:
            return 0
        runs = [bits]
        for k in range(1, self.reach + 1):
            runs.append(runs[-1] | bits << k | bits >> k)
        # Rows are cut before they are shifted up and down, else their ends would come round.
        runs = [run & self.free for run in runs]
        out = runs[self.reach]
        for up in range(1, self.reach + 1):
            run = runs[int(np.sqrt(self.reach**2 - up**2) + 1e-9)]
            out |= run << up * self.width | run >> up * self.width
        return out & self.free


def near(grid, links, by):
    """Grid points within so much of the robot, seen from above."""
    found = np.zeros(grid.places.shape[:2], bool)
    for c, d, thick, _, _ in links:
        c, d = c[:2], d[:2]
        way = (d - c) @ (d - c)
        t = np.clip(((grid.places - c) @ (d - c)) / (way or 1), 0, 1)
        found |= np.linalg.norm(grid.places - c - t[..., None] * (d - c), axis=-1) <= by + thick
    return found


def fastest(links):
    """No point of the links is faster."""
    return max(np.linalg.norm(v0 + np.cross(w, p)) + np.linalg.norm(w) * r for c, d, r, v0, w in links for p in (c, d))


def search(cell, chain, grid, until_s, postures, told_mask):
    """All harmful grid points, those of them that are not told with all that is known of them, and the sets by instant and state."""
    bodies = {name: Person(cell, name) for name in postures}
    # Head and throat have no safe speed, and are nowhere near the floor.
    low = all(max(c[2], d[2]) + thick < 1.2 for c, d, thick, _, _ in chain.links(chain.start))
    slowest = min(safe for safe in cell.safe.values() if safe > 1e-3 or not low)
    harmful = np.zeros(told_mask.shape, bool)
    levels, missed, looked, hits = [{chain.start: grid.start}], [], 0, 0
    for n in range(round(until_s / STEP_S)):
        new, landed = {}, {}
        for state, places in levels[-1].items():
            for heading, sets in enumerate(grid.with_readings):
                for reading, those in sets.items():
                    here = places & those
                    # "From the start" is who is not seen when the FMU starts.
                    if here and (n > 0 or not any(reading)):
                        after = chain.after(state, reading)
                        landed.setdefault(after, {}).setdefault(heading, {}).setdefault(here, None)
        for state, by_heading in landed.items():
            steps = {}
            for heading, sources in by_heading.items():
                union = 0
                for source in sources:
                    union |= source
                if union not in steps:
                    steps[union] = grid.step(union)
                by_heading[heading] = steps[union]
                new[state] = new.get(state, 0) | steps[union]
        levels.append(new)
        for state, by_heading in landed.items():
            links = chain.links(state)
            if fastest(links) <= slowest:
                continue
            there = grid.mask(new[state])
            for name, body in bodies.items():
                # Of places that are told and known to be harmful nothing more is asked.
                ask = near(grid, links, body.reach) & there & ~(harmful & told_mask)
                if not ask.any():
                    continue
                for heading, bits in by_heading.items():
                    k = np.argwhere(ask & grid.mask(bits))
                    if not len(k):
                        continue
                    angle = grid.headings[heading]
                    places = grid.places[k[:, 0], k[:, 1]]
                    hit = body.hit(places, np.full(len(k), angle), links)
                    looked, hits = looked + len(k), hits + int(hit.sum())
                    harmful[k[hit, 0], k[hit, 1]] = True
                    for row, column in k[hit]:
                        if not told_mask[row, column]:
                            missed.append((n + 1, state, heading, name, row, column))
    return harmful, missed, levels, looked, hits


def walk(cell, chain, grid, levels, n, state, heading, row, column):
    """A walk that ends there: of each step place, heading and reading."""
    place = (row, column)
    at = grid.places[place]
    steps = []
    for m in range(n - 1, -1, -1):
        one = np.zeros(grid.places.shape[:2], bool)
        one[place] = True
        around = grid.step(grid.bits(one))
        headings = [heading] if m == n - 1 else range(len(grid.headings))
        before = next(
            (earlier, h, reading, around & places & those)
            for earlier, places in levels[m].items() for h in headings
            for reading, those in grid.with_readings[h].items()
            if around & places & those and (m > 0 or not any(reading)) and chain.after(earlier, reading) == state)
        state, h, reading, from_here = before
        options = np.argwhere(grid.mask(from_here))
        place = tuple(options[np.abs(options - place).sum(1).argmin()])
        steps.append((m * STEP_S, *grid.places[place], np.degrees(grid.headings[h]), reading))
    return steps[::-1], at


def tightness(grid, harmful, told):
    """How far cells that are told are from harmful grid points."""
    hit = grid.places[harmful]
    for what, cells in (("floor", told.floor), ("open", told.open)):
        if not len(cells):
            print(f"  {what}: none")
            continue
        far = np.array([np.maximum(np.abs(hit - at) - told.half, 0) for at in cells]) if len(hit) else None
        far = np.linalg.norm(far, axis=-1).min(1) if far is not None else np.full(len(cells), np.inf)
        print(f"  {what}: {len(cells)} cells, {int((far == 0).sum())} with a harmful grid point in them; the others are "
              f"{1000 * far[far > 0].mean() if (far > 0).any() else 0:.0f} mm from one on average, {1000 * far.max():.0f} mm at most")


def main():
    parser = arguments(__doc__)
    parser.add_argument("--grid-mm", type=float, default=8)
    parser.add_argument("--headings", type=int, default=16)
    parser.add_argument("--half-m", type=float, default=2.0, help="the grid reaches so far from the origin")
    given = parser.parse_args()
    cell = Cell(given.cell)
    assert not (given.bends and cell.walls)
    folder = Path(given.folder) / Path(given.cell).stem
    folder.mkdir(parents=True, exist_ok=True)
    begun = time.time()
    told = Told(given.told or scan(given.binary, given.cell, max(given.until_s, 1.0), folder / "scan"))
    scanned = time.time()
    chain = Chain(Fmu(cell, folder / "fmu"), cell.delays)
    grid = Grid(cell, given.grid_mm / 1000, given.half_m, given.headings)
    kinds = sorted({r for sets in grid.with_readings for r in sets})
    merged = chain.merge(kinds, round(given.until_s / STEP_S))
    told_mask = told.holds(grid.places.reshape(-1, 2)).reshape(grid.places.shape[:2])
    postures = list(BENDS) if given.bends else ["upright"]
    harmful, missed, levels, looked, hits = search(cell, chain, grid, given.until_s, postures, told_mask)
    seen = [state for level in levels for state in level]
    print(f"{Path(given.cell).stem}: {told.verdict}, {len(told.hazards)} hazards, {len(told.floor)} cells of floor, {len(told.open)} open, "
          f"scan {scanned - begun:.0f} s, brute force {time.time() - scanned:.0f} s")
    print(f"  {len(levels) - 1} steps, {len(seen)} states{'' if merged else ' (not merged)'}, {sum(b.bit_count() for level in levels for b in level.values())} "
          f"(state, place) come to; {looked} poses near the robot looked at, {hits} harmful, at {int(harmful.sum())} places "
          f"({harmful.sum() * (given.grid_mm / 1000) ** 2:.3f} m2), {int((harmful & ~told_mask).sum())} of them not told")
    np.save(folder / "harmful.npy", grid.places[harmful])
    tightness(grid, harmful, told)
    sure = [m for m in missed if surely_hit(Person(cell, m[3]), grid.places[m[4], m[5]], grid.headings[m[2]], chain.links(m[1]))]
    if missed:
        print(f"  not told: {len(missed)} poses; harmful 10 mm around as well: {len(sure)}")
    for n, state, heading, name, row, column in sure[:3]:
        steps, at = walk(cell, chain, grid, levels, n, state, heading, row, column)
        history = [s[4] for s in steps]
        same = chain.fmu.plain(chain.delayed(history))[-1] == chain.fmu.values[chain.all[state][0]]
        print(f"  MISSED {name} at {at} after {n * STEP_S:.2f} s; a fresh FMU says the same: {same}")
        for s in steps:
            print(f"    {s[0]:.2f} s  ({s[1]:.4f}, {s[2]:.4f}) m  {s[3]:.1f} deg  {s[4]}")
    sys.exit(1 if sure else 0)


if __name__ == "__main__":
    main()
