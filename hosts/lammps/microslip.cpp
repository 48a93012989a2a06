// Microslip: the summits of a contact slip one after the other (asperity_microslip_steps), behind the grain's own spring.
//
// With the displacement D of the step, of which d goes into the summits and the rest into the grain, of stiffness G:
//   T(d) = T_before + G (D - d)
// T, of the library, is the sum of many parts that stick or slip, and Newton's method finds d. It begins with what the tangent of
// the step before says, or where a contact is unloaded with that of sticking. Its last correction is not asked for but kept for
// the next step: most steps then take one call. A contact that slides far has the limit in the direction of T_before + G D, and its
// summits forget all else: that needs none until it slows down.
// d is in the softened grain's lengths: the summits of the real one move by softening_ times as much.
#include "law.h"

namespace asperity_lammps {

namespace {

// What the force of sticking summits by the last correction may be, over the limit, where it turns back, and where it goes on;
// what that of a contact that slides far is at least; and the most calls. Parts slip one after the other as d grows, so that
// iterations approach from one side, from one piece of T to the next.
const double tolerance = 1e-3, onward_tolerance = 0.01, far_away = 10;
const int most_calls = 40;

double product(const double *v, const double *w) { return v[0] * w[0] + v[1] * w[1]; }

double square(const double *v) { return product(v, v); }

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
        const double size = dot(f.one, f.one);
        if (size > 0.01) {
            const double inverse = 1 / std::sqrt(size);
            for (double &component : f.one) component *= inverse;
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

// A state to or from a history: it ends with two stiffnesses, which grow with the area of the contact, and the largest pressure; all else
// are displacements.
void copy_state(const double *from, int numbers, double scale, double *to) {
    std::copy_n(from, numbers, to);
    for (int m = numbers - 3; m < numbers - 1; m++) to[m] *= scale;
}

// What is solved for a contact: forces and displacements in the directions of its frame.
struct Step {
    Frame frame;
    double moved[2], part[2];           // D, and d
    double kept[2];                     // of the displacements before, what the library was not asked about yet
    double asked[2];                    // what it is asked about
    double earlier[2], force[2];        // T before and now
    double tangent[3];                  // dT/dd: xx, xy, yy
    double correction[2], left_over;    // of the iteration before, and the square of what it missed
};

// The displacement of the step, and a first guess of the summits' part of it.
void begin(const Contact &c, const Forces &r, double kept, double dt, double grain, double summits, Step &step) {
    double slip[3];
    for (int a = 0; a < 3; a++) slip[a] = c.velocity[a] + r.approach * c.normal[a];
    step.frame = frame_of(c, c.history[STIFFNESS] != 0);
    std::copy_n(c.history + TANGENT, 3, step.tangent);
    double taken[2];
    for (int axis = 0; axis < 2; axis++) {
        step.kept[axis] = kept > 0 ? c.history[KEPT + axis] : 0;
        step.moved[axis] = -dt * step.frame.along(slip, axis);
        step.earlier[axis] = kept > 0 ? kept * c.history[FORCE + axis] : 0;
        step.force[axis] = 0;
        taken[axis] = grain * step.moved[axis];
    }
    if (product(step.moved, step.earlier) > 0) solve(grain + step.tangent[0], step.tangent[1], grain + step.tangent[2], taken, step.part);
    else for (int axis = 0; axis < 2; axis++) step.part[axis] = taken[axis] / (grain + summits);
}

// Displaces the summits of some contacts of a batch, all with the states `before`, by what is asked.
void displace(const asperity_model *model, const double *softening, int numbers, int count, const int *which, const double *area,
              const Forces *r, const double *before, Step *step, double *after) {
    double pressure[BATCH], increment[2 * BATCH], some[2 * BATCH * MOST], stress[2 * BATCH], slope[4 * BATCH];
    if (count < 1) return;
    const bool are_first = which[count - 1] == count - 1;    // in order: then they need not be gathered
    const double *from = are_first ? before : some;
    double *to = are_first ? after : some + BATCH * MOST;
    for (int w = 0; w < count; w++) {
        const int k = which[w];
        pressure[w] = r[k].pressure;
        for (int axis = 0; axis < 2; axis++) increment[2 * w + axis] = softening[k] * step[k].asked[axis];
        if (!are_first) std::copy_n(before + k * numbers, numbers, some + w * numbers);
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
        if (!are_first) std::copy_n(to + w * numbers, numbers, after + k * numbers);
    }
}

// After a call that gave the force and the tangent: a better part, and true if the force of that is known well enough.
bool balanced(double grain, double summits, double limit, bool first, Step &step) {
    double missing[2];
    for (int axis = 0; axis < 2; axis++)
        missing[axis] = step.earlier[axis] + grain * (step.moved[axis] - step.part[axis]) - step.force[axis];
    const double size = square(missing);
    if (!first && size >= step.left_over) {    // too far, over several pieces: half as far
        for (int axis = 0; axis < 2; axis++) step.part[axis] -= step.correction[axis] *= 0.5;
        return false;
    }
    step.left_over = size;
    solve(grain + step.tangent[0], step.tangent[1], grain + step.tangent[2], missing, step.correction);
    for (int axis = 0; axis < 2; axis++) step.part[axis] += step.correction[axis];
    const double allowed = product(step.correction, step.asked) < 0 ? tolerance : onward_tolerance;
    return summits * summits * square(step.correction) <= allowed * limit * allowed * limit;
}

// True for a contact that slides so far that its force, and all that its summits remember, is that of sliding.
bool slides(double grain, double summits, double limit, Step &step) {
    double trial[2];
    for (int axis = 0; axis < 2; axis++) trial[axis] = step.earlier[axis] + grain * step.moved[axis];
    const double size = square(trial), far = limit * (summits + far_away * grain);
    if (!(size * summits * summits > far * far)) return false;
    for (int axis = 0; axis < 2; axis++) {
        step.kept[axis] = step.part[axis] = trial[axis] * (1 - limit / std::sqrt(size)) / grain;
        step.tangent[axis] = step.tangent[axis + 1] = 0;
    }
    return true;
}

// The force is that of the grain's spring.
void carry(double grain, double limit, Step &step) {
    for (int axis = 0; axis < 2; axis++) step.force[axis] = step.earlier[axis] + grain * (step.moved[axis] - step.part[axis]);
    const double size = square(step.force);
    if (size > limit * limit)
        for (double &force : step.force) force *= limit / std::sqrt(size);
}

void finish(const Contact &c, const Step &step, double dt, Forces &r) {
    const double *force = step.force;
    for (int a = 0; a < 3; a++) r.spring[a] = force[0] * step.frame.one[a] + force[1] * step.frame.other[a];
    r.slips = square(force) >= r.limit * r.limit * (1 - 2e-9) || slipped_before(c.history, dt);
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
    std::copy_n(step.kept, 2, c.history + KEPT);
}

}    // namespace

void Law::microslip(int count, const Contact *contact, double dt, const Bodies &bodies, Forces *result) const {
    Step step[BATCH];
    double before[BATCH * MOST], after[BATCH * MOST];
    const double *grain = bodies.grain, *summits = bodies.summits, *area = bodies.area;
    const int numbers = remembered_;
    const auto ask = [&](int many, const int *which, double *to) {
        displace(model_.get(), bodies.softening, numbers, many, which, area, result, before, step, to);
    };
    int asked[BATCH], waiting[BATCH], many = 0, open = 0;
    for (int k = 0; k < count; k++) {
        const Contact &c = contact[k];
        Step &s = step[k];
        const double had = std::abs(c.history[STIFFNESS]), now = result[k].stiffness, limit = result[k].limit;
        // What is unloaded loses the force of the part of the grain that opens: see spring(). The summits know of theirs.
        const double kept = had == 0 ? 0 : now < had ? now / had : 1;
        begin(c, result[k], kept, dt, grain[k], summits[k], s);
        // Without load there is neither friction nor memory.
        if (limit <= 0 && dt > 0) std::fill_n(c.history + SUMMITS, numbers, 0.0);
        if (limit <= 0 || slides(grain[k], summits[k], limit, s)) continue;
        asked[many++] = k;
        if (kept > 0) copy_state(c.history + SUMMITS, numbers, 1 / area[k], before + k * numbers);
        else std::fill_n(before + k * numbers, numbers, 0.0);
        // What turns back after all that was kept, or after sliding, has a turn in its path.
        const double had_kept = summits[k] * summits[k] * square(s.kept), whole = limit * limit;
        if (had_kept > whole || (had_kept > tolerance * tolerance * whole && product(s.kept, s.part) < 0)) waiting[open++] = k;
        std::copy_n(s.kept, 2, s.asked);
    }
    if (open > 0) ask(open, waiting, before);
    for (int w = 0; w < open; w++) std::fill_n(step[waiting[w]].kept, 2, 0.0);
    std::copy_n(asked, open = many, waiting);
    for (int call = 0; call < most_calls && open > 0; call++) {
        for (int w = 0; w < open; w++)
            for (int axis = 0; axis < 2; axis++) step[waiting[w]].asked[axis] = step[waiting[w]].kept[axis] + step[waiting[w]].part[axis];
        ask(open, waiting, after);
        int left = 0;
        for (int w = 0; w < open; w++) {
            const int k = waiting[w];
            if (!balanced(grain[k], summits[k], result[k].limit, call == 0, step[k])) waiting[left++] = k;
        }
        open = left;
    }
    for (int w = 0; w < many; w++) {
        const int k = asked[w];
        std::copy_n(step[k].correction, 2, step[k].kept);
        if (dt > 0) copy_state(after + k * numbers, numbers, area[k], contact[k].history + SUMMITS);
    }
    for (int k = 0; k < count; k++) {
        if (result[k].limit > 0) carry(grain[k], result[k].limit, step[k]);
        finish(contact[k], step[k], dt, result[k]);
    }
}

}    // namespace asperity_lammps
