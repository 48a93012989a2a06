"""A friction coefficient with the band that it is known within, as `asperity.friction` returns it."""

from __future__ import annotations

import ctypes
import os
import re
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
import numpy.typing as npt

from . import _header
from ._library import LIBRARY, text_of
from .errors import Error, Status, check
from .params import Params
from .results import Warnings
from .tools import checks
from .tools.band_figure import drawn

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

Array = npt.NDArray[np.float64]

_SOURCES = {
    _header.ASPERITY_STRENGTH_DEFAULT: "default",
    _header.ASPERITY_STRENGTH_TABLE: "table",
    _header.ASPERITY_STRENGTH_GIVEN: "given",
    _header.ASPERITY_STRENGTH_MEASURED: "measured",
}
_SPECIMENS = {
    _header.ASPERITY_SPECIMEN_MANY_CONTACTS: "many contacts",
    _header.ASPERITY_SPECIMEN_ANY: "any",
    _header.ASPERITY_SPECIMEN_MEASURED: "measured",
}
_SHARES = ("strength", "size", "pressure", "adhesion", "hardness", "slope", "measurement", "model", "specimen")
# Of more loads the text has the first and the last.
_WRITTEN = 8
# A line over these loads in a figure; around one load it reaches so far either way.
_DRAWN, _AROUND = 61, 10.0


class Band(NamedTuple):
    """A quantity with the ends of its band, like the loads."""

    value: Any
    low: Any
    high: Any


class OneSpecimen(NamedTuple):
    """What an estimate tells of one specimen, with bands, like the loads: the same as of many where many summits touch.

    Attributes:
        of: whose the numbers of each load are, like the loads: "many contacts" (specimens hardly differ), "any" (one, whichever it is) or
            "measured" (the one that was measured, with `specimens=1`).
        friction: F/P; infinite from the pull-off load to 0.
        another: F/P of another specimen than the measured one; that of `friction` where none was.
        force: F [N], also without a load.
        stiffness, normal_stiffness: K_t and -dP/d(gap) [N/m].
        gap: between the mean planes [m]; NaN if the surfaces are apart.
        pull_off: the largest pull that a specimen withstands [N]; NaN at loads at which many summits touch: ask at 0.
    """

    of: Any
    friction: Band
    another: Band
    force: Band
    stiffness: Band
    normal_stiffness: Band
    gap: Band
    pull_off: Band


