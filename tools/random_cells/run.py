"""Random cells against the program: what it says of each twin, and what an independent search of explicit walks meets.

    run.py BINARY FOLDER [--cells 100] [--first 0] [--walks 1500] [--time 60]
    run.py BINARY FOLDER --enough  what `explain --complete` calls enough, of flawed cells in which people begin 0.7 m farther away
    run.py BINARY FOLDER --restarting  stops that restart by themselves, and walks of many entries: see again.py
    run.py --table FOLDER          the table of the book, from what is in FOLDER/results.jsonl; with --restarting, of restarting.jsonl

Each cell is one line of results.jsonl; cells that have theirs are left out, so it may be ended and begun again at any time. Both twins are
scanned from anywhere and from the start. Each is searched by free walks (against what is said of anywhere) and by sequences of actions
(against what is said of the start). Refuted is: "nobody" (exit code 0 from anywhere) and a sure hit by a free walk; "complete, none"
(exit code 0 from the start) and one by a sequence; "fixed" (`compare`, `replay --changed`) and one by a sequence in the repaired twin; a change that is
said to be enough, where the changed cell is hit by a sequence or, with --enough, by a free walk. Where something can be accepted, the cell is accepted and scanned again.
"""

import argparse
import json
import re
import shutil
import subprocess
import sys
import time
from collections import Counter
from pathlib import Path

import fmu as fmus
from generate import KINDS, from_farther, twins
from people import Cell
from search import Search

# How much farther away people begin where changes are asked for, m.
FARTHER = 0.7
SLOW = {"fence too low", "door that restarts", "door not wired"}


def told(binary, cell, source, until, seconds, out, advice):
    """One scan: exit code, words, what is open."""
    shutil.rmtree(out, ignore_errors=True)
    command = ["nice", binary, "scan", cell, "--from", source, "--time", f"{seconds}s", "--quiet", "--out", out]
    command += ["--until", f"{until:.1f}s"] if source == "anywhere" else [] if advice else ["--no-advice"]
    begun = time.time()
    run = subprocess.run([str(c) for c in command], capture_output=True, text=True, timeout=900)
    result = {"exit": run.returncode, "s": round(time.time() - begun, 1)}
    file = Path(out) / "scan.json"
    if not file.exists():
        return result | {"error": (run.stdout + run.stderr)[-1500:]}
    scan = json.loads(file.read_text())
    result |= {"verdict": scan["verdict"], "headline": scan["headline"]["says"], "hazards": len(scan["hazards"]),
               "complete": (scan["certificate"] or {}).get("complete"), "warnings": scan["warnings"],
               "open": [[o["need"], o.get("about"), o["why"]] for o in scan["obligations"] if o["standing"] == "open"],
               "accept": [o["accept"] for o in scan["obligations"] if o["standing"] == "open" and o.get("accept")]}
    if advice:
        result["advice"] = [c | {"cause": cause["id"]} for cause in scan["causes"] for c in (cause.get("advice") or {"changes": []})["changes"]]
    return result


def walked(file, folder, until, seed, number, margin):
    """Free walks and sequences in a cell, in two rounds each: how many, how many hit, how many surely, the first sure one."""
    cell = Cell(file)
    fmu = fmus.Fmu(folder / "fmu", cell.fmi, cell.parameters, [s["variable"] for s in cell.sensors], cell.step_s)
    search, result = Search(cell, fmu, until, seed), {}
    number = number // 4 if cell.bends and cell.walls else number
    for name in ("free", "sequences"):
        begun = time.time()
        hits, records, last = getattr(search, name)(number)
        found = {"walks": number, "hits": len(hits), "sure": 0, "what": dict(Counter(h[3] for h in hits))}
        for hit in sorted(hits, key=lambda h: -h[2])[:40]:
            if search.sure(hit, records, last, margin[name]):
                found["sure"] += 1
                found.setdefault("first", search.told(hit, records, last))
        result[name] = found | {"s": round(time.time() - begun, 1)}
    fmu.close()
    return result


