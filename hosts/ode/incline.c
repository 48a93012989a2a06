/* A box on an incline in ODE, its friction coefficient the law at the normal force of the same step (SI units). */
#define _GNU_SOURCE
#define HOST "ode"
#include "../incline.h"
#include "law_step.h"

static double slide(const asperity_model *model) {
    const dWorldID world = dWorldCreate();
    const dSpaceID space = dHashSpaceCreate(0);
    const dBodyID box = dBodyCreate(world);
    const double dt = share * 1e-3;
    law_stepper stepper;
    dMass inertia;
    dWorldSetGravity(world, downhill, 0, -normal);
    dWorldSetContactSurfaceLayer(world, 1e-5);
    dCreatePlane(space, 0, 0, 1, 0);
    dMassSetBoxTotal(&inertia, box_mass, 0.2, 0.1, 0.1);
    dBodySetMass(box, &inertia);
    dGeomSetBody(dCreateBox(space, 0.2, 0.1, 0.1), box);
    dBodySetPosition(box, 0, 0, 0.05 - 1e-5);
    law_stepper_init(&stepper, world, space);
    stepper.body[stepper.bodies++] = box; /* all that a step may move */
    stepper.model = model;
    stepper.first_load = box_mass * normal;
    double begin = 0;
    for (int step = 0; step < 1000; step++) {
        if (step == 100) begin = dBodyGetLinearVel(box)[0];
        if (law_stepper_step(&stepper, dt) == 0) fail("%s", stepper.failure);
    }
    const double found = (dBodyGetLinearVel(box)[0] - begin) / (900 * dt);
    law_stepper_destroy(&stepper);
    dSpaceDestroy(space);
    dWorldDestroy(world);
    return found;
}

int main(void) {
    dInitODE2(0);
    if (!dCheckConfiguration("ODE_double_precision")) fail("this ODE is built in single precision");
    return judge_incline(slide, 1e-6);
}
