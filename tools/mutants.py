#!/usr/bin/env python3
"""Cell files of the examples with one mistake each: does `check` end soon, and is a scan of them never falsely clean?

    tools/mutants.py FMI_HAZARD FOLDER [--number 1000] [--scans 100] [--seed 1] [--time 30s]

A mistake is a number that is scaled by 10, 57.3 or 1000, two coordinates that are exchanged, two names that are, or a line that is missing.
None may end `check` by a signal, take it over 10 s, or over 1 GB. Of some, flawed cells, a scan says what it finds: where it is exit
code 0 its mistake and what the result rests on are printed, to be read. FOLDER/mutants.jsonl has a line for each.
"""

import argparse
import json
import os
import random
import re
import subprocess
import sys
import time
from pathlib import Path

NUMBER = re.compile(r"(?<![\w.\"-])-?\d+(?:\.\d+)?(?![\w.\"])")
NAME = re.compile(r'"([^"\n]+)"')
MOST_S, MOST_MB = 10, 1000


def scaled(rng, lines):
    """A number is in another unit, or has its point elsewhere."""
    at = [(n, found) for n, line in enumerate(lines) for found in NUMBER.finditer(line.split("#")[0]) if "schema" not in line]
    n, found = rng.choice(at)
    by = rng.choice([10, 0.1, 57.3, 1 / 57.3, 1000, 0.001])
    value = float(found[0]) * by
    whole = found[0].lstrip("-").isdigit() and value == int(value)
    lines[n] = lines[n][: found.start()] + (str(int(value)) if whole else f"{value:.9g}") + lines[n][found.end():]
    return f"line {n + 1}: {found[0]} by {by:.4g}"


def exchanged_axes(rng, lines):
    """Two coordinates changed places."""
    at = [(n, found) for n, line in enumerate(lines) for found in re.finditer(r"\[(-?[\d.]+), (-?[\d.]+)(?:, (-?[\d.]+))?\]", line)]
    n, found = rng.choice(at)
    values = [value for value in found.groups() if value is not None]
    i, j = rng.sample(range(len(values)), 2)
    values[i], values[j] = values[j], values[i]
    lines[n] = lines[n][: found.start()] + "[" + ", ".join(values) + "]" + lines[n][found.end():]
    return f"line {n + 1}: {found[0]} with {i} and {j} exchanged"


def exchanged_names(rng, lines):
    """Two names, or variables, changed places."""
    at = [(n, found) for n, line in enumerate(lines) for found in NAME.finditer(line.split("#")[0])]
    (n, one), (m, other) = rng.sample(at, 2)
    lines[n] = lines[n].replace(f'"{one[1]}"', "\0", 1)
    lines[m] = lines[m].replace(f'"{other[1]}"', f'"{one[1]}"', 1)
    lines[n] = lines[n].replace("\0", f'"{other[1]}"', 1)
    return f"lines {n + 1} and {m + 1}: {one[1]} and {other[1]} exchanged"


def dropped(rng, lines):
    """A line is missing."""
    at = [n for n, line in enumerate(lines) if line.strip() and not line.startswith("#")]
    n = rng.choice(at)
    return f"line {n + 1} is missing: {lines.pop(n)}"


MISTAKES = [scaled, scaled, scaled, exchanged_axes, exchanged_names, dropped]


def run(command, seconds):
    """Exit code, what it said, how long it took and how much memory it had at most, MB."""
    begun = time.time()
    with open("said.txt", "w+", encoding="utf-8") as said:
        process = subprocess.Popen([str(c) for c in command], stdout=said, stderr=subprocess.STDOUT)
        while True:
            pid, status, used = os.wait4(process.pid, os.WNOHANG)
            if pid:
                break
            if time.time() - begun > seconds:
                process.kill()
            time.sleep(0.01)
        process.returncode = os.waitstatus_to_exitcode(status)
        said.seek(0)
        return process.returncode, said.read(), time.time() - begun, used.ru_maxrss / 1000


def rests_on(out):
    """What a clean result says that it rests on."""
    report = json.loads((out / "scan.json").read_text(encoding="utf-8"))
    found = [f'{one["need"]}: {one.get("figure") or one.get("why") or one.get("by")}' for one in report["obligations"]]
    return {"headline": report["headline"]["says"], "warnings": report["warnings"], "rests_on": found}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("folder", type=Path)
    parser.add_argument("--number", type=int, default=1000)
    parser.add_argument("--scans", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--time", default="30s")
    arguments = parser.parse_args()
    program, folder = str(Path(arguments.program).resolve()), arguments.folder.resolve()
    folder.mkdir(parents=True, exist_ok=True)
    os.chdir(folder)
    subprocess.run([program, "examples", "export", "examples"], check=True, capture_output=True)
    cells = sorted(Path("examples").glob("*/cell.toml")) + sorted(Path("examples").glob("*/fixed.toml"))
    rng = random.Random(arguments.seed)
    bad, counts, scans = [], {}, []
    with open("mutants.jsonl", "w", encoding="utf-8") as told:
        for number in range(arguments.number):
            cell = rng.choice(cells)
            lines = cell.read_text(encoding="utf-8").splitlines()
            mistake = None
            while mistake is None:
                try:
                    mistake = rng.choice(MISTAKES)(rng, lines)
                except (IndexError, ValueError):
                    # A short file has nothing of that kind.
                    continue
            file = cell.with_name(f"mutant-{number}.toml")
            file.write_text("\n".join(lines) + "\n", encoding="utf-8")
            code, words, seconds, memory = run([program, "check", file, "--svg", "mutant.svg"], 6 * MOST_S)
            counts[code] = counts.get(code, 0) + 1
            row = {"number": number, "cell": str(cell), "mistake": mistake, "code": code, "s": round(seconds, 2), "mb": round(memory)}
            if code < 0 or code > 4 or "panicked" in words or seconds > MOST_S or memory > MOST_MB:
                bad.append(row | {"said": words[-2000:]})
                print("BAD", bad[-1], flush=True)
            if cell.name == "cell.toml" and code == 0:
                scans.append((file, row))
            told.write(json.dumps(row) + "\n")
        print("check:", counts, "bad:", len(bad), flush=True)
        rng.shuffle(scans)
        clean, codes = [], {}
        for file, row in scans[: arguments.scans]:
            out = Path("out")
            code, words, seconds, memory = run([program, "scan", file, "--time", arguments.time, "--no-advice", "--quiet", "--out", out], 300)
            codes[code] = codes.get(code, 0) + 1
            row |= {"scan": code, "scan_s": round(seconds, 1)}
            if code < 0 or "panicked" in words:
                bad.append(row)
                print("BAD", row, words[-2000:], flush=True)
            if code == 0:
                clean.append(row | rests_on(out))
                print("CLEAN", json.dumps(clean[-1]), flush=True)
            told.write(json.dumps(row) + "\n")
        print("scan:", codes, "clean:", len(clean))
    sys.exit(1 if bad else 0)


if __name__ == "__main__":
    main()
