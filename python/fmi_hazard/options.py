"""The options of each command, with the names and values that they have on the command line. `fmi-hazard scan --help` explains them."""

from collections.abc import Sequence
from os import PathLike
from typing import Literal, TypedDict

File = str | PathLike[str]


class Hosting(TypedDict, total=False):
    """Where the FMU runs."""

    in_process: bool
    trust_fmu: bool
    fmu_timeout: int
    fmu_memory: int


class ScanOptions(Hosting, total=False):
    """Of `scan`."""

    resume: File
    cell: File
    begin: int
    until: str
    presses: int
    strategy: Literal[
        "auto", "exhaustive", "mcts-dpw", "mcts-dpw-lee", "mcts-dpw-literal", "random", "plan", "hybrid"
    ]
    seed: int
    iterations: int
    stop_at: Literal["first", "budget"]
    out: File
    baseline: File
    write_baseline: bool
    time: str
    paper_iterations: bool
    no_advice: bool
    state: Literal["auto", "fmu", "fork", "process", "replay"]
    max_states: int
    max_memory: int
    max_work: int
    merge: Literal["auto", "history"]
    workers: int
    from_: Literal["start", "anywhere", "both"]
    partition: str
    parts: File | Sequence[File]
    verbose: bool


class CheckOptions(Hosting, total=False):
    """Of `check`."""

    cell: File
    svg: File
    no_run: bool


class ExplainOptions(Hosting, total=False):
    """Of `explain`."""

    cell: File
    fmu: File
    no_changes: bool
    quick: bool
    complete: bool
    from_: Literal["start", "anywhere", "both"]
    until: str
    iterations: int
    max_states: int
    max_memory: int
    max_work: int
    workers: int


class ChangedOptions(Hosting, total=False):
    """Of `replay --changed`."""

    cell: File
    junit: File


class ReplayOptions(Hosting, total=False):
    """Of `replay`."""

    cell: File
    fmu: File
    mcap: File
