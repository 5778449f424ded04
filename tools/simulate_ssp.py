"""Simulates a system of FMUs (.ssp) with FMPy, an importer that this project did not write, and prints its connectors.

    tools/simulate_ssp.py system.ssp --step 0.01 --stop 1 --input mat_clear:0=1 --input mat_clear:0.4=0

An input NAME:TIME=VALUE holds from that time on. Prints JSON: {"connector": [value after each step, ...], ...}. FMPy
reads SSP 1.0 with FMI 2.0 FMUs; it hands every connection on after all components have taken a step, so each adds a step,
and gives all inputs 0 in the first step.
"""

import argparse
import json

from fmpy.ssp.simulation import simulate_ssp


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("ssp")
    parser.add_argument("--step", type=float, required=True)
    parser.add_argument("--stop", type=float, required=True)
    parser.add_argument("--input", action="append", default=[])
    arguments = parser.parse_args()
    tables = {}
    for text in arguments.input:
        name, change = text.rsplit(":", 1)
        time, value = change.split("=")
        tables.setdefault(name, []).append((float(time), float(value)))

    def held(table):
        table = sorted(table)
        return lambda time: [value for since, value in table if since <= time + 1e-9][-1]

    inputs = {name: held(table) for name, table in tables.items()}
    result = simulate_ssp(arguments.ssp, stop_time=arguments.stop, step_size=arguments.step, input=inputs)
    print(json.dumps({name: [float(value) for value in result[name]] for name in result.dtype.names}))


if __name__ == "__main__":
    main()
