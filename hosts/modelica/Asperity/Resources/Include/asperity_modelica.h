/* asperity for Modelica tools, between their external functions and the C interface: the constructor of an external object
 * returns the object, where asperity_create returns a status, and a tool takes errors by ModelicaFormatError, which does
 * not return. */
#ifndef ASPERITY_MODELICA_H
#define ASPERITY_MODELICA_H

#include <asperity.h>
#include <ModelicaUtilities.h>

/* Nothing of the library is on the stack here, so leaving by longjmp is safe. */
static inline void asperity_modelica_check(asperity_status status)
{
    if (status != ASPERITY_OK) {
        char message[512];
        asperity_last_error(message, sizeof message);
        ModelicaFormatError("asperity: %s\n", message);
    }
}

/* Young's moduli [Pa], Poisson's ratios, w [J/m2], h, b, sigma, R [m], number of summits. */
static inline void *asperity_modelica_create(double E1, double nu1, double E2, double nu2, double w, double h,
                                             double b, double sigma, double R, double n)
{
    asperity_params params;
    asperity_model *model = NULL;

    asperity_modelica_check(asperity_params_init(&params));
    asperity_modelica_check(asperity_params_set_materials(&params, E1, nu1, E2, nu2));
    params.work_of_adhesion = w;
    params.adhesion_range = h;
    params.burgers_vector = b;
    params.height_std = sigma;
    params.summit_radius = R;
    params.asperity_count = n;
    asperity_modelica_check(asperity_create(&params, &model));
    return model;
}

static inline void asperity_modelica_free(void *law)
{
    asperity_free((asperity_model *)law);
}

static inline double asperity_modelica_force(void *law, double load)
{
    return asperity_friction_force_at_load((const asperity_model *)law, load);
}

/* dF/d(load). A separated contact has no friction and no slope: that is an answer, not an error. */
static inline double asperity_modelica_slope(void *law, double load)
{
    double slope = 0;
    const asperity_status status =
        asperity_friction_force_at_loads((const asperity_model *)law, 1, &load, NULL, &slope);

    if (status != ASPERITY_SEPARATED)
        asperity_modelica_check(status);
    return slope;
}

#endif
