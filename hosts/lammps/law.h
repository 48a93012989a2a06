// The law of a contact between two grains, or a grain and a wall: Hertz and damping along the normal, friction with a stick
// stiffness or microslip across it. Knows nothing of LAMMPS. hosts/lammps/README.md has the equations.
#ifndef ASPERITY_LAMMPS_LAW_H
#define ASPERITY_LAMMPS_LAW_H

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "asperity.h"
#include "beads.h"

namespace asperity_lammps {

inline double dot(const double *a, const double *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

inline void cross(const double *a, const double *b, double *c) {
    c[0] = a[1] * b[2] - a[2] * b[1];
    c[1] = a[2] * b[0] - a[0] * b[2];
    c[2] = a[0] * b[1] - a[1] * b[0];
}

// Two intervals to a power of two, counted on; one begins at pressure_of it.
inline std::int64_t half_binade(double positive) {
    std::int64_t bits;
    std::memcpy(&bits, &positive, sizeof bits);
    return bits >> 51;
}

inline double pressure_of(std::int64_t half_binade) {
    const std::int64_t bits = half_binade << 51;
    double value;
    std::memcpy(&value, &bits, sizeof value);
    return value;
}

// Where fewer summits touch, single contacts scatter, and with fewer waves on a side ASPERITY_WARNING_FEW_WAVES holds (docs/model.md).
const double fewest_summits = 20, fewest_waves = 8;

// What a contact remembers: the force of its tangential spring on the first body, and the stiffness that it had, below 0 if it
// slipped; 0: nothing.
// With microslip in place of the force a direction in the tangent plane; behind the stiffness on which side the other
// direction is, the force in both, how stiff the summits were (xx, xy, yy), what of their displacement the library was not asked about
// yet, and what the library keeps of them.
enum { SPRING, STIFFNESS = 3, SIDE, FORCE, TANGENT = 7, KEPT = 10, SUMMITS = 12 };

// The same contact seen from the other body.
inline void turn_round(double *history, int numbers) {
    for (int a = 0; a < 3; a++) history[SPRING + a] = -history[SPRING + a];
    if (numbers > SIDE) history[SIDE] = -history[SIDE];
}

// A step that is computed again, as the first of a run, finds the contacts slipping that did.
inline bool slipped_before(const double *history, double dt) { return !(dt > 0) && history[STIFFNESS] < 0; }

struct Contact {
    int first, second;            // the grains
    double *history;              // Law::history() numbers
    double radius, mass;          // effective ones
    double overlap, normal[3];    // towards the first body
    double velocity[3];           // of the first body against the second, where they touch
};

struct Forces {
    double load, elastic;         // the whole normal force, and that of the overlap
    double pull;                  // of adhesion, by which the load is less than what presses
    double summits, scatter;      // in contact, by the mean of the surface; how far single contacts are from the mean friction
    double approach;              // speed
    double spring[3], friction[3];    // of the tangential spring, and with damping; on the first body
    double limit, stiffness;      // of friction and of the tangential spring
    double pressure;              // of the real grain
    double friction_work;         // taken from the bodies in this step, into the spring or as heat
    bool slips;

    double elastic_energy(double overlap) const { return (0.4 * elastic - pull) * overlap; }    // after Hertz
};

// Sums over contacts.
struct Sums {
    double elastic_energy = 0, stick_energy = 0;         // now
    double friction_work = 0, damping_work = 0;          // since the run began
    double contacts = 0, slipping = 0, load = 0, held = 0;    // now; held: load where the model holds
    std::uint64_t warnings = 0;                          // of the contacts where it does not
    std::uint64_t told = 0;                              // of the interface and the surface, at whatever load
    double few = 0, few_summits = 0, few_scatter = 0;    // load on fewest_summits or fewer, and times their number and scatter

    void begin_step() { elastic_energy = stick_energy = contacts = slipping = load = held = few = few_summits = few_scatter = 0; }
};

class Law {
public:
    using Words = std::vector<std::string>;

    // The law of names and values, one after the other: those of a style, then those of its types. One of the known laws, of
    // which making one takes milliseconds, if words and surface file come to the same. Throws std::invalid_argument with a
    // message that names the word. units: those of the script.
    static std::shared_ptr<const Law> of(const std::string &units, const Words &style, const Words &own = {},
                                         const std::vector<std::shared_ptr<const Law>> &known = {});

    // All that the law is made of: equal if the laws are. A restart file keeps it, and of_made makes the law again.
    const std::string &made_of() const { return made_of_; }
    static std::shared_ptr<const Law> of_made(const std::string &made_of, const std::vector<std::shared_ptr<const Law>> &known);

    // Contacts are computed so many at a time, as the library's batch calls are the faster ones.
    enum { BATCH = 32 };

    // How many numbers the history of a contact has, and how many it can have.
    int history() const { return microslip_ ? SUMMITS + remembered_ : SIDE; }
    enum { MOST_REMEMBERED = 64, MOST_HISTORY = SUMMITS + MOST_REMEMBERED };

    // Computes up to BATCH contacts. dt: by which the springs are moved on; 0 leaves the histories as they are, for a step that is
    // computed again.
    void forces(int count, const Contact *contact, double dt, Forces *result) const;

    // Adds a contact to the sums. share: 1, or 1/2 where another rank has it too.
    void add(const Contact &contact, const Forces &forces, double dt, double share, bool state, Sums &sums) const;

private:
    struct Interval {
        double touching;          // summits per unit area at its lower end
        std::uint64_t warnings;   // between its ends
        std::uint64_t told;       // of the interface and the surface
    };

    // A file, which replaces the words of the command before, and the words that change it.
    struct Surface {
        std::string file;
        Words names;
        std::vector<double> values;
        bool given = false, changed = false;    // by this command; by other words of it

        void take(const std::string &name, const std::string &text);
    };

    enum { NUMBERS = 8 };    // of made_of_, before the text of the surface

    Law() = default;
    std::shared_ptr<const Law> made(const std::vector<std::shared_ptr<const Law>> &known);
    void read(const std::string &units, const Words &style, const Words &own);
    void read_surface(const Surface &surface, const std::string &units);
    void make_model();
    void find_where_it_holds(double composite_modulus);
    void normal(const Contact &contact, Forces &result) const;
    double touching(double pressure) const;    // summits per unit area
    const Beads &beads() const;
    // What the tangential forces of a batch need beside Forces.
    struct Bodies {
        double area[BATCH] = {};       // of the real contacts
        double grain[BATCH] = {};      // stick stiffness of the grains alone
        double summits[BATCH] = {};    // and of the summits
        double softening[BATCH];       // displacement of the summits over that in the grain's lengths
    };
    void limits(int count, const Contact *contact, Bodies &bodies, Forces *result) const;
    void spring(const Contact &contact, double dt, Forces &result) const;
    void microslip(int count, const Contact *contact, double dt, const Bodies &bodies, Forces *result) const;
    void damp(const Contact &contact, double dt, Forces &result) const;

    std::string made_of_;
    asperity_params params_;                   // of one unit of area; not set with a constant coefficient
    std::shared_ptr<asperity_model> model_;    // of them
    double mu_ = -1;
    double modulus_ = -1;                      // E* that the grains are computed with
    double tangential_ratio_ = 0;              // Mindlin's stiffness over the normal one
    double damping_ = 0;
    double area_ = 0;                          // area of smooth grains over (load radius)^(2/3)
    double rough_area_ = 0;                    // what roughness adds to it, over the radius
    double softening_ = 1;                     // (modulus/real_modulus)^(2/3)
    double least_area_ = 0;                    // of a contact as wide as the fewest waves
    mutable std::shared_ptr<const Beads> beads_;    // made where it is first asked for
    bool pull_off_ = false;                    // rough grains stick
    bool microslip_ = false;                   // summits slip one after the other, not all at once
    int remembered_ = 0;                       // numbers that the library keeps of a contact
    std::int64_t first_interval_ = 0;
    std::vector<Interval> intervals_;          // by half_binade(pressure) - first_interval_
};

inline void Law::add(const Contact &c, const Forces &r, double dt, double share, bool state, Sums &sums) const {
    sums.friction_work += share * r.friction_work;
    sums.damping_work += share * (r.load + r.pull - r.elastic) * r.approach * dt;
    if (!state) return;
    sums.elastic_energy += share * r.elastic_energy(c.overlap);
    sums.contacts += share;
    sums.slipping += r.slips ? share : 0;
    sums.load += share * r.load;
    if (r.stiffness > 0) sums.stick_energy += share * 0.5 * dot(r.spring, r.spring) / r.stiffness;
    if (!model_ || !(r.load > 0)) return;
    const std::int64_t place = half_binade(r.pressure) - first_interval_, last = std::int64_t(intervals_.size()) - 1;
    // Above the last, at the pressure E*, the model is far off.
    const Interval &interval = intervals_[static_cast<std::size_t>(std::clamp<std::int64_t>(place, 0, last))];
    std::uint64_t warnings = interval.warnings;
    if (r.summits < fewest_summits) {
        sums.few += share * r.load;
        sums.few_summits += share * r.load * r.summits;
        sums.few_scatter += share * r.load * r.scatter;
    }
    if (r.load < least_area_ * r.pressure) warnings |= ASPERITY_WARNING_FEW_WAVES;
    if (warnings == 0) sums.held += share * r.load;
    sums.warnings |= warnings;
    sums.told |= interval.told;
}

}    // namespace asperity_lammps

#endif
