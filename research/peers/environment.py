"""A cell as an environment of Gymnasium, for agents that learn where somebody is hit.

    env = CellEnv("cell.toml")
    observation, info = env.reset(seed=1)
    observation, reward, terminated, truncated, info = env.step(env.action_space.sample())

Actions, rewards and the length of an episode are those of the paper (Huck, Ledermann, Kroeger 2021): 36 actions of 0.2 s; 0 on the way
and for an unsafe contact, less at an end without one, by how near it came. `info["hazard"]` has what was met.
"""

import os
from typing import Any

import gymnasium
import numpy
from gymnasium.spaces import Box, Discrete
from numpy.typing import NDArray

from stepper import Observation, Stepper, Taken

Vector = NDArray[numpy.float32]


class CellEnv(gymnasium.Env[Vector, numpy.int64]):
    """Nothing in it is random: a seed changes what `action_space.sample()` gives, and no more.

    An observation is one vector: share of the episode that is over; x and y of the person, m; cosine and sine of where they look; 1 for
    each sensor that reports them, else 0; x, y and z of each link's middle, m; an upper bound on each link's speed, m/s.
    """

    metadata: dict[str, Any] = {"render_modes": []}
    render_mode = None

    def __init__(self, path: str | os.PathLike[str]) -> None:
        self.stepper = Stepper(path)
        described = self.stepper.description
        size = 5 + len(described["sensors"]) + 4 * len(described["links"])
        self.observation_space = Box(-numpy.inf, numpy.inf, (size,), numpy.float32)
        self.action_space = Discrete(len(described["actions"]))
        self._horizon = described["horizon"]
        self._last = numpy.zeros(size, numpy.float32)

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[Vector, dict[str, Any]]:
        """To the start."""
        super().reset(seed=seed)
        return self._seen(self.stepper.reset()), {}

    def step(self, action: numpy.int64) -> tuple[Vector, float, bool, bool, dict[str, Any]]:
        """An action. What the FMU could not finish is truncated; an unsafe contact and the end of the sequence are terminal."""
        taken: Taken = self.stepper.step(int(action))
        if taken["observation"] is not None:
            self._seen(taken["observation"])
        terminated, truncated = taken["end"] in ("unsafe", "horizon"), taken["end"] == "not_evaluated"
        info = {} if taken["hazard"] is None else {"hazard": taken["hazard"]}
        return self._last.copy(), taken["reward"], terminated, truncated, info

    def save(self) -> int:
        """Keeps the present state; its number."""
        return self.stepper.save()

    def restore(self, state: int) -> Vector:
        """Back to a state that was saved."""
        return self._seen(self.stepper.restore(state))

    def forget(self, state: int) -> None:
        """A state that is not needed any more."""
        self.stepper.forget(state)

    def close(self) -> None:
        """Ends the program."""
        self.stepper.close()

    def _seen(self, observation: Observation) -> Vector:
        links = [number for link in observation["links_m"] for number in link]
        person = [observation["actions"] / self._horizon, *observation["xy_m"], *observation["heading"]]
        self._last = numpy.array([*person, *observation["sensors"], *links, *observation["speeds_m_s"]], numpy.float32)
        return self._last.copy()
