"""What the friction force at constant load changes by with each parameter.

The library's sensitivities are sums over the summits, no differences: right to 1e-7, in a tenth of a millisecond or two.
"""

from __future__ import annotations

import os
from dataclasses import dataclass, fields
from typing import TYPE_CHECKING

from .tools.style import BLUE, ORANGE, saved, style

if TYPE_CHECKING:
    from matplotlib.figure import Figure

# Of these the sensitivity is d(ln F)/dp: they may be 0 or negative.
LINEAR = ("radius_amplitude", "skew", "pressure_coefficient")
# Sensitivities smaller than this part of the largest are left out of the figure.
_INVISIBLE = 1e-3


@dataclass(frozen=True)
class Sensitivities:
    """What the friction force F, and so the friction coefficient, at constant load changes by with each parameter p.

    d(ln F)/d(ln p), the percentage of F for each percent of p; for `radius_amplitude`, `skew` and
    `pressure_coefficient`, which may be 0, d(ln F)/dp. 0 for a parameter that the model does not read.

    Attributes:
        load: at which load [force].
        composite_modulus: to E*.
        effective_shear_modulus: to G*: 1 where `pressure_coefficient` is 0.
        work_of_adhesion: to w; 0 where w is 0.
        adhesion_range: to h; 0 where w is 0.
        burgers_vector: to b; the slip radii grow with it.
        height_std: to sigma.
        summit_radius: to R.
        asperity_count: to N.
        weibull_shape: to omega; 0 unless heights are Weibull's.
        radius_amplitude: d(ln F)/d(epsilon), also where epsilon is 0.
        radius_rate: to rho; 0 where epsilon is 0.
        slip_radius_1: to a_1/b.
        slip_stress_1: to tau_1/G*.
        slip_radius_2: to a_2/b.
        slip_stress_2: to tau_2/G*.
        skew: d(ln F)/d(skew) at this kurtosis; 0 unless heights are Johnson's.
        kurtosis: at this skew; 0 unless heights are Johnson's.
        hardness: to H; 0 where contacts are elastic.
        pressure_coefficient: d(ln F)/d(kappa), also where kappa is 0.
    """

    load: float
    composite_modulus: float
    effective_shear_modulus: float
    work_of_adhesion: float
    adhesion_range: float
    burgers_vector: float
    height_std: float
    summit_radius: float
    asperity_count: float
    weibull_shape: float
    radius_amplitude: float
    radius_rate: float
    slip_radius_1: float
    slip_stress_1: float
    slip_radius_2: float
    slip_stress_2: float
    skew: float
    kurtosis: float
    hardness: float
    pressure_coefficient: float

    def by_size(self) -> dict[str, float]:
        """The parameters that are read, the most important first."""
        named = {name: getattr(self, name) for name in NAMES}
        return {name: value for name, value in sorted(named.items(), key=lambda item: -abs(item[1])) if value != 0}

    def plot(self, file: str | os.PathLike[str] | None = None) -> Figure:
        """Draws a bar for each parameter, the largest on top, and writes the figure if a file is named.

        Args:
            file: its ending is its format, for example "sensitivities.svg".

        Raises:
            ImportError: matplotlib is missing.
        """
        with style():
            from matplotlib.figure import Figure

            sizes = self.by_size()
            largest = max(map(abs, sizes.values()))
            shown = {name: value for name, value in sizes.items() if abs(value) > _INVISIBLE * largest}
            figure = Figure(figsize=(6.5, 1 + 0.32 * len(shown)), layout="constrained")
            axes = figure.subplots()
            labels = [f"{name}, absolute" if name in LINEAR else name for name in shown]
            colors = [BLUE if value > 0 else ORANGE for value in shown.values()]
            bars = axes.barh(labels, list(shown.values()), color=colors)
            axes.bar_label(bars, fmt="%.2f", padding=3)
            axes.invert_yaxis()
            axes.margins(x=0.15)
            axes.axvline(0, color="black", linewidth=0.8)
            axes.set_xlabel(f"% of friction per % of the parameter, at load {self.load:.4g}")
            axes.grid(axis="y", visible=False)
            return saved(figure, file)


NAMES = tuple(field.name for field in fields(Sensitivities) if field.name != "load")
