"""A cell that one steps oneself: the conversation with `fmi-hazard-research step`, a line of JSON for each question and each answer.

The program is the one that `FMI_HAZARD_RESEARCH` names, else the one on the path.
"""

import json
import os
import subprocess
import tempfile
from types import TracebackType
from typing import Any, Literal, TypedDict, cast


class SteppingError(Exception):
    """What the program says where something cannot be done."""


class Description(TypedDict):
    """What a cell is to whoever steps it."""

    cell: str
    actions: list[str]
    """Names of the actions, by their number."""
    horizon: int
    """Longest episode, in actions."""
    action_s: float
    sensors: list[str]
    links: list[str]


class Observation(TypedDict):
    """What there is to see at one instant: lengths in m, speeds in m/s, in the frame of the world."""

    actions: int
    """Taken so far."""
    xy_m: list[float]
    heading: list[float]
    """Cosine and sine of where the person looks."""
    sensors: list[bool]
    links_m: list[list[float]]
    speeds_m_s: list[float]


class Taken(TypedDict):
    """What an action led to."""

    observation: Observation | None
    """None where the FMU could not finish the action."""
    reward: float
    """The paper's: 0 on the way and for an unsafe contact, less at an end without one, by how near it came."""
    end: Literal["unsafe", "horizon", "not_evaluated"] | None
    """Why the episode is over, or None."""
    hazard: dict[str, Any] | None


class Stepper:
    """A cell at its start, in a process of its own. Actions are numbers of `description["actions"]`."""

    def __init__(self, path: str | os.PathLike[str]) -> None:
        program = os.environ.get("FMI_HAZARD_RESEARCH", "fmi-hazard-research")
        self._said = tempfile.TemporaryFile("w+", encoding="utf-8", errors="replace")
        self._process = subprocess.Popen(
            [program, "step", os.fspath(path)],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=self._said,
            # Ctrl-C is about what steps it.
            process_group=0,
            encoding="utf-8",
        )
        self.description = cast(Description, self._ask({"do": "describe"}))

    def reset(self) -> Observation:
        """Goes to the start."""
        return cast(Observation, self._ask({"do": "reset"})["observation"])

    def step(self, action: int) -> Taken:
        """Takes an action."""
        return cast(Taken, self._ask({"do": "step", "action": int(action)}))

    def save(self) -> int:
        """Keeps the present state, of FMU, sensors and person: its number."""
        return cast(int, self._ask({"do": "save"})["state"])

    def restore(self, state: int) -> Observation:
        """Goes back to a state that was saved."""
        return cast(Observation, self._ask({"do": "restore", "state": state})["observation"])

    def forget(self, state: int) -> None:
        """A state that is not needed any more."""
        self._ask({"do": "forget", "state": state})

    def close(self) -> None:
        """Ends it."""
        if not self._said.closed:
            self._process.communicate()
            self._said.close()

    def _ask(self, question: dict[str, object]) -> dict[str, Any]:
        assert self._process.stdin is not None and self._process.stdout is not None
        try:
            self._process.stdin.write(json.dumps(question) + "\n")
            self._process.stdin.flush()
            line = self._process.stdout.readline()
        except BrokenPipeError:
            line = ""
        if not line:
            code = self._process.wait()
            self._said.seek(0)
            said = self._said.read().removeprefix("Error:").strip()
            self.close()
            raise SteppingError(said or f"{self._process.args} ended with exit code {code}")
        answer = cast(dict[str, Any], json.loads(line))
        if "error" in answer:
            raise SteppingError(answer["error"])
        return answer

    def __enter__(self) -> "Stepper":
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()
