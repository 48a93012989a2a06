/* A sled on a plane in ODE, its friction coefficient the law at the normal force of the same step (SI units).
 * 1. Pulled under a slowly varying load: friction and normal force, as the sled's motion shows them, against the law.
 * 2. On an incline: the angle at which it starts to slip, against tan(theta) = mu(m g cos(theta)).
 * Also: what a lagged normal force would give, and what the law costs. */
#define _GNU_SOURCE
#include <fenv.h>
#include <math.h>

#define HOST "ode"
#include "../verdict.h"
#include "law_step.h"

static const double limit = 1e-6;
static const double mass = 20, gravity = 9.81, length = 0.2, width = 0.1, height = 0.02;

typedef struct sled {
    dWorldID world;
    dSpaceID space;
    dBodyID body;
    law_stepper stepper;
} sled;

static void keep_upright(sled *s) {
    const dJointID motor = dJointCreateAMotor(s->world, 0);
    dJointAttach(motor, s->body, 0);
    dJointSetAMotorNumAxes(motor, 3);
    for (int axis = 0; axis < 3; axis++) dJointSetAMotorAxis(motor, axis, 0, axis == 0, axis == 1, axis == 2);
    dJointSetAMotorParam(motor, dParamFMax1, dInfinity);
    dJointSetAMotorParam(motor, dParamFMax2, dInfinity);
    dJointSetAMotorParam(motor, dParamFMax3, dInfinity);
    dWorldSetCFM(s->world, 0);           /* no redundant constraint, so no softness is needed */
}

/* On a flat base (a box: four contact points, whose forces only sum to something unique) or on one spherical foot. */
static void sled_build(sled *s, const asperity_model *model, int one_foot) {
    dMass inertia;
    s->world = dWorldCreate();
    s->space = dHashSpaceCreate(0);
    dWorldSetGravity(s->world, 0, 0, -gravity);
    dWorldSetContactSurfaceLayer(s->world, 1e-5);
    dCreatePlane(s->space, 0, 0, 1, 0);
    s->body = dBodyCreate(s->world);
    dMassSetBoxTotal(&inertia, mass, length, width, height);
    dBodySetMass(s->body, &inertia);
    const double radius = 0.5 * height;
    dGeomSetBody(one_foot ? dCreateSphere(s->space, radius) : dCreateBox(s->space, length, width, height), s->body);
    if (one_foot) keep_upright(s);
    dBodySetPosition(s->body, 0, 0, 0.5 * height - 1e-5);
    law_stepper_init(&s->stepper, s->world, s->space);
    s->stepper.body[0] = s->body;
    s->stepper.bodies = 1;
    s->stepper.model = model;
    s->stepper.first_load = mass * gravity;
}

static void sled_destroy(sled *s) {
    law_stepper_destroy(&s->stepper);
    dSpaceDestroy(s->space);
    dWorldDestroy(s->world);
}

static int sled_step(sled *s, double time_step) {
    const int passes = law_stepper_step(&s->stepper, time_step);
    if (passes == 0) fail("%s", s->stepper.failure);
    return passes;
}

typedef struct pull {
    double seconds, deviation;     /* of F/N from the law, relative */
    double least_load, greatest_load;
    int steps, passes;
} pull;

/* Two seconds under a load of 200 to 1000 N on top of the weight. F and N come from the momentum of the sled. */
static pull pull_sled(const asperity_model *model, const asperity_model *reference, int max_passes) {
    const double dt = 1e-3, traction = 400;
    pull result = {.least_load = INFINITY};
    sled s;
    sled_build(&s, model, 0);
    s.stepper.max_passes = max_passes;
    s.stepper.constant_mu = 0.3;
    dBodySetLinearVel(s.body, 5, 0, 0);
    for (int step = 0; step < 2000; step++) {
        const double added = 600 + 400 * sin(M_PI * step * dt);
        const double vx = dBodyGetLinearVel(s.body)[0], vz = dBodyGetLinearVel(s.body)[2];
        dBodyAddForce(s.body, traction, 0, -added);
        const double start = now();
        result.passes += sled_step(&s, dt);
        result.seconds += now() - start;
        result.steps++;
        const double normal = mass * gravity + added + mass * (dBodyGetLinearVel(s.body)[2] - vz) / dt;
        const double friction = traction - mass * (dBodyGetLinearVel(s.body)[0] - vx) / dt;
        if (s.stepper.pairs != 1 || !(normal > 0) || !(dBodyGetLinearVel(s.body)[0] > 1))
            fail("the sled left the plane or stopped at step %d", step);
        result.least_load = fmin(result.least_load, normal);
        result.greatest_load = fmax(result.greatest_load, normal);
        if (step > 0 && reference) {
            const double mu = exact_mu(reference, normal);
            result.deviation = worse(result.deviation, fabs(friction / normal - mu) / mu);
        }
    }
    sled_destroy(&s);
    return result;
}

