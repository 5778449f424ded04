"""One peer on one cell: what `research/peers/compare.py` starts in the peer's own environment of Python.

    one.py METHOD CELL FIRST_SEED SEEDS ITERATIONS

Prints a JSON object for each seed: the iteration of the first hazard, and the seconds until then (null if there was none), the ids of all
hazards after so many iterations, and the seconds of all of them. An iteration is a sequence of actions from the start. All peers
choose sequences and are told one number for each, below 0 for an unsafe contact: how near it came, m, or the force over its limit.
"""

import importlib
import json
import random
import sys
import tempfile
import time

from stepper import Stepper

FACTORS = 6
"""An action is one of six moves with one of six postures; `factored` peers choose both by themselves."""


LOADED = {
    "uniform": ["staliro"],
    "annealing": ["staliro"],
    "halton": ["verifai.samplers", "verifai.features"],
    "cross-entropy": ["verifai.samplers", "verifai.features"],
    "dqn": ["stable_baselines3", "environment"],
}


class Enough(Exception):
    """All iterations are done."""


class Cell:
    """Sequences of one seed, counted."""

    def __init__(self, path, iterations):
        self.stepper = Stepper(path)
        described = self.stepper.description
        self.actions, self.horizon, self.iterations = len(described["actions"]), described["horizon"], iterations

    def begin(self):
        self.began, self.done, self.first, self.first_s, self.ids = time.monotonic(), 0, None, None, set()

    def met(self, hazard):
        """A hazard in the present iteration."""
        self.ids.add(hazard["id"])
        if self.first is None:
            self.first, self.first_s = self.done + 1, time.monotonic() - self.began

    def ended(self):
        """An iteration is over."""
        self.done += 1
        if self.done >= self.iterations:
            raise Enough

    def cost(self, sequence):
        """How near a sequence came to harm: below 0 it is harm."""
        self.stepper.reset()
        for action in sequence:
            taken = self.stepper.step(action)
            if taken["end"] is not None:
                break
        cost = -taken["reward"]
        if taken["hazard"] is not None:
            self.met(taken["hazard"])
            cost = -taken["hazard"]["ratio"]
        self.ended()
        return cost

    def whole(self, numbers):
        """A sequence from numbers of 0 to 1, one an action."""
        return [min(int(number * self.actions), self.actions - 1) for number in numbers]

    def factored(self, numbers):
        """The same from two numbers an action."""
        part = [min(int(number * FACTORS), FACTORS - 1) for number in numbers]
        return [FACTORS * a + b for a, b in zip(part[::2], part[1::2], strict=True)]


def taliro(cell, seed, optimizer, factored):
    """Psi-TaLiRo, with what it does unless told otherwise. Its one setting here is how sequences are written as numbers."""
    import staliro

    size = cell.horizon * (2 if factored else 1)
    decode = cell.factored if factored else cell.whole

    @staliro.costfunc
    def cost(inputs):
        return cell.cost(decode([inputs.static[f"a{number}"] for number in range(size)]))

    inputs = {f"a{number}": (0.0, 1.0) for number in range(size)}
    # Dual annealing may end a little earlier or later than it is told to.
    options = staliro.TestOptions(runs=1, iterations=2 * cell.iterations, seed=seed, static_inputs=inputs)
    staliro.staliro(cost, optimizer, options)


