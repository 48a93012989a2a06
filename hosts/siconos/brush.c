/* A brush on a moving plate in Siconos: 120 hinged fingers press on it with 1 to 1000 N, each contact with its own
 * friction coefficient, the law at its own normal force (SI units).
 *
 * One implicit time step is a friction-contact problem u = W r + q, whose mu[i] Siconos takes as given. A fixed point
 * over its driver makes each mu the law at the reaction found. Friction lifts the fingers that trail and digs the
 * leading ones in, and the plate floats, so that every normal force depends on every coefficient.
 *
 * What comes out is put to each body's law of motion, without W: the tips must stay on the plate, and every reaction
 * lie on its own cone, the exact law's, against the slip. */
#define _GNU_SOURCE
#include <fenv.h>
#include <math.h>
#include <string.h>

#include <FrictionContactProblem.h>
#include <Friction_cst.h>
#include <NonSmoothDrivers.h>
#include <NumericsMatrix.h>
#include <SolverOptions.h>

#define HOST "siconos"
#include "../verdict.h"

enum { FINGERS = 120, SIZE = 3 * FINGERS };
static const double cone_limit = 1e-8, motion_limit = 1e-8;
static const double time_step = 1e-3, hinge_height = 0.1, reach = 0.25;
static const double plate_mass = 20, plate_speed = 1, pull = 8000;

/* Finger i: without friction its moment would press with 1 to 1000 N; from above, it points by yaw off the plate's
 * motion. */
static double moment_of(int i) { return reach * pow(10, 3.0 * i / (FINGERS - 1)); }

/* About the hinge: what presses more is heavier. */
static double inertia_of(int i) { return 4e-5 * moment_of(i); }

/* Holds the plate up against all fingers, but for what friction adds or takes. */
static double support(void) {
    double sum = 0;
    for (int i = 0; i < FINGERS; i++) sum += moment_of(i) / reach;
    return sum;
}

static double yaw_of(int i) { return 2.399963229728653 * i; }   /* the golden angle: all directions alike */

/* The plate's axes, up, along its motion, and across, in the axes of tip i: up, outward from the hinge, and across. */
static void plate_axes(int i, double axis[3][3]) {
    const double c = cos(yaw_of(i)), s = sin(yaw_of(i));
    const double axes[3][3] = {{1, 0, 0}, {0, c, -s}, {0, s, c}};
    memcpy(axis, axes, sizeof axes);
}

/* Impulses r and relative velocities u of the tips. A finger turns about its hinge; the plate moves in three ways. */
static void set_problem(double *W, double *q) {
    const double arm[3] = {reach, hinge_height, 0};
    const double plate[3] = {time_step * support() / plate_mass, plate_speed + time_step * pull / plate_mass, 0};
    double of_i[3][3], of_j[3][3];
    for (int i = 0; i < FINGERS; i++) {
        plate_axes(i, of_i);
        for (int a = 0; a < 3; a++) {
            q[3 * i + a] = -arm[a] * time_step * moment_of(i) / inertia_of(i);
            for (int d = 0; d < 3; d++) q[3 * i + a] -= of_i[d][a] * plate[d];
        }
        for (int j = 0; j < FINGERS; j++) {
            plate_axes(j, of_j);
            for (int a = 0; a < 3; a++)
                for (int b = 0; b < 3; b++) {
                    double *w = &W[3 * i + a + SIZE * (3 * j + b)];
                    *w = i == j ? arm[a] * arm[b] / inertia_of(i) : 0;
                    for (int d = 0; d < 3; d++) *w += of_i[d][a] * of_j[d][b] / plate_mass;
                }
        }
    }
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
            change = worse(change, fabs(law[i] - problem->mu[i]) / law[i]);
            problem->mu[i] = law[i];
        }
        if (change < 1e-10) return iteration;
    }
    fail("the friction coefficients do not converge");
}

/* Of five solutions, each from nothing: the machine may be busy. */
static double least_seconds(FrictionContactProblem *problem, SolverOptions *options, const asperity_model *model,
                            double *r, double *u, int *iterations) {
    double least = INFINITY;
    for (int run = 0; run < 5; run++) {
        for (int i = 0; i < FINGERS; i++) problem->mu[i] = 0.5;
        memset(r, 0, SIZE * sizeof *r);
        memset(u, 0, SIZE * sizeof *u);
        const double start = now();
        *iterations = solve(problem, options, model, r, u);
        least = fmin(least, now() - start);
    }
    return least;
}

