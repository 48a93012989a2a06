#include "told.h"

#include <algorithm>

#include "comm.h"
#include "error.h"

namespace asperity_lammps {

namespace {

// A run is warned of if the model holds for less of the load: a few light contacts, of which there are always some, say little.
const double least_held = 0.99;

std::string said_by(std::uint64_t warning) {
    char text[512];
    asperity_warnings_text(warning, text, sizeof text);
    return text;
}

}    // namespace

void Told::begin() {
    std::fill_n(sums_, 5, 0.0);
    warnings_ = told_ = 0;
}

void Told::add(const Sums &sums) {
    const double more[] = {sums.load, sums.held, sums.few, sums.few_summits, sums.few_scatter};
    for (int k = 0; k < 5; k++) sums_[k] += more[k];
    warnings_ |= sums.warnings;
    told_ |= sums.told;
}

void Told::say(const std::string &who, bool always) {
    double all[5];
    std::uint64_t warnings = 0, told = 0;
    MPI_Allreduce(sums_, all, 5, MPI_DOUBLE, MPI_SUM, world);
    MPI_Allreduce(&warnings_, &warnings, 1, MPI_UINT64_T, MPI_BOR, world);
    MPI_Allreduce(&told_, &told, 1, MPI_UINT64_T, MPI_BOR, world);
    if (comm->me != 0) return;
    for (std::uint64_t bit = 1; always && bit <= told; bit *= 2)
        if (told & bit) error->warning(FLERR, "{}: {}", who, said_by(bit));
    if (all[2] > (1 - least_held) * all[0])
        error->warning(FLERR, "{}: {:.3g} % of the load is on grains that touch on fewer than {:g} asperities, {:.2g} on average: "
                       "they have the mean friction of such contacts; expect +-{:.2g} % of a single one (95 %)",
                       who, 100 * all[2] / all[0], fewest_summits, all[3] / all[2], 100 * all[4] / all[2]);
    if (!(all[1] < least_held * all[0])) return;
    for (std::uint64_t bit = 1; bit <= warnings; bit *= 2)
        if (warnings & bit)
            error->warning(FLERR, "{}: the model holds for contacts with {:.3g} % of the load: {}", who, 100 * all[1] / all[0], said_by(bit));
}

}    // namespace asperity_lammps
