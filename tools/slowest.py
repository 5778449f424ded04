"""What nextest's JUnit file says of a run: the slowest ten tests, for each that failed the command that runs it alone, and how many passed.

    tools/slowest.py target/nextest/default/junit.xml
"""

import os
import sys
import xml.etree.ElementTree as ElementTree


def alone(case):
    """The command that runs a test alone, with the cases of this run."""
    package, _, binary = case.get("classname", "").partition("::")
    kind, _, name = binary.rpartition("/")
    target = ["--lib"] if not binary else ["--bin" if kind == "bin" else "--test", name]
    sample = f"FMI_HAZARD_SAMPLE={os.environ.get('FMI_HAZARD_SAMPLE', '0')}"
    return " ".join([sample, "cargo test --package", package, *target, "-- --include-ignored --exact", case.get("name")])


def main():
    cases = list(ElementTree.parse(sys.argv[1]).getroot().iter("testcase"))
    seconds = {case: float(case.get("time", 0)) for case in cases}
    for case in sorted(cases, key=lambda case: -seconds[case])[:10]:
        print(f"{seconds[case]:6.1f} s  {case.get('name')}")
    print(f"{sum(seconds.values()):6.0f} s  in all {len(cases)}, one after the other")
    failed = [case for case in cases if case.find("failure") is not None or case.find("error") is not None]
    for case in failed:
        print(f"FAILED   {alone(case)}")
    print(f"{len(cases) - len(failed)} passed, {len(failed)} failed")


if __name__ == "__main__":
    main()
