"""fmi-hazard from Python: it runs the program that comes with this package, and reads what that writes.

    import fmi_hazard

    scan = fmi_hazard.scan("cell.toml", time="2m")
    scan.hazards_frame()
    scan                      # in a notebook: the report

Whatever is found is found by the program; nothing is computed here. The types of what it writes are in `fmi_hazard.types`.
"""

from ._program import program
from ._results import Answer, Scan, read_scan
from ._running import Running
from .commands import check, compare, explain, export_examples, replay, replay_changed, scan, start_explain, start_scan
from .errors import FmiHazardError, FmuFailedError, UsageError

__all__ = [
    "Answer",
    "FmiHazardError",
    "FmuFailedError",
    "Running",
    "Scan",
    "UsageError",
    "check",
    "compare",
    "explain",
    "export_examples",
    "program",
    "read_scan",
    "replay",
    "replay_changed",
    "scan",
    "start_explain",
    "start_scan",
]