def changed(text, change):
    """The cell file with a change that is told in words; nothing where the words are not known."""
    if m := re.fullmatch(r"(?:zone of )(.+) ([\d.]+) m wider on every side", change):
        name, by = m[1], float(m[2])
        block = re.search(rf'name = "{re.escape(name)}"\nkind[^[]*?polygon_m = (\[\[.*?\]\])', text, re.S)
        corners = json.loads(block[1])
        xs, ys = [c[0] for c in corners], [c[1] for c in corners]
        wide = [[min(xs) - by, min(ys) - by], [max(xs) + by, min(ys) - by], [max(xs) + by, max(ys) + by], [min(xs) - by, max(ys) + by]]
        return text.replace(block[0], block[0].replace(block[1], json.dumps(wide)))
    if m := re.fullmatch(r"(R\d) ([\d.]+) m farther away, towards ([+-])([xy])", change):
        block = re.search(rf'name = "{m[1]}"\nbase = {{ xyz_m = (\[.*?\])', text)
        at = json.loads(block[1])
        at["xy".index(m[4])] += float(m[2]) * (1 if m[3] == "+" else -1)
        return text.replace(block[0], block[0].replace(block[1], json.dumps(at)))
    if m := re.fullmatch(r"(\w[\w ,]*) ([\d.]+) m higher", change):
        for name in re.split(r", | and ", m[1]):
            block = re.search(rf'name = "{re.escape(name)}"\ncentre_m = (\[.*?\])\nsize_m = (\[.*?\])', text)
            if not block:
                return None
            centre, size = json.loads(block[1]), json.loads(block[2])
            centre[2], size[2] = centre[2] + float(m[2]) / 2, size[2] + float(m[2])
            text = text.replace(block[0], f'name = "{name}"\ncentre_m = {json.dumps(centre)}\nsize_m = {json.dumps(size)}')
        return text
    if m := re.fullmatch(r"(.+) held once it has reported, until .*", change):
        return text.replace(f'name = "{m[1]}"\nkind', f'name = "{m[1]}"\nlatched = true\nkind')
    if m := re.fullmatch(r"a mat behind (.+), ([\d.]+) m deep, that reports by the same input", change):
        # All planes of these cells are at -y, and the robot is behind them.
        block = re.search(rf'\[\[sensor\]\]\nname = "{re.escape(m[1])}"\n[^\[]*?zone = .*\n', text)
        (x0, y), (x1, _) = json.loads(re.search(r"line_m = (\[\[.*?\]\])", block[0])[1])
        mat = block[0].replace(f'name = "{m[1]}"', f'name = "mat behind {m[1]}"').replace("interlocked_door", "mat")
        mat = re.sub(r"zone = .*", f"zone = {{ polygon_m = {[[x0, y], [x1, y], [x1, y + float(m[2])], [x0, y + float(m[2])]]} }}", mat)
        return text.replace(block[0], block[0] + mat)
    if m := re.search(r"\b(r\d\.\w+)\b.*?(?:to|instead of|=) ?([\d.]+|true|false)", change):
        line = re.search(rf'"{re.escape(m[1])}" = (\S+)', text)
        value = m[2]
        if m2 := re.search(r"([\d.]+|true|false)(?: \w+)? instead of", change):
            value = m2[1]
        return text.replace(line[0], f'"{m[1]}" = {value}') if line else None
    return None


def accepted(file, lines):
    """The cell with what can be accepted accepted."""
    text = "\n".join(lines)
    text = re.sub(r'^by = .*$', 'by = "random cells"', text, flags=re.M)
    text = re.sub(r'^because = .*$', 'because = "it is so in robots.c"', text, flags=re.M)
    other = file.with_name(file.stem + "-accepted.toml")
    other.write_text(file.read_text() + "\n" + text + "\n")
    return other


def claims(binary, first, second, cell):
    """What `compare` and `replay --changed` say of the hazards of the flawed twin, as they stand."""
    result = {}
    for name, command in (("compare", ["compare", first, second]), ("replay", ["replay", first, "--changed", cell])):
        run = subprocess.run([str(c) for c in [binary, *command, "--format", "json", "--quiet"]], capture_output=True, text=True, timeout=600)
        words = Counter(re.findall(r'"(?:change|result)": ?"(\w+)"', run.stdout))
        result[name] = {"exit": run.returncode, "words": dict(words)}
    return result


