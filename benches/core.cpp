// What the numerical core costs: makes a model, or evaluates exact states, so many times, to count instructions; prints the memory of
// models; makes calls at loads of every kind, with a dump of callgrind after each kind.
//
// usage: core make|state SURFACE TIMES, core memory, core calls
#include "kinds_of_load.hpp"
#include "surfaces.hpp"

#include <valgrind/callgrind.h>

#include <string>

namespace {

// Polysilicon by the moments of its surface: radii fall with height.
asperity_params of_moments() {
    asperity_params params;
    require(asperity_params_init(&params, sizeof params));
    require(asperity_params_set_materials(&params, 160e9, 0.22, 160e9, 0.22));
    params.work_of_adhesion = 0.063;
    params.adhesion_range = params.burgers_vector = 0.384e-9;
    require(asperity_params_set_spectral_moments(&params, 2.5e-17, 4e-3, 2e12, 1e-8));
    return params;
}

asperity_params params_of(const std::string &name, const Histogram &histogram) {
    if (name == "histogram") return histogram.params();
    if (name == "spectral moments") return of_moments();
    for (const Surface &surface : all_surfaces()) {
        if (surface.name == name) return surface.params;
    }
    std::fprintf(stderr, "core: no surface %s\n", name.c_str());
    std::exit(2);
}

}  // namespace

int main(int count, char **arguments) {
    const std::string what = count > 1 ? arguments[1] : "";
    const Histogram histogram(100);
    if (what == "memory") {
        for (const char *name : {"default", "skew 1", "epsilon .5", "spectral moments", "histogram"}) {
            std::printf("%s\t%.0f\n", name, bytes_of(params_of(name, histogram)) / 1024.0);
        }
        return 0;
    }
    if (what == "calls") {
        KindsOfLoad::each([](const std::string &surface, const std::string &kind, const std::string &call, const auto &pass) {
            pass();  // what a first call finds out is no part of it
            CALLGRIND_ZERO_STATS;
            pass();
            const std::string name = surface + "|" + kind + "|" + call;
            asm volatile("" : : "r"(name.c_str()) : "memory");  // the request reads it
            CALLGRIND_DUMP_STATS_AT(name.c_str());
        });
        return 0;
    }
    if (count != 4 || (what != "make" && what != "state")) {
        std::fprintf(stderr, "usage: core make|state SURFACE TIMES, core memory, core calls\n");
        return 2;
    }
    const int times = std::atoi(arguments[3]);
    const asperity_params params = params_of(arguments[2], histogram);
    if (what == "make") {
        for (int i = 0; i < times; ++i) make_model(params);
        return 0;
    }
    const Model model = make_model(params);
    for (int i = 0; i < times; ++i) {
        asperity_state state;
        state.struct_size = sizeof state;
        require(asperity_state_at_load(model.get(), 0.1 * std::pow(1.7, i), &state));
    }
    return 0;
}
