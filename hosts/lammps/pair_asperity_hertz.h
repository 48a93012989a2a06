// pair_style asperity/hertz: contacts between grains.
#ifndef PAIR_ASPERITY_HERTZ_H
#define PAIR_ASPERITY_HERTZ_H

#include <memory>
#include <string>
#include <vector>

#include "told.h"
#include "pair.h"

namespace LAMMPS_NS {

class FixAsperityHistory;

class PairAsperityHertz : public Pair {
public:
    static constexpr const char *style = "asperity/hertz";

    explicit PairAsperityHertz(LAMMPS *);
    ~PairAsperityHertz() override;
    void settings(int, char **) override;
    void coeff(int, char **) override;
    void init_style() override;
    double init_one(int, int) override;
    void compute(int, int) override;
    double single(int, int, int, int, double, double, double, double &) override;
    void finish() override;
    void write_restart(FILE *) override;
    void read_restart(FILE *) override;
    void write_restart_settings(FILE *) override;
    void read_restart_settings(FILE *) override;

private:
    using Words = std::vector<std::string>;

    void allocate();
    void set_law(int, int, const Words &, const std::string &made_of = "");
    void make_fix_history();
    void find_radii();
    bool touching(int, int, asperity_lammps::Contact &) const;
    void apply(const asperity_lammps::Law &, int, const asperity_lammps::Contact *);
    void history_of(int, int, double *) const;
    void write_words(FILE *, const Words &) const;
    Words read_words(FILE *);

    Words words_;                                                  // of pair_style
    std::vector<Words> own_words_;                                 // of pair_coeff, [i * (types + 1) + j]
    std::vector<std::shared_ptr<const asperity_lammps::Law>> laws_;    // the same index
    std::vector<double> largest_, largest_frozen_;                 // radii by type
    std::string history_id_;                                       // of the fix that keeps the histories
    FixAsperityHistory *fix_history_ = nullptr;
    int freeze_bit_ = 0;
    asperity_lammps::Sums sums_;
    asperity_lammps::Told told_;
};

}    // namespace LAMMPS_NS

#endif