@dataclass(frozen=True, eq=False, repr=False)
class Estimate:
    """A friction coefficient, or many, with a band: a number that says how far it can be trusted.

    `float(estimate)` and `numpy.asarray(estimate)` are the coefficient alone; `print(estimate)` says all of it.

    Attributes:
        value: F/P: a float for one load, else what the loads came in, with the same shape and labels. Infinite from the
            pull-off load to 0, where F/P has no limit; 0 below.
        low: lower end of the band, like `value`; None if all inputs count as known.
        high: upper end; None with it.
        coverage: the probability that the coefficient lies between `low` and `high`; None with them.
        force: F [N], like `value`.
        contacts: how many summits touch, by the mean of the model, like `value`; NaN if loads are pressures. Below 20 `value` is that of one
            specimen, and its scatter is in the band.
        specimens: what one specimen has, with bands: friction, stiffness, gap and pull-off.
        curve: F/P of `Model(estimate.params)`, like `value`: the same to the digits that are printed, or the text says how far off it is. NaN
            where no strength gives the measured friction.
        constant_odds: how probable it is that F/P is within 10 % of the measured mean, like `value`: above 0.8 a constant does.
        stiffness, normal_stiffness, unloading_stiffness, contact_radius_sum, gap: K_t and -dP/d(gap) [N/m], of loading and when the load
            begins to fall, the sum of the radii of all contacts [m] and the gap between the mean planes [m], each a `Band` of `value`,
            `low` and `high`; the constriction conductance is 2 k times the fourth.
        shares: "strength", "size", "pressure", "adhesion", "hardness", "slope", "measurement", "model" and "specimen" to the share of the variance of
            ln(F/P) that each causes, like `value`: what would narrow the band.
        strength: what the strength of the interface rests on: "default", "table" (of interfaces), "given" or "measured".
        error_growth: by how much the errors of the measured points grew, since they contradict each other; 1 if they do not.
        warnings: what of the model fails between the lightest and the heaviest load > 0.
        unit: of the loads, "N"; "Pa" if no nominal area was given: loads are nominal pressures then, and forces shear stresses.
    """

    value: Any
    low: Any
    high: Any
    coverage: float | None
    force: Any
    contacts: Any
    specimens: OneSpecimen
    curve: Any
    constant_odds: Any
    stiffness: Band
    normal_stiffness: Band
    unloading_stiffness: Band
    contact_radius_sum: Band
    gap: Band
    shares: dict[str, Any]
    strength: str
    error_growth: float
    warnings: Warnings
    unit: str
    _text: str
    _loads: Array = field(default_factory=lambda: np.empty(0))

    @cached_property
    def text(self) -> str:
        """The estimate for people, as the library writes it: coefficients, what they rest on, what would narrow the band."""
        loads = self._loads if self._loads.size <= _WRITTEN else self._loads[[0, -1]]
        text = self._text.encode()
        return text_of(LIBRARY.asperity_estimate_text, text, len(text), loads.size, loads.ctypes.data_as(_header._double)).rstrip()

    @cached_property
    def params(self) -> Params:
        """The surfaces as the estimate takes them, with its contact law and strength: `Model(estimate.params)` has its friction."""
        return Params.from_text(self._text if self.unit == "N" else f"nominal_area = 1.0\n{self._text}")

    @property
    def surface(self) -> str:
        """A surface file of `params`."""
        return self.params.to_text()

    def plot(self, file: str | os.PathLike[str] | None = None, *, axes: Axes | None = None) -> Figure:
        """Draws the coefficient with its band over the load, marks the loads asked for and the measured points, and writes the figure
        if a file is named.

        The line reaches from the lightest to the heaviest of these loads; around a single one a decade either way.

        Args:
            file: its ending is its format, for example "friction.svg".
            axes: of a figure of your own to draw in.

        Raises:
            ImportError: Matplotlib is missing.
            Error: no load is > 0, since the axis of loads is logarithmic.
        """
        shown = np.isfinite(self.value) & (self._loads.reshape(np.shape(self.value)) > 0)
        at, value = self._loads[np.ravel(shown)], np.ravel(np.asarray(self.value))[np.ravel(shown)]
        if not at.size:
            raise Error("load: must be > 0 to be drawn, since the axis of loads is logarithmic", Status.INVALID_LOAD)
        measured = _measured(self._text)
        every = np.concatenate([at, measured[:, 0]])
        reach = _AROUND if every.min() == every.max() else 1.0
        line = np.geomspace(every.min() / reach, every.max() * reach, _DRAWN)
        found = estimate(self._text, line, self.coverage or 0.95)
        label = "\n".join((f"{100 * (self.coverage or 0.0):g} % band", *self.rests_on))
        return drawn(file, axes, self.unit, line, found.value, found.low, found.high, label, (at, value), measured)

    @property
    def rests_on(self) -> tuple[str, ...]:
        """What was taken for granted, a line each; first the strength of the interface."""
        return self._lines("rests on: ")

    @property
    def narrow(self) -> tuple[str, ...]:
        """What would make the band narrower, a line each."""
        return self._lines("to narrow it: ")

    def _lines(self, kind: str) -> tuple[str, ...]:
        return tuple(line.removeprefix(kind) for line in self.text.splitlines() if line.startswith(kind))

    def __float__(self) -> float:
        return float(self.value)

    def __array__(self, dtype: Any = None, copy: Any = None) -> Any:
        return np.array(self.value, dtype=dtype)

    def __format__(self, spec: str) -> str:
        """With a format of numbers, as in f"{estimate:.3f}": the coefficient and its band, or that it has no limit; else all of it."""
        if not spec:
            return repr(self)
        ends = zip(*(np.ravel(end) for end in (self.low, self.high))) if self.low is not None else None
        shown = []
        for value in np.ravel(self.value):
            low_high = f" ({' to '.join(format(float(end), spec) for end in next(ends))})" if ends else ""
            shown.append(format(float(value), spec) + low_high if np.isfinite(value) else "no limit")
        return ", ".join(shown)

    def __repr__(self) -> str:
        return self.text


