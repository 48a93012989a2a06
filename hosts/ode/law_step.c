/* See law_step.h. The contact joints of ODE live for one step only, so what is known of a contact is kept by its pair
 * of geometries. */
#include "law_step.h"

#include <math.h>
#include <string.h>

typedef struct body_state {
    dVector3 position, linear, angular, force, torque;
    dQuaternion rotation;
} body_state;

static body_state body_state_of(dBodyID body) {
    body_state s;
    memcpy(s.position, dBodyGetPosition(body), sizeof s.position);
    memcpy(s.rotation, dBodyGetQuaternion(body), sizeof s.rotation);
    memcpy(s.linear, dBodyGetLinearVel(body), sizeof s.linear);
    memcpy(s.angular, dBodyGetAngularVel(body), sizeof s.angular);
    memcpy(s.force, dBodyGetForce(body), sizeof s.force);
    memcpy(s.torque, dBodyGetTorque(body), sizeof s.torque);
    return s;
}

static void put_back(dBodyID body, const body_state *s) {
    dBodySetPosition(body, s->position[0], s->position[1], s->position[2]);
    dBodySetQuaternion(body, s->rotation);
    dBodySetLinearVel(body, s->linear[0], s->linear[1], s->linear[2]);
    dBodySetAngularVel(body, s->angular[0], s->angular[1], s->angular[2]);
    dBodySetForce(body, s->force[0], s->force[1], s->force[2]);
    dBodySetTorque(body, s->torque[0], s->torque[1], s->torque[2]);
}

static double law(const law_stepper *stepper, double load) {
    return stepper->model ? asperity_friction_at_load(stepper->model, load) : stepper->constant_mu;
}

static int find_or_add_pair(law_stepper *stepper, dGeomID first, dGeomID second) {
    for (int i = 0; i < stepper->pairs; i++) {
        const law_pair *p = &stepper->pair[i];
        if ((p->first == first && p->second == second) || (p->first == second && p->second == first)) return i;
    }
    if (stepper->pairs == LAW_MAX_PAIRS) return -1;
    const double mu = law(stepper, stepper->first_load);
    stepper->pair[stepper->pairs] = (law_pair){.first = first, .second = second, .mu = mu};
    return stepper->pairs++;
}

/* ODE's friction is a pyramid: only along its two axes is the friction mu N. Put the first along the slip. */
static void align_with_slip(dContact *contact, double surface_velocity) {
    dVector3 slip = {0}, at;
    const dGeomID geometry[2] = {contact->geom.g1, contact->geom.g2};
    for (int side = 0; side < 2; side++) {
        const dBodyID body = dGeomGetBody(geometry[side]);
        if (!body) continue;
        const double *p = contact->geom.pos;
        dBodyGetPointVel(body, p[0], p[1], p[2], at);
        for (int k = 0; k < 3; k++) slip[k] += (side == 0 ? at[k] : -at[k]);
    }
    slip[0] -= surface_velocity;
    const double *n = contact->geom.normal;
    const double along = slip[0] * n[0] + slip[1] * n[1] + slip[2] * n[2];
    for (int k = 0; k < 3; k++) slip[k] -= along * n[k];
    const double speed = sqrt(slip[0] * slip[0] + slip[1] * slip[1] + slip[2] * slip[2]);
    if (speed < 1e-9) return;            /* at rest: ODE picks the axes */
    for (int k = 0; k < 3; k++) contact->fdir1[k] = slip[k] / speed;
    contact->surface.mode |= dContactFDir1;
    if (surface_velocity != 0) {
        contact->surface.mode |= dContactMotion1;
        contact->surface.motion1 = surface_velocity * contact->fdir1[0];
    }
}

static void near_callback(void *data, dGeomID first, dGeomID second) {
    law_stepper *stepper = data;
    const dBodyID a = dGeomGetBody(first), b = dGeomGetBody(second);
    if (stepper->failure || (!a && !b)) return;
    if (a && b && dAreConnectedExcluding(a, b, dJointTypeContact)) return;
    const int room = LAW_MAX_CONTACTS - stepper->contacts;
    if (room == 0) { stepper->failure = "more contact points than LAW_MAX_CONTACTS"; return; }
    dContact *contact = &stepper->contact[stepper->contacts];
    const int found = dCollide(first, second, room, &contact->geom, sizeof *contact);
    if (found == 0) return;
    const int owner = find_or_add_pair(stepper, first, second);
    if (owner < 0) { stepper->failure = "more pairs of geometries than LAW_MAX_PAIRS"; return; }
    stepper->pair[owner].touching = 1;
    for (int i = 0; i < found; i++) {
        contact[i].surface = (dSurfaceParameters){.mode = dContactApprox1};   /* else mu is a force */
        align_with_slip(&contact[i], a && b ? 0 : stepper->surface_velocity);
        stepper->owner[stepper->contacts++] = owner;
    }
}

