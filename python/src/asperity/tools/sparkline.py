"""A small curve as SVG, for notebooks: drawn here, since a picture of its own is no reason to load matplotlib."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from .style import BLUE, GREY

Array = npt.NDArray[np.float64]

_WIDTH, _HEIGHT, _EDGE = 300, 140, 26


def is_wide(low: Array | None, high: Array | None) -> bool:
    """Whether a band spans more than a factor of 10, so that it is drawn on a logarithmic axis."""
    return low is not None and high is not None and bool(low.min() > 0) and bool(high.max() > 10 * low.min())


def sparkline(load: Array, value: Array, low: Array | None = None, high: Array | None = None) -> str:
    """Friction over loads > 0, of which the axis is logarithmic, with a band if there is one."""
    wide = is_wide(low, high)
    top = 1.05 * float(np.max(value if high is None else high))
    bottom = float(np.min(low)) / 1.05 if wide and low is not None else 0.0
    x = _EDGE + (_WIDTH - 2 * _EDGE) * _part(np.log(load))

    def points(of: Array) -> list[str]:
        part = np.log(of / bottom) / np.log(top / bottom) if wide else of / top
        y = _HEIGHT - _EDGE - (_HEIGHT - 2 * _EDGE) * part
        return [f"{a:.1f},{b:.1f}" for a, b in zip(x, y)]

    band = ""
    if low is not None and high is not None:
        outline = " ".join([*points(low), *reversed(points(high))])
        band = f'<polygon points="{outline}" fill="{BLUE}" fill-opacity="0.2"/>'
    base = _HEIGHT - _EDGE
    label = f"friction coefficient {value[0]:.3g} at the load {load[0]:.3g}, {value[-1]:.3g} at {load[-1]:.3g}"
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{_WIDTH}" height="{_HEIGHT}" role="img" aria-label="{label}" '
        f'font-family="DejaVu Sans, sans-serif" font-size="10" fill="{GREY}">'
        f'<path d="M{_EDGE},{_EDGE} V{base} H{_WIDTH - _EDGE}" fill="none" stroke="{GREY}"/>{band}'
        f'<polyline points="{" ".join(points(value))}" fill="none" stroke="{BLUE}" stroke-width="1.6"/>'
        f'<text x="{_EDGE}" y="{_HEIGHT - 10}">{load[0]:.3g}</text>'
        f'<text x="{_WIDTH - _EDGE}" y="{_HEIGHT - 10}" text-anchor="end">{load[-1]:.3g}</text>'
        f'<text x="{_WIDTH / 2:g}" y="{_HEIGHT - 10}" text-anchor="middle">load [force]</text>'
        f'<text x="{_EDGE}" y="{_EDGE - 8}">F/P, {bottom:.3g} to {top:.3g}</text></svg>'
    )


def _part(x: Array) -> Array:
    return np.asarray((x - x[0]) / (x[-1] - x[0] or 1.0))
