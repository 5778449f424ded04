"""A joint that turns while it is allowed to, for the exporter PythonFMU (FMI 2.0)."""

from pythonfmu import Boolean, Fmi2Causality, Fmi2Slave, Fmi2Variability, Integer, Real


class Joint2(Fmi2Slave):
    description = "A joint that turns while it is allowed to"

    def __init__(self, **kwargs):
        super().__init__(**kwargs)
        self.q = 0.0
        self.steps = 0
        self.speed = 0.5
        self.stop = False
        self.register_variable(Real("q", causality=Fmi2Causality.output))
        self.register_variable(
            Integer("steps", causality=Fmi2Causality.output, variability=Fmi2Variability.discrete)
        )
        self.register_variable(Real("speed", causality=Fmi2Causality.input, start=0.5))
        self.register_variable(
            Boolean("stop", causality=Fmi2Causality.input, variability=Fmi2Variability.discrete, start=False)
        )

    def do_step(self, current_time, step_size):
        self.steps += 1
        if not self.stop:
            self.q += self.speed * step_size
        return True
