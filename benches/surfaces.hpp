// The parameter sets that the benchmark runs over: the default case, the limits of adhesion, skewed heights, unequal
// radii. Loads are in the default's units, b = G = 1, one summit.
#pragma once

#include "asperity.h"

#include <malloc.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

inline void require(asperity_status status) {
    if (status == ASPERITY_OK) return;
    char message[512];
    asperity_last_error(message, sizeof message);
    std::fprintf(stderr, "solver_speed: %s: %s\n", asperity_status_string(status), message);
    std::exit(1);
}

struct Surface {
    std::string name;
    asperity_params params;
    bool equal_radii() const { return params.radius_amplitude == 0.0; }
};

inline asperity_params surface_of(double alpha, double beta, double gamma) {
    asperity_params params;
    require(asperity_params_init(&params, sizeof params));
    require(asperity_params_set_dimensionless(&params, alpha, beta, gamma, 1.0, 0.3));
    return params;
}

// Weibull heights of this skew.
inline void set_skew(asperity_params &params, double skew) {
    const char *const name = "skew";
    require(asperity_params_set_values(&params, 1, &name, &skew));
}

inline asperity_params default_surface() { return surface_of(0.01, 1000.0, 0.001); }

inline std::vector<Surface> all_surfaces() {
    std::vector<Surface> surfaces = {
        {"default", default_surface()},
        {"no adhesion (Hertz)", surface_of(0.01, 1000.0, 0.0)},
        {"near JKR: alpha .006, beta 5e4, gamma .01", surface_of(0.006, 5e4, 0.01)},
    };
    for (double skew : {-1.0, 1.0}) {
        asperity_params params = default_surface();
        set_skew(params, skew);
        surfaces.push_back({skew < 0.0 ? "skew -1" : "skew 1", params});
    }
    asperity_params narrow = default_surface();
    narrow.height_distribution = ASPERITY_HEIGHTS_WEIBULL;
    narrow.weibull_shape = 40.74;
    surfaces.push_back({"Weibull shape 40.74", narrow});
    for (double amplitude : {0.5, -0.95}) {
        asperity_params params = default_surface();
        params.radius_amplitude = amplitude;
        surfaces.push_back({amplitude > 0.0 ? "epsilon .5" : "epsilon -.95", params});
    }
    return surfaces;
}

// Heights as measured ones are given: the density of bins over 7 standard deviations, uneven as counts are.
class Histogram {
public:
    explicit Histogram(size_t bins) {
        for (size_t i = 0; i <= bins; ++i) {
            const double z = -3.5 + 7.0 * double(i) / double(bins);
            const bool is_end = i == 0 || i == bins;
            height_.push_back(z);
            density_.push_back(is_end ? 0.0 : std::exp(-0.5 * z * z) * (1.0 + 0.3 * std::sin(7.0 * z * z * z)));
        }
    }
    // Valid as long as this is.
    asperity_params params() const {
        asperity_params params = default_surface();
        params.height_distribution = ASPERITY_HEIGHTS_TABULATED;
        params.table_height = height_.data();
        params.table_density = density_.data();
        params.table_length = height_.size();
        return params;
    }

private:
    std::vector<double> height_, density_;
};

struct FreeModel {
    void operator()(asperity_model *model) const { asperity_free(model); }
};
using Model = std::unique_ptr<asperity_model, FreeModel>;

inline Model make_model(const asperity_params &params) {
    asperity_model *model = nullptr;
    require(asperity_create(&params, &model));
    return Model(model);
}

inline asperity_summary summary_of(const Model &model) {
    asperity_summary summary;
    summary.struct_size = sizeof summary;
    require(asperity_summary_of(model.get(), &summary));
    return summary;
}

// What a model adds to the heap.
inline double heap_bytes() {
    const struct mallinfo2 heap = mallinfo2();
    return double(heap.uordblks + heap.hblkhd);
}

inline double bytes_of(const asperity_params &params) {
    make_model(params);  // what a first call leaves behind is no part of the handle
    const double before = heap_bytes();
    const Model model = make_model(params);
    return heap_bytes() - before;
}
