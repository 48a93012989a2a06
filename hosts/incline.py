"""A box that slides down an incline: what the solvers whose loads jitter are compared with. SI units.

The load on the box is its weight's part normal to the incline, on average; so its acceleration is known, from the law
at that load. The box lies on a plane, and gravity is inclined.
"""

import math

import asperity
import verdict
from surface import demand, surface

MASS, GRAVITY, ANGLE, AREA = 1.0, 9.81, math.radians(24), 1e-4
HALF_LENGTHS = (0.1, 0.05, 0.05)
DOWNHILL, NORMAL = GRAVITY * math.sin(ANGLE), GRAVITY * math.cos(ANGLE)
FIRST_GUESS = 0.3  # the coefficient before a load is known
TIME_CONSTANT = 0.02  # of the mean of the loads [s]
LIMIT = 0.05


def law(work_of_adhesion=None):
    """The law of the box on the incline, checked from a half to twice the load; of another surface with a work of adhesion."""
    params = surface(AREA)
    model = asperity.Model(params if work_of_adhesion is None else params.replace(work_of_adhesion=work_of_adhesion))
    demand(model, MASS * NORMAL / 2, MASS * NORMAL * 2)
    return model


def right_acceleration(model):
    return DOWNHILL - model.state_at_load(MASS * NORMAL).friction_force / MASS


def acceleration(times, speeds):
    """The slope of the line through the speeds, a tenth of a second after the start."""
    points = [(t, v) for t, v in zip(times, speeds) if t > 0.1]
    mean_t, mean_v = (sum(column) / len(points) for column in zip(*points))
    return sum((t - mean_t) * (v - mean_v) for t, v in points) / sum((t - mean_t) ** 2 for t, _ in points)


def run(host, slide, lagged=None, limit=LIMIT):
    """The verdict on the accelerations that `slide` gives for the laws of two surfaces, one after the other in one process. `lagged`,
    with the load of the step before, must miss: else the test would show nothing."""

    def main():
        worst, found = 0.0, []
        for of_surface in (law(), law(work_of_adhesion=0.02)):
            right, mean = right_acceleration(of_surface), slide(of_surface)
            worst = max(worst, abs(mean / right - 1)) if mean == mean else mean
            found.append(f"{mean:.3f} in place of {right:.3f}")
        late = lagged and lagged(law())
        good = worst <= limit and (not lagged or abs(late / right_acceleration(law()) - 1) > limit)
        missed = f"; {late:.3f} at the load of the step before" if lagged else ""
        return good, f"box on an incline: {', '.join(found)} m/s2, {worst:.1e} (limit {limit:g}){missed}"

    verdict.run(host, main)
