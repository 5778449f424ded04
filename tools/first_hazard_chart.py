#!/usr/bin/env python3
"""Draws how many iterations each strategy needs to its first hazard, as one chart instead of a table for each cell.

    fmi-hazard bench paper --strategies mcts-dpw,hybrid,random --seeds 100 --format json > first-hazard.json
    tools/first_hazard_chart.py first-hazard.json docs/first-hazard.svg

Reads what `bench paper` or `fmi-hazard-research strategies` prints with `--format json`. The same figures give the same drawing.
"""

import html
import json
import math
import sys

# Mean iterations to the first hazard that the paper reports (its table I, ten seeds), as in src/strategies/paper.rs.
PAPER = {
    "safety-fence": {"random": 37.4, "mcts-dpw": 16.3},
    "sensor-mat": {"random": 203.4, "mcts-dpw": 131.6},
    "head-collision": {"random": 115.8, "mcts-dpw": 83.1},
    "light-curtain": {"random": 28.5, "mcts-dpw": 14.9},
    "two-scanners": {"random": 174.3, "mcts-dpw": 69.4},
    "heavy-workpiece": {"random": 71.1, "mcts-dpw": 24.6},
}

# From top to bottom in each cell: name in the figures, name in the legend, colour, mark. The colours differ in grey, too.
STRATEGIES = [
    ("random", "random", "#959ea8", "square"),
    ("mcts-dpw", "the paper's method (tree search)", "#b85600", "triangle"),
    ("hybrid", "ours (hybrid)", "#12306b", "circle"),
]

WIDTH = 700
LEFT, RIGHT = 156, 556  # Where the axis begins and ends.
HERE, THERE = 622, 680  # Where the columns of figures end: ours, those of the paper.
TOP = 112
LANE, GAP = 19, 17
TICKS = [1, 2, 5, 10, 20, 50, 100, 200]
INK, SOFT, LINE = "#1c2430", "#566273", "#d8dde4"


def read(path):
    """For each cell its name, seeds, budget, and by strategy the mean and the ends of its interval."""
    with open(path, encoding="utf-8") as file:
        cells = json.load(file)
    for cell in cells:
        rows = {}
        for row in cell["rows"]:
            if "iterations" in row:  # of `strategies`
                rows[row["strategy"]] = tuple(row["iterations"][key] for key in ("mean", "low", "high"))
            else:
                rows[row["strategy"]] = (row["mean"], *row["mean_interval"])
        first = cell["rows"][0]
        yield cell["cell"], len(first.get("first_hit") or first["runs"]), cell.get("budget") or cell["iterations"], rows


def text(x, y, words, size=13, colour=INK, anchor="start", extra=""):
    """A line of text."""
    words = html.escape(words, quote=False)
    return f'<text x="{x:.1f}" y="{y:.1f}" font-size="{size}" fill="{colour}" text-anchor="{anchor}"{extra}>{words}</text>'


def line(x1, y1, x2, y2, colour, width=1.0, extra=""):
    """A straight line."""
    return f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" stroke="{colour}" stroke-width="{width}"{extra}/>'


def mark(kind, x, y, colour):
    """The mark of a strategy, or the hollow diamond of the paper's own figure."""
    if kind == "circle":
        return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="5" fill="{colour}"/>'
    corners = {
        "square": [(-4.5, -4.5), (4.5, -4.5), (4.5, 4.5), (-4.5, 4.5)],
        "triangle": [(0, -5.5), (5.5, 4.5), (-5.5, 4.5)],
        "diamond": [(0, -6), (6, 0), (0, 6), (-6, 0)],
    }[kind]
    points = " ".join(f"{x + dx:.1f},{y + dy:.1f}" for dx, dy in corners)
    look = f'fill="none" stroke="{colour}" stroke-width="1.6"' if kind == "diamond" else f'fill="{colour}"'
    return f'<polygon points="{points}" {look}/>'


def draw(cells):
    """The drawing."""
    seeds = {seeds for _, seeds, _, _ in cells}
    budgets = {budget for _, _, budget, _ in cells}
    if len(seeds) != 1 or len(budgets) != 1:
        sys.exit("the cells differ in their seeds or budgets: one chart cannot say both")
    seeds, budget = seeds.pop(), budgets.pop()

    def across(value):
        return LEFT + (RIGHT - LEFT) * math.log(value) / math.log(budget)

    bottom = TOP + len(cells) * (len(STRATEGIES) * LANE + GAP)
    height = bottom + 82
    out = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" width="{WIDTH}" height="{height}" '
        f'role="img" aria-labelledby="title" font-family="system-ui, \'Segoe UI\', Helvetica, Arial, sans-serif">',
        '<title id="title">Iterations to the first hazard, by cell and strategy</title>',
        f'<rect width="{WIDTH}" height="{height}" rx="6" fill="#ffffff"/>',
        text(16, 30, "Iterations to the first hazard", 18, extra=' font-weight="600"'),
        text(16, 50, f"mean of {seeds} seeds, with 95 % interval; fewer is better; logarithmic", colour=SOFT),
    ]

    legend = [(kind, words, colour) for _, words, colour, kind in STRATEGIES] + [("diamond", "reported in the paper", INK)]
    for x, (kind, words, colour) in zip([22, 112, 366, 496], legend):
        out += [mark(kind, x, 73, colour), text(x + 12, 77.5, words)]
    out += [text(x, TOP - 13, words, colour=SOFT, anchor="end") for x, words in [(HERE, "here"), (THERE, "paper")]]
    for tick in [*(tick for tick in TICKS if tick < 0.8 * budget), budget]:
        at = across(tick)
        dashes = ' stroke-dasharray="4 3"' if tick == budget else ""
        out += [line(at, TOP - 8, at, bottom - 4, LINE if tick < budget else SOFT, extra=dashes)]
        out += [text(at, y, str(tick), colour=SOFT, anchor="middle") for y in (TOP - 13, bottom + 13)]

    y = TOP
    for number, (name, _, _, rows) in enumerate(cells):
        if number > 0:
            out.append(line(16, y - GAP / 2, THERE, y - GAP / 2, LINE))
        out.append(text(16, y + LANE * len(STRATEGIES) / 2 + 4.5, name, 14, extra=' font-weight="600"'))
        for strategy, _, colour, kind in STRATEGIES:
            middle = y + LANE / 2
            y += LANE
            if strategy not in rows:
                continue
            mean, low, high = rows[strategy]
            out.append(line(across(low), middle, across(high), middle, colour, 2.5))
            out += [line(across(end), middle - 4, across(end), middle + 4, colour, 2) for end in (low, high)]
            out += [mark(kind, across(mean), middle, colour), text(HERE, middle + 4.5, f"{mean:.1f}", anchor="end")]
            paper = PAPER.get(name, {}).get(strategy)
            if paper:
                out += [mark("diamond", across(paper), middle, INK), text(THERE, middle + 4.5, f"{paper:.1f}", colour=SOFT, anchor="end")]
        y += GAP

    notes = [
        f"A run without a hazard counts as its budget of {budget} iterations. An iteration is a sequence of up to eight actions.",
        "The paper's cells are not public; these follow its descriptions. Its figures are means of ten seeds.",
    ]
    out += [text(16, bottom + 42 + 19 * number, note, 12, SOFT) for number, note in enumerate(notes)]
    return "\n".join([*out, "</svg>", ""])


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    with open(sys.argv[2], "w", encoding="utf-8") as file:
        file.write(draw(list(read(sys.argv[1]))))


if __name__ == "__main__":
    main()
