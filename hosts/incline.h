/* A box that slides down an incline, for programs in C and C++: hosts/incline.py says what it is. The program defines HOST. SI
 * units. */
#ifndef HOSTS_INCLINE_H
#define HOSTS_INCLINE_H

#include <math.h>

#include "verdict.h"

static double box_mass, downhill, normal, share; /* of its step, and all of the case that is computed */

/* The verdict on the accelerations that a function gives in the cases of hosts/incline.py, one after the other. */
static inline int judge_incline(double (*acceleration)(const asperity_model *), double limit) {
    const double start = now(), degree = 0.017453292519943295;
    const struct { double adhesion, mass, angle, share, measured; } cases[] = {{0.06, 1, 24, 1, 0}, {0.02, 1, 24, 1, 0}, {0.06, 0.1, 24, 1, 0},
        {0.06, 10, 24, 1, 0}, {0.02, 3, 40, 1, 0}, {0.06, 1, 24, 0.5, 0}, {0.06, 1, 24, 1, 0.2}, {0.06, 1, 24, 1, 0}};
    enum { COUNT = sizeof cases / sizeof cases[0] };
    double worst = 0, first = 0, found = 0;
    for (int i = 0; i < COUNT; i++) {
        asperity_params params;
        asperity_model *model = NULL;
        box_mass = cases[i].mass;
        share = cases[i].share;
        downhill = 9.81 * sin(cases[i].angle * degree);
        normal = 9.81 * cos(cases[i].angle * degree);
        const double load = box_mass * normal;
        if (set_surface(&params, 1e-4) != ASPERITY_OK) fail("no surface");
        params.work_of_adhesion = cases[i].adhesion;
        if (cases[i].measured > 0 && asperity_params_calibrate(&params, 10, cases[i].measured) != ASPERITY_OK) fail("not calibrated");
        if (asperity_create(&params, &model) != ASPERITY_OK || !surface_holds(model, load / 2, 2 * load))
            fail("the model does not hold for the surface at these loads");
        const double right = downhill - exact_mu(model, load) * normal;
        found = acceleration(model);
        if (i == 0) first = found;
        printf("  %g kg, %g degrees, %g J/m2: %.6f in place of %.6f m/s2\n", box_mass, cases[i].angle, params.work_of_adhesion, found, right);
        worst = worse(worst, fabs(found / right - 1));
        asperity_free(model);
    }
    if (found != first) fail("after the others the first case does not give the same bits again");
    printf(HOST "  %s  box on an incline: %d cases within %.1e (limit %g)  %.1f s\n", worst <= limit ? "PASS" : "FAIL", (int)COUNT, worst, limit,
           now() - start);
    return !(worst <= limit);
}

#endif