/* The plate's velocity after the step, by its momentum: up, along and across. */
static void plate_velocity(const double *r, double v[3]) {
    const double along = plate_speed + time_step * pull / plate_mass;
    v[0] = time_step * support() / plate_mass;
    v[1] = along;
    v[2] = 0;
    for (int i = 0; i < FINGERS; i++) {
        const double c = cos(yaw_of(i)), s = sin(yaw_of(i)), *on_tip = &r[3 * i];
        v[0] -= on_tip[0] / plate_mass;
        v[1] -= (c * on_tip[1] - s * on_tip[2]) / plate_mass;
        v[2] -= (s * on_tip[1] + c * on_tip[2]) / plate_mass;
    }
}

typedef struct deviations {
    double cone;                   /* friction over normal force against the exact law, relative */
    double lifting;                /* of a tip from the plate, over the plate's speed */
    double direction;              /* of friction against slip, as the distance of unit vectors */
    double least_load, greatest_load;
} deviations;

static deviations compare(const asperity_model *model, const double *r) {
    deviations d = {.least_load = INFINITY};
    double v[3];
    plate_velocity(r, v);
    for (int i = 0; i < FINGERS; i++) {
        const double normal = r[3 * i], out = r[3 * i + 1], across = r[3 * i + 2];
        const double c = cos(yaw_of(i)), s = sin(yaw_of(i));
        const double load = normal / time_step, mu = exact_mu(model, load), friction = hypot(out, across);
        const double turning =
            (reach * normal + hinge_height * out - time_step * moment_of(i)) / inertia_of(i);
        const double slip_out = hinge_height * turning - (c * v[1] + s * v[2]), slip_across = s * v[1] - c * v[2];
        const double slip = hypot(slip_out, slip_across);
        d.cone = worse(d.cone, fabs(friction / normal - mu) / mu);
        d.lifting = worse(d.lifting, fabs(reach * turning - v[0]) / plate_speed);
        const double off = hypot(out / friction + slip_out / slip, across / friction + slip_across / slip);
        d.direction = worse(d.direction, off);
        d.least_load = fmin(d.least_load, load);
        d.greatest_load = fmax(d.greatest_load, load);
    }
    return d;
}

int main(void) {
    const double start = now();
    static double q[SIZE], mu[FINGERS], r[SIZE], u[SIZE];
    double *W = malloc(SIZE * SIZE * sizeof *W);
    if (!W) fail("out of memory");
    feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
    asperity_model *model = law_of_contact();
    set_problem(W, q);
    NumericsMatrix *matrix = NM_create_from_data(NM_DENSE, SIZE, SIZE, W);
    FrictionContactProblem *problem = frictionContactProblem_new_with_data(3, FINGERS, matrix, q, mu);
    SolverOptions *options = solver_options_create(SICONOS_FRICTION_3D_NSGS);
    options->dparam[SICONOS_DPARAM_TOL] = 1e-12;
    options->iparam[SICONOS_IPARAM_MAX_ITER] = 20000;
    /* With the default, NSGS tightens its own tolerance from call to call, until none is left. */
    options->iparam[SICONOS_FRICTION_3D_IPARAM_ERROR_EVALUATION] = SICONOS_FRICTION_3D_NSGS_ERROR_EVALUATION_FULL;

    int iterations;
    const double constant = least_seconds(problem, options, NULL, r, u, &iterations);
    const double law = least_seconds(problem, options, model, r, u, &iterations);

    const deviations d = compare(model, r);
    printf("brush: %d contacts, N = %.1f to %.0f N, %d iterations of the fixed point\n", FINGERS, d.least_load,
           d.greatest_load, iterations);
    printf("brush: tips lift by %.1e of the plate's speed, friction is %.1e off the slip (limit %.0e)\n", d.lifting,
           d.direction, motion_limit);
    if (!surface_holds(model, d.least_load, d.greatest_load))
        fail("the model does not hold for the surface at these loads");
    printf("siconos  cost  constant mu %.1f ms; the law x %.2f\n", 1e3 * constant, law / constant);

    problem->q = problem->mu = NULL;   /* not from the heap */
    frictionContactProblem_free(problem);
    solver_options_delete(options);
    free(options);
    asperity_free(model);
    const int pass = d.cone <= cone_limit && d.lifting <= motion_limit && d.direction <= motion_limit;
    printf("siconos  %s  max |F/N - mu(N)|/mu = %.1e  (limit %.0e)  %.1f s\n", pass ? "PASS" : "FAIL", d.cone,
           cone_limit, now() - start);
    return !pass;
}