def advised(text, scan, folder, seed, until, number):
    """Each change that is said to be enough, applied and searched."""
    rows, tried = [], {}
    for advice in scan.get("advice", []):
        if not (advice["complete"] and advice["removes_all"]) or advice["change"] in tried:
            continue
        tried[advice["change"]] = row = {"change": advice["change"], "checked": advice["checked"], "enough_until_s": advice.get("enough_until_s")}
        rows.append(row)
        other = changed(text, advice["change"])
        if other is None:
            row["applied"] = False
            continue
        file = folder / "cells" / f"{seed}-advice-{len(rows)}.toml"
        file.write_text(other)
        row |= {"applied": True, **walked(file, folder, until, seed + 7000, number, {"free": 0.045, "sequences": 0.025})}
    return rows


def one(binary, folder, seed, number, seconds):
    """One cell."""
    kind, *texts = twins(seed)
    result = {"seed": seed, "kind": kind, "fmi": 2 + seed // 10 % 2, "twins": {}, "refuted": []}
    if kind in SLOW:
        seconds *= 2
    for which, text in zip(("flawed", "repaired"), texts):
        file = folder / "cells" / f"{seed}-{which}.toml"
        file.write_text(text)
        until = max(Cell(file).actions * 0.2, 1.0)
        out = folder / "out" / f"{seed}-{which}"
        twin = {"anywhere": told(binary, file, "anywhere", until, seconds, out / "anywhere", False),
                "start": told(binary, file, "start", until, min(seconds, 40), out / "start", which == "flawed"),
                **walked(file, folder, until, seed + (5000 if which == "flawed" else 6000), number, {"free": 0.045, "sequences": 0.025})}
        if twin["anywhere"].get("accept") and len(twin["anywhere"]["accept"]) == len(twin["anywhere"]["open"]):
            other = accepted(file, twin["anywhere"]["accept"])
            twin["accepted"] = told(binary, other, "anywhere", until, seconds, out / "accepted", False)
        for scan, walks in (("anywhere", "free"), ("accepted", "free"), ("start", "sequences")):
            if twin.get(scan, {}).get("exit") == 0 and twin[walks]["sure"]:
                result["refuted"].append({"claim": f"{which}: {twin[scan]['headline']}", "walk": twin[walks]["first"], "scan": scan})
        result["twins"][which], result["until_s"] = twin, until
    flawed, repaired = result["twins"]["flawed"], result["twins"]["repaired"]
    if flawed["start"].get("hazards"):
        out = folder / "out"
        result["fixed"] = claims(binary, out / f"{seed}-flawed/start", out / f"{seed}-repaired/start", folder / "cells" / f"{seed}-repaired.toml")
        if repaired["sequences"]["sure"] and any(c["words"].get("fixed") for c in result["fixed"].values()):
            result["refuted"].append({"claim": "fixed", "walk": repaired["sequences"]["first"]})
        result["advice"] = advised(texts[0], flawed["start"], folder, seed, result["until_s"], number)
        for row in result["advice"]:
            if row["applied"] and row["sequences"]["sure"]:
                result["refuted"].append({"claim": f"nothing left from the start: {row['change']}", "walk": row["sequences"]["first"]})
            if row["applied"] and row["enough_until_s"] and row["free"]["sure"] and row["free"]["first"]["at_s"] <= row["enough_until_s"]:
                result["refuted"].append({"claim": f"enough: {row['change']}", "walk": row["free"]["first"]})
    return result


def enough(binary, folder, seed, number, seconds):
    """What `explain` calls enough for the first cause of a flawed cell, from its start and from anywhere: applied, and searched by both."""
    kind, text, _ = twins(seed)
    text = from_farther(text, FARTHER)
    cell, out = folder / "cells" / f"{seed}-far.toml", folder / "out" / f"{seed}-far"
    cell.write_text(text)
    until = max(Cell(cell).actions * 0.2, 1.0)
    result = {"seed": seed, "kind": kind, "ended": True, "changes": []}
    if not told(binary, cell, "start", until, min(seconds, 60), out, False).get("hazards"):
        return result
    command = [binary, "explain", out, json.loads((out / "scan.json").read_text())["causes"][0]["id"], "--complete", "--until", f"{until:.1f}s", "--format", "json"]
    try:
        run = subprocess.run([str(c) for c in command], capture_output=True, text=True, timeout=seconds)
    except subprocess.TimeoutExpired:
        return result | {"ended": False}
    rows = result["changes"]
    for remedy in json.loads(run.stdout)["remedies"]:
        checked = remedy["outcome"].get("sufficient") if isinstance(remedy["outcome"], dict) else None
        if not checked or (checked.get("everywhere") or {"reasons": ["not looked at"]})["reasons"]:
            continue
        rows.append(row := {"change": remedy["change"], "one_less": checked["one_less"]})
        other = changed(text, remedy["change"])
        if other is None:
            continue
        file = folder / "cells" / f"{seed}-enough-{len(rows)}.toml"
        file.write_text(other)
        row |= walked(file, folder, until, seed + 9000, number, {"free": 0.045, "sequences": 0.025})
    return result


def all_enough(binary, folder, given):
    """The same of many, one a line of enough.jsonl; resumable."""
    kept = folder / "enough.jsonl"
    done = {json.loads(line)["seed"] for line in kept.read_text().splitlines()} if kept.exists() else set()
    for seed in range(given.first, given.first + given.cells):
        if seed in done:
            continue
        found = enough(binary, folder, seed, given.walks, 8 * given.time)
        with kept.open("a") as file:
            file.write(json.dumps(found) + "\n")
        hits = [(c["free"]["sure"], c["sequences"]["sure"]) if "free" in c else "not applied" for c in found["changes"]]
        print(f"{found['seed']} {found['kind']}: {'' if found['ended'] else 'not ended; '}{[c['change'] for c in found['changes']]} {hits}", flush=True)


def hit(twin):
    """Whether a walk or a sequence met harm."""
    return bool(twin["free"]["hits"] or twin["sequences"]["hits"])


def table(folder):
    """The table of the book, and below it what somebody should look at."""
    rows = [json.loads(line) for line in (folder / "results.jsonl").read_text().splitlines()]
    columns = ["flaw", "cells", "hit by walks", "hazards told", "not shown", "said to be clean", "hit by walks", "nobody, from anywhere",
               "with what is accepted", "not shown", "none, from the start", "answers refuted"]
    print("Columns three to six are of the flawed twins, those after them of the repaired ones.\n")
    print("| " + " | ".join(columns) + " |\n" + "|---" * len(columns) + "|")

    def exits(twins, scan, code):
        return sum(t.get(scan, {}).get("exit") == code for t in twins)

    def row(name, of):
        flawed, mended = [r["twins"]["flawed"] for r in of], [r["twins"]["repaired"] for r in of]
        found = sum(1 in (t["anywhere"]["exit"], t["start"]["exit"]) for t in flawed)
        clean = exits(flawed, "anywhere", 0)
        cells = [name, len(of), sum(map(hit, flawed)), found, len(of) - found - clean, clean, sum(map(hit, mended)), exits(mended, "anywhere", 0),
                 exits(mended, "accepted", 0), exits(mended, "anywhere", 4), exits(mended, "start", 0), sum(len(r["refuted"]) for r in of)]
        print("| " + " | ".join(map(str, cells)) + " |")

    for kind in KINDS:
        if of := [r for r in rows if r["kind"] == kind]:
            row(kind, of)
    row("**all**", rows)
    walks = sum(t[w]["walks"] for r in rows for t in r["twins"].values() for w in ("free", "sequences"))
    advice = [a for r in rows for a in r.get("advice", [])]
    applied = [a for a in advice if a["applied"]]
    kept = folder / "enough.jsonl"
    asked = [json.loads(line) for line in kept.read_text().splitlines()] if kept.exists() else []
    enough_of = [c for one in asked for c in one["changes"] if "free" in c]
    fixed = [r for r in rows if any(c["words"].get("fixed") for c in r.get("fixed", {}).values())]
    print(f"\n{walks:,} walks and sequences in all. Of {len(advice)} changes after which advice says that nothing is left from the start, {len(applied)} "
          f"were applied: a sequence from the start met harm after {sum(bool(a['sequences']['sure']) for a in applied)}, a walk from anywhere, of which "
          f"nothing is said then, after {sum(bool(a['free']['sure']) for a in applied)}. Of {len(asked)} cells explain was asked, too: {len(enough_of)} "
          f"changes are called enough, from anywhere as well; a walk or a sequence met harm after "
          f"{sum(bool(c['free']['sure'] or c['sequences']['sure']) for c in enough_of)} of them. "
          f"Hazards are said to be fixed in {len(fixed)} repaired twins: a sequence met harm in "
          f"{sum(bool(r['twins']['repaired']['sequences']['sure']) for r in fixed)} of them.\n")
    remarks(rows)


def remarks(rows):
    """What is refuted or odd, one a line."""
    for r in rows:
        for refuted in r["refuted"]:
            print(f"REFUTED {r['seed']} {r['kind']}: {refuted['claim']}")
        for a in r.get("advice", []):
            if not a["applied"]:
                print(f"  not applied {r['seed']}: {a['change']}")
        for which, t in r["twins"].items():
            codes = t["anywhere"]["exit"], t["start"]["exit"]
            wrong = which == "flawed" and (not hit(t) or codes[0] == 0) or which == "repaired" and (hit(t) or 1 in codes)
            if wrong or any(code not in (0, 1, 4) for code in codes):
                print(f"  look at {r['seed']} {which} ({r['kind']}): anywhere {codes[0]}, start {codes[1]}, walks {t['free']['hits']}, "
                      f"sequences {t['sequences']['hits']}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("binary", nargs="?")
    parser.add_argument("folder", type=Path)
    parser.add_argument("--cells", type=int, default=100)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--walks", type=int, default=1500)
    parser.add_argument("--time", type=int, default=60, help="longest time of a scan from anywhere, s; twice that for doors and low fences; 40 s at most from the start")
    parser.add_argument("--enough", action="store_true", help="what explain calls enough")
    parser.add_argument("--restarting", action="store_true", help="stops that restart by themselves")
    parser.add_argument("--walks-only", action="store_true", help="with --restarting: no scans")
    parser.add_argument("--table", action="store_true")
    given = parser.parse_args()
    folder = given.folder.resolve()
    if given.restarting:
        import again  # It needs this file.
    if given.table:
        return again.table(folder) if given.restarting else table(folder)
    binary = Path(given.binary).resolve()
    fmus.build(folder / "fmu")
    (folder / "cells").mkdir(exist_ok=True)
    for fmi in (2, 3):
        shutil.copy(folder / f"fmu/robots{fmi}.fmu", folder / "cells")
    if given.restarting:
        return again.all_pairs(binary, folder, given)
    if given.enough:
        return all_enough(binary, folder, given)
    results = folder / "results.jsonl"
    done = {json.loads(line)["seed"] for line in results.read_text().splitlines()} if results.exists() else set()
    for seed in range(given.first, given.first + given.cells):
        if seed in done:
            continue
        begun = time.time()
        result = one(binary, folder, seed, given.walks, given.time)
        result["s"] = round(time.time() - begun, 1)
        with results.open("a") as file:
            file.write(json.dumps(result) + "\n")
        f, r = result["twins"]["flawed"], result["twins"]["repaired"]
        print(f"{seed} {result['kind']}: flawed {f['anywhere']['exit']}/{f['start']['exit']}, hit {f['free']['hits']}/{f['sequences']['hits']}; repaired "
              f"{r['anywhere']['exit']}/{r['start']['exit']}, hit {r['free']['hits']}/{r['sequences']['hits']}; advice {len(result.get('advice', []))}; "
              f"refuted {len(result['refuted'])}; {result['s']} s", flush=True)
    return None


if __name__ == "__main__":
    sys.exit(main())
