"""A box that slides down an incline: what the solvers whose loads jitter are compared with. SI units.

The load on the box is its weight's part normal to the incline, on average; so its acceleration is known, from the law
at that load. The box lies on a plane, and gravity is inclined.
"""

import math

import asperity
import habits
import verdict
from surface import demand, surface

GRAVITY, AREA, ANGLE = 9.81, 1e-4, math.radians(24)
MASS, DOWNHILL, NORMAL = 1.0, GRAVITY * math.sin(ANGLE), GRAVITY * math.cos(ANGLE)  # of the case that is computed
HABITS = {
    "another surface": dict(adhesion=0.02), "0.1 kg": dict(mass=0.1), "10 kg": dict(mass=10.0), "calibrated": dict(measured=(10, 0.2)),
    "steeper": dict(angle=math.radians(40), mass=3.0, adhesion=0.02), "another step": dict(share=0.5),
}  # fmt: skip
SHARE = 1.0  # of its step that a host is to take
HALF_LENGTHS = (0.1, 0.05, 0.05)
FIRST_GUESS = 0.3  # the coefficient before a load is known
TIME_CONSTANT = 0.02  # of the mean of the loads [s]
LIMIT = 0.05


def law(mass=1.0, angle=ANGLE, adhesion=None, measured=None, share=1.0):
    """The law of a case, which becomes the one that is computed; checked from a half to twice the load."""
    global MASS, DOWNHILL, NORMAL, SHARE
    MASS, DOWNHILL, NORMAL, SHARE = mass, GRAVITY * math.sin(angle), GRAVITY * math.cos(angle), share
    params = surface(AREA) if adhesion is None else surface(AREA).replace(work_of_adhesion=adhesion)
    model = asperity.Model(params.calibrated(*measured) if measured else params)
    demand(model, MASS * NORMAL / 2, MASS * NORMAL * 2)
    return model


def right_acceleration(model):
    return DOWNHILL - model.state_at_load(MASS * NORMAL).friction_force / MASS


def acceleration(times, speeds):
    """The slope of the line through the speeds, a tenth of a second after the start."""
    points = [(t, v) for t, v in zip(times, speeds) if t > 0.1]
    mean_t, mean_v = (sum(column) / len(points) for column in zip(*points))
    return sum((t - mean_t) * (v - mean_v) for t, v in points) / sum((t - mean_t) ** 2 for t, _ in points)


def run(host, slide, lagged=None, limit=LIMIT, share=0.5):
    """The verdict on the accelerations that `slide` gives with each habit, one after the other in one process; `share` of the step is one. `lagged`,
    with the load of the step before, must miss: else the test would show nothing."""
    found = []

    def error(**change):
        of_case = law(**change)
        found.append((slide(of_case), right_acceleration(of_case)))
        print("  {:.4f} in place of {:.4f}".format(*found[-1]), flush=True)
        return found[-1][0] / found[-1][1] - 1

    def main():
        (worst,) = habits.worst(HABITS | {"another step": dict(share=share)}, error)
        late = lagged and lagged(law())
        good = worst <= limit and (not lagged or abs(late / right_acceleration(law()) - 1) > limit)
        missed = f"; {late:.3f} at the load of the step before" if lagged else ""
        first = "{:.3f} in place of {:.3f}".format(*found[0])
        return good, f"box on an incline: {first} m/s2, {len(HABITS)} habits, {worst:.1e} (limit {limit:g}){missed}"

    verdict.run(host, main)
