"""Cells whose stops restart by themselves against the program: `run.py BINARY FOLDER --restarting`.

First both twins of all cells are searched by walks of many entries (walks.jsonl), then both are scanned from anywhere, one line of
restarting.jsonl a cell; where a scan asks for nothing but to accept what the FMU remembers, that is accepted and the cell is scanned again.
Refuted is "nobody" and a sure hit of a walk before the time until which was scanned. What controllers that count stops remember does not show
while nothing changes: a hit in a cell that was accepted all the same shows that to be wrong, not the answer. Both files may be ended and gone on with at any time.
"""

import json
import time

import fmu as fmus
from entries import Entries, searched
from people import Cell
from restarting import KINDS, UNTIL, twins
from run import accepted, told

# What may be accepted here: nothing about sensors that a robot ignores, or people who are alike.
NEEDS = {"changes", "memory_shows", "nearly_alike", "readings_alike"}


def lines(file):
    return {row["seed"]: row for row in map(json.loads, file.read_text().splitlines())} if file.exists() else {}


def kept(file, row):
    with file.open("a") as to:
        to.write(json.dumps(row) + "\n")


def written(folder, seed):
    """Both cell files."""
    kind, *texts = twins(seed)
    files = {which: folder / "cells" / f"{seed}-{which}.toml" for which in ("flawed", "repaired")}
    for file, text in zip(files.values(), texts):
        file.write_text(text)
    return kind, files


def walked(folder, seed, number):
    """Walks in both twins: two thirds until the time of the scan, a third for 10 s."""
    kind, files = written(folder, seed)
    row = {"seed": seed, "kind": kind, "fmi": Cell(files["flawed"]).fmi, "until_s": UNTIL, "twins": {}}
    for which, file in files.items():
        cell, begun = Cell(file), time.time()
        fmu = fmus.Fmu(folder / "fmu", cell.fmi, cell.parameters, [s["variable"] for s in cell.sensors], cell.step_s)
        found = searched(Entries(cell, fmu, UNTIL, 8000 + seed), [(2 * number // 3, UNTIL), (number // 3, 10.0)])
        fmu.close()
        row["twins"][which] = found | {"s": round(time.time() - begun, 1)}
    return row


def scanned(binary, folder, row, seconds):
    """Scans of both twins, and what walks say of the answers."""
    seed, result = row["seed"], row | {"scans": {}, "refuted": [], "later": [], "wrongly": []}
    for which, file in written(folder, seed)[1].items():
        out, walks = folder / "out" / f"{seed}-{which}", row["twins"][which]
        scans = {"anywhere": told(binary, file, "anywhere", UNTIL, seconds, out / "anywhere", False)}
        first = scans["anywhere"]
        if first.get("open") and len(first["accept"]) == len(first["open"]) and {o[0] for o in first["open"]} <= NEEDS:
            scans["accepted"] = told(binary, accepted(file, first["accept"]), "anywhere", UNTIL, seconds, out / "accepted", False)
        for name, scan in scans.items():
            if scan["exit"] == 0 and walks["first"]:
                where = "later" if walks["first"]["at_s"] > UNTIL else "wrongly" if name == "accepted" and '"r1.hears"' in file.read_text() else "refuted"
                result[where].append({"claim": f"{which}: {scan['headline']}", "scan": name, "walk": walks["first"]})
        result["scans"][which] = scans
    return result


def all_pairs(binary, folder, given):
    """Walks of all cells, then scans of all."""
    walks, results = folder / "walks.jsonl", folder / "restarting.jsonl"
    seeds, done = range(given.first, given.first + given.cells), lines(walks)
    for seed in seeds:
        if seed in done:
            continue
        done[seed] = row = walked(folder, seed, given.walks)
        kept(walks, row)
        f, r = row["twins"]["flawed"], row["twins"]["repaired"]
        first = f["first"] and (f["first"]["at_s"], f["first"]["entries"])
        print(f"{seed} {row['kind']}: flawed {f['hits']} hits, {f['sure']} sure, first {first}; repaired {r['hits']}, {r['sure']} sure, "
              f"{r['entries']} entries; {f['s'] + r['s']:.0f} s", flush=True)
    ready = lines(results)
    for seed in seeds if not given.walks_only else []:
        if seed in ready:
            continue
        begun = time.time()
        result = scanned(binary, folder, done[seed], given.time)
        result["s"] = round(time.time() - begun, 1)
        kept(results, result)
        codes = {which: [scan["exit"] for scan in scans.values()] for which, scans in result["scans"].items()}
        print(f"{seed} {result['kind']}: {codes}, refuted {len(result['refuted'])}; {result['s']} s", flush=True)


def table(folder):
    """The table of the book, and below it what somebody should look at."""
    walks, results = lines(folder / "walks.jsonl"), lines(folder / "restarting.jsonl")
    columns = ["flaw", "cells", "hit by walks", "scanned", "hazards told", "not shown", "said to be clean", "hit by walks", "scanned", "nobody",
               "with what is accepted", "hazards told", "not shown", "answers refuted"]
    print("Columns three to seven are of the flawed twins, those after them of the repaired ones.\n")
    print("| " + " | ".join(columns) + " |\n" + "|---" * len(columns) + "|")

    def row(name, seeds):
        of, scans = [walks[s]["twins"] for s in seeds], [results[s]["scans"] for s in seeds if s in results]
        last = {which: [list(s[which].values())[-1]["exit"] for s in scans] for which in ("flawed", "repaired")}
        at_once = sum(s["repaired"]["anywhere"]["exit"] == 0 for s in scans)
        cells = [name, len(of), sum(bool(t["flawed"]["sure"]) for t in of), len(scans), last["flawed"].count(1), last["flawed"].count(4),
                 last["flawed"].count(0), sum(bool(t["repaired"]["hits"]) for t in of), len(scans), at_once, last["repaired"].count(0) - at_once,
                 last["repaired"].count(1), last["repaired"].count(4), sum(len(results[s]["refuted"]) for s in seeds if s in results)]
        print("| " + " | ".join(map(str, cells)) + " |")

    for kind in KINDS:
        if of := [s for s in walks if walks[s]["kind"] == kind]:
            row(kind, of)
    row("**all**", list(walks))
    both = [t for w in walks.values() for t in w["twins"].values()]
    print(f"\n{sum(t['walks'] for t in both):,} walks of {sum(t['seconds'] for t in both) / 3600:.0f} hours in all, with {sum(t['entries'] for t in both):,} "
          f"entries, {max(t['most_entries'] for t in both)} at most in one; {sum(t['again'] for t in both)} whole histories came out the same in a fresh FMU.\n")
    remarks(walks, results)


def remarks(walks, results):
    """What is refuted or odd, one a line."""
    for seed, w in walks.items():
        for which, t in w["twins"].items():
            if bool(t["hits"]) != (which == "flawed"):
                print(f"  look at {seed} {which} ({w['kind']}): {t['hits']} hits, {t['sure']} sure")
    for seed, r in results.items():
        for word in ("refuted", "later", "wrongly"):
            for refuted in r.get(word, []):
                print(f"{word.upper()} {seed} {r['kind']}: {refuted['claim']}")
        for which, scans in r["scans"].items():
            code = list(scans.values())[-1]["exit"]
            if code not in (0, 1, 4) or code == {"flawed": 0, "repaired": 1}[which]:
                print(f"  look at {seed} {which} ({r['kind']}): exit {code}")
