"""Reads the results of a scan with readers that this project did not write, and compares them with scan.json.

    tools/check_formats.py out/cell --scan-schema scan.schema.json --sarif-schema sarif-schema-2.1.0.json --fmu cell.fmu

jsonschema validates scan.json against the published schema and hazards.sarif against that of OASIS, pandas reads
hazards.csv, junitparser reads junit.xml, and FMPy simulates the FMU with each hazard's inputs and compares the outputs, which must have the same bits. Exit code 1:
problems found.
"""

import argparse
import json
import pathlib

import jsonschema
import numpy
import pandas
from fmpy import simulate_fmu
from fmpy.util import read_csv
from junitparser import Error, Failure, JUnitXml, Skipped


def check_scan(scan, schema):
    schema = json.loads(pathlib.Path(schema).read_text(encoding="utf-8"))
    # Everything that is written must be described, too.
    close(schema)
    validator = jsonschema.validators.validator_for(schema)
    validator.check_schema(schema)
    problems = [f"{list(error.path)}: {error.message}" for error in validator(schema).iter_errors(scan)]
    assert not problems, problems
    return "valid"


def close(schema, is_part=False):
    if isinstance(schema, dict):
        has_variants = "properties" in schema and "oneOf" in schema
        if "properties" in schema and not is_part:
            schema.setdefault("unevaluatedProperties" if has_variants else "additionalProperties", False)
        for key, part in schema.items():
            # What variants add is what the whole may have.
            close(part, has_variants and key == "oneOf")
    elif isinstance(schema, list):
        for part in schema:
            close(part, is_part)


def check_csv(folder, scan):
    table = pandas.read_csv(folder / "hazards.csv")
    hazards = scan["hazards"]
    assert list(table["id"]) == [hazard["id"] for hazard in hazards]
    # Estimation follows identification, reduction follows estimation.
    order = ["id", "hazard", "body_region", "force_n", "ratio", "severity", "exposure", "avoidance", "measure"]
    order += ["residual_risk", "decision"]
    places = [table.columns.get_loc(name) for name in order]
    assert places == sorted(places), places
    # As many digits as mean something: half of the last one is lost.
    half = lambda digits: 0.500001 * 10**-digits
    near = lambda column, values, digits: all(abs(a - b) <= half(digits) for a, b in zip(table[column], values))
    columns = {"force_n": 0, "limit_n": 0, "ratio": 2, "speed_m_s": 2, "safe_below_m_s": 2, "time_s": 2, "times_found": 0}
    for name, digits in columns.items():
        assert near(name, [hazard[name] for hazard in hazards], digits), name
    for axis, name in enumerate(["person_x_m", "person_y_m"]):
        assert near(name, [hazard["person_xy_m"][axis] for hazard in hazards], 3), name
    causes = pandas.read_csv(folder / "causes.csv")
    assert list(causes["id"]) == [cause["id"] for cause in scan["causes"]]
    assert list(causes["hazards"]) == [len(cause["hazards"]) for cause in scan["causes"]]
    # Each hazard is of one cause, which lists it.
    for cause in scan["causes"]:
        assert sorted(table["id"][table["cause"] == cause["id"]]) == sorted(cause["hazards"]), cause["id"]
    assert sum(len(cause["hazards"]) for cause in scan["causes"]) == len(hazards)
    return f"{len(table)} rows, {len(table.columns)} columns; {len(causes)} causes"


def check_junit(folder, scan):
    suites = list(JUnitXml.fromfile(str(folder / "junit.xml")))
    title, beginning = scan["subject"]["cell"], scan["subject"].get("beginning")
    if beginning and beginning["of"] > 1:
        title += f", beginning {beginning['number']} of {beginning['of']}"
    assert len(suites) == 1 and suites[0].name == title
    cases = list(suites[0])
    of = lambda kind: [case for case in cases if any(isinstance(result, kind) for result in case.result)]
    failed = {case.name.split()[0] for case in of(Failure)}
    known = {case.name.split()[0] for case in of(Skipped)}
    there = {cause["id"] for cause in scan["causes"]}
    assert failed <= there <= failed | known, failed
    assert suites[0].failures == len(failed) and suites[0].tests == len(cases)
    assert len(of(Error)) == len(scan["faults"]) + (scan["verdict"] not in ("hazards_found", "none_found"))
    return f"{len(cases)} cases, {len(failed)} failures, {len(known)} skipped"


def check_sarif(folder, scan, schema):
    log = json.loads((folder / "hazards.sarif").read_text(encoding="utf-8"))
    schema = json.loads(pathlib.Path(schema).read_text(encoding="utf-8"))
    validator = jsonschema.validators.validator_for(schema)(schema)
    problems = [f"{list(error.path)}: {error.message}" for error in validator.iter_errors(log)]
    assert not problems, problems
    results = log["runs"][0]["results"]
    assert [result["partialFingerprints"]["hazardId/v1"] for result in results] == [h["id"] for h in scan["hazards"]]
    for result, hazard in zip(results, scan["hazards"]):
        steps = result["codeFlows"][0]["threadFlows"][0]["locations"]
        assert len(steps) == len(hazard["actions"])
        # Services refuse a whole file for one result without a place in a file.
        places = [result["locations"][0], *(step["location"] for step in steps)]
        assert all(place["physicalLocation"]["artifactLocation"]["uri"] for place in places)
    return f"{len(results)} results, valid"


def check_traces(folder, fmu):
    checked = 0
    for path in sorted(folder.glob("H-*.inputs.csv")):
        inputs = read_csv(path)
        expected = pandas.read_csv(str(path).replace(".inputs.", ".outputs."))
        step = expected["time"][0]
        names = list(expected.columns[1:])
        options = {"step_size": step, "output_interval": step, "stop_time": expected["time"].iloc[-1]}
        result = simulate_fmu(str(fmu), input=inputs, output=names, set_stop_time=False, **options)
        # The first row is the start.
        assert len(result) == len(expected) + 1, (len(result), len(expected))
        for name in names:
            assert numpy.array_equal(result[name][1:], expected[name]), f"{path.name}: {name}"
        checked += 1
    return f"{checked} traces, the same bits in FMPy"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--scan-schema", required=True)
    parser.add_argument("--sarif-schema", required=True)
    parser.add_argument("--fmu")
    arguments = parser.parse_args()
    scan = json.loads((arguments.folder / "scan.json").read_text(encoding="utf-8"))
    print("scan:", check_scan(scan, arguments.scan_schema))
    print("csv:", check_csv(arguments.folder, scan))
    print("junit:", check_junit(arguments.folder, scan))
    print("sarif:", check_sarif(arguments.folder, scan, arguments.sarif_schema))
    if arguments.fmu:
        print("traces:", check_traces(arguments.folder, arguments.fmu))


if __name__ == "__main__":
    main()
