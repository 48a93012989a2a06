/* Contact friction in Adams: the friction function of a CONTACT statement is F(N) tanh(v/v0), against the slip velocity.
 *
 *     FRICTION_FUNCTION = USER(v0, string, length, force)
 *
 * v0, in the units of the model; the number of the STRING that names the surface file; the units of length and force of the
 * model, in m and N. Contacts with the same numbers share one model of friction. There is a set of them for each thread, so that
 * nothing is locked. */

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "asperity.h"
#include "asperity_loads.h"
#include "slv_c_utils.h"

adams_c_Cffsub Cffsub;

enum { SPEED, STRING, LENGTH, FORCE, NUMBERS, MOST = 64 };

/* Ends the simulation with a message that names the contact. */
static void stop(int contact, const char *message) {
    char text[640];
    snprintf(text, sizeof text, "asperity: %s", message);
    c_errmes(1, text, contact, "STOP");
}

/* The path in a STRING statement; 0 if there is no such statement. */
static int find_path(int string, char *path, int size) {
    int length = size - 1, status = 0;
    memset(path, 0, (size_t)size);
    c_gtstrg(string, path, &length, &status);
    if (status != 0) return 0;
    if (length >= 0 && length < size) path[length] = 0;
    return 1;
}

static asperity_status make(const char *path, double length, double force, asperity_model **model) {
    asperity_params params;
    asperity_status status = asperity_params_init(&params, sizeof params);
    if (status == ASPERITY_OK) status = asperity_params_read(&params, path);
    if (status == ASPERITY_OK) status = asperity_params_set_units(&params, length, force);
    return status == ASPERITY_OK ? asperity_create(&params, model) : status;
}

/* The model for the numbers of a contact, made when they are met first; NULL after a message. */
static const asperity_model *model_of(int contact, const double *numbers) {
    static _Thread_local struct {
        double numbers[NUMBERS];
        asperity_model *model;
    } made[MOST];
    char path[4096], message[512];
    const size_t first = STRING, size = (NUMBERS - first) * sizeof *numbers;
    int i = 0;
    while (i < MOST && made[i].model && memcmp(made[i].numbers + first, numbers + first, size) != 0) i++;
    if (i == MOST) {
        stop(contact, "there are more than 64 surfaces: raise MOST in cffsub.c");
        return NULL;
    }
    if (made[i].model) return made[i].model;
    if (!find_path((int)numbers[STRING], path, sizeof path)) {
        stop(contact, "the second number of FRICTION_FUNCTION=USER must be that of a STRING that names a surface file");
        return NULL;
    }
    if (make(path, numbers[LENGTH], numbers[FORCE], &made[i].model) != ASPERITY_OK) {
        asperity_last_error(message, sizeof message);
        stop(contact, message);
        return NULL;
    }
    memcpy(made[i].numbers, numbers, sizeof made[i].numbers);
    return made[i].model;
}

void Cffsub(const struct sAdamsContactFriction *contact, double time, const double *loci, const double *locj,
            const double *x, const double *xdot, double nforce, double area, int dflag, int iflag, double *force) {
    (void)time, (void)loci, (void)locj, (void)x, (void)area, (void)dflag;
    force[0] = force[1] = force[2] = 0;
    if (contact->NPAR != NUMBERS) {
        stop(contact->contact.ID, "FRICTION_FUNCTION=USER wants 4 numbers: the slip speed v0, the number of a STRING that names a "
                                  "surface file, and the units of length and force of the model in m and N");
        return;
    }
    const asperity_model *model = model_of(contact->contact.ID, contact->PAR);
    /* Not 0: the solver asks which variables the force depends on, or saves; there is nothing beyond the arguments. */
    if (model == NULL || iflag) return;
    const double slip = hypot(xdot[0], xdot[1]), strength = asperity_friction_force_at_load(model, nforce);
    if (!isgreater(contact->PAR[SPEED], 0) || !isfinite(slip) || isnan(strength)) {
        stop(contact->contact.ID, "v0 must be > 0, and normal force and slip velocity must be finite");
        return;
    }
    if (slip > 0) {
        const double friction = asperity_slip_force(strength, slip, contact->PAR[SPEED]);
        force[0] = -friction * (xdot[0] / slip);
        force[1] = -friction * (xdot[1] / slip);
    }
}
