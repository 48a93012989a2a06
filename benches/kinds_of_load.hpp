// Calls at loads of every kind that a solver may have: zero, pulling, separated, light, heavy, and those in a row of the table that
// has a kink.
#pragma once

#include "asperity.h"
#include "interleaved.hpp"
#include "surfaces.hpp"

#include <cmath>
#include <cstdio>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

class KindsOfLoad {
public:
    // Calls visit(surface, kind, call, function) for each of them, where the function makes kCount calls; ordinary loads come first.
    template <class Visit>
    static void each(const Visit &visit) {
        for (const Surface &surface : kinds_of_surface()) {
            const KindsOfLoad kinds_of(surface);
            for (const auto &[kind, loads] : kinds_of.kinds()) {
                std::vector<Contestant> calls;
                if (!loads.empty()) kinds_of.add_calls(calls, "", loads);
                for (const Contestant &call : calls) visit(surface.name, kind, call.name, call.pass);
            }
        }
    }

private:
    static constexpr size_t kCount = 256;
    // The separation, in height_std, to which tables reached before.
    static constexpr double kFormerEnd = -12.0;

    static std::vector<Surface> kinds_of_surface() {
        asperity_params silicon = default_surface(), skewed = default_surface(), steep = default_surface();
        require(asperity_params_set_materials(&silicon, 160e9, 0.22, 72e9, 0.17));
        silicon.work_of_adhesion = 0.1;
        silicon.adhesion_range = silicon.burgers_vector = 0.384e-9;
        silicon.height_std = 20e-9;
        silicon.summit_radius = 1e-6;
        silicon.asperity_count = 1e5;
        set_skew(skewed, 0.8);
        steep.radius_amplitude = -0.5;
        asperity_params johnson = default_surface();
        johnson.height_distribution = ASPERITY_HEIGHTS_JOHNSON;
        johnson.skew = 0.5;
        johnson.kurtosis = 4.0;
        asperity_params hardly = default_surface();  // a pull-off load of -3e-138
        set_skew(hardly, 1.0);
        return {{"default", default_surface()}, {"Si/SiO2, sigma 20 nm", silicon},
                {"Hertz", surface_of(0.01, 1000.0, 0.0)}, {"Weibull, skew .8", skewed},
                {"epsilon -.5", steep}, {"Johnson", johnson}, {"hardly adheres", hardly}};
    }

    explicit KindsOfLoad(const Surface &surface) : params_(surface.params), model_(make_model(surface.params)) {}

    double load_at(double separation) const {
        asperity_state state;
        state.struct_size = sizeof state;
        require(asperity_state_at_gap(model_.get(), separation * params_.height_std, &state));
        return state.load;
    }

    // Loads in the first row, from the heaviest down, that has parts; none if there is no such row.
    std::vector<double> in_a_row_with_parts() const {
        asperity_table table;
        table.struct_size = sizeof table;
        require(asperity_table_of(model_.get(), ASPERITY_TABLE_FRICTION, &table));
        std::vector<double> loads;
        for (uint64_t row = table.row_count; row-- > 0 && loads.empty();) {
            if (table.rows[8 * row] == table.rows[8 * row]) continue;
            double edges[2];
            for (uint64_t k = 0; k < 2; ++k) {
                const uint64_t bits = (table.base + row + k) << table.shift;
                std::memcpy(&edges[k], &bits, sizeof bits);
            }
            for (size_t i = 0; i < kCount; ++i)
                loads.push_back(table.pull_off_load + edges[0] + (edges[1] - edges[0]) * (double(i) + 0.5) / kCount);
        }
        return loads;
    }

    std::vector<double> spread(double lightest, double heaviest) const {
        std::vector<double> loads(kCount);
        // Not in order: a processor learns what comes next.
        for (size_t i = 0; i < kCount; ++i)
            loads[i * 77 % kCount] = lightest * std::pow(heaviest / lightest, (double(i) + 0.5) / kCount);
        return loads;
    }

    std::vector<std::pair<std::string, std::vector<double>>> kinds() const {
        const asperity_summary summary = summary_of(model_);
        const double half = std::fabs(load_at(0.0)), former = load_at(kFormerEnd), pull_off = summary.pull_off_load;
        return {
            {"ordinary", spread(0.1 * half, 10.0 * half)},
            {"zero", std::vector<double>(kCount, 0.0)},
            {"negative zero", std::vector<double>(kCount, -0.0)},
            {"pulling", pull_off < 0.0 ? spread(0.9 * pull_off, 0.1 * pull_off) : std::vector<double>()},
            {"at pull-off", std::vector<double>(kCount, pull_off)},
            {"separated", std::vector<double>(kCount, 2.0 * pull_off - half)},
            {"light", spread(1e-21 * half, 1e-20 * half)},
            {"10 x the former end", spread(5.0 * former, 15.0 * former)},
            {"far beyond", spread(0.5e6 * former, 1.5e6 * former)},
            {"too heavy", std::vector<double>(kCount, 1e300)},
            {"kink", in_a_row_with_parts()},
        };
    }

    static constexpr const char *kCalls[] = {" scalar mu", " scalar F", " batch mu", " batch F"};

    // Separated and pulling loads are no errors here: the statuses are not looked at.
    void add_calls(std::vector<Contestant> &calls, const std::string &kind, const std::vector<double> &loads) const {
        const asperity_model *model = model_.get();
        const auto scalar = [&](const char *call, double (*function)(const asperity_model *, double)) {
            calls.push_back({kind + call, double(kCount), [loads, model, function] {
                                 double out[kCount];
                                 for (size_t i = 0; i < kCount; ++i) out[i] = function(model, loads[i]);
                                 asm volatile("" : : "r"(out) : "memory");
                             }});
        };
        scalar(kCalls[0], asperity_friction_at_load);
        scalar(kCalls[1], asperity_friction_force_at_load);
        calls.push_back({kind + kCalls[2], double(kCount), [loads, model] {
                             double mu[kCount];
                             asperity_friction_at_loads(model, kCount, loads.data(), mu, nullptr);
                             asm volatile("" : : "r"(mu) : "memory");
                         }});
        calls.push_back({kind + kCalls[3], double(kCount), [loads, model] {
                             double force[kCount], slope[kCount];
                             asperity_friction_force_at_loads(model, kCount, loads.data(), force, slope);
                             asm volatile("" : : "r"(force), "r"(slope) : "memory");
                         }});
    }

    asperity_params params_;
    Model model_;
};
