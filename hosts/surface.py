"""The surface of all hosts, and the check that the model holds for it at the loads of a run. The same in C is
hosts/surface.h. docs/hosts-reference.md says where the numbers come from.
"""

import asperity

# Hard carbon on hard carbon, ta-C(51) of Nature Commun. 12 (2021), doi 10.1038/s41467-021-24766-6, table 1: Young's
# modulus, hardness, and the roughness of both bodies together after running in. The slope is taken as that of the
# steepest ascent, twice the variance of a profile's. Poisson's ratio, adhesion and b are those of docs/materials.md;
# Nayak's bandwidth was not measured: 10 is assumed.
YOUNG, POISSON, HARDNESS, ADHESION, BURGERS = 493e9, 0.25, 51e9, 0.06, 0.25e-9
RMS_HEIGHT, RMS_SLOPE, BANDWIDTH = 9.8e-9, 0.060, 10


def surface(nominal_area, metre=1.0, pascal=1.0):
    """Parameters in a system whose units are so many to a metre and a pascal: SI, or metre=1e3, pascal=1e-6 for mm and
    MPa. The nominal area is in that system too."""
    m0, m2 = RMS_HEIGHT**2, RMS_SLOPE**2 / 2
    return asperity.Params.from_spectral_moments(
        m0=m0 * metre**2, m2=m2, m4=BANDWIDTH * m2**2 / m0 / metre**2, nominal_area=nominal_area,
        E1=YOUNG * pascal, nu1=POISSON, E2=YOUNG * pascal, nu2=POISSON, work_of_adhesion=ADHESION * pascal * metre,
        adhesion_range=BURGERS * metre, burgers_vector=BURGERS * metre, hardness=HARDNESS * pascal,
    )


def demand(model, lightest, heaviest, fewest_summits=None):
    """Raises RuntimeError unless the model holds at all loads between two. fewest_summits: how many of the model's summits
    lie on the smallest contact, where loads are loads per area; the warning of too few contacts is about all of them."""
    if not model.params.hardness > 0:
        raise RuntimeError("the hardness of the surface is not given: whether summits yield is not known")
    warnings = model.check(lightest, heaviest)
    # The strength of this interface was not measured, and its bandwidth is assumed: said, and no reason to stop.
    told = warnings & (asperity.Warnings.UNCALIBRATED | asperity.Warnings.BROAD)
    if told:
        print("\n".join(f"  {line}" for line in str(told).split("\n")))
    warnings &= ~told
    if warnings:
        raise RuntimeError(f"the model does not hold for this surface from {lightest:.4g} to {heaviest:.4g}: {warnings}")
    touching = model.state_at_load(lightest).fraction_in_contact * (fewest_summits or model.params.asperity_count)
    if touching < 20:
        raise RuntimeError(f"at {lightest:.4g} {touching:.2g} summits touch: too few for a mean")
    print(f"  the model holds for this surface from {lightest:.4g} to {heaviest:.4g}, with {touching:.2g} contacts or more")
