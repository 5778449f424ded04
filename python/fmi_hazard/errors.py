"""What goes wrong, as exceptions: one class for each exit code that says so.

Hazards found (1), inconclusive (4) and interrupted (130) are results, not errors.
"""

from typing import Any


class FmiHazardError(Exception):
    """The program ended with an exit code that is no result. The message is what it said."""

    def __init__(self, message: str, exit_code: int, result: Any = None) -> None:
        super().__init__(message)
        self.exit_code = exit_code
        """The exit code of the program; below zero, the signal that ended it."""
        self.result = result
        """What it wrote or printed all the same, if it did."""


class UsageError(FmiHazardError):
    """Exit code 2: the options, the cell file or the FMU file cannot be used."""


class FmuFailedError(FmiHazardError):
    """Exit code 3: the FMU failed while running."""


_CLASSES = {2: UsageError, 3: FmuFailedError}


def _error(message: str, exit_code: int, result: Any = None) -> FmiHazardError:
    """The exception for an exit code."""
    return _CLASSES.get(exit_code, FmiHazardError)(message, exit_code, result)
