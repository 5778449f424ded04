"""A joint that turns while it is allowed to, for the exporter PythonFMU3 (FMI 3.0)."""

from pythonfmu3 import Boolean, Float64, Fmi3Causality, Fmi3Slave, Fmi3Variability, Int32


class Joint3(Fmi3Slave):
    description = "A joint that turns while it is allowed to"

    def __init__(self, **kwargs):
        super().__init__(**kwargs)
        self.time = 0.0
        self.q = 0.0
        self.steps = 0
        self.speed = 0.5
        self.stop = False
        self.register_variable(
            Float64("time", causality=Fmi3Causality.independent, variability=Fmi3Variability.continuous)
        )
        self.register_variable(Float64("q", causality=Fmi3Causality.output))
        self.register_variable(Int32("steps", causality=Fmi3Causality.output, variability=Fmi3Variability.discrete))
        self.register_variable(Float64("speed", causality=Fmi3Causality.input, start=0.5))
        self.register_variable(
            Boolean("stop", causality=Fmi3Causality.input, variability=Fmi3Variability.discrete, start=False)
        )

    def do_step(self, current_time, step_size):
        self.steps += 1
        if not self.stop:
            self.q += self.speed * step_size
        return True
