"""The commands of the program, a function each. Options have the names that they have there, with `_` for `-`.

What a command says on the way is shown at a terminal and in a notebook; `progress` says otherwise: False, True, or a function
that hears of each event.
"""

import os
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, Unpack

from ._results import Answer, Scan, as_answer
from ._running import HAZARDS, INCONCLUSIVE, INTERRUPTED, Ended, Running, failed, wait
from .options import ChangedOptions, CheckOptions, ExplainOptions, ReplayOptions, ScanOptions
from .types import Check, Comparison, Event, Explanation, ReplayedHazard, VerifiedHazard

PathLike = str | os.PathLike[str]
Telling = bool | Callable[[Event], object] | None


def start_scan(path: PathLike | None = None, **options: Unpack[ScanOptions]) -> Running[Scan]:
    """Starts to search a cell for hazards, and gives what is at work. Without a path, with `resume`: goes on with a scan."""
    return Running(["scan", *([] if path is None else [os.fspath(path)]), *_options(options)], _scanned)


def scan(path: PathLike | None = None, *, progress: Telling = None, **options: Unpack[ScanOptions]) -> Scan:
    """Searches a cell for hazards. Ctrl-C ends the search; what was found by then is the result."""
    return wait(start_scan(path, **options), progress)


def check(path: PathLike, **options: Unpack[CheckOptions]) -> Answer[Check]:
    """Finds everything that is wrong with a cell, without searching. Problems are its result, with exit code 2, and no exception."""
    return _printed("check", [path], options, results=(0, 2))


def start_explain(scan: Scan | PathLike, id: str, **options: Unpack[ExplainOptions]) -> Running[Answer[Explanation]]:
    """Starts to explain a hazard or a cause, and gives what is at work."""
    arguments = ["explain", _folder(scan), id, "--format", "json", *_options(options)]
    return Running(arguments, lambda ended: _answer(ended, (0, INTERRUPTED)))


def explain(
    scan: Scan | PathLike, id: str, *, progress: Telling = None, **options: Unpack[ExplainOptions]
) -> Answer[Explanation]:
    """Explains a hazard or a cause, with its formula, the safe speed, and the smallest changes against it."""
    return wait(start_explain(scan, id, **options), progress)


def compare(before: Scan | PathLike, after: Scan | PathLike) -> Answer[Comparison]:
    """Compares two scans: what is fixed, the same, worse, new. Exit code 1 if something is new or worse, 4 if that is not shown."""
    return _printed("compare", [_folder(before), _folder(after)], {})


def replay(scan: Scan | PathLike, id: str = "all", **options: Unpack[ReplayOptions]) -> Answer[list[ReplayedHazard]]:
    """Simulates recorded hazards again and says whether they reproduce. Exit code 1 if one does, 4 if none could be tried."""
    return _printed("replay", [_folder(scan), id], options)


def replay_changed(
    scan: Scan | PathLike, changed: PathLike, id: str = "all", **options: Unpack[ChangedOptions]
) -> Answer[list[VerifiedHazard]]:
    """Tries the hazards of a scan again in a changed cell. Exit code 1 if one is still there, 4 if one is not shown to be gone."""
    return _printed("replay", [_folder(scan), id, f"--changed={os.fspath(changed)}"], options)


def export_examples(folder: PathLike) -> list[Path]:
    """Writes the example cells into a folder; the files that it wrote."""
    running = Running(["examples", "export", os.fspath(folder)], _lines)
    return [Path(line) for line in wait(running, progress=False)]


def _lines(ended: Ended) -> list[str]:
    if ended.exit_code != 0:
        raise failed(ended)
    return ended.printed.splitlines()


def _printed(
    command: str,
    arguments: list[PathLike],
    options: Mapping[str, Any],
    results: tuple[int, ...] = (0, HAZARDS, INCONCLUSIVE),
) -> Answer[Any]:
    words = [command, *(os.fspath(argument) for argument in arguments), "--format", "json", *_options(options)]
    return wait(Running(words, lambda ended: _answer(ended, results)), progress=False)


def _answer(ended: Ended, results: tuple[int, ...]) -> Answer[Any]:
    """What was printed, if the exit code is a result."""
    answer = as_answer(ended.exit_code, ended.printed) if ended.printed.strip() else None
    if answer is None and ended.exit_code == INTERRUPTED:
        raise KeyboardInterrupt
    if answer is None or ended.exit_code not in results:
        raise failed(ended, answer)
    return answer


def _scanned(ended: Ended) -> Scan:
    """The results of a scan, if it has any."""
    folders = [event["folder"] for event in ended.told if event["event"] == "results"]
    scan = Scan(folders[0], ended.exit_code, ended.printed) if folders else None
    if scan is None or ended.exit_code not in (0, HAZARDS, INCONCLUSIVE, INTERRUPTED):
        raise failed(ended, scan)
    return scan


def _folder(scan: Scan | PathLike) -> str:
    return os.fspath(scan.folder if isinstance(scan, Scan) else scan)


def _options(options: Mapping[str, Any]) -> list[str]:
    """As they stand on a command line. `True` is an option alone, `False` and `None` are none; of a list each stands by itself."""
    words: list[str] = []
    for name, value in options.items():
        # `from` is a word of Python: `from_`.
        option = "--" + name.rstrip("_").replace("_", "-")
        for one in value if isinstance(value, list | tuple) else [value]:
            if one is True:
                words.append(option)
            elif one is not None and one is not False:
                # In one word: a value may begin with a dash.
                words.append(f"{option}={os.fspath(one) if isinstance(one, os.PathLike) else one}")
    return words
