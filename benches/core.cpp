// What the numerical core costs: does each work of the table of costs once, and calls at loads of every kind, with a dump of callgrind
// after each; prints the memory of models, and the table of limits.
//
// usage: core costs|kinds|memory|limits
#include "costs.hpp"

#include <valgrind/callgrind.h>

#include <string>

namespace {

// What a pass counts, in a dump of this name.
template <class Pass> void count(const std::string &name, const Pass &pass) {
    CALLGRIND_ZERO_STATS;
    pass();
    asm volatile("" : : "r"(name.c_str()) : "memory");  // the request reads it
    CALLGRIND_DUMP_STATS_AT(name.c_str());
}

}  // namespace

int main(int count_of_arguments, char **arguments) {
    const std::string what = count_of_arguments > 1 ? arguments[1] : "";
    if (what == "kinds") {
        KindsOfLoad::each([](const std::string &surface, const std::string &kind, const std::string &call, const auto &pass) {
            pass();  // what a first call finds out is no part of it
            count(surface + "|" + kind + "|" + call, pass);
        });
        return 0;
    }
    const Costs costs;
    if (what == "costs") {
        for (const Cost &cost : costs.all()) {
            if (cost.count > 1) cost.pass();
            count(cost.name, cost.pass);
        }
    } else if (what == "limits") {
        for (const Cost &cost : costs.all())
            std::printf("%s\t%g\t%s\t%g\n", cost.name.c_str(), cost.limit, cost.unit, cost.count);
    } else if (what == "memory") {
        for (const Surface &surface : costs.surfaces())
            std::printf("%s\t%.1f\n", surface.name.c_str(), bytes_of(surface.params) / 1024.0);
    } else {
        std::fprintf(stderr, "usage: core costs|kinds|memory|limits\n");
        return 2;
    }
    return 0;
}
