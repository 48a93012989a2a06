#include "fix_wall_asperity_hertz.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>

#include "atom.h"
#include "error.h"
#include "force.h"
#include "update.h"
#include "utils.h"

using namespace LAMMPS_NS;
using namespace asperity_lammps;

namespace {

enum { VECTOR = 12 };

int axis_of(const std::string &word) { return word == "x" ? 0 : word == "y" ? 1 : word == "z" ? 2 : -1; }

}    // namespace

FixWallAsperityHertz::FixWallAsperityHertz(LAMMPS *lmp, int narg, char **arg) : Fix(lmp, narg, arg), told_(lmp) {
    const Law::Words words = read_planes(narg, arg);
    try {
        law_ = Law::of(update->unit_style, words);
    } catch (const std::invalid_argument &refused) {
        error->all(FLERR, "fix {} wall/asperity/hertz: {}", id, refused.what());
    }
    restart_peratom = 1;
    create_attribute = 1;
    of_grain_ = WALLS * law_->history();
    maxexchange = of_grain_;
    vector_flag = 1;
    size_vector = VECTOR;
    global_freq = 1;
    extvector = 1;
    FixWallAsperityHertz::grow_arrays(atom->nmax);
    atom->add_callback(Atom::GROW);
    atom->add_callback(Atom::RESTART);
}

FixWallAsperityHertz::~FixWallAsperityHertz() {
    atom->delete_callback(id, Atom::GROW);
    atom->delete_callback(id, Atom::RESTART);
}

// fix ID group wall/asperity/hertz zplane LOW HIGH [shear x V] ...; returns the words of the law.
Law::Words FixWallAsperityHertz::read_planes(int narg, char **arg) {
    const std::string wanted = "must be xplane, yplane or zplane with two places, of which one may be NULL";
    const std::string plane = narg > 5 ? arg[3] : "";
    axis_ = plane.size() == 6 && plane.substr(1) == "plane" ? axis_of(plane.substr(0, 1)) : -1;
    if (axis_ < 0) error->all(FLERR, "fix {} wall/asperity/hertz: {}", id, wanted);
    bool any = false;
    for (int w = 0; w < WALLS; w++) {
        const bool none = std::strcmp(arg[4 + w], "NULL") == 0;
        place_[w] = none ? std::numeric_limits<double>::infinity() : utils::numeric(FLERR, arg[4 + w], false, lmp);
        any = any || !none;
    }
    if (!any) error->all(FLERR, "fix {} wall/asperity/hertz: {}", id, wanted);
    Law::Words words;
    for (int next = 6; next < narg; next++) {
        if (std::strcmp(arg[next], "shear") != 0) {
            words.push_back(arg[next]);
            continue;
        }
        const int along = narg > next + 2 ? axis_of(arg[next + 1]) : -1;
        if (along < 0 || along == axis_)
            error->all(FLERR, "fix {} wall/asperity/hertz: shear: needs a direction along the wall and a speed, as 'shear {} 0.3'", id,
                       axis_ == 0 ? "y" : "x");
        velocity_[along] = utils::numeric(FLERR, arg[next + 2], false, lmp);
        next += 2;
    }
    return words;
}

int FixWallAsperityHertz::setmask() { return FixConst::POST_FORCE | FixConst::POST_RUN; }

void FixWallAsperityHertz::init() {
    if (!atom->radius_flag || !atom->rmass_flag || !atom->omega_flag || !atom->torque_flag)
        error->all(FLERR, "fix {} wall/asperity/hertz: grains need radius, mass and spin (atom_style sphere)", id);
    sums_ = Sums();
    driving_ = 0;
    told_.begin();
}

void FixWallAsperityHertz::setup(int vflag) { post_force(vflag); }

void FixWallAsperityHertz::post_force(int) {
    const double dt = update->setupflag ? 0 : update->dt;
    sums_.begin_step();
    // The force of the last step was there for the first half of this one.
    driving_ += 0.5 * dt * dot(force_, velocity_);
    std::fill(force_, force_ + 3, 0.0);
    Contact contacts[Law::BATCH];
    int waiting = 0;
    for (int i = 0; i < atom->nlocal; i++) {
        if (!(atom->mask[i] & groupbit)) continue;
        for (int w = 0; w < WALLS; w++) {
            const double side = w == 0 ? 1 : -1, overlap = atom->radius[i] - side * (atom->x[i][axis_] - place_[w]);
            double *history = of_grain(i) + w * law_->history();
            if (std::isfinite(place_[w]) && overlap > 0) {
                meet(i, overlap, side, history, contacts[waiting++]);
            } else if (history[STIFFNESS] != 0) {
                std::fill_n(history, law_->history(), 0.0);
            }
            if (waiting == Law::BATCH) {
                apply(waiting, contacts, dt);
                waiting = 0;
            }
        }
    }
    apply(waiting, contacts, dt);
    told_.add(sums_);
    driving_ += 0.5 * dt * dot(force_, velocity_);
}

