"""A cell as an environment of Gymnasium, in a folder with the example cells: `research/tests/stepping.rs` runs this there."""

import unittest
import warnings

from environment import CellEnv
from gymnasium.utils.env_checker import check_env
from stepper import Stepper, SteppingError


class Stepping(unittest.TestCase):
    def test_a_cell_is_an_environment_of_gymnasium_whose_states_come_back(self):
        with warnings.catch_warnings():
            warnings.simplefilter("error", UserWarning)
            # Positions have no bounds.
            warnings.filterwarnings("ignore", ".*infinity.*")
            env = CellEnv("heavy-workpiece/cell.toml")
            self.addCleanup(env.close)
            check_env(env, skip_render_check=True)

        def episode(seed):
            first, _ = env.reset(seed=seed)
            env.action_space.seed(seed)
            told = [first]
            while True:
                seen, reward, terminated, truncated, info = env.step(env.action_space.sample())
                told.append(seen)
                if terminated or truncated:
                    return told, reward, info

        ends = [episode(seed) for seed in range(40)]
        self.assertEqual({len(seen[0]) for seen, _, _ in ends}, {env.observation_space.shape[0]})
        self.assertLess(min(reward for _, reward, info in ends if not info), 0)
        again, reward, _ = episode(7)
        self.assertTrue((reward == ends[7][1]) and all((a == b).all() for a, b in zip(again, ends[7][0], strict=True)))
        env.reset()
        env.step(3)
        state, after = env.save(), [env.step(5)[0] for _ in range(3)]
        env.reset()
        env.restore(state)
        self.assertTrue(all((env.step(5)[0] == seen).all() for seen in after))
        env.forget(state)
        with self.assertRaisesRegex(SteppingError, "no state"):
            env.restore(state)
        with self.assertRaises(SteppingError):
            Stepper("nowhere.toml")


if __name__ == "__main__":
    unittest.main()
