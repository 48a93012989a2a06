/* A ball and a box drawn slowly over a plane in MuJoCo, the friction coefficient of each the law at its normal force in
 * the same step (SI units). mj_step is opened between collision and constraints, and that part repeated until mu is the
 * law at the normal force that the constraint solver finds, summed over the contacts of a pair of geometries: the box
 * has four, and what it carries must not change the ball's mu. Checked while the load on the ball varies slowly:
 * friction over normal force of both pairs, and the pull of the ball's servo over the weight that it carries, against
 * the exact law. */
#define _GNU_SOURCE
#include <fenv.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include <mujoco/mujoco.h>

#include "../surface.h"

static const double limit = 1e-6;
static const double ball_servo = 0.035, box_servo = 0.016;    /* they slip slower, by the friction over kv */
static const double mass = 20, gravity = 9.81;

/* Processor time, in which other programs have no part. */
static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
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

/* The 1 cm2 of a slider that bears. */
static asperity_model *coated_pads(void) {
    asperity_params params;
    asperity_model *model = NULL;
    char message[400];
    if (set_surface(&params, 1e-4) == ASPERITY_OK && asperity_create(&params, &model) == ASPERITY_OK) return model;
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

enum { MOST_PAIRS = 16 };

/* What is known of two geometries that touch; kept from step to step, for the contacts are made anew in each. */
typedef struct pair {
    int geometry[2];
    double mu, normal, friction;        /* sums over the contacts of the pair */
} pair;

typedef struct pairs {
    pair of[MOST_PAIRS];
    int count;
} pairs;

static pair *pair_of(pairs *known, const mjContact *contact) {
    for (int i = 0; i < known->count; i++) {
        pair *p = &known->of[i];
        if (p->geometry[0] == contact->geom[0] && p->geometry[1] == contact->geom[1]) return p;
    }
    if (known->count == MOST_PAIRS) fail("more than %d pairs of geometries touch", MOST_PAIRS);
    known->of[known->count] = (pair){.geometry = {contact->geom[0], contact->geom[1]}, .mu = 0.2};
    return &known->of[known->count++];
}

/* The part from there to the accelerations, with the sliding friction mu of each pair. mj_collision is in it, for it
 * alone gives back the memory of the constraints of the pass before. */
static void solve_with(const mjModel *m, mjData *d, pairs *known) {
    mj_collision(m, d);
    for (int i = 0; i < d->ncon; i++) {
        const double mu = pair_of(known, &d->contact[i])->mu;
        d->contact[i].friction[0] = d->contact[i].friction[1] = mu;
    }
    mj_makeConstraint(m, d);
    mj_island(m, d);
    mj_projectConstraint(m, d);
    mj_transmission(m, d);
    mj_fwdVelocity(m, d);
    mj_fwdActuation(m, d);
    mj_fwdAcceleration(m, d);
    mj_fwdConstraint(m, d);
}

static void sum_forces(const mjModel *m, const mjData *d, pairs *known) {
    for (int i = 0; i < known->count; i++) known->of[i].normal = known->of[i].friction = 0;
    for (int i = 0; i < d->ncon; i++) {
        mjtNum force[6];
        pair *p = pair_of(known, &d->contact[i]);
        mj_contactForce(m, d, i, force);
        p->normal += force[0];
        p->friction += hypot(force[1], force[2]);
    }
}

/* A step in which the mu of each pair is the law at its own normal force, or, with one pass only, at that of the step
 * before. Returns the passes made. */
static int law_step(const mjModel *m, mjData *d, const asperity_model *model, int most_passes, pairs *known) {
    until_collision(m, d);
    for (int pass = 1; pass <= most_passes; pass++) {
        solve_with(m, d, known);
        sum_forces(m, d, known);
        int converged = 1;
        for (int i = 0; i < known->count; i++) {
            pair *p = &known->of[i];
            if (p->normal <= 0) continue;         /* apart in this step */
            const double law = asperity_friction_at_load(model, p->normal);
            if (fabs(law - p->mu) <= 1e-10 * law) continue;
            p->mu = law;
            converged = 0;
        }
        if (converged || most_passes == 1) {
            mj_checkAcc(m, d);
            mj_Euler(m, d);
            return pass;
        }
    }
    fail("mu and the normal force do not converge in %d passes at t = %g s", most_passes, d->time);
}

/* Friction over normal force of the pair that a geometry of this name has with the plane, against the exact law. */
static double pair_deviation(const mjModel *m, const asperity_model *model, const pairs *known, const char *name,
                             double *normal) {
    const int geometry = mj_name2id(m, mjOBJ_GEOM, name);
    for (int i = 0; i < known->count; i++) {
        const pair *p = &known->of[i];
        if ((p->geometry[0] != geometry && p->geometry[1] != geometry) || !(p->normal > 0)) continue;
        const double mu = exact_mu(model, p->normal);
        *normal = p->normal;
        return fabs(p->friction / p->normal - mu) / mu;
    }
    fail("the %s left the plane", name);
}

typedef struct result {
    double seconds, ball_deviation, box_deviation, servo_deviation, least_load, greatest_load;
    int steps, passes;
} result;

/* A second to settle at a load of 600 N, then two between 200 and 1000 N. Without a model mu stays as it is. */
static result draw_slider(const mjModel *m, mjData *d, const asperity_model *model, int most_passes, int check) {
    result r = {.least_load = INFINITY};
    pairs known = {.count = 0};
    mj_resetData(m, d);
    d->ctrl[0] = ball_servo;
    d->ctrl[1] = box_servo;
    while (d->time < 3) {
        const double settled = fmax(d->time - 1, 0), added = 600 + 400 * sin(M_PI * settled);
        d->qfrc_applied[2] = -added;
        const double vx = d->qvel[0], vz = d->qvel[2], start = now();
        if (model) r.passes += law_step(m, d, model, most_passes, &known);
        else mj_step(m, d);
        r.seconds += now() - start;
        r.steps++;
        if (!check || settled == 0) continue;
        if (d->ncon != 5 || d->qvel[0] < 0.01 || d->qvel[3] < 0.002)
            fail("at t = %g s there are %d contacts, not 5, or ball (%g m/s) or box (%g m/s) is stuck", d->time,
                 d->ncon, d->qvel[0], d->qvel[3]);
        double on_ball, on_box;
        r.ball_deviation = fmax(r.ball_deviation, pair_deviation(m, model, &known, "ball", &on_ball));
        r.box_deviation = fmax(r.box_deviation, pair_deviation(m, model, &known, "box", &on_box));
        /* The momentum of the ball, with the servo's force, knows nothing of what MuJoCo says of the contact. */
        const double carried = mass * gravity + added + mass * (d->qvel[2] - vz) / m->opt.timestep;
        const double pull = d->qfrc_actuator[0] - mass * (d->qvel[0] - vx) / m->opt.timestep;
        const double at_weight = exact_mu(model, carried);
        r.servo_deviation = fmax(r.servo_deviation, fabs(pull / carried - at_weight) / at_weight);
        r.least_load = fmin(r.least_load, fmin(on_ball, on_box));
        r.greatest_load = fmax(r.greatest_load, fmax(on_ball, on_box));
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
    asperity_model *model = coated_pads();

    const result r = draw_slider(m, d, model, 50, 1), lagged = draw_slider(m, d, model, 1, 1);
    printf("slider: N = %.0f to %.0f N, %d steps, %.2f passes a step\n", r.least_load, r.greatest_load, r.steps,
           (double)r.passes / r.steps);
    printf("slider: |F/N - mu(N)|/mu of the ball %.1e, of its servo over the weight %.1e, of the box %.1e\n",
           r.ball_deviation, r.servo_deviation, r.box_deviation);
    printf("slider with the normal force of the step before: %.1e\n", lagged.ball_deviation);
    if (!surface_holds(model, r.least_load, r.greatest_load))
        fail("the model does not hold for the surface at these loads");
    const double constant = least_seconds(m, d, NULL, 1);
    printf("mujoco  cost  constant mu %.1f ms; the law at the lagged force x %.2f, at the current force x %.2f\n",
           1e3 * constant, least_seconds(m, d, model, 1) / constant, least_seconds(m, d, model, 50) / constant);

    asperity_free(model);
    mj_deleteData(d);
    mj_deleteModel(m);
    const double deviation = fmax(fmax(r.ball_deviation, r.box_deviation), r.servo_deviation);
    const int pass = deviation <= limit && lagged.ball_deviation > limit;
    printf("mujoco  %s  max |F/N - mu(N)|/mu = %.1e  (limit %.0e)  %.1f s\n", pass ? "PASS" : "FAIL", deviation, limit,
           now() - start);
    return !pass;
}