// The pair style has told what is so at every load.
void FixWallAsperityHertz::post_run() {
    told_.say(std::string("fix ") + id + " wall/asperity/hertz", !force->pair_match("asperity/hertz", 0));
}

void FixWallAsperityHertz::meet(int i, double overlap, double side, double *history, Contact &c) const {
    const double radius = atom->radius[i];
    double turning[3];
    c = {i, -1, history, radius, atom->rmass[i], overlap, {0, 0, 0}, {0, 0, 0}};
    c.normal[axis_] = side;
    cross(atom->omega[i], c.normal, turning);
    for (int a = 0; a < 3; a++) c.velocity[a] = atom->v[i][a] - radius * turning[a] - velocity_[a];
}

void FixWallAsperityHertz::apply(int count, const Contact *contacts, double dt) {
    Forces forces[Law::BATCH];
    law_->forces(count, contacts, dt, forces);
    for (int k = 0; k < count; k++) {
        const Contact &c = contacts[k];
        const Forces &r = forces[k];
        const int i = c.first;
        double twist[3];
        law_->add(c, r, dt, 1, true, sums_);
        cross(c.normal, r.friction, twist);
        for (int a = 0; a < 3; a++) {
            const double force = r.load * c.normal[a] + r.friction[a];
            atom->f[i][a] += force;
            atom->torque[i][a] -= c.radius * twist[a];
            force_[a] += force;
        }
    }
}

// Force on the grains (3), then elastic and stick energy, friction and damping work, contacts, slipping ones, load, load
// where the model holds, and the work of the walls.
double FixWallAsperityHertz::compute_vector(int n) {
    const double mine[VECTOR] = {force_[0], force_[1], force_[2], sums_.elastic_energy, sums_.stick_energy,
                                 sums_.friction_work, sums_.damping_work, sums_.contacts, sums_.slipping, sums_.load,
                                 sums_.held, driving_};
    double all = 0;
    MPI_Allreduce(&mine[n], &all, 1, MPI_DOUBLE, MPI_SUM, world);
    return all;
}

// ---- What LAMMPS asks of a fix with data of its own for each grain ----

double *FixWallAsperityHertz::of_grain(int i) { return histories_.data() + static_cast<std::size_t>(i) * of_grain_; }

void FixWallAsperityHertz::grow_arrays(int nmax) { histories_.resize(static_cast<std::size_t>(nmax) * of_grain_); }

void FixWallAsperityHertz::copy_arrays(int from, int to, int) { std::copy_n(of_grain(from), of_grain_, of_grain(to)); }

void FixWallAsperityHertz::set_arrays(int i) { std::fill_n(of_grain(i), of_grain_, 0.0); }

int FixWallAsperityHertz::pack_exchange(int i, double *buffer) {
    std::copy_n(of_grain(i), of_grain_, buffer);
    return of_grain_;
}

int FixWallAsperityHertz::unpack_exchange(int i, double *buffer) {
    std::copy_n(buffer, of_grain_, of_grain(i));
    return of_grain_;
}

int FixWallAsperityHertz::pack_restart(int i, double *buffer) {
    buffer[0] = 1 + of_grain_;
    return 1 + pack_exchange(i, buffer + 1);
}

// The numbers of all fixes stand behind one another, each set beginning with its length.
void FixWallAsperityHertz::unpack_restart(int i, int nth) {
    double *buffer = atom->extra[i];
    for (int n = 0; n < nth; n++) buffer += static_cast<int>(buffer[0]);
    if (static_cast<int>(buffer[0]) != 1 + of_grain_)
        error->one(FLERR, "fix {} wall/asperity/hertz: contacts of the restart file remember {} numbers, these {}: microslip must "
                   "be as it was", id, (buffer[0] - 1) / WALLS, law_->history());
    unpack_exchange(i, buffer + 1);
}
