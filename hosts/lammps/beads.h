// What single contacts have where few summits touch, over the mean of their surface, and the pull-off force of rough grains. Knows
// nothing of LAMMPS.
#ifndef ASPERITY_LAMMPS_BEADS_H
#define ASPERITY_LAMMPS_BEADS_H

#include <memory>
#include <vector>

#include "asperity.h"

namespace asperity_lammps {

struct Single {
    double friction = 0, stiffness = 0;    // mean of single specimens over that of the surface
    double scatter = 0;                    // half of their 95 % range, over their mean
};

class Beads {
public:
    static constexpr double MANY = 60;    // summits in contact from which a specimen is as the mean

    // Of the surface on a unit of area, in a second; the pull-off force only if it is asked for, which throws std::invalid_argument if
    // the library refuses it.
    Beads(const asperity_params &per_area, bool pull_off);

    // For so many summits in contact, by the mean of the surface, of those on the area of the contact.
    Single single(double contacts, double summits) const;

    // Mean pull-off force of rough spheres of a radius, the effective one of two; of one smooth hill where fewer than three summits stand
    // at the lowest point. 0 without adhesion.
    double pull_off(double radius) const;

private:
    static double load_of(const asperity_model *model, double contacts);

    std::vector<Single> table_;        // with logarithms of friction and stiffness
    std::vector<double> pull_off_;     // of spheres of least_radius_, and each time four times that
    double pull_off_of_summit_ = 0, summit_radius_, least_radius_ = 0;
};

}    // namespace asperity_lammps

#endif
