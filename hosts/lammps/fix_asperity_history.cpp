#include "fix_asperity_history.h"

#include <algorithm>
#include <cstring>

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "modify.h"
#include "neigh_list.h"
#include "pair.h"

using namespace LAMMPS_NS;
using asperity_lammps::HISTORY;

FixAsperityHistory::FixAsperityHistory(LAMMPS *lmp, int narg, char **arg) : Fix(lmp, narg, arg) {
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
    const NeighList &list = *pair_->list;
    for (int ii = 0; ii < list.inum; ii++) {
        const int i = list.ilist[ii];
        const double *history = of_grain(i);
        for (int jj = 0; jj < list.numneigh[i]; jj++, history += HISTORY) {
            if (history[3] == 0) continue;
            const int j = list.firstneigh[i][jj] & NEIGHMASK;
            partners_[i].push_back({atom->tag[j], {history[0], history[1], history[2], history[3]}});
            if (j < listed_)
                partners_[j].push_back({atom->tag[i], {-history[0], -history[1], -history[2], history[3]}});
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
    for (int ii = 0; ii < list.inum; ii++) total += HISTORY * list.numneigh[list.ilist[ii]];
    values_.assign(total + 1, 0.0);    // one more, so that the place of a last grain without neighbours exists
    std::size_t place = 0;
    for (int ii = 0; ii < list.inum; ii++) {
        const int i = list.ilist[ii];
        first_[i] = place;
        for (int jj = 0; jj < list.numneigh[i]; jj++, place += HISTORY) {
            if (partners_[i].empty()) continue;
            const tagint tag = atom->tag[list.firstneigh[i][jj] & NEIGHMASK];
            for (const Partner &partner : partners_[i])
                if (partner.tag == tag) std::memcpy(&values_[place], partner.history, sizeof partner.history);
        }
    }
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
    maxexchange = static_cast<int>(PACKED * most_ + 1);
}

void FixAsperityHistory::grow_arrays(int nmax) { partners_.resize(nmax); }

void FixAsperityHistory::copy_arrays(int from, int to, int) { partners_[to] = partners_[from]; }

void FixAsperityHistory::set_arrays(int i) { partners_[i].clear(); }

int FixAsperityHistory::pack(int i, double *buffer) const {
    int m = 0;
    buffer[m++] = static_cast<double>(partners_[i].size());
    for (const Partner &partner : partners_[i]) {
        buffer[m++] = static_cast<double>(partner.tag);
        for (const double value : partner.history) buffer[m++] = value;
    }
    return m;
}

int FixAsperityHistory::unpack(int i, const double *buffer) {
    int m = 0;
    partners_[i].resize(static_cast<std::size_t>(buffer[m++]));
    for (Partner &partner : partners_[i]) {
        partner.tag = static_cast<tagint>(buffer[m++]);
        for (double &value : partner.history) value = buffer[m++];
    }
    most_ = std::max(most_, partners_[i].size());
    return m;
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

int FixAsperityHistory::size_restart(int i) { return static_cast<int>(2 + PACKED * partners_[i].size()); }

int FixAsperityHistory::maxsize_restart() {
    const int mine = static_cast<int>(most_);
    int most = 0;
    MPI_Allreduce(&mine, &most, 1, MPI_INT, MPI_MAX, world);
    return 2 + PACKED * most;
}

double FixAsperityHistory::memory_usage() {
    double bytes = sizeof(double) * values_.capacity() + sizeof(std::size_t) * first_.capacity();
    for (const auto &partners : partners_) bytes += sizeof partners + sizeof(Partner) * partners.capacity();
    return bytes;
}
