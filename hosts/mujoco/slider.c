/* A ball drawn slowly over a plane in MuJoCo, its friction coefficient the law at the normal force of the same step (SI
 * units). mj_step is opened between collision and constraints, and that part repeated until mu is the law at the normal
 * force that the constraint solver finds. Checked while the load on the ball varies slowly: friction over normal force
 * of the contact, and the pull of the servo over the weight that the ball carries, both against the exact law. */
#define _GNU_SOURCE
#include <fenv.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include <mujoco/mujoco.h>

#include "asperity.h"

static const double limit = 1e-6;
static const double servo_speed = 0.035, mass = 20, gravity = 9.81;

static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static _Noreturn void fail(const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    printf("mujoco  FAIL  ");
    vprintf(format, arguments);
    printf("\n");
    va_end(arguments);
    exit(1);
}

/* Fine-ground steel on steel: 1e10 summits per m2 on 1 cm2. */
static asperity_model *steel_on_steel(void) {
    asperity_params params;
    asperity_model *model = NULL;
    char message[400];
    if (asperity_params_init(&params) == ASPERITY_OK &&
        asperity_params_set_materials(&params, 207e9, 0.3, 207e9, 0.3) == ASPERITY_OK) {
        params.work_of_adhesion = 0.03;
        params.adhesion_range = params.burgers_vector = 0.25e-9;
        params.height_std = 2.5e-9;
        params.summit_radius = 25e-6;
        params.asperity_count = 1e10 * 1e-4;
        if (asperity_create(&params, &model) == ASPERITY_OK) return model;
    }
    asperity_last_error(message, sizeof message);
    fail("%s", message);
}

static double exact_mu(const asperity_model *model, double load) {
    asperity_state state = {.struct_size = sizeof state};
    if (asperity_state_at_load(model, load, &state) != ASPERITY_OK) fail("no exact state at %g N", load);
    return state.friction_coefficient;
}

/* The part of mj_step before the contacts have friction. */
static void until_collision(const mjModel *m, mjData *d) {
    mj_checkPos(m, d);
    mj_checkVel(m, d);
    mj_fwdKinematics(m, d);
    mj_makeM(m, d);
    mj_factorM(m, d);
}

/* The part from there to the accelerations, with sliding friction mu at all contacts. mj_collision is in it, for it
 * alone gives back the memory of the constraints of the pass before. */
static void solve_with(const mjModel *m, mjData *d, double mu) {
    mj_collision(m, d);
    for (int i = 0; i < d->ncon; i++) d->contact[i].friction[0] = d->contact[i].friction[1] = mu;
    mj_makeConstraint(m, d);
    mj_island(m, d);
    mj_projectConstraint(m, d);
    mj_transmission(m, d);
    mj_fwdVelocity(m, d);
    mj_fwdActuation(m, d);
    mj_fwdAcceleration(m, d);
    mj_fwdConstraint(m, d);
}

static void contact_forces(const mjModel *m, const mjData *d, double *normal, double *friction) {
    mjtNum force[6];
    *normal = *friction = 0;
    for (int i = 0; i < d->ncon; i++) {
        mj_contactForce(m, d, i, force);
        *normal += force[0];
        *friction += hypot(force[1], force[2]);
    }
}

/* A step whose mu is the law at its own normal force, or, with one pass only, at that of the step before. Returns the
 * passes made; mu is kept from step to step. */
static int law_step(const mjModel *m, mjData *d, const asperity_model *model, int most_passes, double *mu) {
    until_collision(m, d);
    for (int pass = 1; pass <= most_passes; pass++) {
        double normal, friction;
        solve_with(m, d, *mu);
        contact_forces(m, d, &normal, &friction);
        const double law = asperity_friction_at_load(model, normal), change = fabs(law - *mu);
        const int converged = d->ncon == 0 || change <= 1e-10 * law;
        if (!converged) *mu = law;
        if (converged || most_passes == 1) {
            mj_checkAcc(m, d);
            mj_Euler(m, d);
            return pass;
        }
    }
    fail("mu and the normal force do not converge in %d passes at t = %g s", most_passes, d->time);
}

