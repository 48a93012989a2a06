#include "pair_asperity_hertz.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "fix.h"
#include "fix_asperity_history.h"
#include "force.h"
#include "memory.h"
#include "modify.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "update.h"
#include "utils.h"

using namespace LAMMPS_NS;
using namespace asperity_lammps;

namespace {

const char *const place = "_PLACE";
enum { EXTRA = 8, SINGLE = 9 };

}    // namespace

PairAsperityHertz::PairAsperityHertz(LAMMPS *lmp) : Pair(lmp), told_(lmp) {
    single_enable = 1;
    no_virial_fdotr_compute = 1;
    centroidstressflag = CENTROID_NOTAVAIL;
    finitecutflag = 1;
    restartinfo = 1;
    single_extra = SINGLE;
    svector = new double[SINGLE];
    nextra = EXTRA;
    pvector = new double[EXTRA]();
    // The fix that keeps the histories can only be made when the grains are there; it must stand where pair_style does.
    // Under pair_style hybrid there may be several of this style, each with a fix of its own.
    for (int number = 1; history_id_.empty(); number++) {
        const std::string id = "ASPERITY_HISTORY" + (number > 1 ? std::to_string(number) : "");
        if (modify->get_fix_by_id(id) || modify->get_fix_by_id(id + place)) continue;
        history_id_ = id;
    }
    modify->add_fix(history_id_ + place + " all DUMMY");
}

PairAsperityHertz::~PairAsperityHertz() {
    if (copymode) return;
    delete[] svector;
    delete[] pvector;
    const std::string id = fix_history_ ? history_id_ : history_id_ + place;
    if (modify->get_fix_by_id(id)) modify->delete_fix(id);
    if (allocated) {
        memory->destroy(setflag);
        memory->destroy(cutsq);
    }
}

void PairAsperityHertz::allocate() {
    allocated = 1;
    const int types = atom->ntypes;
    memory->create(setflag, types + 1, types + 1, "pair:setflag");
    memory->create(cutsq, types + 1, types + 1, "pair:cutsq");
    for (int i = 1; i <= types; i++)
        for (int j = 1; j <= types; j++) setflag[i][j] = 0;
    own_words_.resize((types + 1) * (types + 1));
    laws_.resize((types + 1) * (types + 1));
}

// ---- The input script ----

// Said again, it asks for pair_coeff again.
void PairAsperityHertz::settings(int narg, char **arg) {
    words_.assign(arg, arg + narg);
    if (!allocated) return;
    for (int i = 1; i <= atom->ntypes; i++) std::fill_n(setflag[i] + 1, atom->ntypes, 0);
    laws_.assign(laws_.size(), nullptr);
}

void PairAsperityHertz::coeff(int narg, char **arg) {
    if (narg < 2) error->all(FLERR, "pair_coeff asperity/hertz: needs two types of grains");
    if (!allocated) allocate();
    int ilo, ihi, jlo, jhi;
    utils::bounds(FLERR, arg[0], 1, atom->ntypes, ilo, ihi, error);
    utils::bounds(FLERR, arg[1], 1, atom->ntypes, jlo, jhi, error);
    const Words own(arg + 2, arg + narg);
    for (int i = ilo; i <= ihi; i++)
        for (int j = jlo; j <= jhi; j++) set_law(std::min(i, j), std::max(i, j), own);
}

// made_of: what a restart file keeps of the law, which counts where the words cannot be read any more.
void PairAsperityHertz::set_law(int i, int j, const Words &own, const std::string &made_of) {
    const int types = atom->ntypes, index = i * (types + 1) + j;
    const char *const command = own.empty() ? "pair_style" : "pair_coeff";
    std::shared_ptr<const Law> law;
    try {
        law = Law::of(update->unit_style, words_, own, laws_);
    } catch (const std::invalid_argument &refused) {
        if (made_of.empty()) error->all(FLERR, "{} asperity/hertz: {}", command, refused.what());
        if (comm->me == 0)
            error->warning(FLERR, "{} asperity/hertz: {}; types {} and {} have the law that the restart file keeps", command,
                           refused.what(), i, j);
        try {
            law = Law::of_made(made_of, laws_);
        } catch (const std::invalid_argument &unread) {
            error->all(FLERR, "{} asperity/hertz: the law of the restart file: {}", command, unread.what());
        }
    }
    own_words_[index] = own_words_[j * (types + 1) + i] = own;
    laws_[index] = laws_[j * (types + 1) + i] = law;
    setflag[i][j] = 1;
}

