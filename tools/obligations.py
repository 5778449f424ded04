#!/usr/bin/env python3
"""What the answers of the repaired examples rest on: the table in docs/src/verdicts.md.

    tools/obligations.py FMI_HAZARD             writes it (an hour)
    tools/obligations.py FMI_HAZARD --only mat  writes the lines of the examples whose names hold this, and keeps the others

Each example is scanned from its start and from anywhere; where all that is open can be accepted, once more with the lines that the
scan prints. FMI_HAZARD is the program.
"""

import argparse
import json
import pathlib
import shutil
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs" / "src" / "verdicts.md"
BEGIN, END = "<!-- obligations of the examples -->\n", "<!-- end of them -->\n"
UNTIL = "2s"
# Controls that are pressed at any moment lead to many more states: these take less time to look at, and more of them.
PRESSED = ("reset-inside", "reset-outside")
UNTIL_PRESSED = "1.6s"
STATES_PRESSED = "2000000"
TIME = "25m"


def scanned(program, folder, cell, more):
    """The verdict and the obligations of a scan."""
    out = folder / "out"
    shutil.rmtree(out, ignore_errors=True)
    words = [program, "scan", str(cell), "--no-advice", "--quiet", "--out", str(out), "--time", TIME, *more]
    ended = subprocess.run(words, capture_output=True, text=True, check=False)
    if not (out / "scan.json").exists():
        return "not looked for: it is refused" if ended.returncode == 2 else "no result", []
    report = json.loads((out / "scan.json").read_text(encoding="utf-8"))
    return report["verdict"], report["obligations"]


def is_open(one):
    """Whether it is not known."""
    return one["standing"] == "open"


def accepting(cell, obligations):
    """A cell file beside this one that accepts all that can be."""
    lines = "".join(one["accept"] + "\n" for one in obligations if is_open(one) and "accept" in one)
    lines = lines.replace('by = ""', 'by = "tools/obligations.py"').replace('because = ""', 'because = "for the table"')
    other = cell.with_name("accepting.toml")
    other.write_text(f'extends = "{cell.name}"\nname = "accepting"\n{lines}', encoding="utf-8")
    return other


def names(obligations):
    """What they are, each once."""
    return ", ".join(dict.fromkeys(one["need"].replace("_", " ") for one in obligations))


def answer(program, folder, cell, more):
    """What comes out, in a few words."""
    verdict, obligations = scanned(program, folder, cell, more)
    left = [one for one in obligations if is_open(one)]
    if verdict == "none_found":
        return "yes"
    if verdict != "inconclusive" or not left:
        return verdict.replace("_", " ")
    if all("accept" in one for one in left):
        again, _ = scanned(program, folder, accepting(cell, obligations), more)
        return f"with acceptance of: {names(left)}" if again == "none_found" else f"accepted, {again}: {names(left)}"
    return f"no: {names([one for one in left if 'accept' not in one])}"


def lines(program, only):
    """The name and the line of each example whose name holds `only`."""
    with tempfile.TemporaryDirectory() as made:
        folder = pathlib.Path(made)
        subprocess.run([program, "examples", "export", str(folder)], check=True, capture_output=True)
        for cell in sorted(folder.glob("*/fixed.toml")):
            if only in cell.parent.name:
                start = answer(program, folder, cell, ["--from", "start"])
                until, states, note = UNTIL, [], ""
                if cell.parent.name in PRESSED:
                    until, states = UNTIL_PRESSED, ["--max-states", STATES_PRESSED]
                    note = f", until {until}, {int(STATES_PRESSED):,} states"
                anywhere = answer(program, folder, cell, ["--from", "anywhere", "--until", until, *states])
                yield cell.parent.name, f"| {cell.parent.name} | {start} | {anywhere}{note} |"


def write(name, line):
    """Puts the line of an example into the table, in place of the one that it had."""
    head, rest = PAGE.read_text(encoding="utf-8").split(BEGIN)
    table, tail = rest.split(END)
    kept = {old.split("|")[1].strip(): old for old in table.splitlines()[2:]}
    kept[name] = line
    table = [f"| repaired example | from its start | from anywhere, {UNTIL} |", "|---|---|---|", *(kept[one] for one in sorted(kept))]
    PAGE.write_text(head + BEGIN + "\n".join(table) + "\n" + END + tail, encoding="utf-8")


def main():
    """Writes them, one after the other."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--only", default="")
    arguments = parser.parse_args()
    for name, line in lines(str(pathlib.Path(arguments.program).resolve()), arguments.only):
        print(line, flush=True)
        write(name, line)


if __name__ == "__main__":
    main()
