// fix wall/asperity/hertz: grains against one or two flat walls across a direction.
#ifndef FIX_WALL_ASPERITY_HERTZ_H
#define FIX_WALL_ASPERITY_HERTZ_H

#include <memory>
#include <vector>

#include "fix.h"
#include "told.h"

namespace LAMMPS_NS {

class FixWallAsperityHertz : public Fix {
public:
    static constexpr const char *style_name = "wall/asperity/hertz";

    FixWallAsperityHertz(LAMMPS *, int, char **);
    ~FixWallAsperityHertz() override;
    int setmask() override;
    void init() override;
    void setup(int) override;
    void post_force(int) override;
    void post_run() override;
    double compute_vector(int) override;

    void grow_arrays(int) override;
    void copy_arrays(int, int, int) override;
    void set_arrays(int) override;
    int pack_exchange(int, double *) override;
    int unpack_exchange(int, double *) override;
    int pack_restart(int, double *) override;
    void unpack_restart(int, int) override;
    int size_restart(int) override { return 1 + of_grain_; }
    int maxsize_restart() override { return 1 + of_grain_; }
    double memory_usage() override { return static_cast<double>(sizeof(double)) * histories_.capacity(); }

private:
    enum { WALLS = 2 };

    asperity_lammps::Law::Words read_planes(int, char **);
    double *of_grain(int i);
    void meet(int grain, double overlap, double side, double *history, asperity_lammps::Contact &) const;
    void apply(int count, const asperity_lammps::Contact *, double dt);

    std::shared_ptr<const asperity_lammps::Law> law_;
    int axis_ = 2;                      // normal to the walls
    double place_[WALLS];               // below and above; not finite where there is none
    double velocity_[3] = {0, 0, 0};
    int of_grain_ = 0;                  // numbers of the histories of a grain at all walls
    std::vector<double> histories_;     // of_grain_ numbers of each grain
    asperity_lammps::Sums sums_;
    asperity_lammps::Told told_;
    double force_[3] = {0, 0, 0};       // of the walls on the grains of this rank
    double driving_ = 0;                // work of the walls on these
};

}    // namespace LAMMPS_NS

#endif
