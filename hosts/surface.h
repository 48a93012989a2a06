/* The surface of all hosts, the check that the model holds for it at the loads of a run, and the larger of two errors. For C
 * and C++; the surface in Python is hosts/surface.py. docs/hosts-reference.md says where the numbers come from. SI units. */
#ifndef HOSTS_SURFACE_H
#define HOSTS_SURFACE_H

#include <stdint.h>
#include <stdio.h>

#include "asperity.h"

/* Hard carbon on hard carbon, ta-C(51) of Nature Commun. 12 (2021), doi 10.1038/s41467-021-24766-6, table 1: Young's
 * modulus, hardness, and the roughness of both bodies together after running in. The slope is taken as that of the
 * steepest ascent, twice the variance of a profile's. Poisson's ratio, adhesion and b are those of docs/materials.md;
 * Nayak's bandwidth was not measured: 10 is assumed. */
static inline asperity_status set_surface(asperity_params *params, double nominal_area) {
    const double rms_height = 9.8e-9, rms_slope = 0.060, bandwidth = 10;
    const double m0 = rms_height * rms_height, m2 = rms_slope * rms_slope / 2, m4 = bandwidth * m2 * m2 / m0;
    asperity_status status = asperity_params_init(params, sizeof *params);
    if (status == ASPERITY_OK) status = asperity_params_set_materials(params, 493e9, 0.25, 493e9, 0.25);
    if (status == ASPERITY_OK) status = asperity_params_set_spectral_moments(params, m0, m2, m4, nominal_area);
    if (status != ASPERITY_OK) return status;
    params->work_of_adhesion = 0.06;
    params->adhesion_range = params->burgers_vector = 0.25e-9;
    params->hardness = 51e9;
    return ASPERITY_OK;
}

/* Says on stdout whether the model holds at all loads between two, and what to do where it does not. A surface of unknown
 * hardness is refused: it may yield. That nobody measured the strength of this interface, and that its bandwidth is broad, is
 * said and no reason to stop: the hosts show how the law is called. */
static inline int surface_holds(const asperity_model *model, double lightest, double heaviest) {
    char message[512];
    asperity_params params;
    uint64_t warnings = 0;
    if (asperity_get_params(model, &params) != ASPERITY_OK ||
        asperity_check_loads(model, lightest, heaviest, &warnings) != ASPERITY_OK) {
        asperity_last_error(message, sizeof message);
        printf("surface: %s\n", message);
        return 0;
    }
    for (uint64_t bit = 1; bit <= warnings; bit *= 2)
        if (warnings & bit) printf("surface from %.4g to %.4g: %s\n", lightest, heaviest, asperity_warning_string(bit));
    if (!(params.hardness > 0)) printf("surface: the hardness is not given: whether summits yield is not known\n");
    warnings &= ~(uint64_t)(ASPERITY_WARNING_UNCALIBRATED | ASPERITY_WARNING_BROAD);
    if (warnings != 0 || !(params.hardness > 0)) return 0;
    printf("surface: the model holds from %.4g to %.4g\n", lightest, heaviest);
    return 1;
}

/* The larger of two errors, or the first that is not a number: fmax would drop that, and the check would pass. */
static inline double worse(double a, double b) { return a != a || b <= a ? a : b; }

#endif
