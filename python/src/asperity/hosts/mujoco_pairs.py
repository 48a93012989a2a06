"""Which pairs of geoms have which law, and what a model must have, for the back ends of MuJoCo that take no plugin."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, Union

import mujoco
import numpy as np
import numpy.typing as npt

from ..errors import Error
from ..model import Model

Geoms = Union[str, tuple[str, str]]


class Pairs:
    """The pairs of geoms of a model that have a law; each has a number."""

    def __init__(self, model: mujoco.MjModel, laws: Mapping[Geoms, Model]) -> None:
        by_pair = _laws_by_pair(model, laws)
        self.count = len(by_pair)
        #: Each law once.
        self.laws = list({id(each): each for each in by_pair.values()}.values())
        #: The place in `laws` of the law of each pair.
        self.law_of: npt.NDArray[np.int32] = np.array([self.laws.index(each) for each in by_pair.values()], dtype=np.int32)
        #: The number of the pair of two geoms; -1 without a law.
        self.number = np.full((model.ngeom, model.ngeom), -1, dtype=np.int32)
        for number, (a, b) in enumerate(by_pair):
            self.number[a, b] = self.number[b, a] = number


class Attached:
    """What `attach` of a back end makes: the pairs that have a law, and how their loads are taken.

    Args:
        model: the `MjModel` of which `m` was made.
        m: the back end's model, with elliptic cones.
        laws: for the names of two geoms, or of one for all that it touches, the law. Changes of `Params` need a new `attach`.
        time_constant: of the mean of the loads [s]; 0.05, or 40 steps if that is more, unless given.
        passes: how often a step is solved for its loads before it is solved with the law; 1 where contacts rarely begin.

    Raises:
        Error: pyramidal cones, RK4, geoms with two surfaces, a time constant or passes that are none.
        KeyError: there is no such geom.
    """

    def __init__(self, model: mujoco.MjModel, m: Any, laws: Mapping[Geoms, Model], time_constant: float | None, passes: int) -> None:
        if int(m.opt.cone) != int(mujoco.mjtCone.mjCONE_ELLIPTIC):
            raise Error('needs <option cone="elliptic"/>: in the pyramidal cone friction depends on the direction of slip')
        if int(m.opt.integrator) == int(mujoco.mjtIntegrator.mjINT_RK4):
            raise Error("needs an integrator that solves a step once, as Euler or implicitfast, not RK4")
        if time_constant is not None and not 0 < time_constant < np.inf:
            raise Error(f"time_constant = {time_constant!r}: must be positive and finite")
        if passes < 1:
            raise Error(f"passes = {passes!r}: must be at least 1")
        self.passes = passes
        self.time_constant = time_constant
        self._pairs = Pairs(model, laws)


def lag_rule(where: Any, minimum: Any, maximum: Any) -> Callable[..., Any]:
    """At which load the friction of a pair is, whose load in this step is known: the mean load of pairs that have touched for long,
    and the load itself of others; then what is remembered: the mean, for how long the pair has touched, and for how long it has been
    apart. With the functions of a back end, of whose arrays or numbers it is computed."""

    def rule(time: float, before: float, step: float, constant: float, load: float, mean: float, age: float, apart: float):  # type: ignore[no-untyped-def]
        # A run that begins again, and a pair that was open for long, have no past.
        had = where(time <= before, 0.0, where(apart > 2.0 * constant, 0.0, age))
        held = where(had > 0.0, mean, 0.0)
        average = held + (load - held) * step / minimum(had + step, maximum(step, constant))
        return where(had > constant, average, load), average, had + step, where(load > 0.0, 0.0, apart + step)

    return rule


def _laws_by_pair(model: mujoco.MjModel, laws: Mapping[Geoms, Model]) -> dict[tuple[int, int], Model]:
    """The law of each two geoms, the smaller number first; a pair that is named has its own."""

    def number(name: str) -> int:
        return int(model.geom(name).id)  # whose KeyError lists the names that there are

    found: dict[tuple[int, int], Model] = {}
    for geoms, of_one in laws.items():
        if not isinstance(geoms, str):
            continue
        for other in range(model.ngeom):
            pair = min(number(geoms), other), max(number(geoms), other)
            if found.setdefault(pair, of_one) is not of_one:
                names = tuple(model.geom(geom).name for geom in pair)
                if names not in laws and names[::-1] not in laws:
                    raise Error(f"geoms {names[0]!r} and {names[1]!r} have different surfaces: name the pair too")
    for geoms, of_pair in laws.items():
        if not isinstance(geoms, str):
            a, b = map(number, geoms)
            found[min(a, b), max(a, b)] = of_pair
    return found