void PairAsperityHertz::init_style() {
    if (!atom->radius_flag || !atom->rmass_flag || !atom->omega_flag || !atom->torque_flag)
        error->all(FLERR, "pair_style asperity/hertz: grains need radius, mass and spin (atom_style sphere)");
    if (!comm->ghost_velocity) error->all(FLERR, "pair_style asperity/hertz: say 'comm_modify vel yes'");
    // Each rank computes a contact with a grain of another rank for its own grain.
    neighbor->add_request(this, NeighConst::REQ_SIZE | NeighConst::REQ_NEWTON_OFF);
    make_fix_history();
    const auto freezing = modify->get_fix_by_style("^freeze");
    freeze_bit_ = freezing.empty() ? 0 : freezing.front()->groupbit;
    find_radii();
    sums_ = Sums();
    told_.begin();
}

// The fix that keeps the histories, as long as the longest of them.
void PairAsperityHertz::make_fix_history() {
    int numbers = 0;
    for (const auto &law : laws_)
        if (law) numbers = std::max(numbers, law->history());
    if (fix_history_ && fix_history_->numbers() == numbers) return;
    if (fix_history_ && comm->me == 0)
        error->warning(FLERR, "pair_style asperity/hertz: microslip is not as it was, and all contacts forget what they carried");
    const std::string wanted = fmt::format("{} all {} {}", history_id_, FixAsperityHistory::style_name, numbers);
    if (fix_history_) modify->add_fix(wanted, 1);    // in the place of the one of this name
    else modify->replace_fix(history_id_ + place, wanted, 1);
    fix_history_ = dynamic_cast<FixAsperityHistory *>(modify->get_fix_by_id(history_id_));
    if (!fix_history_) error->all(FLERR, "pair_style asperity/hertz: no fix that keeps the histories");
    fix_history_->of_pair(this);
}

// The largest grains of each type, those included that fix pour or fix deposit will add.
void PairAsperityHertz::find_radii() {
    const int types = atom->ntypes;
    std::vector<double> mine(types + 1, 0.0), frozen(types + 1, 0.0);
    for (int i = 0; i < atom->nlocal; i++) {
        double &largest = (atom->mask[i] & freeze_bit_ ? frozen : mine)[atom->type[i]];
        largest = std::max(largest, atom->radius[i]);
    }
    for (const char *style : {"^pour", "^deposit"})
        for (Fix *fix : modify->get_fix_by_style(style))
            for (int type = 1; type <= types; type++) {
                int itype = type;    // extract takes the type and gives the dimension
                const auto *radius = static_cast<const double *>(fix->extract("radius", itype));
                if (radius) mine[type] = std::max(mine[type], *radius);
            }
    largest_.assign(types + 1, 0.0);
    largest_frozen_.assign(types + 1, 0.0);
    MPI_Allreduce(mine.data(), largest_.data(), types + 1, MPI_DOUBLE, MPI_MAX, world);
    MPI_Allreduce(frozen.data(), largest_frozen_.data(), types + 1, MPI_DOUBLE, MPI_MAX, world);
}

// No contacts between two frozen grains.
double PairAsperityHertz::init_one(int i, int j) {
    if (!setflag[i][j])
        error->all(FLERR, "pair_style asperity/hertz: no pair_coeff for types {} and {}; say 'pair_coeff * *'", i, j);
    return std::max({largest_[i] + largest_[j], largest_frozen_[i] + largest_[j], largest_[i] + largest_frozen_[j]});
}

// ---- Contacts ----

