"""A command at work: what it tells, how it is interrupted, and what it ends with."""

import json
import queue
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Callable, Iterator, Sequence
from signal import SIGINT
from types import TracebackType
from typing import Generic, TypeVar, cast

from ._program import program
from .errors import _error
from .types import Event

T = TypeVar("T")

HAZARDS, INCONCLUSIVE, INTERRUPTED = 1, 4, 130
"""Exit codes that are results, besides 0."""

_SAME_S = 0.2
"""A second Ctrl-C within this time is the first one, for the program too."""


class Ended:
    """What a command left: its exit code, what it printed, and what it told."""

    def __init__(self, exit_code: int, printed: str, told: list[Event], said: list[str]) -> None:
        self.exit_code = exit_code
        self.printed = printed
        self.told = told
        self.said = said

    def message(self) -> str:
        """Why it failed: its errors, else all that it said."""
        errors = [event["text"] for event in self.told if event["event"] == "error"]
        return "\n".join(errors or self.said) or f"fmi-hazard ended with exit code {self.exit_code}"


class Running(Generic[T]):
    """A command at work, in a process of its own. Going through it gives what it tells, as it tells it:

        with fmi_hazard.start_scan("cell.toml") as running:
            for event in running:
                print(event["event"], event.get("text"))
            scan = running.result()

    Ctrl-C, or the stop button of a notebook, ends the search and not this: what was found by then is the result, with exit code
    130. Once more ends the program at once, and raises KeyboardInterrupt.
    """

    def __init__(self, arguments: Sequence[str], ended: Callable[[Ended], T]) -> None:
        self._ended = ended
        self._events: queue.SimpleQueue[Event | None] = queue.SimpleQueue()
        self._told: list[Event] = []
        self._said: list[str] = []
        self._interrupted_at: float | None = None
        self._interrupted_twice = False
        self._over = False
        self._outcome: Ended | None = None
        self._printed = tempfile.TemporaryFile("w+", encoding="utf-8")
        # A group of its own: Ctrl-C at a terminal reaches this process only, which hands it on once.
        self._process = subprocess.Popen(
            [program(), "--progress", "json", *arguments],
            stdin=subprocess.DEVNULL,
            stdout=self._printed,
            stderr=subprocess.PIPE,
            process_group=0,
            encoding="utf-8",
            errors="replace",
        )
        # A thread of its own, so that an interrupt tears no line.
        threading.Thread(target=self._listen, name="fmi-hazard", daemon=True).start()

    def _listen(self) -> None:
        assert self._process.stderr is not None
        with self._process.stderr as lines:
            for line in lines:
                try:
                    event = json.loads(line)
                except ValueError:
                    event = None
                if isinstance(event, dict) and "event" in event:
                    self._events.put(cast(Event, event))
                else:
                    self._said.append(line.rstrip("\n"))
        self._events.put(None)

    def __iter__(self) -> Iterator[Event]:
        return self

    def __next__(self) -> Event:
        if self._over:
            raise StopIteration
        while True:
            try:
                event = self._events.get()
                break
            except KeyboardInterrupt:
                self._by_user()
        if event is None:
            self._over = True
            raise StopIteration
        if event["event"] in ("results", "warning", "error"):
            self._told.append(event)
        return event

    def _by_user(self) -> None:
        """Ctrl-C: the first ends the search, a later one the program."""
        if self._interrupted_twice:
            raise KeyboardInterrupt
        again = self._interrupted_at is not None
        if again and time.monotonic() - cast(float, self._interrupted_at) < _SAME_S:
            return
        self.interrupt()
        if again:
            self._interrupted_twice = True
            raise KeyboardInterrupt

    def interrupt(self) -> None:
        """Ends the search; the result is what was found so far. Once more ends the program at once."""
        self._interrupted_at = time.monotonic()
        if self._process.poll() is None:
            self._process.send_signal(SIGINT)

    def result(self) -> T:
        """Waits for the end: what came out of it, or an exception if that is no result."""
        for _ in self:
            pass
        while self._outcome is None:
            try:
                exit_code = self._process.wait()
            except KeyboardInterrupt:
                self._by_user()
                continue
            self._printed.seek(0)
            self._outcome = Ended(exit_code, self._printed.read(), self._told, self._said)
            self._printed.close()
        if self._outcome.exit_code == -SIGINT:
            # Before there was anything to keep.
            raise KeyboardInterrupt
        return self._ended(self._outcome)

    def __enter__(self) -> "Running[T]":
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self._process.poll() is None:
            self.interrupt()
        for _ in self:
            pass
        self._process.wait()

    def __del__(self) -> None:
        process = getattr(self, "_process", None)
        if process is not None and process.poll() is None:
            process.send_signal(SIGINT)


def failed(ended: Ended, result: object = None) -> Exception:
    """The exception for what a command ended with."""
    return _error(ended.message(), ended.exit_code, result)


def wait(running: Running[T], progress: bool | Callable[[Event], object] | None) -> T:
    """Its result. `progress` hears of each event; True shows it, None where somebody may look."""
    if progress is None:
        progress = sys.stderr.isatty() or "ipykernel" in sys.modules
    with running:
        while progress:
            try:
                if callable(progress):
                    for event in running:
                        progress(event)
                else:
                    _show(running)
                break
            except KeyboardInterrupt:
                # Ctrl-C while an event is told: what was found by then is the result, too.
                running._by_user()
        return running.result()


def _show(events: Iterator[Event]) -> None:
    """A line that changes, and above it what stays."""
    width, shown = 100, 0

    def line(text: str, end: str) -> None:
        nonlocal shown
        text = text if end else text[:width]
        sys.stderr.write("\r" + text.ljust(shown) + end)
        sys.stderr.flush()
        shown = 0 if end else len(text)

    for event in events:
        if event["event"] == "doing":
            line(event["text"], "")
        elif event["event"] == "progress":
            line(f"{event['done']}/{event['total']} {event['unit']}  {event['text']}", "")
        elif event["event"] in ("warning", "error"):
            line(f"{event['event']}: {event['text']}", "\n")
    line("", "")
    sys.stderr.write("\r")
