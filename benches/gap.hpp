// What the calls beside friction by load cost: load against gap, contacts of many models in one call; each against the scalar
// call that it stands for or beside, in the same run.
#pragma once

#include "asperity.h"
#include "interleaved.hpp"
#include "surfaces.hpp"

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

class Gap {
public:
    static void report() {
        std::printf("\n### Load against gap, and many pairs\n\n"
                    "Time per contact over that of the call named, median (least to most), of %zu contacts in random order. "
                    "Separations are from where the load is 1e-8 of that at half touch to 6 height_std of compression, *all kinds* are "
                    "those and open gaps and up to 9e3 height_std of compression in equal parts.\n\n"
                    "| call | surface | time | over | ratio | limit | |\n|---|---|---|---|---|---|---|\n", kCount);
        for (const Surface &surface : all_surfaces()) Gap(surface).gaps();
        pairs();
    }

private:
    static constexpr size_t kCount = 4096;
    static constexpr size_t kModels = 16;
    static constexpr Schedule kSchedule = {7, 9, 1e-4};

    struct Row {
        const char *call, *over;
        double limit;
    };

    explicit Gap(const Surface &surface)
        : surface_(surface), model_(make_model(surface.params)), load_(kCount), close_(kCount), all_(kCount) {
        const double sigma = surface.params.height_std;
        asperity_state far, half;
        far.struct_size = half.struct_size = sizeof far;
        require(asperity_state_at_gap(model_.get(), 0.0, &half));
        require(asperity_state_at_load(model_.get(), 1e-8 * std::fabs(half.load), &far));
        for (size_t i = 0; i < kCount; ++i) {
            close_[i] = uniform(-6.0 * sigma, far.gap);
            const double kinds[] = {close_[i], uniform(10.0, 100.0) * sigma, -sigma * std::exp(uniform(1.0, 9.1))};
            all_[i] = kinds[i % 3];
            load_[i] = std::exp(uniform(std::log(1e-3), std::log(1e3)));
        }
    }

    double uniform(double from, double to) { return std::uniform_real_distribution<double>(from, to)(engine_); }

    // The statuses are not looked at: open gaps are separated.
    static Contestant call(const std::string &name, std::function<void()> pass) { return {name, double(kCount), pass}; }

    template <class Function>
    static Contestant each(const std::string &name, const Function &one) {
        return call(name, [one] {
            static double out[kCount];
            for (size_t i = 0; i < kCount; ++i) out[i] = one(i);
            asm volatile("" : : "r"(out) : "memory");
        });
    }

    static void rows(const std::string &surface, const Interleaved &times, std::initializer_list<Row> rows) {
        for (const Row &row : rows) {
            const Spread ratio = times.ratio(row.call, row.over);
            std::printf("| %s | %s | %.2f ns | %s | %.2f (%.2f to %.2f) | %.2f | %s |\n", row.call, surface.c_str(),
                        1e9 * times.seconds(row.call).median, row.over, ratio.median, ratio.least, ratio.most, row.limit,
                        ratio.median <= row.limit ? "met" : "**MISSED**");
        }
    }

    void gaps() {
        const asperity_model *model = model_.get();
        static double value[kCount], slope[kCount];
        const auto batch = [model](const std::vector<double> &at, double *slopes) {
            asperity_loads_at_gaps(model, kCount, at.data(), value, slopes);
            asm volatile("" : : "r"(value), "r"(slope) : "memory");
        };
        const Interleaved times({
            each("scalar F", [this, model](size_t i) { return asperity_friction_force_at_load(model, load_[i]); }),
            each("load at gap", [this, model](size_t i) { return asperity_load_and_slope_at_gap(model, close_[i], nullptr); }),
            each("load at gap, all kinds", [this, model](size_t i) { return asperity_load_and_slope_at_gap(model, all_[i], nullptr); }),
            call("loads at gaps", [this, batch] { batch(close_, nullptr); }),
            call("loads at gaps and slopes", [this, batch] { batch(close_, slope); }),
            call("loads at gaps, all kinds", [this, batch] { batch(all_, nullptr); }),
        }, kSchedule);
        rows(surface_.name, times, {
            {"load at gap", "scalar F", 3.0},
            {"load at gap, all kinds", "scalar F", 3.0},
            {"loads at gaps", "scalar F", 2.0},
            {"loads at gaps and slopes", "scalar F", 2.0},
            {"loads at gaps, all kinds", "scalar F", 3.0},
        });
    }

    // Contacts of models in random order, as a solver has them.
    static void pairs() {
        std::vector<Model> owners;
        std::vector<const asperity_model *> models;
        for (size_t i = 0; i < kModels; ++i) {
            owners.push_back(make_model(surface_of(0.01, 1000.0 * (1.0 + 0.1 * double(i)), 0.001)));
            models.push_back(owners.back().get());
        }
        Gap loads({"default", default_surface()});
        std::vector<uint32_t> which(kCount);
        for (uint32_t &index : which) index = uint32_t(loads.uniform(0.0, double(kModels)));
        static double force[kCount], slope[kCount];
        const auto batch = [&](double *slopes) {
            asperity_friction_force_at_loads_of(models.data(), kModels, kCount, which.data(), loads.load_.data(), force, slopes);
            asm volatile("" : : "r"(force), "r"(slope) : "memory");
        };
        const Interleaved times({
            each("a call each", [&](size_t i) { return asperity_friction_force_at_load(models[which[i]], loads.load_[i]); }),
            each("a call each, with its slope", [&](size_t i) {
                return asperity_friction_force_and_slope_at_load(models[which[i]], loads.load_[i], &slope[i]);
            }),
            call("forces of 16 models", [&] { batch(nullptr); }),
            call("forces and slopes of 16 models", [&] { batch(slope); }),
        }, kSchedule);
        rows("16 of them", times, {
            {"forces of 16 models", "a call each", 1.0},
            {"forces and slopes of 16 models", "a call each, with its slope", 1.0},
        });
    }

    Surface surface_;
    Model model_;
    std::vector<double> load_, close_, all_;
    std::mt19937_64 engine_{20051};
};
