// Microslip: the summits of a contact slip one after the other (asperity_microslip_steps), behind the grain's own spring.
//
// With the displacement D of the step, of which d goes into the summits and the rest into the grain, of stiffness G:
//   T(d) = T_before + G (D - d)
// T, of the library, is the sum of many parts that stick or slip; Newton's method takes one or two calls a step.
// d is in the softened grain's lengths: the summits of the real one move by softening_ times as much.
#include "law.h"

namespace asperity_lammps {

namespace {

// Of the residual, relative to the limit, and of calls. Parts slip one after the other as d grows, so that iterations
// approach from one side, from one piece of T to the next.
const double tolerance = 1e-10;
const int most_calls = 40;

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
    double pressure[BATCH], moved[BATCH][2], part[BATCH][2], earlier[BATCH][2], force[BATCH][2];
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
            part[k][axis] = moved[k][axis] * bodies.grain[k] / (bodies.grain[k] + bodies.summits[k]);
            earlier[k][axis] = had == 0 ? 0 : kept * c.history[FORCE + axis];
            force[k][axis] = 0;
        }
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
            if (std::hypot(residual[0], residual[1]) <= tolerance * result[k].limit) continue;
            const double scale = softening_ * area;
            const double xx = grain + scale * s[0], xy = scale * s[1], yx = scale * s[2], yy = grain + scale * s[3];
            const double inverse = 1 / (xx * yy - xy * yx);
            part[k][0] -= inverse * (yy * residual[0] - xy * residual[1]);
            part[k][1] -= inverse * (xx * residual[1] - yx * residual[0]);
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
        for (std::size_t m = 0; m < numbers; m++) c.history[SUMMITS + m] = bodies.area[k] * after[k * numbers + m];
    }
}

}    // namespace asperity_lammps
