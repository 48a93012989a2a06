// What a run says at its end of where the model does not hold, from the steps that were added.
#ifndef ASPERITY_LAMMPS_TOLD_H
#define ASPERITY_LAMMPS_TOLD_H

#include <string>

#include "law.h"
#include "pointers.h"

namespace asperity_lammps {

class Told : LAMMPS_NS::Pointers {
public:
    using Pointers::Pointers;
    void begin();
    void add(const Sums &sums);
    // who: the command; always: also what is so at every load.
    void say(const std::string &who, bool always);

private:
    double sums_[5];    // load, where the model holds, on few summits, and that times their number and scatter
    std::uint64_t warnings_ = 0, told_ = 0;
};

}    // namespace asperity_lammps

#endif
