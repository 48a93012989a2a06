"""The figure of a fit: measured and fitted friction over the load, the residuals below."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from ._style import saved, style
from .model import Model

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from .fit import Fit

Array = npt.NDArray[np.float64]

_SI = {"stress": "Pa", "force/length": "N/m", "length": "m", "force": "N"}


def draw(fit: Fit, file: str | os.PathLike[str] | None, units: str | None) -> Figure:
    """Draws it, and writes it if a file is named."""
    if units not in (None, "SI"):
        raise ValueError(f"units = {units!r}: must be 'SI', or None if they are others")

    def unit(dimension: str) -> str:
        return f" [{dimension if units is None else _SI[dimension]}]" if dimension else ""

    with style():
        from matplotlib.figure import Figure

        figure = Figure(figsize=(7.5, 6), layout="constrained")
        above, below = figure.subplots(2, 1, sharex=True, gridspec_kw={"height_ratios": (3, 1)})
        linear_to = _linear_to(fit.load)
        if (fit.load > 0).all():
            above.set_xscale("log")
        else:
            above.set_xscale("symlog", linthresh=linear_to)
        if (fit.fitted > 0).all() and (fit.measured > 0).all():
            above.set_yscale("log" if fit.quantity == "force" else "linear")
        above.errorbar(fit.load, fit.measured, yerr=fit.sigma, fmt="o", ms=4, mfc="none", color="black", label="measured")
        load = _loads(fit.load, linear_to)
        named = "\n".join(
            f"  {name} = {fit.values[name]:.4g} ± {fit.errors[name]:.1g}{unit(fit.dimensions[name])}" for name in fit.free
        )
        pressing = load[load > 0]
        if pressing.size:
            with Model(fit.params) as model:
                model.warn(float(pressing.min()), float(pressing.max()))
        curve, deviation = fit.predict(load)
        if np.isfinite(deviation).all():
            above.fill_between(load, curve - 2 * deviation, curve + 2 * deviation, color="C0", alpha=0.25, lw=0,
                               label="two standard errors of the fit")  # fmt: skip
        above.plot(load, curve, color="C0", label=f"fitted\n{named}")
        above.set_ylabel("friction coefficient $F/P$" if fit.quantity == "mu" else f"friction force $F${unit('force')}")
        above.legend()

        below.axhline(0, color="C0")
        below.plot(fit.load, fit.residuals, "o", ms=4, mfc="none", color="black")
        below.set(xlabel=f"normal load $P${unit('force')}", ylabel="residual" if fit.sigma is None else r"residual/$\sigma$")
        return saved(figure, file)


def _linear_to(load: Array) -> float:
    """Up to which magnitude the axis of loads is linear where some of them are <= 0."""
    positive = load[load > 0]
    return max(-float(load.min()), float(positive.min()) if positive.size else 0.0) or 1.0


def _loads(measured: Array, linear_to: float) -> Array:
    """Where to draw the curve."""
    lowest, highest = float(measured.min()), float(measured.max())
    if lowest > 0:
        return np.geomspace(lowest, highest, 200)
    light = np.linspace(lowest, min(linear_to, highest), 200)
    return np.concatenate([light, np.geomspace(linear_to, highest, 200)]) if highest > linear_to else light
