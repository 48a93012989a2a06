/* A box that slides down an incline, for programs in C and C++: hosts/incline.py says what it is. The program defines HOST. SI
 * units. */
#ifndef HOSTS_INCLINE_H
#define HOSTS_INCLINE_H

#include <math.h>

#include "verdict.h"

static const double box_mass = 1, downhill = 9.81 * 0.40673664307580021, normal = 9.81 * 0.91354545764260087; /* of 24 degrees */

/* The verdict on the accelerations that a function gives for the laws of two surfaces, one after the other. */
static inline int judge_incline(double (*acceleration)(const asperity_model *), double limit) {
    const double start = now(), adhesions[] = {0.06, 0.02}, load = box_mass * normal;
    double worst = 0, found[2], right[2];
    for (int i = 0; i < 2; i++) {
        asperity_params params;
        asperity_model *model = NULL;
        if (set_surface(&params, 1e-4) != ASPERITY_OK) fail("no surface");
        params.work_of_adhesion = adhesions[i];
        if (asperity_create(&params, &model) != ASPERITY_OK || !surface_holds(model, load / 2, 2 * load))
            fail("the model does not hold for the surface at these loads");
        right[i] = downhill - exact_mu(model, load) * normal;
        found[i] = acceleration(model);
        worst = worse(worst, fabs(found[i] / right[i] - 1));
        asperity_free(model);
    }
    printf(HOST "  %s  box on an incline: %.6f in place of %.6f, %.6f in place of %.6f m/s2, %.1e (limit %g)  %.1f s\n",
           worst <= limit ? "PASS" : "FAIL", found[0], right[0], found[1], right[1], worst, limit, now() - start);
    return !(worst <= limit);
}

#endif
