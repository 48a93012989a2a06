// A contact that remembers: what a step costs, alone and in a batch, in calls of exp of the same run, and how far its forces
// and the work of its cycles are from the exact ones.
#pragma once

#include "asperity.h"
#include "interleaved.hpp"
#include "surfaces.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

class MicroslipBench {
public:
    static void report(const std::vector<Surface> &surfaces) {
        std::printf("\n### Contacts that remember\n\n"
                    "A step of a contact, with force, tangents and state, over a call of exp. Every step moves each of %zu contacts by "
                    "up to half of F/K_t in any direction, so that some levels slip. Limits: %.0f, and %.1f in a batch.\n\n"
                    "| call | time | over exp | limit | |\n|---|---|---|---|---|\n",
                    kContacts, kMostAlone, kMostInBatch);
        MicroslipBench bench;
        const Interleaved times(bench.calls(), {9, 15, 3e-4});
        row(times, "one step", kMostAlone);
        row(times, "batch of steps", kMostInBatch);
        accuracy(surfaces);
    }

private:
    static constexpr size_t kContacts = 1024;
    static constexpr double kMostAlone = 40.0, kMostInBatch = 15.0;
    static constexpr double kMostForce = 0.01, kMostWork = 0.1;
    static constexpr int kSets = 8;

    MicroslipBench() : model_(make_model(default_surface())), length_(asperity_microslip_length(model_.get())) {
        std::mt19937_64 engine(32);
        std::uniform_real_distribution<double> part(0.0, 1.0);
        state_.assign(kContacts * length_, 0.0);
        for (size_t i = 0; i < kContacts; ++i) load_.push_back(1e-3 * std::pow(1e6, part(engine)));
        increment_.resize(kSets);
        for (std::vector<double> &set : increment_) {
            for (double load : load_) {
                const double most = asperity_friction_force_at_load(model_.get(), load) /
                                    asperity_tangential_stiffness_at_load(model_.get(), load);
                for (int axis = 0; axis < 2; ++axis) set.push_back((part(engine) - 0.5) * most);
            }
        }
        force_.resize(2 * kContacts);
        stiffness_.resize(4 * kContacts);
        value_.resize(kContacts);
    }

    std::vector<Contestant> calls() {
        return {{"exp", double(kContacts),
                 [this] {
                     for (size_t i = 0; i < kContacts; ++i) value_[i] = std::exp(load_[i] * 1e-2 - 5.0);
                     asm volatile("" : : "r"(value_.data()) : "memory");
                 }},
                {"one step", double(kContacts),
                 [this] {
                     const std::vector<double> &increment = increment_[set_++ % kSets];
                     asperity_microslip out;
                     out.struct_size = sizeof out;
                     for (size_t i = 0; i < kContacts; ++i) {
                         double *state = &state_[i * length_];
                         require(asperity_microslip_step(model_.get(), load_[i], &increment[2 * i], state, state, &out));
                     }
                 }},
                {"batch of steps", double(kContacts), [this] {
                     require(asperity_microslip_steps(model_.get(), kContacts, load_.data(), increment_[set_++ % kSets].data(),
                                                      state_.data(), state_.data(), force_.data(), stiffness_.data()));
                 }}};
    }

    static void row(const Interleaved &times, const char *name, double limit) {
        const Spread ratio = times.ratio(name, "exp");
        std::printf("| %s | %.0f ns | %.1f (%.1f to %.1f) | %.1f | %s |\n", name, 1e9 * times.seconds(name).median, ratio.median,
                    ratio.least, ratio.most, limit, ratio.median <= limit ? "met" : "**MISSED**");
    }

    // Against integration over the summits, at loads of eight decades about that at which half of the summits touch.
    static void accuracy(const std::vector<Surface> &surfaces) {
        std::printf("\nAgainst the exact tangential force, at loads of eight decades: the largest error of the force of a first loading, "
                    "over F, and of the work of cycles of amplitudes from 0.1 to 2 F/K_t, over that work. Limits: %.2f and %.2f.\n\n"
                    "| surface | force | work of a cycle | |\n|---|---|---|---|\n",
                    kMostForce, kMostWork);
        for (const Surface &surface : surfaces) {
            const Model model = make_model(surface.params);
            asperity_state half;
            half.struct_size = sizeof half;
            require(asperity_state_at_gap(model.get(), 0.0, &half));
            double force = 0.0, work = 0.0;
            for (int decade = -6; decade <= 2; ++decade) {
                const Errors found = errors_at(model.get(), 0.5 * std::fabs(half.load) * std::pow(10.0, decade));
                force = std::max(force, found.force);
                work = std::max(work, found.work);
            }
            const bool is_met = force <= kMostForce && work <= kMostWork;
            std::printf("| %s | %.4f | %.3f | %s |\n", surface.name.c_str(), force, work, is_met ? "met" : "**MISSED**");
        }
    }

    struct Errors {
        double force, work;
    };

    static Errors errors_at(const asperity_model *model, double load) {
        const double strength = asperity_friction_force_at_load(model, load);
        const double length = strength / asperity_tangential_stiffness_at_load(model, load);
        const auto exact = [&](double x) {
            double force = 0.0;
            require(asperity_tangential_at_load(model, load, x * length, &force, nullptr));
            return force / strength;
        };
        const auto moved = [&](double x, std::vector<double> &state) {
            asperity_microslip out;
            out.struct_size = sizeof out;
            const double by[2] = {x * length, 0.0};
            require(asperity_microslip_step(model, load, by, state.data(), state.data(), &out));
            return out;
        };
        const size_t numbers = asperity_microslip_length(model);
        Errors errors = {0.0, 0.0};
        for (double x = 0.03; x < 6.0; x *= 1.15) {
            std::vector<double> state(numbers);
            errors.force = std::max(errors.force, std::fabs(moved(x, state).force[0] / strength - exact(x)));
        }
        for (double amplitude : {0.1, 0.2, 0.5, 1.0, 2.0}) {
            std::vector<double> state(numbers);
            moved(amplitude, state);
            const double work = moved(-2.0 * amplitude, state).dissipated + moved(2.0 * amplitude, state).dissipated;
            // Masing's loop, by Simpson's rule.
            constexpr int kSteps = 40;
            double area = 0.0;
            for (int i = 0; i <= kSteps; ++i)
                area += (i == 0 || i == kSteps ? 1.0 : 2.0 + 2.0 * (i % 2)) * exact(amplitude * i / kSteps);
            area *= amplitude / (3.0 * kSteps);
            const double expected = (8.0 * area - 4.0 * amplitude * exact(amplitude)) * strength * length;
            errors.work = std::max(errors.work, std::fabs(work / expected - 1.0));
        }
        return errors;
    }

    Model model_;
    size_t length_, set_ = 0;
    std::vector<double> load_, state_, force_, stiffness_, value_;
    std::vector<std::vector<double>> increment_;
};
