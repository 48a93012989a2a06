"""Friction over a range of loads, ready to be drawn, with a band where a parameter is not known exactly.

    model.curve([1e-6, 1e-5, 1e-4], spread={"work_of_adhesion": 0.3}).plot("curve.svg")
"""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from .params import Params
from .results import Warnings
from .tools.band_figure import drawn
from .tools.labelled import frame
from .tools.sparkline import sparkline
from .units import unit

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

Array = npt.NDArray[np.float64]


@dataclass(frozen=True, eq=False, repr=False)
class Curve:
    """Friction at loads > 0, ascending. `Model.curve` makes it.

    Attributes:
        params: the surfaces.
        load: normal loads [force].
        friction_coefficient: F/P at each.
        friction_force: F at each [force].
        low: lower end of the band of the coefficient; None where all parameters count as known.
        high: upper end; None with it.
        coverage: the probability that the coefficient lies within the band; None with it.
        warnings: what of the model fails between the lightest load and the heaviest.
        rests_on: what the band takes as known, and how well: the strength of the interface, what has a spread, and that all else is known.
    """

    params: Params
    load: Array
    friction_coefficient: Array
    friction_force: Array
    low: Array | None
    high: Array | None
    coverage: float | None
    warnings: Warnings
    rests_on: tuple[str, ...]

    def plot(self, file: str | os.PathLike[str] | None = None, *, axes: Axes | None = None) -> Figure:
        """Draws the coefficient over the load, with the band and what it rests on, and writes the figure if a file is named.

        The axis of the coefficient is logarithmic where the band spans more than a factor of 10.

        Args:
            file: its ending is its format, for example "curve.svg".
            axes: of a figure of your own to draw in.

        Raises:
            ImportError: matplotlib is missing.
        """
        label = "\n".join((self._band(), *self.rests_on))
        return drawn(file, axes, self._unit(), self.load, self.friction_coefficient, self.low, self.high, label)

    def to_pandas(self) -> Any:
        """A `pandas.DataFrame` of the arrays, a row for each load.

        Raises:
            ImportError: pandas is missing.
        """
        names = ("load", "friction_coefficient", "friction_force", "low", "high")
        return frame({name: getattr(self, name) for name in names if getattr(self, name) is not None})

    def __repr__(self) -> str:
        ends = f"{self.load[0]:.4g} to {self.load[-1]:.4g} [{self._unit()}]"
        values = f"{self.friction_coefficient[0]:.4g} to {self.friction_coefficient[-1]:.4g}"
        band = f"{self._band()}; " if self.coverage is not None else ""
        return f"<Curve: friction coefficient {values} at {self.load.size} loads from {ends}; {band}{'; '.join(self.rests_on)}>"

    def _unit(self) -> str:
        return unit("force", self.params.in_si)

    def _band(self) -> str:
        return f"{100 * (self.coverage or 0.0):g} % band"

    def _repr_html_(self) -> str:
        return sparkline(self.load, self.friction_coefficient, self.low, self.high)
