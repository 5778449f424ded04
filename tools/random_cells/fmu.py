"""The FMU of the random cells: made from robots.c for FMI 2.0 and 3.0, and run by FMPy."""

import subprocess
import zipfile
from pathlib import Path

import fmpy
from fmpy.fmi2 import FMU2Slave
from fmpy.fmi3 import FMU3Slave

TOKEN = "{6e4f2a31-random-cells}"
REALS = ["middle", "swing", "begin"]
INTEGERS = ["period_ms", "reaction_ms", "ramp_ms", "restart_ms", "heeds", "mutes", "mute_ms", "deaf_ms", "hears"]
DEFAULTS = {"period_ms": 1000, "reaction_ms": 100, "ramp_ms": 100}


def variables():
    """Name, value reference, kind, causality, start value."""
    rows = []
    for r in range(2):
        rows += [(f"r{r + 1}.{n}", 10 * r + k, "Real", "parameter", 0.0) for k, n in enumerate(REALS)]
        rows += [(f"r{r + 1}.{n}", 100 + 10 * r + k, "Integer", "parameter", DEFAULTS.get(n, 0)) for k, n in enumerate(INTEGERS)]
        rows += [(f"r{r + 1}.latched", 210 + r, "Boolean", "parameter", "false")]
        rows += [(f"r{r + 1}.{n}", 10 * r + 5 + k, "Real", "output", None) for k, n in enumerate(["q", "qd"])]
    return rows + [(f"s{s + 1}", 200 + s, "Boolean", "input", "true") for s in range(3)]


def description(fmi):
    """modelDescription.xml."""
    types = {"Real": "Float64", "Integer": "Int32", "Boolean": "Boolean"}
    body, outputs = [], []
    for number, (name, reference, kind, causality, start) in enumerate(variables()):
        variability = "fixed" if causality == "parameter" else "discrete" if kind != "Real" else "continuous"
        begin = "" if start is None else f' start="{start}"'
        how = f'name="{name}" valueReference="{reference}" causality="{causality}" variability="{variability}"'
        body.append(f"    <ScalarVariable {how}><{kind}{begin}/></ScalarVariable>" if fmi == 2 else f"    <{types[kind]} {how}{begin}/>")
        if causality == "output":
            outputs.append(number + 1 if fmi == 2 else reference)
    states = "canGetAndSetFMUstate" if fmi == 2 else "canGetAndSetFMUState"
    serialize = "canSerializeFMUstate" if fmi == 2 else "canSerializeFMUState"
    token = "guid" if fmi == 2 else "instantiationToken"
    if fmi == 3:
        body.append('    <Float64 name="time" valueReference="999" causality="independent" variability="continuous"/>')
    structure = "".join(f'<Unknown index="{k}"/>' if fmi == 2 else f'<Output valueReference="{k}"/>' for k in outputs)
    if fmi == 2:
        initial = "".join(f'<Unknown index="{k}"/>' for k in outputs)
        structure = f"<Outputs>{structure}</Outputs><InitialUnknowns>{initial}</InitialUnknowns>"
    else:
        structure += "".join(f'<InitialUnknown valueReference="{k}"/>' for k in outputs)
    return f"""<?xml version="1.0" encoding="UTF-8"?>
<fmiModelDescription fmiVersion="{fmi}.0" modelName="robots" {token}="{TOKEN}">
  <CoSimulation modelIdentifier="robots" canHandleVariableCommunicationStepSize="true" {states}="true" {serialize}="true"/>
  <ModelVariables>
{chr(10).join(body)}
  </ModelVariables>
  <ModelStructure>{structure}</ModelStructure>
</fmiModelDescription>
"""


def build(folder):
    """Compiles robots.c and packs robots2.fmu and robots3.fmu, unless they are there."""
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    library = folder / "robots.so"
    source = Path(__file__).with_name("robots.c")
    if not library.exists():
        subprocess.run(["gcc", "-O2", "-Wall", "-Wextra", "-shared", "-fPIC", "-fvisibility=hidden", "-o", library, source, "-lm"], check=True)
    for fmi, place in ((2, "linux64"), (3, "x86_64-linux")):
        file = folder / f"robots{fmi}.fmu"
        if not file.exists():
            with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as pack:
                pack.writestr(zipfile.ZipInfo("modelDescription.xml"), description(fmi))
                pack.write(library, f"binaries/{place}/robots.so")
        if not (folder / f"robots{fmi}").exists():
            fmpy.extract(str(file), unzipdir=str(folder / f"robots{fmi}"))
    return folder


