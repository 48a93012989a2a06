/* The surface of all hosts, and the check that the model holds for it at the loads of a run. For C and C++; the same in
 * Python is hosts/surface.py. docs/hosts.md says where the numbers come from. SI units. */
#ifndef HOSTS_SURFACE_H
#define HOSTS_SURFACE_H

#include <stdio.h>
#include <string.h>

#include "asperity.h"

/* Hard carbon on hard carbon, ta-C(51) of Nature Commun. 12 (2021), doi 10.1038/s41467-021-24766-6, table 1: Young's
 * modulus, hardness, and the roughness of both bodies together after running in. The slope is taken as that of the
 * steepest ascent, twice the variance of a profile's. Poisson's ratio, adhesion and b are those of docs/materials.md;
 * Nayak's bandwidth was not measured: 10 is assumed. */
static inline asperity_status set_surface(asperity_params *params, double nominal_area) {
    const double rms_height = 9.8e-9, rms_slope = 0.060, bandwidth = 10;
    const double m0 = rms_height * rms_height, m2 = rms_slope * rms_slope / 2, m4 = bandwidth * m2 * m2 / m0;
    asperity_status status = asperity_params_init(params);
    if (status == ASPERITY_OK) status = asperity_params_set_materials(params, 493e9, 0.25, 493e9, 0.25);
    if (status == ASPERITY_OK) status = asperity_params_set_spectral_moments(params, m0, m2, m4, nominal_area);
    if (status != ASPERITY_OK) return status;
    params->work_of_adhesion = 0.06;
    params->adhesion_range = params->burgers_vector = 0.25e-9;
    params->hardness = 51e9;
    return ASPERITY_OK;
}

/* NULL where the model holds at this load; otherwise what of it does not. The state is written where there is one.
 * area_ratio: nominal area of the contact over that of the model, which is 1 unless the load is one per area. */
static inline const char *surface_fault(const asperity_model *model, double load, double area_ratio,
                                        asperity_state *state) {
    asperity_params params;
    state->struct_size = sizeof *state;
    if (asperity_get_params(model, &params) != ASPERITY_OK) return "there is no model";
    if (asperity_state_at_load(model, load, state) != ASPERITY_OK) return "there is no state";
    if (!(state->contacting * area_ratio >= 20)) return "fewer than 20 summits touch: too few for a mean";
    if (!(state->fraction_in_contact <= 0.1)) return "more than 10 % of the summits touch: they feel each other";
    if (!(state->mean_contact_radius <= 0.1 * params.summit_radius)) return "contacts too large for Hertz: a > R/10";
    if (!(state->mean_contact_radius > params.burgers_vector)) return "contacts are smaller than the Burgers vector";
    if (!(params.hardness > 0)) return "the hardness is not given";
    if (!(state->mean_asperity_pressure < 0.4 * params.hardness) || state->warnings != 0) return "summits yield";
    return NULL;
}

/* Says on stdout how the surface is in contact at two loads, and whether the model holds there. */
static inline int surface_holds(const asperity_model *model, double lightest, double heaviest) {
    const double loads[2] = {lightest, heaviest};
    int holds = 1;
    for (int i = 0; i < 2; i++) {
        asperity_state state;
        memset(&state, 0, sizeof state);
        const char *fault = surface_fault(model, loads[i], 1, &state);
        printf("surface at %.4g: %.2g %% of the summits touch, %.2g contacts%s%s\n", loads[i],
               100 * state.fraction_in_contact, state.contacting, fault ? ": " : "", fault ? fault : "");
        if (fault) holds = 0;
    }
    return holds;
}

#endif
