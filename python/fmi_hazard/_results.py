"""What a scan wrote, and what other commands printed."""

import html
import json
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, Generic, TypeVar, cast

from ._running import HAZARDS, INCONCLUSIVE, INTERRUPTED
from .types import Cause, Hazard, Obligation, ReachabilityResult, ScanReport

if TYPE_CHECKING:
    import pandas

T = TypeVar("T")


@dataclass(frozen=True)
class Answer(Generic[T]):
    """What a command printed with `--format json`, and its exit code."""

    data: T
    exit_code: int

    @property
    def interrupted(self) -> bool:
        """Whether Ctrl-C ended it: `data` is what was known by then."""
        return self.exit_code == INTERRUPTED


class Scan:
    """The results of a scan, in the folder into which it wrote them. In a notebook it shows as its report."""

    def __init__(self, folder: str | Path, exit_code: int | None = None, printed: str = "") -> None:
        self.folder = Path(folder)
        self.exit_code = exit_code
        """Exit code of the scan; None for one that was only read."""
        self.printed = printed
        """What the scan printed for people."""

    def __repr__(self) -> str:
        return f"Scan({str(self.folder)!r}, exit_code={self.exit_code})"

    @property
    def has_hazards(self) -> bool:
        """Whether it found any: exit code 1."""
        return self.exit_code == HAZARDS if self.exit_code is not None else bool(self.hazards)

    @property
    def inconclusive(self) -> bool:
        """Whether nothing was found, and it is not shown that there is nothing: exit code 4. See `obligations`."""
        return self.exit_code == INCONCLUSIVE

    @property
    def clean(self) -> bool:
        """Whether there is no hazard, and everything that this needs is shown or accepted."""
        return self.data["verdict"] == "none_found" and all(one["standing"] != "open" for one in self.obligations)

    @property
    def obligations(self) -> list[Obligation]:
        """What the result rests on: shown, assumed or open."""
        return self.data["obligations"]

    @property
    def interrupted(self) -> bool:
        """Whether Ctrl-C ended it; what was found by then is here."""
        return self.exit_code == INTERRUPTED

    @cached_property
    def data(self) -> ScanReport:
        """Everything: scan.json."""
        return cast(ScanReport, self._json("scan.json"))

    @property
    def hazards(self) -> list[Hazard]:
        """The hazards, worst first."""
        return self.data["hazards"]

    @property
    def causes(self) -> list[Cause]:
        """What is wrong with the cell: hazards that belong together, worst first."""
        return self.data["causes"]

    def hazards_frame(self) -> "pandas.DataFrame":
        """The hazards as a table, a row each: hazards.csv. Needs pandas."""
        return self._table("hazards.csv")

    def causes_frame(self) -> "pandas.DataFrame":
        """The causes as a table, a row each: causes.csv. Needs pandas."""
        return self._table("causes.csv")

    @property
    def report(self) -> Path:
        """The report for people, a file of its own."""
        return self.folder / "report.html"

    @property
    def anywhere(self) -> "Scan | None":
        """The look from anywhere that went before the scan from the start, if there was one: a scan in a folder of its own."""
        folder = self.folder / "anywhere"
        return Scan(folder) if (folder / "anywhere.json").exists() else None

    @cached_property
    def anywhere_data(self) -> ReachabilityResult:
        """Everything of a scan from anywhere: anywhere.json."""
        return cast(ReachabilityResult, self._json("anywhere.json"))

    @property
    def beginnings(self) -> "list[Scan]":
        """A scan for each of the cell's beginnings, if it has several. They have results of their own, and this has none."""
        if not (self.folder / "beginnings.json").exists():
            return []
        table = self._json("beginnings.json")
        return [Scan(self.folder / entry["folder"], entry["exit_code"]) for entry in table["beginnings"]]

    def _repr_html_(self) -> str:
        if not self.report.exists():
            return "".join(scan._repr_html_() for scan in self.beginnings) or html.escape(repr(self))
        page = html.escape(self.report.read_text(encoding="utf-8"))
        return (
            f'<iframe srcdoc="{page}" title="{html.escape(str(self.report))}" sandbox="allow-scripts allow-downloads allow-modals" '
            'style="width: 100%; height: 720px; border: 1px solid #ccc"></iframe>'
        )

    def _json(self, name: str) -> Any:
        path = self.folder / name
        if not path.exists() and (self.folder / "beginnings.json").exists():
            raise FileNotFoundError(f"{path} is not there: the cell has several beginnings, see `beginnings`")
        return json.loads(path.read_text(encoding="utf-8"))

    def _table(self, name: str) -> "pandas.DataFrame":
        import pandas

        return pandas.read_csv(self.folder / name)


def read_scan(folder: str | Path) -> Scan:
    """The results of an earlier scan, in this folder."""
    scan = Scan(folder)
    if not (scan.folder / "beginnings.json").exists():
        _ = scan.data
    return scan


def as_answer(exit_code: int, printed: str) -> "Answer[Any]":
    """What a command printed, as data."""
    return Answer(json.loads(printed), exit_code)
