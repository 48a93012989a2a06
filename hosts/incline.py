"""A box that slides down an incline: what the solvers whose loads jitter are compared with. SI units.

The load on the box is its weight's part normal to the incline, on average; so its acceleration is known, from the law
at that load. The box lies on a plane, and gravity is inclined.
"""

import math

import asperity
import verdict
from surface import demand, surface

GRAVITY, AREA, ANGLE = 9.81, 1e-4, math.radians(24)
MASS, DOWNHILL, NORMAL = 1.0, GRAVITY * math.sin(ANGLE), GRAVITY * math.cos(ANGLE)  # of the case that is computed
# What a user changes: the mass, the angle, the surface.
CASES = (dict(), dict(adhesion=0.02), dict(mass=0.1), dict(mass=10.0), dict(angle=math.radians(40), mass=3.0, adhesion=0.02))
HALF_LENGTHS = (0.1, 0.05, 0.05)
FIRST_GUESS = 0.3  # the coefficient before a load is known
TIME_CONSTANT = 0.02  # of the mean of the loads [s]
LIMIT = 0.05


def law(mass=1.0, angle=ANGLE, adhesion=None):
    """The law of a case, which becomes the one that is computed; checked from a half to twice the load."""
    global MASS, DOWNHILL, NORMAL
    MASS, DOWNHILL, NORMAL = mass, GRAVITY * math.sin(angle), GRAVITY * math.cos(angle)
    params = surface(AREA)
    model = asperity.Model(params if adhesion is None else params.replace(work_of_adhesion=adhesion))
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
    """The verdict on the accelerations that `slide` gives in all cases, one after the other in one process. `lagged`, with the load of the
    step before, must miss: else the test would show nothing."""

    def main():
        worst, found = 0.0, []
        for case in CASES:
            of_case = law(**case)
            right, mean = right_acceleration(of_case), slide(of_case)
            print(f"  {case}: {mean:.4f} in place of {right:.4f}", flush=True)
            worst = max(worst, abs(mean / right - 1)) if mean == mean else math.inf
            found.append(f"{mean:.3f} in place of {right:.3f}")
        late = lagged and lagged(law())
        good = worst <= limit and (not lagged or abs(late / right_acceleration(law()) - 1) > limit)
        missed = f"; {late:.3f} at the load of the step before" if lagged else ""
        return good, f"box on an incline: {found[0]}, {found[-1]} m/s2, {len(found)} cases, {worst:.1e} (limit {limit:g}){missed}"

    verdict.run(host, main)