def estimate(surface: str, load: Any, coverage: float = 0.95, unit: str = "") -> Estimate:
    """What the library estimates of the text of a surface, at one load or many."""
    loads = checks.array("load", load, unit)
    text, flat = surface.encode(), np.ravel(loads)
    found = (_header.asperity_estimate * max(flat.size, 1))()
    found[0].struct_size = ctypes.sizeof(_header.asperity_estimate)
    check(LIBRARY.asperity_estimate_at_loads(text, len(text), flat.size, flat.ctypes.data_as(_header._double), found))

    table = np.ctypeslib.as_array(found)[: flat.size]

    def column(name: str) -> Any:
        values = np.ascontiguousarray(table[name]).reshape(loads.shape)
        return checks.shaped(load, values, name)

    def band(name: str) -> Band:
        return Band(column(name), column(f"{name}_low"), column(f"{name}_high"))

    known = bool((table["low"] == table["high"]).all())
    coefficient = Band(*(column(name) for name in ("friction_coefficient", "low", "high")))
    stiffness, normal, gap, another = band("tangential_stiffness"), band("normal_stiffness"), band("gap"), band("another_force")
    with np.errstate(divide="ignore", invalid="ignore"):
        another = Band(*(checks.shaped(load, np.asarray(end) / loads, "another") for end in another))
    of = np.array([_SPECIMENS[code] for code in table["specimen"]]).reshape(loads.shape)
    whose = str(of) if of.ndim == 0 else of
    one = OneSpecimen(whose, coefficient, another, band("friction_force"), stiffness, normal, gap, band("pull_off_force"))
    return Estimate(
        coefficient.value,
        None if known else coefficient.low,
        None if known else coefficient.high,
        None if known else coverage,
        column("friction_force"),
        column("contacts"),
        one,
        column("curve_coefficient"),
        column("constant_odds"),
        stiffness,
        normal,
        band("unloading_stiffness"),
        band("contact_radius_sum"),
        gap,
        {name: column(f"{name}_share") for name in _SHARES},
        _SOURCES[found[0].strength_source],
        found[0].error_growth,
        Warnings(found[0].warnings),
        "Pa" if found[0].is_of_pressures else "N",
        surface,
        flat,
    )


_POINTS = re.compile(r"^\s*measured\s*=\s*(\[(?:[^\[\]]|\[[^\[\]]*\])*\])", re.MULTILINE)


def _measured(surface: str) -> Array:
    """The measured points in a text that the library took: rows of load and coefficient."""
    text = re.sub(r"#.*", "", surface)
    if (found := _POINTS.search(text)) is not None:
        points = re.findall(r"\[([^\[\]]*)\]", found[1])
        return np.array([[float(number) for number in point.split(",")[:2]] for point in points])
    keys = ("calibration_load", "calibration_friction_coefficient", "calibration_friction_force")
    given = {key: float(one[1]) for key in keys if (one := re.search(rf"^\s*{key}\s*=\s*(\S+)", text, re.MULTILINE)) is not None}
    load = given.pop("calibration_load", 0.0)
    if not (given and load > 0):
        return np.empty((0, 2))
    return np.array([[load, given.get("calibration_friction_coefficient", given.get("calibration_friction_force", 0.0) / load)]])
