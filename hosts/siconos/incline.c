/* A box on an incline by Siconos: time steps with one contact, u = W r + q, solved again until mu is the law at the reaction found.
 * SI units. */
#define _GNU_SOURCE
#define HOST "siconos"
#include "../incline.h"

#include <FrictionContactProblem.h>
#include <Friction_cst.h>
#include <NonSmoothDrivers.h>
#include <NumericsMatrix.h>
#include <SolverOptions.h>

/* Solves a step; r is the impulse, with its normal part first. */
static void solve(FrictionContactProblem *problem, SolverOptions *options, const asperity_model *model, double dt, double *r, double *u) {
    for (int pass = 0; pass < 100; pass++) {
        if (fc3d_driver(problem, r, u, options) != 0) fail("fc3d_driver did not converge");
        const double law = asperity_friction_at_load(model, r[0] / dt), change = fabs(law / problem->mu[0] - 1);
        problem->mu[0] = law;
        if (change < 1e-10) return;
    }
    fail("friction and normal force do not settle");
}

static double slide(const asperity_model *model) {
    const double dt = share * 1e-3;
    double W[9] = {1 / box_mass, 0, 0, 0, 1 / box_mass, 0, 0, 0, 1 / box_mass}, q[3], mu[1] = {0.3};
    double r[3] = {0}, u[3] = {0}, speed = 0, begin = 0;
    FrictionContactProblem *problem = frictionContactProblem_new();
    SolverOptions *options = solver_options_create(SICONOS_FRICTION_3D_NSGS);
    problem->dimension = 3;
    problem->numberOfContacts = 1;
    problem->M = NM_create_from_data(NM_DENSE, 3, 3, W);
    problem->q = q;
    problem->mu = mu;
    options->dparam[SICONOS_DPARAM_TOL] = 1e-12;
    options->iparam[SICONOS_FRICTION_3D_IPARAM_ERROR_EVALUATION] = SICONOS_FRICTION_3D_NSGS_ERROR_EVALUATION_FULL;
    for (int step = 0; step < 1000; step++) {
        if (step == 100) begin = speed;
        q[0] = -normal * dt;
        q[1] = speed + downhill * dt;
        q[2] = 0;
        solve(problem, options, model, dt, r, u);
        speed = u[1];
    }
    solver_options_delete(options);
    problem->M->matrix0 = NULL; /* not on the heap */
    NM_clear(problem->M);
    free(problem->M);
    free(problem);
    return (speed - begin) / (900 * dt);
}

int main(void) { return judge_incline(slide, 1e-6); }
