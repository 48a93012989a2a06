/* A brush on a moving plate in Siconos: 120 hinged fingers press on it with 1 to 1000 N, each contact with its own
 * friction coefficient, the law at its own normal force (SI units).
 *
 * One implicit time step is a friction-contact problem u = W r + q, whose mu[i] Siconos takes as given. A fixed point
 * over its driver makes each mu the law at the reaction found. Friction lifts the fingers that trail and digs the
 * leading ones in, so all normal forces depend on all coefficients. What must come out is simple mechanics: all tips
 * slip along the plate's motion, moments balance about each hinge, and the plate loses the momentum of all friction. */
#define _GNU_SOURCE
#include <fenv.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include <FrictionContactProblem.h>
#include <Friction_cst.h>
#include <NonSmoothDrivers.h>
#include <NumericsMatrix.h>
#include <SolverOptions.h>

#include "asperity.h"

enum { FINGERS = 120, SIZE = 3 * FINGERS };
static const double cone_limit = 1e-8, force_limit = 1e-7;
static const double time_step = 1e-3, hinge_height = 0.1, reach = 0.25, finger_inertia = 0.01;
static const double plate_mass = 100, plate_speed = 1, plate_force = 8000;

static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static _Noreturn void fail(const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    printf("siconos  FAIL  ");
    vprintf(format, arguments);
    printf("\n");
    va_end(arguments);
    exit(1);
}

/* Fine-ground steel on steel: 1e10 summits per m2 on the 1 cm2 of a tip. */
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

/* Finger i: its moment presses with some 1 to 1000 N; seen from above it points by yaw away from the plate's motion. */
static double moment_of(int i) { return reach * pow(10, 3.0 * i / (FINGERS - 1)); }

static double yaw_of(int i) { return 2.399963229728653 * i; }   /* the golden angle: all directions alike */

/* The plate's axes, along its motion and across, in the axes of tip i: normal, outward from the hinge, across. */
static void plate_axes(int i, double along[3], double across[3]) {
    const double c = cos(yaw_of(i)), s = sin(yaw_of(i));
    memcpy(along, (double[3]){0, c, -s}, 3 * sizeof *along);
    memcpy(across, (double[3]){0, s, c}, 3 * sizeof *across);
}

/* Impulses r and relative velocities u of the tips. A finger turns about its hinge; the plate has two velocities, and
 * couples all fingers. */
static void set_problem(double *W, double *q) {
    const double arm[3] = {reach, hinge_height, 0}, free_speed = plate_speed + time_step * plate_force / plate_mass;
    double along_i[3], across_i[3], along_j[3], across_j[3];
    for (int i = 0; i < FINGERS; i++) {
        plate_axes(i, along_i, across_i);
        for (int a = 0; a < 3; a++)
            q[3 * i + a] = -arm[a] * time_step * moment_of(i) / finger_inertia - along_i[a] * free_speed;
        for (int j = 0; j < FINGERS; j++) {
            plate_axes(j, along_j, across_j);
            for (int a = 0; a < 3; a++)
                for (int b = 0; b < 3; b++)
                    W[3 * i + a + SIZE * (3 * j + b)] =
                        (along_i[a] * along_j[b] + across_i[a] * across_j[b]) / plate_mass +
                        (i == j ? arm[a] * arm[b] / finger_inertia : 0);
        }
    }
}

/* N (reach + mu(N) H cos(yaw)) = M, the balance of moments of a finger whose tip slips along the plate's motion. */
static double normal_force_by_mechanics(const asperity_model *model, int i) {
    double low = 1e-3, high = 1e5;
    while (high > low * (1 + 1e-12)) {
        const double middle = sqrt(low * high);
        const double moment = middle * (reach + exact_mu(model, middle) * hinge_height * cos(yaw_of(i)));
        *(moment > moment_of(i) ? &high : &low) = middle;
    }
    return sqrt(low * high);
}

