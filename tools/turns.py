"""The filter for nextest that leaves out the tests whose turn it is not, and how many they are: they are told as skipped, not as passed.

    tools/turns.py SAMPLE

The turns stand in the tests themselves, as `if !sample::is_turn(PLACE, OF)` in their first lines; see tests/sample.
"""

import re
import sys
from pathlib import Path

TURN = re.compile(r"fn (\w+)\(\) \{\s*if !sample::is_turn\((\d+), (\d+)\)")


def turns():
    """Each test that takes turns: its name, its place, and of how many."""
    suite = Path("tests/suite")
    roots = [Path("src"), *sorted(Path("crates").glob("*/src")), suite]
    for root, path in ((root, path) for root in roots for path in sorted(root.rglob("*.rs"))):
        text = path.read_text(encoding="utf-8")
        found = TURN.findall(text)
        if len(found) != text.count("sample::is_turn("):
            sys.exit(f"{path}: a turn that is not the first thing of a test")
        # Unit tests stand in the file that they are about, or beside it.
        module = "::".join(path.relative_to(root).with_suffix("").parts)
        module = module if root == suite else module.removesuffix("_tests") + "::tests"
        for name, place, of in found:
            yield f"{module}::{name}", int(place), int(of)


def main():
    sample = int(sys.argv[1])
    waiting = [name for name, place, of in turns() if sample % of != place]
    print(f"not ({' | '.join(f'test(={name})' for name in waiting)})")
    print(f"{len(waiting)} of {len(list(turns()))} tests that take turns wait for theirs", file=sys.stderr)


if __name__ == "__main__":
    main()
