// Grains that touch on few summits: what single specimens of their surface have, over what its mean has; and how hard rough grains stick.
#include "beads.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace asperity_lammps {

namespace {

// Places of the table, as numbers of summits that the mean of the surface has in contact, and as numbers of summits on the area of the
// contact. With more in contact, or more on the area, nothing changes within 1 %.
const double touching[] = {1e-5, 1e-4, 1e-3, 0.01, 0.05, 0.2, 0.5, 1, 2, 5, 10, 20, Beads::MANY};
const double all[] = {1, 4, 16, 64, 1024};
enum { TOUCHING = sizeof touching / sizeof *touching, ALL = sizeof all / sizeof *all, SPECIMENS = 200, SEED = 1, RADII = 6 };
const double fewest_on_sphere = 3;    // of the library, within height_std of the lowest point

struct Place {
    int first;
    double share;
};

// Where a value is between those of a table, by its logarithm; below 0 if it is before the first.
template <int N> Place place_in(const double (&table)[N], double value) {
    int i = 0;
    while (i < N - 2 && value >= table[i + 1]) i++;
    return {i, std::log(value / table[i]) / std::log(table[i + 1] / table[i])};
}

void demand(asperity_status status) {
    char message[512];
    if (status == ASPERITY_OK) return;
    asperity_last_error(message, sizeof message);
    throw std::invalid_argument(message);
}

using Model = std::unique_ptr<asperity_model, void (*)(asperity_model *)>;

// A model of so many summits, with its area; `per_area` is of one unit of area.
Model of_summits(const asperity_params &per_area, double count) {
    asperity_params params = per_area;
    const double area = count / per_area.asperity_count;
    for (double *total : {&params.asperity_count, &params.nominal_area, &params.calibration_load, &params.calibration_friction_force})
        *total *= area;
    params.asperity_count = count;
    asperity_model *model = nullptr;
    asperity_create(&params, &model);
    return {model, asperity_free};
}

double pull_off_of(const asperity_model *model, double radius) {
    double load = 0, force[SPECIMENS], other[4][SPECIMENS], pull[SPECIMENS], sum = 0;
    demand(asperity_each_specimen_at_loads(model, radius, 0, SPECIMENS, SEED, 1, &load, force, other[0], other[1], other[2], other[3], pull));
    for (double each : pull) sum += each;
    return sum / SPECIMENS;
}

}    // namespace

Beads::Beads(const asperity_params &per_area, bool pull_off) : table_(TOUCHING * ALL), summit_radius_(per_area.summit_radius) {
    for (int column = 0; column < ALL; column++) {
        const Model model = of_summits(per_area, all[column]);
        for (int row = 0; row < TOUCHING; row++) {
            Single &found = table_[column * TOUCHING + row];
            if (row == TOUCHING - 1 || touching[row] > 0.9 * all[column]) continue;    // as the mean, if many touch or nearly all
            const double load = model ? load_of(model.get(), touching[row]) : 0;
            asperity_specimens single;
            single.struct_size = sizeof single;
            double mean, stiffness;
            if (load > 0 && asperity_specimens_at_loads(model.get(), SPECIMENS, SEED, 1, &load, &single) == ASPERITY_OK &&
                asperity_friction_force_at_loads(model.get(), 1, &load, &mean, nullptr) == ASPERITY_OK &&
                asperity_tangential_stiffness_at_loads(model.get(), 1, &load, &stiffness) == ASPERITY_OK) {
                const double *force = single.friction_force, unit = force[ASPERITY_SPREAD_MEAN];
                found.friction = std::log(unit / mean);
                found.stiffness = std::log(single.tangential_stiffness[ASPERITY_SPREAD_MEAN] / stiffness);
                found.scatter = 0.5 * (force[ASPERITY_SPREAD_HIGH] - force[ASPERITY_SPREAD_LOW]) / unit;
            } else if (column > 0) {    // the load is too light: as with fewer summits
                found = table_[(column - 1) * TOUCHING + row];
            }
        }
    }
    if (!pull_off) return;
    pull_off_of_summit_ = pull_off_of(of_summits(per_area, 1).get(), 0);
    const Model flat = of_summits(per_area, 64);
    least_radius_ = 1.001 * fewest_on_sphere / (2 * std::acos(-1.0) * per_area.height_std * per_area.asperity_count);
    for (int k = 0; k < RADII; k++) pull_off_.push_back(pull_off_of(flat.get(), least_radius_ * std::pow(4, k)));
}

// The load at which the mean of a surface has so many summits in contact; 0 if there is none that can be had.
double Beads::load_of(const asperity_model *model, double contacts) {
    asperity_state state;
    state.struct_size = sizeof state;
    const auto has = [&](double load) {
        return asperity_state_at_load(model, load, &state) == ASPERITY_OK ? state.contacting : -1;
    };
    asperity_summary summary;
    summary.struct_size = sizeof summary;
    if (asperity_summary_of(model, &summary) != ASPERITY_OK) return 0;
    double high = summary.max_table_load, low = 1e-15 * high;
    if (!(has(low) <= contacts)) return 0;
    for (int halving = 0; halving < 40; halving++) {
        const double middle = std::sqrt(low * high), found = has(middle);
        (found < 0 || found > contacts ? high : low) = middle;
    }
    return low;
}

Single Beads::single(double contacts, double summits) const {
    // Of lighter loads than those of the table one summit carries all: powers of their number.
    const Place row = place_in(touching, contacts), column = place_in(all, summits);
    const double of_column = std::clamp(column.share, 0.0, 1.0);
    const auto at = [&](double Single::*what, double of_row) {
        double value[2];
        for (int c = 0; c < 2; c++) {
            const Single *first = &table_[(column.first + c) * TOUCHING + row.first];
            value[c] = first[0].*what + of_row * (first[1].*what - first[0].*what);
        }
        return value[0] + of_column * (value[1] - value[0]);
    };
    return {std::exp(at(&Single::friction, row.share)), std::exp(at(&Single::stiffness, row.share)),
            at(&Single::scatter, std::max(row.share, 0.0))};
}

double Beads::pull_off(double radius) const {
    if (pull_off_.empty()) return 0;
    if (radius < least_radius_) return pull_off_of_summit_ * radius / (radius + summit_radius_);    // the body is the larger hill
    const double place = std::log(radius / least_radius_) / std::log(4.0);
    const int k = std::min(static_cast<int>(place), RADII - 1);
    if (k == RADII - 1) return pull_off_[k] * radius / (least_radius_ * std::pow(4, k));
    return pull_off_[k] * std::pow(pull_off_[k + 1] / pull_off_[k], place - k);
}

}    // namespace asperity_lammps