def verifai(cell, seed, kind, tuned):
    """VerifAI's samplers on as many unit intervals as there are numbers."""
    import numpy
    from dotmap import DotMap
    from verifai.features import Box, Feature, FeatureSpace
    from verifai.samplers import FeatureSampler

    random.seed(seed)
    numpy.random.seed(seed)
    size = cell.horizon * (2 if tuned else 1)
    decode = cell.factored if tuned else cell.whole
    space = FeatureSpace({f"a{number}": Feature(Box([0, 1])) for number in range(size)})
    if kind == "halton":
        # It has no seed: each takes up the row where the one before has ended.
        params = DotMap(sample_index=seed * cell.iterations, bases_skipped=0)
        sampler = FeatureSampler.haltonSamplerFor(space, params)
    else:
        # Unless told otherwise it learns from harm alone. Tuned it learns from what comes within 0.3 m, too, and as many buckets as choices.
        own = DotMap(alpha=0.9, thres=0.3, cont=DotMap(buckets=FACTORS, dist=None), disc=DotMap(dist=None))
        sampler = FeatureSampler.crossEntropySamplerFor(space, own if tuned else None)
    feedback = None
    while True:
        sample = sampler.nextSample(feedback)
        feedback = cell.cost(decode([getattr(sample, f"a{number}")[0] for number in range(size)]))


def learning(cell, path, seed, tuned):
    """DQN of Stable-Baselines3 on the environment of Gymnasium, with the paper's rewards."""
    import torch
    from environment import CellEnv
    from stable_baselines3 import DQN
    from stable_baselines3.common.callbacks import BaseCallback

    torch.set_num_threads(1)

    class Counting(BaseCallback):
        def _on_step(self):
            hazard = self.locals["infos"][0].get("hazard")
            if hazard is not None:
                cell.met(hazard)
            if self.locals["dones"][0]:
                cell.ended()
            return True

    own = {"learning_rate": 1e-3, "train_freq": 1, "exploration_fraction": 0.5, "target_update_interval": 200} if tuned else {}
    env = CellEnv(path)
    try:
        steps = cell.iterations * cell.horizon
        DQN("MlpPolicy", env, seed=seed, device="cpu", **own).learn(steps, callback=Counting())
        # Episodes that end with harm are shorter.
        while True:
            DQN("MlpPolicy", env, seed=seed + 1, device="cpu", **own).learn(steps, callback=Counting())
    finally:
        env.close()


def ours(cell, path, seed, strategy):
    """A scan, as on the command line. Its clock begins before the program does; that of the others when the cell is at its start."""
    import fmi_hazard

    search = {"strategy": strategy, "seed": seed, "iterations": cell.iterations}
    with tempfile.TemporaryDirectory() as out:
        with fmi_hazard.start_scan(path, from_="start", no_advice=True, workers=1, out=out, **search) as running:
            for event in running:
                if event["event"] == "hazard" and cell.first is None:
                    cell.first, cell.first_s = event["hazard"]["first_iteration"], time.monotonic() - cell.began
            cell.ids = {hazard["id"] for hazard in running.result().hazards}
    cell.done = cell.iterations


def run(method, cell, path, seed):
    """All iterations of a seed."""
    name, _, setting = method.partition(":")
    tuned = setting == "tuned"
    if name == "uniform":
        from staliro.optimizers import UniformRandom

        taliro(cell, seed, UniformRandom(), tuned)
    elif name == "annealing":
        from staliro.optimizers import DualAnnealing

        taliro(cell, seed, DualAnnealing(), tuned)
    elif name in ("halton", "cross-entropy"):
        verifai(cell, seed, name, tuned)
    elif name == "ours":
        ours(cell, path, seed, setting)
    elif name == "dqn":
        learning(cell, path, seed, tuned)
    else:
        raise SystemExit(f"there is no peer {method}")


def main():
    method, path, first, seeds, iterations = sys.argv[1], sys.argv[2], *map(int, sys.argv[3:])
    # What a peer loads is none of its time.
    for name in LOADED.get(method.partition(":")[0], []):
        importlib.import_module(name)
    cell = Cell(path, iterations)
    for seed in range(first, first + seeds):
        cell.begin()
        try:
            run(method, cell, path, seed)
        except Enough:
            pass
        told = {"seed": seed, "iterations": cell.done, "first": cell.first, "first_s": cell.first_s}
        print(json.dumps({**told, "ids": sorted(cell.ids), "seconds": time.monotonic() - cell.began}), flush=True)


if __name__ == "__main__":
    main()
