// What the numerical core costs: makes a model, or evaluates exact states, so many times, to count instructions; prints the memory of models.
//
// usage: core make|state SURFACE TIMES, core memory
#include "surfaces.hpp"

#include <malloc.h>

#include <string>

namespace {

Model model_of(const std::string &name, Histogram &histogram) {
    if (name == "histogram") return make_model(histogram.params());
    for (const Surface &surface : all_surfaces()) {
        if (surface.name == name) return make_model(surface.params);
    }
    std::fprintf(stderr, "core: no surface %s\n", name.c_str());
    std::exit(2);
}

double kibibytes(const std::string &name, Histogram &histogram) {
    model_of(name, histogram);  // what a first call leaves behind is no part of the handle
    const struct mallinfo2 before = mallinfo2();
    const Model model = model_of(name, histogram);
    const struct mallinfo2 after = mallinfo2();
    return double(after.uordblks + after.hblkhd - before.uordblks - before.hblkhd) / 1024.0;
}

}  // namespace

int main(int count, char **arguments) {
    const std::string what = count > 1 ? arguments[1] : "";
    Histogram histogram(100);
    if (what == "memory") {
        for (const char *name : {"default", "skew 1", "epsilon .5", "histogram"}) {
            std::printf("%s\t%.0f\n", name, kibibytes(name, histogram));
        }
        return 0;
    }
    if (count != 4 || (what != "make" && what != "state")) {
        std::fprintf(stderr, "usage: core make|state SURFACE TIMES, core memory\n");
        return 2;
    }
    const int times = std::atoi(arguments[3]);
    if (what == "make") {
        for (int i = 0; i < times; ++i) model_of(arguments[2], histogram);
        return 0;
    }
    const Model model = model_of(arguments[2], histogram);
    for (int i = 0; i < times; ++i) {
        asperity_state state;
        state.struct_size = sizeof state;
        require(asperity_state_at_load(model.get(), 0.1 * std::pow(1.7, i), &state));
    }
    return 0;
}
