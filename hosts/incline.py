"""A box that slides down an incline: what the solvers whose loads jitter are compared with. SI units.

The load on the box is its weight's part normal to the incline, on average; so its acceleration is known, from the law
at that load. The box lies on a plane, and gravity is inclined.
"""

import math

import asperity
from surface import demand, surface

MASS, GRAVITY, ANGLE, AREA = 1.0, 9.81, math.radians(24), 1e-4
HALF_LENGTHS = (0.1, 0.05, 0.05)
DOWNHILL, NORMAL = GRAVITY * math.sin(ANGLE), GRAVITY * math.cos(ANGLE)
FIRST_GUESS = 0.3  # the coefficient before a load is known
TIME_CONSTANT = 0.02  # of the mean of the loads [s]
LIMIT = 0.05


def law():
    """The law of the box on the incline, checked from a half to twice the load."""
    model = asperity.Model(surface(AREA))
    demand(model, MASS * NORMAL / 2, MASS * NORMAL * 2)
    return model


def right_acceleration(model):
    return DOWNHILL - model.state_at_load(MASS * NORMAL).friction_force / MASS


def acceleration(times, speeds):
    """The slope of the line through the speeds, a tenth of a second after the start."""
    points = [(t, v) for t, v in zip(times, speeds) if t > 0.1]
    mean_t, mean_v = (sum(column) / len(points) for column in zip(*points))
    return sum((t - mean_t) * (v - mean_v) for t, v in points) / sum((t - mean_t) ** 2 for t, _ in points)


def judge(mean, right, lagged=None):
    """The verdict. The lagged load, where given, must miss: else the test would show nothing."""
    error = abs(mean / right - 1)
    good = error <= LIMIT and (lagged is None or abs(lagged / right - 1) > LIMIT)
    missed = "" if lagged is None else f"; {lagged:.3f} at the load of the step before"
    return good, f"box on an incline: {mean:.3f} in place of {right:.3f} m/s2, {error:.1e} (limit {LIMIT:g}){missed}"
