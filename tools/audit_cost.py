#!/usr/bin/env python3
"""What running the FMU again costs a complete scan: processor time by process, from /proc (Linux).

    tools/audit_cost.py target/release/fmi-hazard cells/head-collision/cell.toml ...

The program itself is `scan`; the worker that steps the FMU for the search comes first, the one that runs it again plainly
(and confirms hazards) after it. An FMU that is never brought back has one worker for both.
"""

import os
import subprocess
import sys
import tempfile
import time

HERTZ = os.sysconf("SC_CLK_TCK")


def processor_time(pid):
    """Seconds of a process, and its parent."""
    with open(f"/proc/{pid}/stat", encoding="utf-8") as stat:
        fields = stat.read().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / HERTZ, int(fields[1])


def main():
    program, *cells = sys.argv[1:]
    for cell in cells:
        with tempfile.TemporaryDirectory() as out:
            command = [program, "scan", cell, "--strategy", "exhaustive", "--out", out, "--quiet"]
            began = time.monotonic()
            scan = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            spent = {}
            while scan.poll() is None:
                for pid in filter(str.isdigit, os.listdir("/proc")):
                    try:
                        seconds, parent = processor_time(pid)
                    except (FileNotFoundError, ProcessLookupError):
                        continue
                    if int(pid) == scan.pid or parent == scan.pid or parent in spent:
                        spent[int(pid)] = seconds
                time.sleep(0.05)
            own = spent.pop(scan.pid, 0.0)
            workers = [round(seconds, 2) for seconds in spent.values() if seconds >= 0.05]
            total = own + sum(spent.values())
            print(f"{cell}: {time.monotonic() - began:.0f} s; scan {own:.2f} s, workers {workers} s of {total:.2f} s", flush=True)


if __name__ == "__main__":
    main()
