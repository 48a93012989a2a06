"""The friction law of two surfaces, ready for use."""

from __future__ import annotations

import warnings
from typing import TYPE_CHECKING, Any, Mapping

import numpy as np

from . import units
from ._friction_law import FrictionLaw
from .curve import Curve
from .errors import Error
from .fits.uncertainty import ALL_ELSE, AS_GIVEN, strength_of, uncertainty
from .results import ValidityWarning
from .tools import checks

if TYPE_CHECKING:
    from concurrent.futures import Executor


class Model(FrictionLaw):
    """The friction law of two surfaces: friction coefficient and force as functions of the normal load.

    >>> params = asperity.Params.from_iso25178(
    ...     Sq=5e-9, Sdq=0.08, nominal_area=1e-8, **asperity.materials.PAIRS["Si/Si"].contact)
    >>> model = asperity.Model(params)
    >>> print(f"{model.friction_at_load(1e-3):.1f}, {model.friction_force_at_load(1e-3):.0e} N")
    0.4, 4e-04 N

    Making a model takes milliseconds: make it once, and call it for each load or array of loads. Threads may share a model,
    and their calls run in parallel, since they do not hold the interpreter lock. A model pickles and copies through its
    parameters. Use it in a `with` statement, or call `close`, to free its memory at a known time.

    Loads of `friction_at_load` and `friction_force_at_load`, one or many:

    - load >= pull-off load: the friction. The coefficient is at most `max_friction_coefficient`, and equal to it
      for loads <= 0, where F is finite and F/P is not;
    - below the pull-off load: 0, since a separated contact has no friction. This is no error;
    - NaN, infinite, or too heavy to be evaluated: `Error`, which for arrays names the index of the first such load.

    Args:
        params: the surfaces.

    Raises:
        Error: a parameter that the library refuses; the message names it, its value and what is allowed.
    """

    def curve(
        self,
        loads: Any = None,
        *,
        spread: Mapping[str, float] | None = None,
        coverage: float = 0.95,
        samples: int = 0,
        seed: int = 0,
        executor: Executor | None = None,
    ) -> Curve:
        """Friction over a range of loads, to look at: `model.curve().plot()`; a notebook shows it by itself.

        Args:
            loads: normal loads > 0 [force], one-dimensional, in any order; by default 61 from 1e-4 to 1e2 times
                `asperity_count` E* b^2.
            spread: name to standard deviation of parameters that are not known well, which gives the curve a band:
                {"work_of_adhesion": 0.3} is 30 %; see `asperity.uncertainty`. A strength of the interface that was not
                measured (`uncalibrated`), or measured with an error (`Params.calibrated`), always gives it one. All else counts as
                known, also an assumed slope, which the band of `asperity.friction` has.
            coverage: probability of the band, between 0 and 1.
            samples: how many surfaces to draw for the band; 0 for the linear one.
            seed: of the random numbers.
            executor: where the samples of the band are evaluated, by default here; see `asperity.uncertainty`.

        Raises:
            Error: loads or a spread that cannot be used.
            Error: what the library refuses.

        Warns:
            ValidityWarning: an assumption of the model that fails at one of the loads.
        """
        params, coverage = self.params, checks.share("coverage", coverage)
        unit = params.asperity_count * params.composite_modulus * params.burgers_vector**2
        load = np.geomspace(1e-4 * unit, 1e2 * unit, 61) if loads is None else np.sort(checks.one_or_more("loads", loads, self._unit()))
        if not load[0] > 0:
            raise Error("loads: must be > 0, since their axis is logarithmic")
        force = self.friction_force_at_load(load)
        band = None
        if spread is not None or strength_of(self).deviation > 0:
            band = uncertainty(params, spread, load, coverage=coverage, samples=samples, seed=seed, executor=executor)
        # The band is that of first loading, about what a larger load has left.
        first = FrictionLaw(params).friction_force_at_load(load) if self._open().largest_load else force
        self.warn(float(load[0]), float(load[-1]))
        return Curve(
            params,
            load,
            self.friction_at_load(load),
            force,
            None if band is None else band.low * (force / first),
            None if band is None else band.high * (force / first),
            None if band is None else coverage,
            self.check(float(load[0]), float(load[-1])),
            (AS_GIVEN, ALL_ELSE) if band is None else band.rests_on,
        )

    def _repr_html_(self) -> str:
        """For notebooks: the parameters with their units, and a small curve."""
        if self._handle is None:
            return "<p>closed Model</p>"
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", ValidityWarning)  # of a picture that nobody asked for
            found = self.curve()
        return units.table(self.params) + found._repr_html_()
