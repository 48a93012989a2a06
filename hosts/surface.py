"""The surface of all hosts, and the check that the model holds for it at the loads of a run. The same in C is
hosts/surface.h. hosts/surface.toml says where the numbers come from.
"""

from pathlib import Path

import asperity

SURFACE = Path(__file__).resolve().parent / "surface.toml"


def surface(nominal_area, length=1.0, force=1.0):
    """Parameters in a system whose units of length and force are so many m and N: SI, or length=1e-3 for mm, N and MPa. The
    nominal area is in that system too."""
    params = asperity.Params.from_toml(SURFACE)
    area = nominal_area * length**2
    summits = params.asperity_count * area / params.nominal_area
    return params.replace(asperity_count=summits, nominal_area=area).in_units(length=length, force=force)


def demand(model, lightest, heaviest, fewest_summits=None):
    """Raises RuntimeError unless the model holds at all loads between two. fewest_summits: how many of the model's summits
    lie on the smallest contact, where loads are loads per area; the warning of too few contacts is about all of them."""
    if not model.params.hardness > 0:
        raise RuntimeError("the hardness of the surface is not given: whether asperities yield is not known")
    warnings = model.check(lightest, heaviest)
    # The strength of this interface was not measured: said, and no reason to stop.
    told = warnings & asperity.Warnings.UNCALIBRATED
    if told:
        print(f"  {told}")
    warnings &= ~told
    if warnings:
        raise RuntimeError(f"the model does not hold for this surface from {lightest:.4g} to {heaviest:.4g}: {warnings}")
    touching = model.state_at_load(lightest).fraction_in_contact * (fewest_summits or model.params.asperity_count)
    if touching < 20:
        raise RuntimeError(f"at {lightest:.4g} {touching:.2g} summits touch: too few for a mean")
    print(f"  the model holds for this surface from {lightest:.4g} to {heaviest:.4g}, with {touching:.2g} contacts or more")