class Fmu:
    """The FMU as a table of transitions between numbered states; each is stepped once, from a state that was brought back."""

    def __init__(self, folder, fmi, parameters, sensors, step_s):
        self.fmi, self.parameters, self.sensors, self.step_s = fmi, parameters, sensors, step_s
        unpacked = str(Path(folder) / f"robots{fmi}")
        self.instance = {"guid": TOKEN, "unzipDirectory": unpacked, "instanceName": "robots", "modelIdentifier": "robots"}
        self.known = {row[0]: row for row in variables()}
        self.told = [reference for name, reference, _, causality, _ in variables() if causality == "output"]
        self.begin()

    def begin(self):
        """The first state, in which all tables begin."""
        self.slave = self.fresh()
        self.numbers, self.saved, self.values, self.steps, self.next = {}, [], [], [], {}
        self.start = self.number(0)

    def fresh(self):
        """A new instance, initialised with nobody seen."""
        slave = FMU2Slave(**self.instance) if self.fmi == 2 else FMU3Slave(**self.instance)
        slave.instantiate()
        if self.fmi == 2:
            slave.setupExperiment(startTime=0.0)
        for name, value in self.parameters.items():
            self.set(slave, name, value)
        self.sense(slave, (False,) * len(self.sensors))
        slave.enterInitializationMode()
        slave.exitInitializationMode()
        return slave

    def set(self, slave, name, value):
        _, reference, kind, _, _ = self.known[name]
        if self.fmi == 2:
            {"Real": slave.setReal, "Integer": slave.setInteger, "Boolean": slave.setBoolean}[kind]([reference], [value])
        else:
            {"Real": slave.setFloat64, "Integer": slave.setInt32, "Boolean": slave.setBoolean}[kind]([reference], [value])

    def sense(self, slave, reading):
        """Several sensors may drive one input: it is false while any of them fires."""
        clear = {}
        for variable, detected in zip(self.sensors, reading):
            clear[variable] = clear.get(variable, True) and not detected
        for variable, value in clear.items():
            self.set(slave, variable, bool(value))

    def get(self, slave):
        return tuple(slave.getReal(self.told) if self.fmi == 2 else slave.getFloat64(self.told))

    def number(self, step):
        two, slave = self.fmi == 2, self.slave
        state = slave.getFMUstate() if two else slave.getFMUState()
        key = (step, slave.serializeFMUstate(state) if two else slave.serializeFMUState(state))
        if key in self.numbers:
            (slave.freeFMUstate if two else slave.freeFMUState)(state)
            return self.numbers[key]
        self.numbers[key] = len(self.saved)
        self.saved.append(state)
        self.values.append(self.get(slave))
        self.steps.append(step)
        return self.numbers[key]

    def after(self, state, reading):
        """The state after a step with these readings."""
        if (state, reading) not in self.next:
            (self.slave.setFMUstate if self.fmi == 2 else self.slave.setFMUState)(self.saved[state])
            self.sense(self.slave, reading)
            self.slave.doStep(self.steps[state] * self.step_s, self.step_s)
            self.next[state, reading] = self.number(self.steps[state] + 1)
        return self.next[state, reading]

    def plain(self, history):
        """The outputs after each step of a history of readings, from a fresh instance that no state is brought back to."""
        slave, values = self.fresh(), []
        for step, reading in enumerate(history):
            self.sense(slave, reading)
            slave.doStep(step * self.step_s, self.step_s)
            values.append(self.get(slave))
        slave.terminate()
        slave.freeInstance()
        return values

    def close(self):
        for state in self.saved:
            (self.slave.freeFMUstate if self.fmi == 2 else self.slave.freeFMUState)(state)
        self.slave.terminate()
        self.slave.freeInstance()