/* The driver again and again until each mu is the law at its own reaction; without a model once, with mu as it is. */
static int solve(FrictionContactProblem *problem, SolverOptions *options, const asperity_model *model, double *r,
                 double *u) {
    double load[FINGERS], law[FINGERS];
    for (int iteration = 1; iteration <= 100; iteration++) {
        if (fc3d_driver(problem, r, u, options) != 0) fail("fc3d_driver did not converge (%d)", iteration);
        if (!model) return iteration;
        for (int i = 0; i < FINGERS; i++) load[i] = r[3 * i] / time_step;
        if (asperity_friction_at_loads(model, FINGERS, load, law, NULL) != ASPERITY_OK) fail("a tip has no load");
        double change = 0;
        for (int i = 0; i < FINGERS; i++) {
            change = fmax(change, fabs(law[i] - problem->mu[i]) / law[i]);
            problem->mu[i] = law[i];
        }
        if (change < 1e-10) return iteration;
    }
    fail("the friction coefficients do not converge");
}

typedef struct deviations {
    double cone, force, speed;
    double least_load, greatest_load;
} deviations;

static deviations compare(const asperity_model *model, const double *r, const double *u) {
    deviations d = {.least_load = INFINITY};
    double friction = 0;
    for (int i = 0; i < FINGERS; i++) {
        const double load = r[3 * i] / time_step, mu = exact_mu(model, load);
        const double expected = normal_force_by_mechanics(model, i);
        d.cone = fmax(d.cone, fabs(hypot(r[3 * i + 1], r[3 * i + 2]) / r[3 * i] - mu) / mu);
        d.force = fmax(d.force, fabs(load / expected - 1));
        d.least_load = fmin(d.least_load, load);
        d.greatest_load = fmax(d.greatest_load, load);
        friction += expected * exact_mu(model, expected);
    }
    const double speed = plate_speed + time_step * (plate_force - friction) / plate_mass;
    for (int i = 0; i < FINGERS; i++) d.speed = fmax(d.speed, fabs(hypot(u[3 * i + 1], u[3 * i + 2]) / speed - 1));
    return d;
}

int main(void) {
    const double start = now();
    static double q[SIZE], mu[FINGERS], r[SIZE], u[SIZE];
    double *W = malloc(SIZE * SIZE * sizeof *W);
    if (!W) fail("out of memory");
    feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
    asperity_model *model = steel_on_steel();
    set_problem(W, q);
    NumericsMatrix *matrix = NM_create_from_data(NM_DENSE, SIZE, SIZE, W);
    FrictionContactProblem *problem = frictionContactProblem_new_with_data(3, FINGERS, matrix, q, mu);
    SolverOptions *options = solver_options_create(SICONOS_FRICTION_3D_NSGS);
    options->dparam[SICONOS_DPARAM_TOL] = 1e-13;
    options->iparam[SICONOS_IPARAM_MAX_ITER] = 20000;

    for (int i = 0; i < FINGERS; i++) mu[i] = 0.5;
    const double constant_start = now();
    solve(problem, options, NULL, r, u);
    const double constant = now() - constant_start;

    memset(r, 0, sizeof r);
    memset(u, 0, sizeof u);
    const double law_start = now();
    const int iterations = solve(problem, options, model, r, u);
    const double law = now() - law_start;

    const deviations d = compare(model, r, u);
    printf("brush: %d contacts, N = %.1f to %.0f N, %d iterations of the fixed point\n", FINGERS, d.least_load,
           d.greatest_load, iterations);
    printf("brush: off mechanics by %.1e in normal force, %.1e in the plate's speed (limit %.0e)\n", d.force, d.speed,
           force_limit);
    printf("siconos  cost  constant mu %.1f ms; the law x %.2f\n", 1e3 * constant, law / constant);

    problem->q = problem->mu = NULL;   /* not from the heap */
    frictionContactProblem_free(problem);
    solver_options_delete(options);
    free(options);
    asperity_free(model);
    const int pass = d.cone <= cone_limit && d.force <= force_limit && d.speed <= force_limit;
    printf("siconos  %s  max |F/N - mu(N)|/mu = %.1e  (limit %.0e)  %.1f s\n", pass ? "PASS" : "FAIL", d.cone,
           cone_limit, now() - start);
    return !pass;
}
