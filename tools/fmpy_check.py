"""Checks an FMU with FMPy, an importer that this project did not write.

Validates modelDescription.xml and the archive, simulates with a fixed communication step and a table of inputs, and
writes all outputs as CSV with full precision, so that another importer's run can be compared bit by bit.

    tools/fmpy_check.py cell.fmu --input inputs.csv --step 0.02 --stop 2 --set fault.kind=1 --output outputs.csv

FMI 2.0 and FMI 3.0 co-simulation. Given several FMUs, each is validated and run, and only problems are told.

The input table has a column `time` (s) and one column per input variable; a row holds from its time until the next
row's time. Booleans are 0 or 1. Without a table the inputs keep their start values. Exit code 1: problems found.
"""

import argparse
import csv
import shutil
import sys

from fmpy import extract, read_model_description
from fmpy.fmi2 import FMU2Slave
from fmpy.fmi3 import FMU3Slave
from fmpy.validation import validate_fmu

INTEGERS = ["Integer", *(f"{sign}Int{bits}" for sign in ("", "U") for bits in (8, 16, 32, 64))]
CONVERT = {"Real": float, "Float64": float, "Float32": float, "Enumeration": int}
CONVERT |= {"Boolean": lambda text: bool(float(text))} | dict.fromkeys(INTEGERS, int)


def read_inputs(path):
    """Rows of (time, {variable: text}), sorted by time."""
    if path is None:
        return []
    with open(path, newline="", encoding="utf-8") as file:
        rows = [(float(row.pop("time")), row) for row in csv.DictReader(file)]
    return sorted(rows, key=lambda row: row[0])


def assign(slave, variables, name, text):
    if name not in variables:
        sys.exit(f"the FMU has no variable {name}")
    variable = variables[name]
    value = CONVERT[variable.type](text)
    getattr(slave, function("set", slave, variable))([variable.valueReference], [value])


def function(verb, slave, variable):
    """Name of the getter or setter of a variable: an enumeration travels as FMI 2.0's Integer or FMI 3.0's Int64."""
    if variable.type == "Enumeration":
        return verb + ("Int64" if isinstance(slave, FMU3Slave) else "Integer")
    return verb + variable.type


def simulate(fmu, inputs, parameters, step, stop):
    """Yields rows of values: time, then all outputs in the order of the model description."""
    description = read_model_description(fmu)
    variables = {variable.name: variable for variable in description.modelVariables}
    outputs = [v for v in description.modelVariables if v.causality == "output" and v.type in CONVERT and not v.dimensions]
    folder = extract(fmu)
    version3 = description.fmiVersion.startswith("3")
    try:
        slave = (FMU3Slave if version3 else FMU2Slave)(
            guid=description.guid,
            unzipDirectory=folder,
            modelIdentifier=description.coSimulation.modelIdentifier,
            instanceName="check",
        )
        slave.instantiate()
        if not version3:
            slave.setupExperiment(startTime=0.0)
        for name, text in parameters:
            assign(slave, variables, name, text)
        slave.enterInitializationMode()
        slave.exitInitializationMode()

        def row(time):
            values = (getattr(slave, function("get", slave, v))([v.valueReference])[0] for v in outputs)
            return [time, *values]

        yield ["time", *(variable.name for variable in outputs)]
        yield row(0.0)
        pending = list(inputs)
        for index in range(round(stop / step)):
            time = index * step
            while pending and pending[0][0] <= time + 1e-9:
                for name, text in pending.pop(0)[1].items():
                    assign(slave, variables, name, text)
            slave.doStep(currentCommunicationPoint=time, communicationStepSize=step)
            yield row((index + 1) * step)
        slave.terminate()
        slave.freeInstance()
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("fmu", nargs="+")
    parser.add_argument("--input", help="CSV table of inputs")
    parser.add_argument("--set", action="append", default=[], metavar="NAME=VALUE", help="start value, may be repeated")
    parser.add_argument("--step", type=float, default=0.02, help="communication step, s")
    parser.add_argument("--stop", type=float, default=2.0, help="duration, s")
    parser.add_argument("--output", help="CSV file for the outputs; standard output if absent")
    parser.add_argument("--lenient", action="store_true", help="tell what validation finds, but do not fail over it")
    arguments = parser.parse_args()

    if len(arguments.fmu) > 1:
        return max(check(fmu, [], [], arguments.step, arguments.stop, None) for fmu in arguments.fmu)
    parameters = [setting.split("=", 1) for setting in arguments.set]
    file = open(arguments.output, "w", newline="", encoding="utf-8") if arguments.output else sys.stdout
    with file:
        inputs = read_inputs(arguments.input)
        failed = check(arguments.fmu[0], inputs, parameters, arguments.step, arguments.stop, file)
    return 0 if arguments.lenient else failed


def check(fmu, inputs, parameters, step, stop, file):
    """Validates and runs one FMU; writes its outputs to the file, if there is one."""
    problems = validate_fmu(fmu)
    for problem in problems:
        print(f"{fmu}: {problem}", file=sys.stderr)
    rows = simulate(fmu, inputs, parameters, step, stop)
    if file is None:
        print(f"{fmu}: {sum(1 for _ in rows)} rows", flush=True)
    else:
        writer = csv.writer(file, lineterminator="\n")
        for row in rows:
            writer.writerow([repr(float(x)) if isinstance(x, float) else x for x in row])
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