/* Of five runs: the machine may be busy. */
static double least_seconds(const asperity_model *model, int max_passes) {
    double least = INFINITY;
    for (int i = 0; i < 5; i++) least = fmin(least, pull_sled(model, NULL, max_passes).seconds);
    return least;
}

/* Does the sled gain speed within 0.1 s from rest? */
static int slips(const asperity_model *model, double angle) {
    sled s;
    sled_build(&s, model, 1);
    dWorldSetGravity(s.world, gravity * sin(angle), 0, -gravity * cos(angle));
    for (int step = 0; step < 10; step++) sled_step(&s, 0.01);
    const double speed = dBodyGetLinearVel(s.body)[0];
    sled_destroy(&s);
    return speed > 1e-10;
}

static double slip_angle_of_sled(const asperity_model *model) {
    double low = 0.1, high = 1.2;
    if (slips(model, low) || !slips(model, high)) fail("no slip angle between %g and %g rad", low, high);
    while (high - low > 1e-10) {
        const double middle = 0.5 * (low + high);
        *(slips(model, middle) ? &high : &low) = middle;
    }
    return 0.5 * (low + high);
}

static double slip_angle_by_mechanics(const asperity_model *model) {
    double low = 0.1, high = 1.2;
    while (high - low > 1e-12) {
        const double middle = 0.5 * (low + high);
        *(tan(middle) > exact_mu(model, mass * gravity * cos(middle)) ? &high : &low) = middle;
    }
    return 0.5 * (low + high);
}

int main(void) {
    const double start = now();
    dInitODE2(0);
    if (!dCheckConfiguration("ODE_double_precision")) fail("this ODE is built in single precision");
    feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
    asperity_model *model = law_of_contact();

    const pull current = pull_sled(model, model, 30), lagged = pull_sled(model, model, 1);
    printf("sled: N = %.0f to %.0f N, %d steps, %.2f passes a step: |F/N - mu(N)|/mu <= %.1e\n", current.least_load,
           current.greatest_load, current.steps, (double)current.passes / current.steps, current.deviation);
    printf("sled with the normal force of the step before: %.1e\n", lagged.deviation);

    const double found = slip_angle_of_sled(model), expected = slip_angle_by_mechanics(model);
    const double angle_deviation = fabs(tan(found) - tan(expected)) / tan(expected);
    printf("incline: slips at %.7f rad, expected %.7f rad: tan off by %.1e\n", found, expected, angle_deviation);

    const double heaviest = fmax(current.greatest_load, mass * gravity);
    if (!surface_holds(model, fmin(current.least_load, mass * gravity * cos(found)), heaviest))
        fail("the model does not hold for the surface at these loads");
    const double constant = least_seconds(NULL, 1);
    printf("ode  cost  constant mu %.1f ms; the law at the lagged force x %.2f, at the current force x %.2f\n",
           1e3 * constant, least_seconds(model, 1) / constant, least_seconds(model, 30) / constant);

    asperity_free(model);
    dCloseODE();
    const double deviation = worse(current.deviation, angle_deviation);
    const int pass = deviation <= limit && lagged.deviation > limit;
    printf("ode  %s  max |F/N - mu(N)|/mu = %.1e  (limit %.0e)  %.1f s\n", pass ? "PASS" : "FAIL", deviation, limit,
           now() - start);
    return !pass;
}
