/* The surface of all hosts, the check that the model holds for it at the loads of a run, and the larger of two errors. For C
 * and C++; hosts/surface.py is the same in Python. SI units. */
#ifndef HOSTS_SURFACE_H
#define HOSTS_SURFACE_H

#include <stdint.h>
#include <stdio.h>

#include "asperity.h"

/* The surface of hosts/surface.toml on another area. The programs of hosts run in the root of the tree. */
static inline asperity_status set_surface(asperity_params *params, double nominal_area) {
    asperity_status status = asperity_params_init(params, sizeof *params);
    if (status == ASPERITY_OK) status = asperity_params_read(params, "hosts/surface.toml");
    if (status != ASPERITY_OK) return status;
    params->asperity_count *= nominal_area / params->nominal_area;
    params->nominal_area = nominal_area;
    return ASPERITY_OK;
}

/* Says on stdout whether the model holds at all loads between two, and what to do where it does not. A surface of unknown
 * hardness is refused: it may yield. That nobody measured the strength of this interface is said and no reason to stop: the
 * hosts show how the law is called. */
static inline int surface_holds(const asperity_model *model, double lightest, double heaviest) {
    char message[512];
    asperity_params params;
    uint64_t warnings = 0;
    params.struct_size = sizeof params;
    if (asperity_get_params(model, &params) != ASPERITY_OK ||
        asperity_check_loads(model, lightest, heaviest, &warnings) != ASPERITY_OK) {
        asperity_last_error(message, sizeof message);
        printf("surface: %s\n", message);
        return 0;
    }
    for (uint64_t bit = 1; bit <= warnings; bit *= 2) {
        if (!(warnings & bit)) continue;
        asperity_warnings_text(bit, message, sizeof message);
        printf("surface from %.4g to %.4g: %s\n", lightest, heaviest, message);
    }
    if (!(params.hardness > 0)) printf("surface: the hardness is not given: whether asperities yield is not known\n");
    warnings &= ~(uint64_t)ASPERITY_WARNING_UNCALIBRATED;
    if (warnings != 0 || !(params.hardness > 0)) return 0;
    printf("surface: the model holds from %.4g to %.4g\n", lightest, heaviest);
    return 1;
}

/* The larger of two errors, or the first that is not a number: fmax would drop that, and the check would pass. */
static inline double worse(double a, double b) { return a != a || b <= a ? a : b; }

#endif
