// Keeps what the contacts of pair_style asperity/hertz remember: beside the neighbour list while that is valid, with the
// grains (by the identifiers of their partners) while they are sorted, sent to other ranks or written to a restart file.
#ifndef FIX_ASPERITY_HISTORY_H
#define FIX_ASPERITY_HISTORY_H

#include <vector>

#include "fix.h"
#include "law.h"

namespace LAMMPS_NS {

class FixAsperityHistory : public Fix {
public:
    static constexpr const char *style_name = "ASPERITY/HISTORY";

    // fix ID group ASPERITY/HISTORY N: with N numbers for each contact
    FixAsperityHistory(LAMMPS *, int, char **);
    ~FixAsperityHistory() override;
    void of_pair(class Pair *pair) { pair_ = pair; }
    // The histories of the neighbours of grain i, numbers() for each. Stiffness 0: nothing is remembered.
    int numbers() const { return numbers_; }
    double *of_grain(int i) { return &values_[first_[i]]; }
    const double *of_grain(int i) const { return &values_[first_[i]]; }
    // The neighbour list has moved on since it was last saved.
    void changed() { saved_ = false; }

    int setmask() override;
    void init() override;
    void setup_post_neighbor() override { post_neighbor(); }
    void pre_exchange() override;
    void post_neighbor() override;
    void min_pre_exchange() override { pre_exchange(); }
    void min_post_neighbor() override { post_neighbor(); }
    void post_run() override { pre_exchange(); }
    void write_restart(FILE *) override;

    void grow_arrays(int) override;
    void copy_arrays(int, int, int) override;
    void set_arrays(int) override;
    int pack_exchange(int, double *) override;
    int unpack_exchange(int, double *) override;
    int pack_restart(int, double *) override;
    void unpack_restart(int, int) override;
    int size_restart(int) override;
    int maxsize_restart() override;
    double memory_usage() override;

private:
    int pack(int, double *) const;
    int unpack(int, const double *);
    void measure();
    const double *find(int, tagint) const;
    int packed() const { return 1 + numbers_; }    // numbers of a partner: its identifier and the history
    enum { HEAD = 2 };                             // before the partners in a buffer: numbers_, and how many follow

    Pair *pair_ = nullptr;
    int numbers_;                                  // of the history of a contact
    std::vector<std::size_t> first_;               // of grain i in values_
    std::vector<double> values_;
    std::vector<std::vector<double>> partners_;    // packed() numbers for each partner of each grain, as last saved
    int listed_ = 0;                               // grains of this rank when the list was built
    std::size_t most_ = 0;                         // numbers of a grain of this rank
    bool saved_ = true;
};

}    // namespace LAMMPS_NS

#endif
