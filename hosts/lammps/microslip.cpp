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

// Of the residual, relative to the limit, and of calls. Parts slip one after the other as d grows, so that iterations
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

}    // namespace

void Law::microslip(int count, const Contact *contact, double dt, const Bodies &bodies, Forces *result) const {
    Frame frame[BATCH];
    double pressure[BATCH], moved[BATCH][2], part[BATCH][2], earlier[BATCH][2], force[BATCH][2], tangent[BATCH][3];
    double correction[BATCH][2], left_over[BATCH];    // of the iteration before
    double before[BATCH * MOST_REMEMBERED], after[BATCH * MOST_REMEMBERED];
    double increments[2 * BATCH], pressures[BATCH], befores[BATCH * MOST_REMEMBERED], afters[BATCH * MOST_REMEMBERED];
    double stresses[2 * BATCH], slopes[4 * BATCH];
    int waiting[BATCH], open = 0;
    const auto numbers = static_cast<std::size_t>(remembered_);

    for (int k = 0; k < count; k++) {
        const Contact &c = contact[k];
        Forces &r = result[k];
        const double had = c.history[STIFFNESS];
        frame[k] = frame_of(c, had != 0);
        // What is unloaded loses the force of the part that opens: see spring().
        const double kept = had == 0 ? 0 : r.stiffness < had ? r.stiffness / had : 1;
        double slip[3];
        for (int a = 0; a < 3; a++) slip[a] = c.velocity[a] + r.approach * c.normal[a];
        for (int axis = 0; axis < 2; axis++) {
            moved[k][axis] = -dt * frame[k].along(slip, axis);
            earlier[k][axis] = had == 0 ? 0 : kept * c.history[FORCE + axis];
            force[k][axis] = 0;
        }
        const double grain = bodies.grain[k], taken[2] = {grain * moved[k][0], grain * moved[k][1]};
        const bool onwards = had != 0 && moved[k][0] * earlier[k][0] + moved[k][1] * earlier[k][1] > 0;
        std::copy_n(c.history + TANGENT, 3, tangent[k]);
        if (onwards) solve(grain + tangent[k][0], tangent[k][1], grain + tangent[k][2], taken, part[k]);
        else for (int axis = 0; axis < 2; axis++) part[k][axis] = taken[axis] / (grain + bodies.summits[k]);
        pressure[k] = r.pressure;
        const bool holds = !(r.limit <= 0);    // without load there is neither friction nor memory
        const double per_area = holds ? kept / bodies.area[k] : 0;
        for (std::size_t m = 0; m < numbers; m++)
            before[k * numbers + m] = had == 0 ? 0 : per_area * c.history[SUMMITS + m], after[k * numbers + m] = 0;
        if (holds) waiting[open++] = k;
    }
    for (int call = 0; call < most_calls && open > 0; call++) {
        for (int w = 0; w < open; w++) {
            const int k = waiting[w];
            pressures[w] = pressure[k];
            for (int axis = 0; axis < 2; axis++) increments[2 * w + axis] = softening_ * part[k][axis];
            std::copy_n(before + k * numbers, numbers, befores + w * numbers);
        }
        // It fails for a pressure that is not finite only, and then gives NaN, as the positions of the grains are.
        asperity_microslip_steps(model_.get(), open, pressures, increments, befores, afters, stresses, slopes);
        int left = 0;
        for (int w = 0; w < open; w++) {
            const int k = waiting[w];
            const double grain = bodies.grain[k], area = bodies.area[k], *s = slopes + 4 * w;
            double residual[2];
            for (int axis = 0; axis < 2; axis++) {
                force[k][axis] = area * stresses[2 * w + axis];
                residual[axis] = force[k][axis] - earlier[k][axis] - grain * (moved[k][axis] - part[k][axis]);
            }
            std::copy_n(afters + w * numbers, numbers, after + k * numbers);
            const double scale = softening_ * area;
            tangent[k][0] = scale * s[0];
            tangent[k][1] = scale * s[1];
            tangent[k][2] = scale * s[3];
            const double size = std::hypot(residual[0], residual[1]);
            if (size <= tolerance * result[k].limit) continue;
            if (call > 0 && size >= left_over[k]) {    // too far, over several pieces: half as far
                for (int axis = 0; axis < 2; axis++) part[k][axis] -= correction[k][axis] *= 0.5;
            } else {
                left_over[k] = size;
                for (double &component : residual) component = -component;
                solve(grain + tangent[k][0], tangent[k][1], grain + tangent[k][2], residual, correction[k]);
                for (int axis = 0; axis < 2; axis++) part[k][axis] += correction[k][axis];
            }
            waiting[left++] = k;
        }
        open = left;
    }
    for (int k = 0; k < count; k++) {
        const Contact &c = contact[k];
        Forces &r = result[k];
        for (int a = 0; a < 3; a++) r.spring[a] = force[k][0] * frame[k].one[a] + force[k][1] * frame[k].other[a];
        r.slips = std::hypot(force[k][0], force[k][1]) >= r.limit * (1 - 1e-9);
        r.friction_work = 0;
        for (int axis = 0; axis < 2; axis++) {
            const double had = c.history[STIFFNESS] == 0 ? 0 : c.history[FORCE + axis];
            r.friction_work += 0.5 * (had + force[k][axis]) * moved[k][axis];
        }
        if (!(dt > 0)) continue;
        std::copy_n(frame[k].one, 3, c.history + SPRING);
        c.history[STIFFNESS] = r.stiffness;
        c.history[SIDE] = frame[k].side;
        std::copy_n(force[k], 2, c.history + FORCE);
        std::copy_n(tangent[k], 3, c.history + TANGENT);
        for (std::size_t m = 0; m < numbers; m++) c.history[SUMMITS + m] = bodies.area[k] * after[k * numbers + m];
    }
}

}    // namespace asperity_lammps
