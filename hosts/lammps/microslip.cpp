// Microslip: the summits of a contact slip one after the other (asperity_microslip_steps), behind the grain's own spring.
//
// With the displacement D of the step, of which d goes into the summits and the rest into the grain, of stiffness G:
//   T(d) = T_before + G (D - d)
// T, of the library, is the sum of many parts that stick or slip, and Newton's method finds d. It begins with what the tangent of
// the step before says, or where a contact is unloaded with that of sticking: most steps then take two calls.
// d is in the softened grain's lengths: the summits of the real one move by softening_ times as much.
#include "law.h"

namespace asperity_lammps {

namespace {

// The largest residual, relative to the limit, and the most calls. Parts slip one after the other as d grows, so that iterations
// approach from one side, from one piece of T to the next.
const double tolerance = 1e-6;
const int most_calls = 40;

// The solution of a symmetric system, (xx xy, xy yy) x = (b0, b1).
void solve(double xx, double xy, double yy, const double *b, double *x) {
    const double inverse = 1 / (xx * yy - xy * xy);
    x[0] = inverse * (yy * b[0] - xy * b[1]);
    x[1] = inverse * (xx * b[1] - xy * b[0]);
}

struct Frame {
    double one[3], other[3], side;

    double along(const double *v, int axis) const { return dot(axis == 0 ? one : other, v); }
};

// The directions of a contact, turned with its tangent plane, or new ones.
Frame frame_of(const Contact &c, bool remembers) {
    const double *n = c.normal;
    Frame f{{0, 0, 0}, {0, 0, 0}, remembers ? c.history[SIDE] : 1.0};
    if (remembers) std::copy_n(c.history + SPRING, 3, f.one);
    for (int attempt = 0; attempt < 2; attempt++) {
        const double off = dot(f.one, n);
        for (int a = 0; a < 3; a++) f.one[a] -= off * n[a];
        const double size = std::sqrt(dot(f.one, f.one));
        if (size > 0.1) {
            for (double &component : f.one) component /= size;
            break;
        }
        // None yet, or one that has become the normal: the axis that is farthest from it.
        const double x = std::abs(n[0]), y = std::abs(n[1]), z = std::abs(n[2]);
        std::fill_n(f.one, 3, 0.0);
        f.one[x <= y && x <= z ? 0 : y <= z ? 1 : 2] = 1;
    }
    cross(n, f.one, f.other);
    for (double &component : f.other) component *= f.side;
    return f;
}

enum { BATCH = Law::BATCH, MOST = Law::MOST_REMEMBERED };

// A state ends with two stiffnesses, which grow with the area of the contact; all else are displacements.
double of_area(int number, int numbers, double area) { return number < numbers - 2 ? 1 : area; }

// What is solved for a contact: forces and displacements in the directions of its frame.
struct Step {
    Frame frame;
    double moved[2], part[2];           // D, and d
    double earlier[2], force[2];        // T before and now
    double tangent[3];                  // dT/dd: xx, xy, yy
    double correction[2], left_over;    // of the iteration before
};

// The displacement of the step, and a first guess of the summits' part of it.
void begin(const Contact &c, const Forces &r, double kept, double dt, double grain, double summits, Step &step) {
    double slip[3];
    for (int a = 0; a < 3; a++) slip[a] = c.velocity[a] + r.approach * c.normal[a];
    step.frame = frame_of(c, c.history[STIFFNESS] != 0);
    std::copy_n(c.history + TANGENT, 3, step.tangent);
    double taken[2];
    for (int axis = 0; axis < 2; axis++) {
        step.moved[axis] = -dt * step.frame.along(slip, axis);
        step.earlier[axis] = kept > 0 ? kept * c.history[FORCE + axis] : 0;
        step.force[axis] = 0;
        taken[axis] = grain * step.moved[axis];
    }
    const bool onwards = step.moved[0] * step.earlier[0] + step.moved[1] * step.earlier[1] > 0;
    if (onwards) solve(grain + step.tangent[0], step.tangent[1], grain + step.tangent[2], taken, step.part);
    else for (int axis = 0; axis < 2; axis++) step.part[axis] = taken[axis] / (grain + summits);
}

// Displaces the summits of some contacts of a batch, all with the states `before`, by the parts of their steps.
void displace(const asperity_model *model, const double *softening, int numbers, int count, const int *which, const double *area,
              const Forces *r, const double *before, Step *step, double *after) {
    double pressure[BATCH], increment[2 * BATCH], from[BATCH * MOST], to[BATCH * MOST] = {}, stress[2 * BATCH], slope[4 * BATCH];
    for (int w = 0; w < count; w++) {
        const int k = which[w];
        pressure[w] = r[k].pressure;
        for (int axis = 0; axis < 2; axis++) increment[2 * w + axis] = softening[k] * step[k].part[axis];
        std::copy_n(before + k * numbers, numbers, from + w * numbers);
    }
    // It fails for what is not finite only, and then gives NaN, as the positions of the grains are.
    asperity_microslip_steps(model, count, pressure, increment, from, to, stress, slope);
    for (int w = 0; w < count; w++) {
        const int k = which[w];
        const double *s = slope + 4 * w, scale = softening[k] * area[k];
        for (int axis = 0; axis < 2; axis++) step[k].force[axis] = area[k] * stress[2 * w + axis];
        step[k].tangent[0] = scale * s[0];
        step[k].tangent[1] = scale * s[1];
        step[k].tangent[2] = scale * s[3];
        std::copy_n(to + w * numbers, numbers, after + k * numbers);
    }
}

// After a call that gave the force and the tangent: true if both bodies carry the same, else with a better part.
bool balanced(double grain, double allowed, bool first, Step &step) {
    double missing[2];
    for (int axis = 0; axis < 2; axis++)
        missing[axis] = step.earlier[axis] + grain * (step.moved[axis] - step.part[axis]) - step.force[axis];
    const double size = std::hypot(missing[0], missing[1]);
    if (size <= allowed) return true;
    if (!first && size >= step.left_over) {    // too far, over several pieces: half as far
        for (int axis = 0; axis < 2; axis++) step.part[axis] -= step.correction[axis] *= 0.5;
        return false;
    }
    step.left_over = size;
    solve(grain + step.tangent[0], step.tangent[1], grain + step.tangent[2], missing, step.correction);
    for (int axis = 0; axis < 2; axis++) step.part[axis] += step.correction[axis];
    return false;
}

void finish(const Contact &c, const Step &step, double dt, Forces &r) {
    const double *force = step.force;
    for (int a = 0; a < 3; a++) r.spring[a] = force[0] * step.frame.one[a] + force[1] * step.frame.other[a];
    r.slips = std::hypot(force[0], force[1]) >= r.limit * (1 - 1e-9) || slipped_before(c.history, dt);
    r.friction_work = 0;
    for (int axis = 0; axis < 2; axis++) {
        const double had = c.history[STIFFNESS] == 0 ? 0 : c.history[FORCE + axis];
        r.friction_work += 0.5 * (had + force[axis]) * step.moved[axis];
    }
    if (!(dt > 0)) return;
    std::copy_n(step.frame.one, 3, c.history + SPRING);
    c.history[STIFFNESS] = r.slips ? -r.stiffness : r.stiffness;
    c.history[SIDE] = step.frame.side;
    std::copy_n(force, 2, c.history + FORCE);
    std::copy_n(step.tangent, 3, c.history + TANGENT);
}

}    // namespace

void Law::microslip(int count, const Contact *contact, double dt, const Bodies &bodies, Forces *result) const {
    Step step[BATCH];
    double before[BATCH * MOST] = {}, after[BATCH * MOST] = {};
    const int numbers = remembered_;
    int waiting[BATCH], open = 0;
    for (int k = 0; k < count; k++) {
        const Contact &c = contact[k];
        const double had = std::abs(c.history[STIFFNESS]), now = result[k].stiffness;
        // What is unloaded loses the force of the part of the grain that opens: see spring(). The summits know of theirs.
        const double kept = had == 0 ? 0 : now < had ? now / had : 1;
        begin(c, result[k], kept, dt, bodies.grain[k], bodies.summits[k], step[k]);
        if (result[k].limit <= 0) continue;    // without load there is neither friction nor memory
        waiting[open++] = k;
        if (kept > 0)
            for (int m = 0; m < numbers; m++) before[k * numbers + m] = c.history[SUMMITS + m] / of_area(m, numbers, bodies.area[k]);
    }
    for (int call = 0; call < most_calls && open > 0; call++) {
        displace(model_.get(), bodies.softening, numbers, open, waiting, bodies.area, result, before, step, after);
        int left = 0;
        for (int w = 0; w < open; w++) {
            const int k = waiting[w];
            if (!balanced(bodies.grain[k], tolerance * result[k].limit, call == 0, step[k])) waiting[left++] = k;
        }
        open = left;
    }
    for (int k = 0; k < count; k++) {
        finish(contact[k], step[k], dt, result[k]);
        if (dt > 0)
            for (int m = 0; m < numbers; m++) contact[k].history[SUMMITS + m] = of_area(m, numbers, bodies.area[k]) * after[k * numbers + m];
    }
}

}    // namespace asperity_lammps
