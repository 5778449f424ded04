#!/usr/bin/env python3
"""Other tools' searches on the example cells, beside this one's: the tables of peers in docs/src/figures.md.

    research/peers/compare.py [--programs target/release] [--seeds 20] [--iterations 320] [--cells ...] [--out peers.json]

Makes an environment of Python for each peer in target/peers, as they cannot all live in one, with the versions below, and starts
`one.py` in it. Prints three tables in Markdown: iterations until the first hazard, seconds until then, and the share of all hazards of
the cell that were met. All hazards are those of the complete search, which has a line of its own. `--out` keeps every run.
"""

import argparse
import concurrent.futures
import json
import os
import pathlib
import random
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
CELLS = ["safety-fence", "sensor-mat", "head-collision", "light-curtain", "two-scanners", "heavy-workpiece"]
OURS, TALIRO, VERIFAI, LEARNING = [], ["psy-taliro==3.2.0"], ["verifai==2.2.0"], ["stable-baselines3==2.9.2"]
PEERS = {
    "ours:hybrid": ("fmi-hazard, hybrid (its quick search)", OURS),
    "ours:mcts-dpw": ("fmi-hazard, mcts-dpw (the paper's method)", OURS),
    "ours:random": ("fmi-hazard, random", OURS),
    "uniform": ("Psi-TaLiRo, uniform", TALIRO),
    "uniform:tuned": ("Psi-TaLiRo, uniform, factored", TALIRO),
    "annealing": ("Psi-TaLiRo, dual annealing", TALIRO),
    "annealing:tuned": ("Psi-TaLiRo, dual annealing, factored", TALIRO),
    "halton": ("VerifAI, Halton", VERIFAI),
    "halton:tuned": ("VerifAI, Halton, factored", VERIFAI),
    "cross-entropy": ("VerifAI, cross-entropy", VERIFAI),
    "cross-entropy:tuned": ("VerifAI, cross-entropy, tuned", VERIFAI),
    "dqn": ("Stable-Baselines3, DQN", LEARNING),
    "dqn:tuned": ("Stable-Baselines3, DQN, tuned", LEARNING),
}


def environment(packages):
    """The Python of an environment with these packages."""
    name = "-".join(package.split("==")[0] for package in packages) or "none"
    folder = ROOT / "target" / "peers" / name
    python, stamp = folder / "bin" / "python", folder / "packages"
    wanted = "\n".join(packages)
    if not stamp.exists() or stamp.read_text() != wanted:
        subprocess.run([sys.executable, "-m", "venv", "--clear", folder], check=True)
        if packages:
            subprocess.run([python, "-m", "pip", "install", "--quiet", "--disable-pip-version-check", *packages], check=True)
        stamp.write_text(wanted)
    return python


def mean(values):
    return sum(values) / len(values)


def interval(values):
    """95 % of the means of samples drawn from these."""
    rng = random.Random(1)
    means = sorted(mean(rng.choices(values, k=len(values))) for _ in range(2000))
    return means[50], means[1949]


def told(values, form):
    low, high = interval(values)
    return f"{mean(values):{form}} [{low:{form}}, {high:{form}}]"


def table(title, rows, cells):
    lines = [f"| {title} | {' | '.join(cells)} |", "|---" * (len(cells) + 1) + "|"]
    return "\n".join([*lines, *(f"| {name} | {' | '.join(values)} |" for name, values in rows)]) + "\n"


def main():
    parser = argparse.ArgumentParser(description="Other tools' searches on the example cells, beside this one's.")
    parser.add_argument("--programs", type=pathlib.Path, default=ROOT / "target" / "release", help="folder with fmi-hazard and fmi-hazard-research")
    parser.add_argument("--seeds", type=int, default=20)
    parser.add_argument("--iterations", type=int, default=320)
    parser.add_argument("--cells", nargs="+", choices=CELLS, default=CELLS)
    parser.add_argument("--peers", nargs="+", choices=list(PEERS), default=list(PEERS))
    parser.add_argument("--workers", type=int, default=os.cpu_count())
    parser.add_argument("--out", type=pathlib.Path)
    own = parser.parse_args()
    pythons = {peer: environment(PEERS[peer][1]) for peer in own.peers}
    programs = own.programs.resolve()
    program = programs / "fmi-hazard"
    env = {**os.environ, "PATH": f"{programs}{os.pathsep}{os.environ['PATH']}", "PYTHONPATH": str(ROOT / "python")}

    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([program, "--quiet", "examples", "export", folder], check=True, stdout=subprocess.DEVNULL)
        every, took = {}, {}
        for cell in own.cells:
            began, out = time.monotonic(), pathlib.Path(folder, "out", cell)
            scan = [program, "-q", "scan", f"{folder}/{cell}/cell.toml", "--from", "start", "--strategy", "exhaustive", "--no-advice"]
            subprocess.run([*scan, "--out", out], stdout=subprocess.DEVNULL)
            took[cell] = time.monotonic() - began
            report = json.loads((out / "scan.json").read_text())
            assert report["certificate"]["complete"], cell
            every[cell] = {hazard["id"] for hazard in report["hazards"]}

        def run(peer, cell):
            words = [pythons[peer], HERE / "one.py", peer, f"{folder}/{cell}/cell.toml", "1", str(own.seeds), str(own.iterations)]
            done = subprocess.run(words, env=env, cwd=folder, capture_output=True, text=True)
            runs = [json.loads(line) for line in done.stdout.splitlines() if line.startswith("{")]
            if done.returncode != 0 or len(runs) != own.seeds:
                raise SystemExit(f"{peer} on {cell}: exit code {done.returncode}\n{done.stderr}")
            print(f"  {PEERS[peer][0]} on {cell}", file=sys.stderr, flush=True)
            return runs

        with concurrent.futures.ThreadPoolExecutor(own.workers) as executor:
            asked = {(peer, cell): executor.submit(run, peer, cell) for cell in own.cells for peer in own.peers}
            found = {key: future.result() for key, future in asked.items()}

    if own.out:
        kept = [{"peer": peer, "cell": cell, **one} for (peer, cell), runs in found.items() for one in runs]
        own.out.write_text(json.dumps({"all": {cell: sorted(ids) for cell, ids in every.items()}, "seconds": took, "runs": kept}))

    def rows(of):
        return [(PEERS[peer][0], [of(found[peer, cell], cell) for cell in own.cells]) for peer in own.peers]

    def first(runs, _):
        missed = sum(one["first"] is None for one in runs)
        text = told([one["first"] or own.iterations for one in runs], ".1f")
        return text + (f", {missed} missed" if missed else "")

    def seconds(runs, _):
        return told([one["seconds"] if one["first_s"] is None else one["first_s"] for one in runs], ".2f")

    def share(runs, cell):
        return told([100 * len(every[cell] & set(one["ids"])) / len(every[cell]) for one in runs], ".0f") + " %"

    complete = "fmi-hazard, every sequence"
    print(table("iterations until the first hazard", rows(first), own.cells))
    print(table("seconds until then", [*rows(seconds), (complete, [f"{took[cell]:.0f}" for cell in own.cells])], own.cells))
    ends = (complete, [f"100 % of {len(every[cell])}" for cell in own.cells])
    print(table(f"share of all hazards after {own.iterations} iterations", [*rows(share), ends], own.cells))


if __name__ == "__main__":
    main()
