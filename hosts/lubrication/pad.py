"""A pad that slides on an oil film and on the summits of its roughness: mixed lubrication. The film is the average Reynolds equation
of Patir and Cheng (1978, 1979) in one direction, p = p_fluid + P(h)/A0 and shear = shear_fluid + F/A0, with P and F of the library.
SI units.
"""

import math
import sys
from pathlib import Path

import asperity
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
import habits  # of hosts/
import verdict
from surface import demand, surface

LENGTH, WEDGE, SIGMA, AREA = 1e-3, 1.0, 9.8e-9, 1e-6  # of the pad; inlet over outlet film less 1; of both surfaces; nominal
VISCOSITY, PRESSURE = 0.01, 5e6  # of the oil; the mean one that the pad carries
X = np.linspace(0, LENGTH, 4001)
FILM_LIMIT, SLOW_LIMIT, SAME_LIMIT = 1e-3, 1e-3, 1e-9
HABITS = {
    "a steep pad": dict(wedge=5.0), "a flat pad": dict(wedge=0.1), "a long pad": dict(length=3e-3), "a coarse mesh": dict(cells=1000),
    "thick oil": dict(viscosity=0.1), "a tenth of the load": dict(pressure=PRESSURE / 10), "ten times the load": dict(pressure=10 * PRESSURE),
    "calibrated": dict(measured=(PRESSURE * AREA, 0.1)),
}  # fmt: skip


def along(value):
    """The integral up to each place."""
    return np.concatenate([[0], np.cumsum((value[1:] + value[:-1]) / 2 * np.diff(X))])


def pad(law, outlet, speed, viscosity=VISCOSITY):
    """Load and friction by width of the film and of the summits, for a film that is so high at the outlet."""
    h = outlet * (1 + WEDGE * (1 - X / LENGTH))
    H, z = h / SIGMA, h / SIGMA / 3
    through = 1 - 0.9 * np.exp(-0.56 * H)  # what roughness leaves of the flow
    film = h * (1 + np.vectorize(math.erf)(H / 2**0.5)) / 2 + SIGMA * np.exp(-(H**2) / 2) / (2 * np.pi) ** 0.5
    resistance = 12 * viscosity / (through * h**3)
    flow = along(resistance * speed * film / 2)[-1] / along(resistance)[-1]
    slope = resistance * (speed * film / 2 - flow)
    low = np.minimum(z, 1)
    touching = (1 - low**2) ** 3 * np.log(300 * (low + 1)) + (
        -55 + low * (132 + low * (345 + low * (-160 + low * (-405 + low * (60 + 147 * low)))))) / 60  # fmt: skip
    high = np.clip(z, 1 + 1e-9, 10)
    apart = (1 - high**2) ** 3 * np.log((high + 1) / (high - 1)) + high / 15 * (66 + high**2 * (30 * high**2 - 80))
    shear = np.where(z < 10, 35 / 32 * z * np.where(z < 1, touching, apart), 1)  # 1 within 4e-3 from there on
    drag = viscosity * speed / h * shear + (1 - 1.4 * np.exp(-0.66 * H)) * h / 2 * slope
    load = np.maximum(law.load_at_gap(h), 0)
    summits = np.where(load > 0, law.friction_force_at_load(load), 0)
    return tuple(along(value)[-1] for value in (along(slope), drag, load / AREA, summits / AREA))


def balanced(law, speed, viscosity=VISCOSITY, pressure=PRESSURE):
    """The film at the outlet at which film and summits carry the load, and what `pad` gives there."""
    low, high = 0.5 * SIGMA, 1e5 * SIGMA
    for _ in range(60):
        outlet = (low * high) ** 0.5
        fluid, _, contact, _ = pad(law, outlet, speed, viscosity)
        low, high = (outlet, high) if fluid + contact > pressure * LENGTH else (low, outlet)
    return outlet, pad(law, outlet, speed, viscosity)


def fit_over_integral(height):
    """A fit that many codes copy for the integral F_5/2 of Greenwood and Tripp, over the integral."""
    above = np.linspace(0, 12, 200001)
    integral = np.sum(above**2.5 * np.exp(-((height + above) ** 2) / 2)) * above[1] / (2 * np.pi) ** 0.5
    return 4.4086e-5 * (4 - height) ** 6.804 / integral


def errors(wedge=1.0, length=LENGTH, cells=4000, viscosity=VISCOSITY, pressure=PRESSURE, measured=None):
    """Of the film alone against the smooth pad, of a slow pad against the law, and of ten times the viscosity at a tenth of the speed."""
    global WEDGE, LENGTH, X
    WEDGE, LENGTH, X = wedge, length, np.linspace(0, length, cells + 1)
    params = surface(AREA).replace(work_of_adhesion=0.0)  # oil wets the summits
    law = asperity.Model(params.calibrated(*measured) if measured else params)
    demand(law, pressure * AREA / 2, 2 * (1 + wedge) * pressure * AREA)
    fluid, drag, _, _ = pad(law, 1000 * SIGMA, 1.0, viscosity)
    unit, log = viscosity * LENGTH / (1000 * SIGMA), math.log(1 + WEDGE)
    smooth = 6 / WEDGE**2 * (log - 2 * WEDGE / (2 + WEDGE)) * unit * LENGTH / (1000 * SIGMA), (4 * log / WEDGE - 6 / (2 + WEDGE)) * unit
    film = np.max(np.abs(np.array([fluid, drag]) / smooth - 1))
    outlet, (fluid, drag, contact, summits) = balanced(law, 1e-9, viscosity, pressure)
    loads = law.load_at_gap(outlet * (1 + WEDGE * (1 - X[:: cells // 250] / LENGTH)))
    exact = np.array([law.state_at_load(load).friction_force if load > 0 else 0 for load in loads]) / AREA
    slow = (drag + summits) / (np.sum(exact[1:] + exact[:-1]) / 2 * LENGTH / 250) - 1
    same = balanced(law, 1e-3, viscosity, pressure)[0] / balanced(law, 1e-4, 10 * viscosity, pressure)[0] - 1
    return film, slow, same


def main():
    print("  the fit over the integral F_5/2:", *(round(fit_over_integral(height), 3) for height in (0, 2, 3, 3.5)))
    law = asperity.Model(surface(AREA).replace(work_of_adhesion=0.0))  # oil wets the summits
    demand(law, PRESSURE * AREA / 2, 20 * PRESSURE * AREA)
    curve = []
    for speed in np.geomspace(1e-7, 1, 15):
        outlet, (fluid, drag, contact, summits) = balanced(law, speed)
        curve.append((drag + summits) / (fluid + contact))
        print(f"  {speed:.0e} m/s | {outlet / SIGMA:.2f} sigma | {100 * contact / (fluid + contact):.2f} % | {curve[-1]:.4f} |")
    film, slow, same = habits.worst(HABITS, errors)
    good = film <= FILM_LIMIT and slow <= SLOW_LIMIT and same <= SAME_LIMIT and min(curve) < curve[-1] and min(curve) < 0.1 * curve[0]
    return good, (
        f"friction {curve[0]:.3f} on summits, {min(curve):.4f} at least, {curve[-1]:.4f} on the film; film alone within {film:.0e} of "
        f"the smooth pad (limit {FILM_LIMIT:g}), slow within {slow:.0e} of the law (limit {SLOW_LIMIT:g}), {len(HABITS)} habits"
    )


if __name__ == "__main__":
    verdict.run("lubrication", main)
