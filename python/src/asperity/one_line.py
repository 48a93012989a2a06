"""Friction in one line: a pair of materials, the roughness, the load.

    import asperity

    mu = asperity.friction("Si/Si", Sq=5e-9, Sdq=0.05, Sds=1e13, load=1e-3, nominal_area=1e-8)
"""

from __future__ import annotations

from functools import lru_cache
from typing import Any

import numpy as np

from ._surface_file import from_mean_deviation, with_interface
from .materials import MATERIALS, PAIRS, Pair, contact
from .model import Model
from .params import Params

# Surfaces whose models are kept: enough for a comparison in a loop, a megabyte in all.
_KEPT = 8


def friction(pair: str | Pair, *, load: Any, nominal_area: float = 1.0, interface: str | None = None, **surface: Any) -> Any:
    """The friction coefficient of two materials with a roughness, at a load or at many. SI units.

    For more than the coefficient make `Params` and a `Model`; this is the same in one call. Models of the last surfaces are
    kept, so that asking again is quick.

    Args:
        pair: a name in `asperity.materials.PAIRS`, as "steel/steel", in either order; or two names in `MATERIALS`, as
            "SiC/SiC", with a `work_of_adhesion`.
        load: normal load [N] on `nominal_area`; a number, an array, a pandas Series or an xarray DataArray.
        nominal_area: [m^2]; without it loads are those of a square metre: nominal pressures [Pa].
        interface: a name in `asperity.materials.INTERFACES`, whose shear strength stands for the default: `Params.with_interface`.
        **surface: the roughness, as `Params.from_iso25178` (`Sq`, `Sdq` and `Sds` or `Ssc`), `Params.from_spectral_moments`
            (`m0`, `m2`, `m4`; `Ra` of Gaussian heights may stand for `Sq` or `m0`) or `Params.si` (`height_std`, `summit_radius`, `summit_density`) take it, and what
            is to replace the numbers of the pair or a default: `work_of_adhesion`, `slip_stress_1`, `kurtosis`, ...

    Returns:
        F/P: a float for a number, else what came in, with the same shape and labels.

    Raises:
        KeyError: materials that are not known; the message has the nearest.
        Error: a value that the library refuses.
        TypeError: a name that is unknown or missing.

    Warns:
        ValidityWarning: an assumption of the model that fails at one of the loads > 0, once for a surface.
    """
    if not isinstance(pair, Pair) and not isinstance(pair, str):
        raise TypeError(f"pair = {pair!r}: must be a name, as 'steel/steel', or one of asperity.materials.PAIRS")
    surface = from_mean_deviation(surface)
    given = _contact(pair, surface) | surface
    make: Any = Params.si
    if surface.keys() & {"Sq", "Sdq", "Sds", "Ssc"}:
        make = Params.from_iso25178
    elif surface.keys() & {"m0", "m2", "m4"}:
        make = Params.from_spectral_moments
    elif "height_std" not in surface:
        raise TypeError("the roughness is missing: give Sq, Sdq and Sds or Ssc; or m0, m2 and m4; or height_std, "
                        "summit_radius and summit_density")  # fmt: skip
    model = _model(with_interface(_made(make, given, nominal_area), interface, surface))
    found = model.friction_at_load(load)
    pressing = np.asarray(load, dtype=np.float64)
    pressing = pressing[pressing > 0]
    if pressing.size:
        model.warn(float(pressing.min()), float(pressing.max()))
    return found


def _made(make: Any, given: dict[str, Any], nominal_area: float) -> Params:
    try:
        params: Params = make(**given, nominal_area=nominal_area)
    except TypeError as error:
        raise TypeError(str(error).replace(f"{make.__qualname__}()", "friction()")) from None
    return params


def _contact(pair: str | Pair, surface: dict[str, Any]) -> dict[str, Any]:
    """What the materials tell: of a pair, or of two bodies with a work of adhesion that is given."""
    given = {name: surface[name] for name in ("work_of_adhesion", "burgers_vector") if name in surface}
    names = pair.split("/") if isinstance(pair, str) else []
    if len(names) == 2 and all(name in MATERIALS for name in names):
        return contact(*names, **given)
    known = PAIRS[pair] if isinstance(pair, str) else pair
    return known.contact_with(**given)


@lru_cache(maxsize=_KEPT)
def _model(params: Params) -> Model:
    return Model(params)
