#include "fix_asperity_history.h"

#include <algorithm>

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "modify.h"
#include "neigh_list.h"
#include "pair.h"
#include "utils.h"

using namespace LAMMPS_NS;
using asperity_lammps::STIFFNESS;
using asperity_lammps::turn_round;

FixAsperityHistory::FixAsperityHistory(LAMMPS *lmp, int narg, char **arg) : Fix(lmp, narg, arg) {
    numbers_ = utils::inumeric(FLERR, arg[3], false, lmp);
    restart_peratom = 1;
    restart_global = 1;    // so that write_restart is called
    create_attribute = 1;
    maxexchange_dynamic = 1;
    measure();
    FixAsperityHistory::grow_arrays(atom->nmax);
    atom->add_callback(Atom::GROW);
    atom->add_callback(Atom::RESTART);
}

FixAsperityHistory::~FixAsperityHistory() {
    atom->delete_callback(id, Atom::GROW);
    atom->delete_callback(id, Atom::RESTART);
}

int FixAsperityHistory::setmask() {
    using namespace FixConst;
    return PRE_EXCHANGE | MIN_PRE_EXCHANGE | POST_NEIGHBOR | MIN_POST_NEIGHBOR | POST_RUN;
}

void FixAsperityHistory::init() {
    if (!atom->tag_enable) error->all(FLERR, "pair_style asperity/hertz: grains need identifiers (atom_modify id yes)");
    // A fix that takes grains away before the histories are saved would leave those of other grains in their places.
    for (const Fix *fix : modify->get_fix_list()) {
        if (fix == this) break;
        if (fix->pre_exchange_migrate)
            error->all(FLERR, "pair_style asperity/hertz: must come before fix {} in the input", fix->id);
    }
}

// From the neighbour list to the grains. Both grains of a contact get it, as they may part to two ranks; a grain of
// another rank has its own.
void FixAsperityHistory::pre_exchange() {
    if (saved_ || !pair_ || !pair_->list) return;
    for (int i = 0; i < listed_; i++) partners_[i].clear();
    const auto remember = [this](int i, tagint partner, const double *history) {
        partners_[i].push_back(static_cast<double>(partner));
        partners_[i].insert(partners_[i].end(), history, history + numbers_);
    };
    const NeighList &list = *pair_->list;
    for (int ii = 0; ii < list.inum; ii++) {
        const int i = list.ilist[ii];
        const double *history = of_grain(i);
        for (int jj = 0; jj < list.numneigh[i]; jj++, history += numbers_) {
            if (history[STIFFNESS] == 0) continue;
            const int j = list.firstneigh[i][jj] & NEIGHMASK;
            remember(i, atom->tag[j], history);
            if (j >= listed_) continue;
            remember(j, atom->tag[i], history);
            turn_round(partners_[j].data() + partners_[j].size() - numbers_, numbers_);
        }
    }
    for (int i = listed_; i < atom->nlocal; i++) partners_[i].clear();    // grains that were added since
    saved_ = true;
    measure();
}

// From the grains to a neighbour list that has just been built.
void FixAsperityHistory::post_neighbor() {
    const NeighList &list = *pair_->list;
    listed_ = atom->nlocal;
    first_.resize(std::max<std::size_t>(first_.size(), listed_));
    std::size_t total = 0;
    for (int ii = 0; ii < list.inum; ii++) total += numbers_ * list.numneigh[list.ilist[ii]];
    values_.assign(total + 1, 0.0);    // one more, so that the place of a last grain without neighbours exists
    std::size_t place = 0;
    for (int ii = 0; ii < list.inum; ii++) {
        const int i = list.ilist[ii];
        first_[i] = place;
        for (int jj = 0; jj < list.numneigh[i]; jj++, place += numbers_) {
            if (partners_[i].empty()) continue;
            const double *history = find(i, atom->tag[list.firstneigh[i][jj] & NEIGHMASK]);
            if (history) std::copy_n(history, numbers_, &values_[place]);
        }
    }
}

// What a grain remembers of its contact with another.
const double *FixAsperityHistory::find(int i, tagint tag) const {
    const auto &partners = partners_[i];
    for (std::size_t at = 0; at < partners.size(); at += packed())
        if (static_cast<tagint>(partners[at]) == tag) return &partners[at + 1];
    return nullptr;
}

void FixAsperityHistory::write_restart(FILE *file) {
    pre_exchange();
    if (comm->me != 0) return;
    const int size = 0;    // of what the fix itself has to say
    fwrite(&size, sizeof size, 1, file);
}

// ---- What LAMMPS asks of a fix with data of its own for each grain ----

void FixAsperityHistory::measure() {
    most_ = 0;
    for (const auto &partners : partners_) most_ = std::max(most_, partners.size());
    maxexchange = static_cast<int>(HEAD + most_);
}

void FixAsperityHistory::grow_arrays(int nmax) { partners_.resize(nmax); }

void FixAsperityHistory::copy_arrays(int from, int to, int) { partners_[to] = partners_[from]; }

void FixAsperityHistory::set_arrays(int i) { partners_[i].clear(); }

int FixAsperityHistory::pack(int i, double *buffer) const {
    buffer[0] = numbers_;
    buffer[1] = static_cast<double>(partners_[i].size());
    std::copy(partners_[i].begin(), partners_[i].end(), buffer + HEAD);
    return static_cast<int>(HEAD + partners_[i].size());
}

int FixAsperityHistory::unpack(int i, const double *buffer) {
    if (buffer[0] != numbers_)
        error->one(FLERR, "pair_style asperity/hertz: contacts of the restart file remember {} numbers, these {}: microslip must "
                   "be as it was", buffer[0], numbers_);
    const auto size = static_cast<std::size_t>(buffer[1]);
    partners_[i].assign(buffer + HEAD, buffer + HEAD + size);
    most_ = std::max(most_, size);
    return static_cast<int>(HEAD + size);
}

int FixAsperityHistory::pack_exchange(int i, double *buffer) { return pack(i, buffer); }

int FixAsperityHistory::unpack_exchange(int i, double *buffer) { return unpack(i, buffer); }

int FixAsperityHistory::pack_restart(int i, double *buffer) {
    buffer[0] = size_restart(i);
    return 1 + pack(i, buffer + 1);
}

// The numbers of all fixes stand behind one another, each set beginning with its length.
void FixAsperityHistory::unpack_restart(int i, int nth) {
    const double *buffer = atom->extra[i];
    for (int n = 0; n < nth; n++) buffer += static_cast<int>(buffer[0]);
    unpack(i, buffer + 1);
}

int FixAsperityHistory::size_restart(int i) { return static_cast<int>(1 + HEAD + partners_[i].size()); }

int FixAsperityHistory::maxsize_restart() {
    const int mine = static_cast<int>(most_);
    int most = 0;
    MPI_Allreduce(&mine, &most, 1, MPI_INT, MPI_MAX, world);
    return 1 + HEAD + most;
}

double FixAsperityHistory::memory_usage() {
    double bytes = sizeof(double) * values_.capacity() + sizeof(std::size_t) * first_.capacity();
    for (const auto &partners : partners_) bytes += sizeof partners + sizeof(double) * partners.capacity();
    return bytes;
}
