"""The surface of all hosts, and the check that the model holds for it at the loads of a run. The same in C is
hosts/surface.h. docs/hosts.md says where the numbers come from.
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


def fault(model, load, area_ratio=1):
    """What of the model does not hold at this load; None where all does. area_ratio: nominal area of the contact over
    that of the model, which is 1 unless the load is one per area."""
    state, params = model.state_at_load(load), model.params
    if not state.contacting * area_ratio >= 20:
        return "fewer than 20 summits touch: too few for a mean"
    if not state.fraction_in_contact <= 0.1:
        return "more than 10 % of the summits touch: they feel each other"
    if not state.mean_contact_radius <= 0.1 * params.summit_radius:
        return "contacts too large for Hertz: a > R/10"
    if not state.mean_contact_radius > params.burgers_vector:
        return "contacts are smaller than the Burgers vector"
    if not params.hardness > 0:
        return "the hardness is not given"
    if not state.mean_asperity_pressure < 0.4 * params.hardness or state.warnings:
        return "summits yield"
    return None


def demand(model, lightest, heaviest, area_ratio=1):
    """Prints how the surface is in contact at two loads; raises RuntimeError where the model does not hold there."""
    for load in (lightest, heaviest):
        state, found = model.state_at_load(load), fault(model, load, area_ratio)
        print(
            f"  surface at {load:.4g}: {state.fraction_in_contact:.2%} of the summits touch, "
            f"{state.contacting * area_ratio:.2g} contacts"
        )
        if found:
            raise RuntimeError(f"the model does not hold for this surface at {load:.4g}: {found}")