inline bool PairAsperityHertz::touching(int i, int j, Contact &c) const {
    const double *x = atom->x[i], *y = atom->x[j], *radius = atom->radius;
    const double apart[3] = {x[0] - y[0], x[1] - y[1], x[2] - y[2]};
    const double sum = radius[i] + radius[j], square = dot(apart, apart);
    if (square >= sum * sum) return false;
    const double distance = std::sqrt(square), inverse = 1 / distance;
    const double mi = atom->rmass[i], mj = atom->rmass[j];
    c.first = i;
    c.second = j;
    c.overlap = sum - distance;
    c.radius = radius[i] * radius[j] / sum;
    c.mass = mi * mj / (mi + mj);
    if (atom->mask[i] & freeze_bit_) c.mass = mj;
    if (atom->mask[j] & freeze_bit_) c.mass = mi;
    double spin[3], turning[3];
    for (int a = 0; a < 3; a++) {
        c.normal[a] = apart[a] * inverse;
        spin[a] = radius[i] * atom->omega[i][a] + radius[j] * atom->omega[j][a];
    }
    cross(spin, c.normal, turning);
    for (int a = 0; a < 3; a++) c.velocity[a] = atom->v[i][a] - atom->v[j][a] - turning[a];
    return true;
}

void PairAsperityHertz::compute(int eflag, int vflag) {
    ev_init(eflag, vflag);
    const int types = atom->ntypes, *type = atom->type, numbers = fix_history_->numbers();
    fix_history_->changed();
    sums_.begin_step();
    Contact contacts[Law::BATCH];
    const Law *law = nullptr;
    int waiting = 0;
    for (int ii = 0; ii < list->inum; ii++) {
        const int i = list->ilist[ii], *neighbours = list->firstneigh[i], count = list->numneigh[i];
        const auto *laws = &laws_[type[i] * (types + 1)];
        double *history = fix_history_->of_grain(i);
        for (int jj = 0; jj < count; jj++, history += numbers) {
            const int j = neighbours[jj] & NEIGHMASK;
            if (!touching(i, j, contacts[waiting])) {
                if (history[STIFFNESS] != 0) std::fill_n(history, numbers, 0.0);
                continue;
            }
            const Law *own = laws[type[j]].get();
            if (own != law && waiting > 0) {    // a contact of other types begins the next batch
                apply(*law, waiting, contacts);
                contacts[0] = contacts[waiting];
                waiting = 0;
            }
            law = own;
            contacts[waiting++].history = history;
            // Seven lines of memory for each contact, which arrive while the batch fills.
            if (numbers > SIDE)
                for (int n = 0; n < numbers; n += 8) __builtin_prefetch(history + n, 1);
            if (waiting == Law::BATCH) {
                apply(*law, waiting, contacts);
                waiting = 0;
            }
        }
    }
    if (waiting > 0) apply(*law, waiting, contacts);
    if (!eflag_either) return;
    told_.add(sums_);
    const double extra[EXTRA] = {sums_.elastic_energy, sums_.stick_energy, sums_.friction_work, sums_.damping_work,
                                 sums_.contacts, sums_.slipping, sums_.load, sums_.held};
    std::copy(extra, extra + EXTRA, pvector);
}

// The forces of contacts on their grains. A grain of another rank has its force from that rank.
void PairAsperityHertz::apply(const Law &law, int count, const Contact *contacts) {
    const int nlocal = atom->nlocal;
    const double *radius = atom->radius, dt = update->setupflag ? 0 : update->dt;
    double **f = atom->f, **torque = atom->torque;
    Forces forces[Law::BATCH];
    law.forces(count, contacts, dt, forces);
    for (int k = 0; k < count; k++) {
        const Contact &c = contacts[k];
        const Forces &r = forces[k];
        const int i = c.first, j = c.second;
        law.add(c, r, dt, j < nlocal ? 1 : 0.5, eflag_either, sums_);
        double force[3], twist[3];
        cross(c.normal, r.friction, twist);
        for (int a = 0; a < 3; a++) {
            force[a] = r.load * c.normal[a] + r.friction[a];
            f[i][a] += force[a];
            torque[i][a] -= radius[i] * twist[a];
        }
        if (j < nlocal)
            for (int a = 0; a < 3; a++) {
                f[j][a] -= force[a];
                torque[j][a] -= radius[j] * twist[a];
            }
        if (evflag) {
            const double distance = radius[i] + radius[j] - c.overlap;
            ev_tally_xyz(i, j, nlocal, 0, r.elastic_energy(c.overlap), 0.0, force[0], force[1], force[2],
                         distance * c.normal[0], distance * c.normal[1], distance * c.normal[2]);
        }
    }
}

