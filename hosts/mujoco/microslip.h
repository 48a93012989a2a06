/* Pairs of geometries that stick: microslip in place of MuJoCo's slow slip, for plugin.c.
 *
 * In MuJoCo the friction of a contact that sticks is f = (-B v - a)/R: it needs a slip velocity v, so that a held body creeps. Here
 * a pair has a contact that remembers (asperity_microslip_step), and its force T is the reference of its friction rows,
 * f = (-T R - B v - a)/R, which MuJoCo's solver limits by the cone as before. A pair at rest has f = -T with v = 0.
 *
 * T follows the displacement explicitly, from step to step. The stiffness of summits is too great for that, so the displacement is
 * scaled down until the stiffness is B^2/4 I/R at each point, that of critical damping. T reaches the same friction force.
 *
 * MuJoCo takes J a for the relative acceleration of two bodies. Of bodies that turn together this lacks J' v, for which a held
 * body would drift at J' v/B; the reference of a pair that sticks has it: aref = -T R - B v - J' v.
 *
 * The points of a pair share T as they share the load. What resists a twist about the normal is one spring with a limit more: a force at each
 * point in proportion to its distance from their centre, on average F at most. The cone limits each point as ever.
 */
#ifndef ASPERITY_MUJOCO_MICROSLIP_H
#define ASPERITY_MUJOCO_MICROSLIP_H

#include <math.h>
#include <stddef.h>

#include <mujoco/mujoco.h>

#include "asperity.h"
#include "asperity_loads.h"

/* A pair that touched in the last step. All zero: a free place. */
typedef struct held_pair {
    double taken, first, second; /* as in asperity_body_pair */
    double tangent[3];           /* the first axis of the state, moved with the bodies */
    double force[3];             /* T, against the motion of the second body */
    double twist;                /* what resists twist, force by distance from the centre of the points */
    double state[];
} held_pair;

/* Places for pairs, in the plugin's state. */
typedef struct held_pairs {
    double *places;
    size_t count, width; /* doubles of a place */
} held_pairs;

static inline size_t held_width(const asperity_model *model) {
    return offsetof(held_pair, state) / sizeof(double) + asperity_microslip_length(model);
}

/* The place of a pair; if it has none, a free one; NULL if there is neither. */
static inline held_pair *held_place(held_pairs pairs, const mjContact *contact) {
    const double first = contact->geom[0], second = contact->geom[1];
    size_t i = asperity_pairs_home(pairs.count, first, second);
    for (size_t tried = 0; tried < pairs.count; tried++, i = (i + 1) % pairs.count) {
        held_pair *place = (held_pair *)(pairs.places + i * pairs.width);
        if (place->taken == 0 || (place->first == first && place->second == second)) return place;
    }
    return NULL;
}

/* The normal force that the depth of a point gives at rest: how the points of a pair share T. 0 where there is no constraint. */
static inline double resting_force(const mjData *d, const mjContact *point) {
    const int row = point->efc_address;
    if (row < 0) return 0;
    const mjtNum *kbip = d->efc_KBIP + 4 * row;
    return fmax(kbip[0] * kbip[2] * (d->efc_margin[row] - d->efc_pos[row]) / d->efc_R[row], mjMINVAL);
}

static inline double resting_forces(const mjData *d, const mjContact *points, int count) {
    double sum = 0;
    for (int i = 0; i < count; i++) sum += resting_force(d, &points[i]);
    return sum;
}

/* The centre of the points of a pair. */
static inline void centre_of(const mjData *d, const mjContact *points, int count, double centre[3]) {
    const double all = resting_forces(d, points, count);
    mju_zero3(centre);
    for (int i = 0; i < count; i++) mju_addToScl3(centre, points[i].pos, resting_force(d, &points[i]) / all);
}

/* Which way a point goes in a twist about the normal by a unit angle. */
static inline void arm_of(const mjContact *point, const double centre[3], double arm[3]) {
    double from_centre[3];
    mju_sub3(from_centre, point->pos, centre);
    mju_cross(arm, point->frame, from_centre);
}

/* J' v of a point: the acceleration of the second body relative to the first that velocities alone give. */
static inline void turning(const mjModel *m, mjData *d, const mjContact *point, double acceleration[3]) {
    mj_markStack(d);
    mjtNum *jacobian = mj_stackAllocNum(d, 3 * (size_t)m->nv);
    mju_zero3(acceleration);
    for (int side = 0; side < 2; side++) {
        double of_body[3];
        mj_jacDot(m, d, jacobian, NULL, point->pos, m->geom_bodyid[point->geom[side]]);
        mju_mulMatVec(of_body, jacobian, d->qvel, 3, m->nv);
        mju_addToScl3(acceleration, of_body, side == 0 ? -1 : 1);
    }
    mj_freeStack(d);
}