static void step_once(law_stepper *stepper, double time_step) {
    for (int i = 0; i < stepper->contacts; i++) {
        dContact *contact = &stepper->contact[i];
        contact->surface.mu = stepper->pair[stepper->owner[i]].mu;
        const dJointID joint = dJointCreateContact(stepper->world, stepper->joints, contact);
        dJointAttach(joint, dGeomGetBody(contact->geom.g1), dGeomGetBody(contact->geom.g2));
        dJointSetFeedback(joint, &stepper->feedback[i]);
    }
    const int stepped = (stepper->quick ? dWorldQuickStep : dWorldStep)(stepper->world, time_step);
    if (!stepped) stepper->failure = "ODE is out of memory";
    dJointGroupEmpty(stepper->joints);
}

/* Which of the two bodies f1 acts on depends on their order in the joint; a contact pushes, whichever it is. */
static void sum_normal_forces(law_stepper *stepper) {
    for (int i = 0; i < stepper->pairs; i++) stepper->pair[i].normal_force = 0;
    for (int i = 0; i < stepper->contacts; i++) {
        const dContactGeom *g = &stepper->contact[i].geom;
        const double *f = stepper->feedback[i].f1;
        const double normal = f[0] * g->normal[0] + f[1] * g->normal[1] + f[2] * g->normal[2];
        stepper->pair[stepper->owner[i]].normal_force += fabs(normal);
    }
}

/* Next mu of a pair: the law at the force found, then by secants, for where the force itself grows with mu (a wedge,
 * a leading brake shoe) setting mu = law again and again may run away. Returns 1 when mu is the law. */
static int update(const law_stepper *stepper, law_pair *pair) {
    const double target = law(stepper, pair->normal_force), mu = pair->mu;
    const int converged = fabs(target - mu) <= stepper->tolerance * mu;
    double next = target;
    if (pair->passes > 0 && mu != pair->previous_mu) {
        const double slope = (target - pair->previous_law) / (mu - pair->previous_mu);
        if (slope < 0.9) next = mu + (target - mu) / (1 - slope);
        if (next <= 0.5 * mu || next >= 2 * mu) next = target;
    }
    pair->previous_mu = mu;
    pair->previous_law = target;
    pair->passes++;
    pair->mu = next;
    return converged;
}

void law_stepper_init(law_stepper *stepper, dWorldID world, dSpaceID space) {
    memset(stepper, 0, sizeof *stepper);
    stepper->world = world;
    stepper->space = space;
    stepper->tolerance = 1e-12;
    stepper->max_passes = 30;
    stepper->first_load = 1;
    stepper->joints = dJointGroupCreate(0);
}

void law_stepper_destroy(law_stepper *stepper) {
    dJointGroupDestroy(stepper->joints);
}

static void forget_separated_pairs(law_stepper *stepper) {
    int kept = 0;
    int moved_to[LAW_MAX_PAIRS];
    for (int i = 0; i < stepper->pairs; i++) {
        moved_to[i] = kept;
        if (stepper->pair[i].touching) stepper->pair[kept++] = stepper->pair[i];
    }
    for (int i = 0; i < stepper->contacts; i++) stepper->owner[i] = moved_to[stepper->owner[i]];
    stepper->pairs = kept;
}

int law_stepper_step(law_stepper *stepper, double time_step) {
    body_state state[LAW_MAX_BODIES];
    for (int i = 0; i < stepper->bodies; i++) state[i] = body_state_of(stepper->body[i]);
    stepper->contacts = 0;
    stepper->failure = NULL;
    const unsigned long seed = dRandGetSeed();   /* dWorldQuickStep shuffles its rows */
    for (int i = 0; i < stepper->pairs; i++) stepper->pair[i].touching = stepper->pair[i].passes = 0;
    dSpaceCollide(stepper->space, stepper, near_callback);
    if (stepper->failure) return 0;
    forget_separated_pairs(stepper);
    const int single = !stepper->model || stepper->max_passes == 1;
    for (int pass = 1;; pass++) {
        step_once(stepper, time_step);
        if (stepper->failure) return 0;
        sum_normal_forces(stepper);
        int converged = 1;
        for (int i = 0; i < stepper->pairs; i++) converged &= update(stepper, &stepper->pair[i]);
        if (converged || single) return pass;
        if (pass == stepper->max_passes) { stepper->failure = "mu and normal force do not converge"; return 0; }
        dRandSetSeed(seed);
        for (int i = 0; i < stepper->bodies; i++) put_back(stepper->body[i], &state[i]);
    }
}