// The history of a contact as seen by i. It is kept with the grain in whose list the other stands.
void PairAsperityHertz::history_of(int i, int j, double *history) const {
    const int numbers = fix_history_->numbers();
    for (int turn = 0; turn < 2; turn++, std::swap(i, j)) {
        if (i >= atom->nlocal) continue;
        const int *neighbours = list->firstneigh[i];
        for (int jj = 0; jj < list->numneigh[i]; jj++) {
            if ((neighbours[jj] & NEIGHMASK) != j) continue;
            std::copy_n(fix_history_->of_grain(i) + numbers * jj, numbers, history);
            if (turn == 1) turn_round(history, numbers);
            return;
        }
    }
}

// For compute pair/local: tangential force on i, its size, load, pressure, limit, stick stiffness, whether it slips.
double PairAsperityHertz::single(int i, int j, int itype, int jtype, double, double, double, double &fforce) {
    Contact c;
    double history[Law::MOST_HISTORY] = {};
    std::fill(svector, svector + SINGLE, 0.0);
    fforce = 0;
    if (!touching(i, j, c)) return 0;
    history_of(i, j, history);
    c.history = history;
    Forces r;
    laws_[itype * (atom->ntypes + 1) + jtype]->forces(1, &c, 0, &r);
    const double size = std::sqrt(dot(r.friction, r.friction));
    const double values[SINGLE] = {r.friction[0], r.friction[1], r.friction[2], size, r.load, r.pressure, r.limit,
                                   r.stiffness, r.slips ? 1.0 : 0.0};
    std::copy(values, values + SINGLE, svector);
    fforce = r.load / (atom->radius[i] + atom->radius[j] - c.overlap);
    return r.elastic_energy(c.overlap);
}

// From the steps at which energies were printed.
void PairAsperityHertz::finish() { told_.say("pair_style asperity/hertz", true); }

// ---- Restart files: the words of the script, from which the laws are made anew ----

void PairAsperityHertz::write_words(FILE *file, const Words &words) const {
    const int count = static_cast<int>(words.size());
    fwrite(&count, sizeof count, 1, file);
    for (const std::string &word : words) {
        const int size = static_cast<int>(word.size());
        fwrite(&size, sizeof size, 1, file);
        fwrite(word.data(), 1, size, file);
    }
}

PairAsperityHertz::Words PairAsperityHertz::read_words(FILE *file) {
    const auto read = [&](void *data, std::size_t size) {
        if (comm->me == 0) utils::sfread(FLERR, data, 1, size, file, nullptr, error);
        MPI_Bcast(data, static_cast<int>(size), MPI_BYTE, 0, world);
    };
    int count = 0;
    read(&count, sizeof count);
    Words words(count);
    for (std::string &word : words) {
        int size = 0;
        read(&size, sizeof size);
        word.resize(size);
        read(word.data(), size);
    }
    return words;
}

void PairAsperityHertz::write_restart_settings(FILE *file) { write_words(file, words_); }

void PairAsperityHertz::read_restart_settings(FILE *file) { words_ = read_words(file); }

void PairAsperityHertz::write_restart(FILE *file) {
    write_restart_settings(file);
    for (int i = 1; i <= atom->ntypes; i++)
        for (int j = i; j <= atom->ntypes; j++) {
            fwrite(&setflag[i][j], sizeof(int), 1, file);
            const int index = i * (atom->ntypes + 1) + j;
            write_words(file, own_words_[index]);
            write_words(file, {laws_[index] ? laws_[index]->made_of() : ""});
        }
}

void PairAsperityHertz::read_restart(FILE *file) {
    read_restart_settings(file);
    allocate();
    for (int i = 1; i <= atom->ntypes; i++)
        for (int j = i; j <= atom->ntypes; j++) {
            int set = 0;
            if (comm->me == 0) utils::sfread(FLERR, &set, sizeof set, 1, file, nullptr, error);
            MPI_Bcast(&set, 1, MPI_INT, 0, world);
            const Words own = read_words(file), made_of = read_words(file);
            if (!set) continue;
            set_law(i, j, own, made_of[0]);
            if (comm->me == 0 && laws_[i * (atom->ntypes + 1) + j]->made_of() != made_of[0])
                error->warning(FLERR, "pair_style asperity/hertz: the surface of types {} and {} is not as it was when the restart "
                               "file was written", i, j);
        }
}