/* Gives the points of a pair their reference, before mj_referenceConstraint: aref = -B v - K I (pos - margin). */
static inline void hold(const mjModel *m, mjData *d, const held_pair *held, const mjContact *points, int count) {
    const double all = resting_forces(d, points, count);
    double centre[3];
    centre_of(d, points, count, centre);
    for (int i = 0; i < count; i++) {
        const double share = resting_force(d, &points[i]) / all;
        double force[3], acceleration[3];
        if (!(share > 0)) continue;
        turning(m, d, &points[i], acceleration);
        arm_of(&points[i], centre, force);
        mju_scl3(force, force, held->twist);
        mju_addTo3(force, held->force);
        for (int axis = 1; axis <= 2; axis++) {
            const int row = points[i].efc_address + axis;
            const mjtNum *way = points[i].frame + 3 * axis;
            const double less = share * mju_dot3(force, way) * d->efc_R[row] + mju_dot3(acceleration, way);
            d->efc_KBIP[4 * row] = 1;
            d->efc_pos[row] = d->efc_margin[row] + less / d->efc_KBIP[4 * row + 2];
        }
    }
}

/* The greatest stiffness of a pair at which no point has more than that of critical damping. */
static inline double greatest_stiffness(const mjData *d, const mjContact *points, int count) {
    const double all = resting_forces(d, points, count);
    double least = INFINITY;
    for (int i = 0; i < count; i++) {
        const double share = resting_force(d, &points[i]) / all;
        if (!(share > 0)) continue;
        const int row = points[i].efc_address + 1;
        const mjtNum *kbip = d->efc_KBIP + 4 * row;
        least = fmin(least, 0.25 * kbip[1] * kbip[1] * kbip[2] / d->efc_R[row] / share);
    }
    return least;
}

/* A step's slip of the second body of a pair over the first. */
typedef struct pair_slip {
    double along[3], angle;
    double distance; /* of the points from their centre, on average */
} pair_slip;

/* `velocity` is that of every row of the constraints. */
static inline pair_slip slip_of(const mjModel *m, const mjData *d, const mjtNum *velocity, const mjContact *points, int count) {
    const double all = resting_forces(d, points, count);
    pair_slip slip = {{0, 0, 0}, 0, 0};
    double centre[3], moment = 0, inertia = 0;
    centre_of(d, points, count, centre);
    for (int i = 0; i < count; i++) {
        const double share = resting_force(d, &points[i]) / all;
        double arm[3], moved[3] = {0, 0, 0};
        if (!(share > 0)) continue;
        for (int axis = 1; axis <= 2; axis++)
            mju_addToScl3(moved, points[i].frame + 3 * axis, m->opt.timestep * velocity[points[i].efc_address + axis]);
        arm_of(&points[i], centre, arm);
        mju_addToScl3(slip.along, moved, share);
        moment += share * mju_dot3(arm, moved);
        inertia += share * mju_dot3(arm, arm);
        slip.distance += share * mju_norm3(arm);
    }
    slip.angle = inertia > mjMINVAL ? moment / inertia : 0;
    return slip;
}

/* Turns the first axis of a pair with its bodies and lays it into the plane of contact. */
static inline void move_tangent(const mjModel *m, const mjData *d, const mjContact *point, double tangent[3]) {
    double spin[3], turned[3];
    const mjtNum *normal = point->frame;
    mju_add3(spin, d->cvel + 6 * m->geom_bodyid[point->geom[0]], d->cvel + 6 * m->geom_bodyid[point->geom[1]]);
    mju_cross(turned, spin, tangent);
    mju_addToScl3(tangent, turned, 0.5 * m->opt.timestep);
    mju_addToScl3(tangent, normal, -mju_dot3(normal, tangent));
    if (mju_normalize3(tangent) < mjMINVAL) mju_copy3(tangent, point->frame + 3);
}

/* Moves the contact of a pair, all 0 if it has just closed, by the slip of this step. Returns 0 if nothing holds the pair. */
static inline int slide(const mjModel *m, const mjData *d, const asperity_model *model, const mjtNum *velocity,
                        const mjContact *points, int count, double load, held_pair *held) {
    const double stiffness = asperity_tangential_stiffness_at_load(model, load);
    asperity_microslip out = {.struct_size = sizeof out};
    if (!(load > 0 && stiffness > 0)) return 0;
    const double soft = fmin(stiffness, greatest_stiffness(d, points, count)), part = soft / stiffness;
    const pair_slip slip = slip_of(m, d, velocity, points, count);
    double across[3];
    move_tangent(m, d, points, held->tangent);
    mju_cross(across, points->frame, held->tangent);
    const double increment[2] = {part * mju_dot3(slip.along, held->tangent), part * mju_dot3(slip.along, across)};
    if (asperity_microslip_step(model, load, increment, held->state, held->state, &out) != ASPERITY_OK) return 0;
    mju_scl3(held->force, held->tangent, out.force[0]);
    mju_addToScl3(held->force, across, out.force[1]);
    const double limit = slip.distance > mjMINVAL ? asperity_friction_force_at_load(model, load) / slip.distance : 0;
    held->twist = fmax(-limit, fmin(limit, held->twist + soft * slip.angle));
    held->taken = 1;
    held->first = points->geom[0];
    held->second = points->geom[1];
    return 1;
}

#endif
