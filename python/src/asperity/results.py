"""Answers of a model other than friction: the exact state of the contact, and the constants of the model."""

from __future__ import annotations

from dataclasses import dataclass, fields
from enum import IntFlag
from functools import reduce
from operator import or_
from typing import Any, Iterator, NamedTuple

import numpy as np
import numpy.typing as npt

from . import _header, _units
from ._labelled import frame, like
from ._library import LIBRARY


class Warnings(IntFlag):
    """Assumptions of the model that fail in a state, or in the states of a range of loads: bits, none of which is set if
    nothing is known to fail. `str` says what fails and what to do about it, one line each.

    `PLASTIC`: summits yield, but the contact law is elastic. The mean asperity pressure is above 0.4 of the hardness, or the
    plasticity index above 1. Never where the hardness is not given.
    `CROWDED`: summits do not act independently. More than 10 % of them touch, or the real area is more than 10 % of the nominal.
    `STEEP`: contacts are too large for their summits, above a tenth of their radius on average.
    `ATOMIC`: contacts are too small for continuum mechanics, below the Burgers vector on average.
    `FEW`: fewer than 20 summits touch, so averages are not reliable. Never where `asperity_count` is 1.
    `ADHESIVE`: adhesion presses the surfaces together with more than the load. Never where `asperity_count` is 1.
    `UNCALIBRATED`: the strength of the interface is the default, not a measured one: see `Params.calibrated`. Never where
    `asperity_count` is 1.
    `BROAD`: the surface is rough on many scales, with a bandwidth above 6.
    `STRONG`: the interface is stronger than the softer body. Never where the hardness is not given.
    """

    PLASTIC = _header.ASPERITY_WARNING_PLASTIC
    CROWDED = _header.ASPERITY_WARNING_CROWDED
    STEEP = _header.ASPERITY_WARNING_STEEP
    ATOMIC = _header.ASPERITY_WARNING_ATOMIC
    FEW = _header.ASPERITY_WARNING_FEW
    ADHESIVE = _header.ASPERITY_WARNING_ADHESIVE
    UNCALIBRATED = _header.ASPERITY_WARNING_UNCALIBRATED
    BROAD = _header.ASPERITY_WARNING_BROAD
    STRONG = _header.ASPERITY_WARNING_STRONG

    @property
    def kinds(self) -> list[Warnings]:
        """The warnings that are set, one by one."""
        return [Warnings(1 << bit) for bit in range(64) if self & (1 << bit)]

    @property
    def description(self) -> str:
        """What a single warning says, in the library's words: what fails and what to do about it."""
        text: bytes = LIBRARY.asperity_warning_string(self)
        return text.decode()

    def __str__(self) -> str:
        return "\n".join(f"{_name(kind)}: {kind.description}" for kind in self.kinds) or "none"

    def __format__(self, spec: str) -> str:
        return format(int(self), spec) if spec else str(self)


class ValidityWarning(UserWarning):
    """An assumption of the model fails at loads at which friction is drawn, tabulated or estimated."""


def _name(kind: Warnings) -> str:
    return f"{kind.name}" if kind in set(Warnings) else f"bit {int(kind):#x}"


class _WithUnits:
    """Shows a dataclass with its units."""

    def __repr__(self) -> str:
        return _units.text(self)

    def _repr_html_(self) -> str:
        return _units.table(self)


@dataclass(frozen=True, repr=False)
class State(_WithUnits):
    """The exact state of the contact, in the units of the parameters.

    Attributes:
        load: normal load P [force]; negative pulls.
        separation: of the flat from the mean of the summit heights [length].
        friction_force: F [force].
        friction_coefficient: F/P, capped, as `Model.friction_at_load` gives it.
        dforce_dload: dF/dP; infinite at the pull-off load itself.
        dmu_dload: d(F/P)/dP [1/force]; 0 where the coefficient is capped.
        dload_dseparation: dP/dd [force/length]: minus the contact stiffness.
        real_area: real area of contact [length^2].
        contacting: number of summits in contact.
        attracted: number of summits that attract without contact.
        attraction_load: part of the load that those carry, <= 0 [force].
        mean_contact_radius: mean radius of the contacts [length]; 0 where there are none.
        max_contact_radius: radius of the largest contact [length]: the largest up to the height that 1/(n + 1) of the n
            contacting summits exceed; not below the mean radius, which it is for n <= 1.
        fraction_below_slip_radius_1: fraction of the contacts with radii up to slip_radius_1.
        fraction_between_slip_radii: fraction of the contacts with radii between slip_radius_1 and slip_radius_2.
        fraction_above_slip_radius_2: fraction of the contacts with radii from slip_radius_2 on.
        fraction_in_contact: fraction of all summits that are in contact.
        mean_asperity_pressure: load of the summits in contact over their real area [stress].
        plasticity_index: Greenwood and Williamson's E* (sigma/R)^(1/2)/H; 0 where the hardness is not given.
        warnings: assumptions of the model that fail in this state; 0 if none is known to fail.
        tangential_stiffness: K_t [force/length], tangential force by displacement while all contacts stick.
        fraction_elastic: fraction of the contacts below first yield; 1 for "maugis" without a hardness.
        fraction_flowing: fraction of the contacts that are fully plastic.
        contact_radius_sum: sum of the radii of all contacts [length]; their constriction conductance is 2 k times it.
        hertz_load: sum of the loads of Hertz' contacts of the same radii [force]: the load and what adhesion adds to it.
        friction_scatter: standard deviation of the friction force over its mean, of nominally equal contacts under this load.
        friction_bias: mean friction force of them over `friction_force`, less 1.
    """

    load: float
    separation: float
    friction_force: float
    friction_coefficient: float
    dforce_dload: float
    dmu_dload: float
    dload_dseparation: float
    real_area: float
    contacting: float
    attracted: float
    attraction_load: float
    mean_contact_radius: float
    max_contact_radius: float
    fraction_below_slip_radius_1: float
    fraction_between_slip_radii: float
    fraction_above_slip_radius_2: float
    fraction_in_contact: float
    mean_asperity_pressure: float
    plasticity_index: float
    warnings: Warnings
    tangential_stiffness: float
    fraction_elastic: float
    fraction_flowing: float
    contact_radius_sum: float
    hertz_load: float
    friction_scatter: float
    friction_bias: float


