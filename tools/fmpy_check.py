"""Checks an FMU with FMPy, an importer that this project did not write.

Validates modelDescription.xml and the archive, simulates with a fixed communication step and a table of inputs, and
writes all outputs as CSV with full precision, so that another importer's run can be compared bit by bit.

    tools/fmpy_check.py cell.fmu --input inputs.csv --step 0.02 --stop 2 --set fault.kind=1 --output outputs.csv

The input table has a column `time` (s) and one column per input variable; a row holds from its time until the next
row's time. Booleans are 0 or 1. Without a table the inputs keep their start values. Exit code 1: problems found.
"""

import argparse
import csv
import shutil
import sys

from fmpy import extract, read_model_description
from fmpy.fmi2 import FMU2Slave
from fmpy.validation import validate_fmu

GETTERS = {"Real": "getReal", "Integer": "getInteger", "Enumeration": "getInteger", "Boolean": "getBoolean"}
SETTERS = {"Real": "setReal", "Integer": "setInteger", "Enumeration": "setInteger", "Boolean": "setBoolean"}
CONVERT = {"Real": float, "Integer": int, "Enumeration": int, "Boolean": lambda text: bool(float(text))}


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
    getattr(slave, SETTERS[variable.type])([variable.valueReference], [value])


def simulate(fmu, inputs, parameters, step, stop):
    """Yields rows of values: time, then all outputs in the order of the model description."""
    description = read_model_description(fmu)
    variables = {variable.name: variable for variable in description.modelVariables}
    outputs = [variable for variable in description.modelVariables if variable.causality == "output"]
    folder = extract(fmu)
    try:
        slave = FMU2Slave(
            guid=description.guid,
            unzipDirectory=folder,
            modelIdentifier=description.coSimulation.modelIdentifier,
            instanceName="check",
        )
        slave.instantiate()
        slave.setupExperiment(startTime=0.0)
        for name, text in parameters:
            assign(slave, variables, name, text)
        slave.enterInitializationMode()
        slave.exitInitializationMode()

        def row(time):
            values = (getattr(slave, GETTERS[v.type])([v.valueReference])[0] for v in outputs)
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
    parser.add_argument("fmu")
    parser.add_argument("--input", help="CSV table of inputs")
    parser.add_argument("--set", action="append", default=[], metavar="NAME=VALUE", help="start value, may be repeated")
    parser.add_argument("--step", type=float, default=0.02, help="communication step, s")
    parser.add_argument("--stop", type=float, default=2.0, help="duration, s")
    parser.add_argument("--output", help="CSV file for the outputs; standard output if absent")
    arguments = parser.parse_args()

    problems = validate_fmu(arguments.fmu)
    for problem in problems:
        print(f"{arguments.fmu}: {problem}", file=sys.stderr)

    parameters = [setting.split("=", 1) for setting in arguments.set]
    rows = simulate(arguments.fmu, read_inputs(arguments.input), parameters, arguments.step, arguments.stop)
    file = open(arguments.output, "w", newline="", encoding="utf-8") if arguments.output else sys.stdout
    with file:
        writer = csv.writer(file, lineterminator="\n")
        for row in rows:
            writer.writerow([repr(float(x)) if isinstance(x, float) else x for x in row])
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