typedef struct result {
    double seconds, contact_deviation, servo_deviation, least_load, greatest_load;
    int steps, passes;
} result;

/* A second to settle at a load of 600 N, then two between 200 and 1000 N. Without a model mu stays as it is. */
static result draw_slider(const mjModel *m, mjData *d, const asperity_model *model, int most_passes, int check) {
    result r = {.least_load = INFINITY};
    double mu = 0.4;
    mj_resetData(m, d);
    d->ctrl[0] = servo_speed;
    while (d->time < 3) {
        const double settled = fmax(d->time - 1, 0), added = 600 + 400 * sin(M_PI * settled);
        d->qfrc_applied[2] = -added;
        const double vx = d->qvel[0], vz = d->qvel[2], start = now();
        if (model) r.passes += law_step(m, d, model, most_passes, &mu);
        else mj_step(m, d);
        r.seconds += now() - start;
        r.steps++;
        if (!check || settled == 0) continue;
        double normal, friction;
        contact_forces(m, d, &normal, &friction);
        if (d->ncon != 1 || d->qvel[0] < 0.01) fail("the slider left the plane or stuck at t = %g s", d->time);
        const double at_contact = exact_mu(model, normal);
        r.contact_deviation = fmax(r.contact_deviation, fabs(friction / normal - at_contact) / at_contact);
        /* The momentum of the ball, with the servo's force, knows nothing of what MuJoCo says of the contact. */
        const double carried = mass * gravity + added + mass * (d->qvel[2] - vz) / m->opt.timestep;
        const double pull = d->qfrc_actuator[0] - mass * (d->qvel[0] - vx) / m->opt.timestep;
        const double at_weight = exact_mu(model, carried);
        r.servo_deviation = fmax(r.servo_deviation, fabs(pull / carried - at_weight) / at_weight);
        r.least_load = fmin(r.least_load, normal);
        r.greatest_load = fmax(r.greatest_load, normal);
    }
    return r;
}

static double least_seconds(const mjModel *m, mjData *d, const asperity_model *model, int most_passes) {
    double least = INFINITY;
    for (int i = 0; i < 5; i++) least = fmin(least, draw_slider(m, d, model, most_passes, 0).seconds);
    return least;
}

int main(int count, char **arguments) {
    const double start = now();
    char message[400];
    if (count != 2) fail("usage: slider slider.xml");
    if (mj_version() != mjVERSION_HEADER) fail("MuJoCo %d, but its header is %d", mj_version(), mjVERSION_HEADER);
    mjModel *m = mj_loadXML(arguments[1], NULL, message, sizeof message);
    if (!m) fail("%s", message);
    mjData *d = mj_makeData(m);
    feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
    asperity_model *model = steel_on_steel();

    const result r = draw_slider(m, d, model, 50, 1), lagged = draw_slider(m, d, model, 1, 1);
    printf("slider: N = %.0f to %.0f N, %d steps, %.2f passes a step\n", r.least_load, r.greatest_load, r.steps,
           (double)r.passes / r.steps);
    printf("slider: |F/N - mu(N)|/mu of the contact %.1e, of the servo over the weight %.1e\n", r.contact_deviation,
           r.servo_deviation);
    printf("slider with the normal force of the step before: %.1e\n", lagged.contact_deviation);
    const double constant = least_seconds(m, d, NULL, 1);
    printf("mujoco  cost  constant mu %.1f ms; the law at the lagged force x %.2f, at the current force x %.2f\n",
           1e3 * constant, least_seconds(m, d, model, 1) / constant, least_seconds(m, d, model, 50) / constant);

    asperity_free(model);
    mj_deleteData(d);
    mj_deleteModel(m);
    const double deviation = fmax(r.contact_deviation, r.servo_deviation);
    const int pass = deviation <= limit && lagged.contact_deviation > limit;
    printf("mujoco  %s  max |F/N - mu(N)|/mu = %.1e  (limit %.0e)  %.1f s\n", pass ? "PASS" : "FAIL", deviation, limit,
           now() - start);
    return !pass;
}