class States:
    """Exact states at many loads or separations.

    The attributes are those of `State`, each an array of the shape that was asked for, with the labels of a Series or a
    DataArray: `states.real_area`. `warnings` holds those of any state, `warning_bits` those of each as integers.
    `states[i]` is one `State`; there are `len(states)` of them.
    """

    def __init__(self, states: list[State], arrays: dict[str, Any], warnings: Warnings) -> None:
        self._states, self._arrays, self.warnings = states, arrays, warnings

    @classmethod
    def of(cls, states: list[State], given: Any, shape: tuple[int, ...]) -> States:
        """States in the order of what was given, which has this shape."""
        arrays = {}
        for name in _STATE_NAMES:
            kind = np.uint64 if name == "warnings" else np.float64
            values = np.array([getattr(state, name) for state in states], dtype=kind).reshape(shape)
            named = "warning_bits" if name == "warnings" else name
            arrays[named] = like(given, values, named)
        return cls(states, arrays, reduce(or_, (state.warnings for state in states), Warnings(0)))

    def __getattr__(self, name: str) -> Any:
        arrays = self.__dict__.get("_arrays", {})
        if name not in arrays:
            raise AttributeError(f"{name!r}: states have {', '.join(arrays)} and warnings")
        return arrays[name]

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self._arrays]

    def __len__(self) -> int:
        return len(self._states)

    def __getitem__(self, index: int) -> State:
        return self._states[index]

    def __iter__(self) -> Iterator[State]:
        return iter(self._states)

    def __repr__(self) -> str:
        return f"<States: {len(self)} of them, with {', '.join(self._arrays)}>"

    def to_pandas(self) -> Any:
        """A `pandas.DataFrame`, a row for each state.

        Raises:
            ImportError: pandas is missing.
        """
        return frame({name: np.ravel(array) for name, array in self._arrays.items()})


_STATE_NAMES = tuple(field.name for field in fields(State))


@dataclass(frozen=True)
class Hysteresis:
    """A closed loop of tangential force against displacement, in the units of the parameters.

    Attributes:
        displacement: from the greatest to the least, and back [length].
        force: the tangential force there [force].
        work: dissipated in one cycle, the area of the loop [force length].
    """

    displacement: npt.NDArray[np.float64]
    force: npt.NDArray[np.float64]
    work: float


class SummitStates(NamedTuple):
    """Single summits, in the units of the parameters; arrays of the shape of the overlaps.

    Attributes:
        load: of each summit [force], negative where it pulls.
        friction_force: [force]; 0 out of contact.
        contact_radius: [length]; 0 out of contact.
    """

    load: npt.NDArray[np.float64]
    friction_force: npt.NDArray[np.float64]
    contact_radius: npt.NDArray[np.float64]


@dataclass(frozen=True, repr=False)
class Summary(_WithUnits):
    """Constants of a model, in the units of the parameters.

    Attributes:
        alpha: (sigma/R)^(1/2), surface roughness.
        beta: (R sigma)^(1/2)/b, friction regime.
        gamma: w/(E* b), surface energy.
        lambda_: Maugis' adhesion parameter: small is DMT, large is JKR.
        skew: of the summit heights.
        kurtosis: of the summit heights; 3 for Gaussian.
        pull_off_load: the least load that holds the surfaces together, <= 0 [force]. Of the mean surface: a pad of which few
            summits touch hangs on the tallest of them, and holds far more; see `asperity.pads`.
        pull_off_friction_force: friction force at the pull-off load [force].
        zero_load_friction_force: friction force at zero load [force], of the mean surface as well.
        min_table_load: the lightest load of the compiled table [force]; below it the law goes on with its slope, as a power.
        max_table_load: the heaviest load of the compiled table [force]; above it likewise.
        table_error: largest relative error of the compiled friction force found when it was built, at samples; between
            them it may be four times as large, or 2e-10 where that is more.
    """

    alpha: float
    beta: float
    gamma: float
    lambda_: float
    skew: float
    kurtosis: float
    pull_off_load: float
    pull_off_friction_force: float
    zero_load_friction_force: float
    min_table_load: float
    max_table_load: float
    table_error: float
