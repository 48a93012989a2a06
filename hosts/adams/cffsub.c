/* Contact friction in Adams: the friction function of a CONTACT statement is F(N) tanh(v/v0), against the slip velocity.
 *
 *     FRICTION_FUNCTION = USER(v0, height_std, ..., pressure_coefficient)    in the order of NAMES, in the units of the model
 *
 * Contacts with the same numbers share one model. There is a set of models for each thread, so that nothing is locked. */

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "asperity.h"
#include "slv_c_utils.h"

adams_c_Cffsub Cffsub;

static const char *const NAMES[] = {
    "height_std",      "summit_radius",  "asperity_count",  "composite_modulus", "effective_shear_modulus",
    "work_of_adhesion", "adhesion_range", "burgers_vector", "hardness",          "slip_stress_1",
    "slip_stress_2",    "pressure_coefficient",
};
enum { COUNT = sizeof NAMES / sizeof *NAMES, MOST = 64 };

/* Ends the simulation with a message that names the contact. */
static void stop(int contact, const char *message) {
    char text[640];
    snprintf(text, sizeof text, "asperity: %s", message);
    c_errmes(1, text, contact, "STOP");
}

static asperity_status make(const double *values, asperity_model **model) {
    asperity_params params;
    asperity_status status = asperity_params_init(&params, sizeof params);
    for (int i = 0; i < COUNT && status == ASPERITY_OK; i++)
        status = asperity_params_set_value(&params, NAMES[i], values[i]);
    return status == ASPERITY_OK ? asperity_create(&params, model) : status;
}

/* The model of the numbers of a contact, made when they are met first; NULL after a message. */
static const asperity_model *model_of(int contact, const double *values) {
    static _Thread_local struct {
        double values[COUNT];
        asperity_model *model;
    } made[MOST];
    char message[512];
    int i = 0;
    while (i < MOST && made[i].model && memcmp(made[i].values, values, sizeof made[i].values) != 0) i++;
    if (i == MOST) {
        stop(contact, "there are more than 64 surfaces: raise MOST in cffsub.c");
        return NULL;
    }
    if (made[i].model) return made[i].model;
    if (make(values, &made[i].model) != ASPERITY_OK) {
        asperity_last_error(message, sizeof message);
        stop(contact, message);
        return NULL;
    }
    memcpy(made[i].values, values, sizeof made[i].values);
    return made[i].model;
}

void Cffsub(const struct sAdamsContactFriction *contact, double time, const double *loci, const double *locj,
            const double *x, const double *xdot, double nforce, double area, int dflag, int iflag, double *force) {
    (void)time, (void)loci, (void)locj, (void)x, (void)area, (void)dflag;
    force[0] = force[1] = force[2] = 0;
    if (contact->NPAR != COUNT + 1) {
        stop(contact->contact.ID, "FRICTION_FUNCTION=USER wants 10 numbers: the slip speed v0 and nine of the surface");
        return;
    }
    const asperity_model *model = model_of(contact->contact.ID, contact->PAR + 1);
    /* Not 0: the solver asks which variables the force depends on, or saves; there is nothing beyond the arguments. */
    if (model == NULL || iflag) return;
    const double slip = hypot(xdot[0], xdot[1]);
    const double friction = asperity_slip_force(model, nforce, slip, contact->PAR[0], NULL, NULL);
    if (isnan(friction)) {
        stop(contact->contact.ID, "v0 must be > 0, and normal force and slip velocity must be finite");
        return;
    }
    if (slip > 0) {
        force[0] = -friction * (xdot[0] / slip);
        force[1] = -friction * (xdot[1] / slip);
    }
}
