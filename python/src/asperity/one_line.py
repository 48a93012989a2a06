"""Friction in one line: a pair of materials, the roughness, the load; a number with its band.

    import asperity

    mu = asperity.friction("steel/steel", Ra=0.8e-6, process="ground", load=20.0, nominal_area=1e-4)
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Iterator

import numpy as np

from ._surface_text import load_unit, text_of_values, without_line
from .errors import Error
from .estimate import Estimate, estimate
from .materials import PAIRS, Pair
from .results import ValidityWarning
from .tools import caller, checks

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._surface_text import Surface


def friction(
    pair: str | Pair | None = None,
    *,
    load: Any,
    nominal_area: float | None = None,
    coverage: float = 0.95,
    **surface: Unpack[Surface],
) -> Estimate:
    """The friction coefficient of two materials with a roughness, at a load or at many, with its band. SI units.

    >>> estimate = asperity.friction("steel/steel", Ra=0.8e-6, process="ground", load=10.0, nominal_area=1e-4, measured=(1000, 0.16))
    >>> print(f"{estimate:.3f}")
    0.173 (0.108 to 0.279)

    `print(estimate)` says what the number rests on and what would narrow its band. It is the call `asperity_estimate_at_loads` of
    the library, of the surface file that the arguments make (docs/solvers.md). For more than the coefficient make a model of the same
    surfaces: `Model(estimate.params)`.

    The band has all that is not known, narrowed by the points that were `measured`: the strength of the interface, whether it depends on
    the size of contacts (a film is taken, unless `interface_kind` is "clean") and on pressure, adhesion, the slope of the surface, the
    hardness, and how real interfaces leave the law between loads. docs/when-to-use.md has what is taken of each. `known_to` says
    what you know better, as {"slope": 1.2, "hardness": 1.1}.

    Where summits yield (a plasticity index above 1) the contact law is elastic-plastic, without adhesion, unless you give a
    `contact_law` or a `work_of_adhesion`. A surface file has the same law.

    Args:
        pair: a name in `asperity.materials.PAIRS`, as "steel/steel", in either order; or two names in `MATERIALS`, as
            "SiC/SiC". `E1`, `nu1`, `E2`, `nu2` and `hardness` replace its numbers. Without a pair give
            these, or `composite_modulus` and `effective_shear_modulus`, and `work_of_adhesion`, `adhesion_range` and
            `burgers_vector`.
        load: normal load [N] on `nominal_area`; a number, an array, a pandas Series or an xarray DataArray. Here and in all
            other numbers a quantity of pint, astropy or xarray is converted; masked numbers are refused.
        nominal_area: [m^2]; without it loads are nominal pressures [Pa].
        coverage: probability of the band, between 0 and 1.
        **surface: the keys of surface files. Of the roughness: `Ra` or `Rq` with `RSm`, `Rdq` or a `process` ("superfinished",
            "lapped", "honed", "ground", "turned", "bored", "milled"); a `process` alone; `Sq` with `Sdq`; `m0` and `m2`; or
            `height_std`, `summit_radius` and `summit_density`. Two rough surfaces are two numbers for each. `measured`, a
            measured point (load, coefficient) or (load, coefficient, relative error), or several of them; or
            `calibration_load` with `calibration_friction_coefficient`. `specimens`, on how many it was measured: say it where fewer than 20
            summits touch. `interface`, a name in
            `asperity.materials.INTERFACES`; `interface_kind`, "film", "clean", "dry metal" or "rock". `measured_on`, the roughness of the
            specimen that was measured, where it is not this one, as {"Ra": 1.6e-6, "RSm": 80e-6}: its strength in Pa is taken. And what is to replace the numbers of the pair or a default:
            `work_of_adhesion`, `slip_stress_1`, `kurtosis`, ...

    Raises:
        Error: names and values that the library refuses; the message has what is allowed, or the nearest name.
        TypeError: a keyword that surface files do not have; a value that is neither a number nor a word.

    Warns:
        ValidityWarning: an assumption of the model that fails at one of the loads > 0.
    """
    coverage = checks.share("coverage", coverage)
    area = {} if nominal_area is None else {"nominal_area": nominal_area}
    given = dict(() if pair is None else of_pair(pair)) | area | {"coverage": coverage} | dict(surface)
    try:
        found = estimate(text_of_values(given), load, coverage, load_unit(given))
    except Error as error:
        raise without_line(error, surface) from None
    for kind in found.warnings.kinds:
        pressing = np.ravel(found._loads)
        pressing = pressing[pressing > 0]
        caller.warn(f"between the loads {pressing.min():g} and {pressing.max():g}: {kind}", ValidityWarning)
    return found


def of_pair(pair: str | Pair) -> Iterator[tuple[str, Any]]:
    """The keys of a pair: its name, and the numbers that are not those of the library."""
    if isinstance(pair, str):
        yield "pair", pair
        return
    if not isinstance(pair, Pair):
        raise TypeError(f"pair = {pair!r}: must be a name, as 'steel/steel', or one of asperity.materials.PAIRS")
    yield "pair", pair.name
    known = PAIRS.get(pair.name)
    for name in ("work_of_adhesion", "slip_stress_1"):
        value = getattr(pair, name)
        if value is not None and (known is None or value != getattr(known, name)):
            yield name, value
