/* One step of an ODE world whose friction coefficients follow the law, at the normal force of that same step.
 *
 * ODE takes mu before it solves for the forces. So the step is made with a guess, the normal force of each pair of
 * geometries is read, the bodies are put back, and the step is made again, until mu is the law at the force found. */
#ifndef LAW_STEP_H
#define LAW_STEP_H

#include <ode/ode.h>

#include "asperity.h"

enum { LAW_MAX_CONTACTS = 64, LAW_MAX_PAIRS = 16, LAW_MAX_BODIES = 16 };

/* Two geometries that touch, at one or more contact points; kept from step to step. */
typedef struct law_pair {
    dGeomID first, second;
    double mu;                           /* what the step is made with */
    double normal_force;                 /* what it gave, summed over the points of the pair */
    double previous_mu, previous_law;    /* of the pass before, for the secant */
    int passes, touching;
} law_pair;

typedef struct law_stepper {
    dWorldID world;
    dSpaceID space;
    dBodyID body[LAW_MAX_BODIES];        /* all that a step may move */
    int bodies;
    const asperity_model *model;         /* NULL: constant_mu throughout, one pass */
    double constant_mu;
    double first_load;                   /* guess of the normal force of a pair that was not there before */
    double tolerance;                    /* relative, on mu */
    int max_passes;                      /* 1: the force of the step before, a lagged law */
    int quick;                           /* 1: dWorldQuickStep, needed where friction changes the normal force */
    double surface_velocity;             /* of fixed geometries, along x: a belt */
    /* The rest is the stepper's own. */
    law_pair pair[LAW_MAX_PAIRS];
    int pairs;
    dContact contact[LAW_MAX_CONTACTS];
    int owner[LAW_MAX_CONTACTS], contacts;
    dJointFeedback feedback[LAW_MAX_CONTACTS];
    dJointGroupID joints;
    const char *failure;                 /* set when a step returned 0 */
} law_stepper;

void law_stepper_init(law_stepper *stepper, dWorldID world, dSpaceID space);
void law_stepper_destroy(law_stepper *stepper);
/* Steps the world; the forces and torques accumulated on the bodies act in every pass. Returns the number of passes
 * made, 0 on failure. */
int law_stepper_step(law_stepper *stepper, double time_step);

#endif
