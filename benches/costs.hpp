// The instructions of everything that a page says the cost of, each with its limit: the one table of both.
#pragma once

#include "asperity.h"
#include "kinds_of_load.hpp"
#include "surfaces.hpp"

#include <functional>
#include <string>
#include <vector>

// So much work, told for one in a unit of so many instructions.
struct Cost {
    std::string name;
    double limit;
    const char *unit;
    double count;
    std::function<void()> pass;
};

class Costs {
public:
    Costs() : histogram_(100), model_(make_model(default_surface())), load_(kContacts), gap_(kContacts), value_(kContacts), slope_(kContacts) {
        const std::vector<Surface> surfaces = all_surfaces();
        const auto named = [&](const char *name) {
            for (const Surface &surface : surfaces)
                if (surface.name == name) return surface.params;
            std::abort();
        };
        made("default", 6.5, default_surface());
        made("Hertz", 4.2, named("no adhesion (Hertz)"));
        made("skew 1", 17, named("skew 1"));
        made("epsilon .5", 29.5, named("epsilon .5"));
        const asperity_params plastic = estimated("pair = \"steel/steel\"\n", "Sq = 0.4e-6\nSdq = 0.1\n");
        asperity_params elastic = plastic;
        elastic.contact_law = ASPERITY_CONTACT_MAUGIS;
        made("Sq and Sdq, elastic", 18.4, elastic);
        made("Sq and Sdq, plastic", 27.8, plastic);
        const std::string skewed = "Sq = 0.4e-6\nSdq = 0.1\nSsk = -1\nSku = 5\n";
        made("skewed at 13 scores", 53, estimated("pair = \"steel/steel\"\n", skewed));
        made("Sq and Sdq, adhesive", 47, estimated("pair = \"Si/Si\"\n", "Sq = 5e-9\nSdq = 0.02\n"));
        made("100 bins", 184, histogram_.params());
        calls();
    }

    const std::vector<Cost> &all() const { return costs_; }
    const std::vector<Surface> &surfaces() const { return surfaces_; }

private:
    static constexpr size_t kContacts = 256;
    // Parameters as an estimate takes them.
    static asperity_params estimated(const std::string &bodies, const std::string &roughness) {
        const std::string text = bodies + "nominal_area = 1e-8\n[roughness]\n" + roughness;
        asperity_params params;
        require(asperity_params_init(&params, sizeof params));
        require(asperity_params_set_text(&params, text.data(), text.size()));
        return params;
    }

    void add(const std::string &name, double limit, const char *unit, double count, std::function<void()> pass) {
        costs_.push_back({name, limit, unit, count, std::move(pass)});
    }

    void made(const std::string &name, double limit, const asperity_params &params) {
        surfaces_.push_back({name, params});
        add("a model: " + name, limit, "million", 1, [params] { make_model(params); });
    }

    // One call for each contact, by its index.
    template <class Call> void each(const char *name, double limit, Call call) {
        add(name, limit, "", double(kContacts), [call] {
            double sum = 0.0;
            for (size_t i = 0; i < kContacts; ++i) sum += call(i);
            asm volatile("" : : "r"(&sum) : "memory");
        });
    }

    void batch(const char *name, double limit, std::function<asperity_status()> call) {
        add(name, limit, "", double(kContacts), [call] { require(call()); });
    }

    void calls() {
        const asperity_model *const model = model_.get();
        const double sigma = default_surface().height_std;
        for (size_t i = 0; i < kContacts; ++i) {
            const double part = (double(i) + 0.5) / kContacts;
            // Not in order, as in a solver.
            load_[i * 77 % kContacts] = 0.1 * std::pow(1e3, part);
            gap_[i * 77 % kContacts] = sigma * (4.0 - 8.0 * part);
        }
        each("mu at a load", 59, [this, model](size_t i) { return asperity_friction_at_load(model, load_[i]); });
        each("F at a load", 58, [this, model](size_t i) { return asperity_friction_force_at_load(model, load_[i]); });
        each("mu and its slope", 91, [this, model](size_t i) {
            return asperity_friction_and_slope_at_load(model, load_[i], &slope_[i]);
        });
        each("F and its slope", 80, [this, model](size_t i) {
            return asperity_friction_force_and_slope_at_load(model, load_[i], &slope_[i]);
        });
        each("load at a gap", 62, [this, model](size_t i) { return asperity_load_and_slope_at_gap(model, gap_[i], nullptr); });
        each("load at a gap and its slope", 94,
             [this, model](size_t i) { return asperity_load_and_slope_at_gap(model, gap_[i], &slope_[i]); });
        batch("mu in a batch", 26, [this, model] { return asperity_friction_at_loads(model, kContacts, load_.data(), value_.data(), nullptr); });
        batch("F in a batch", 22,
              [this, model] { return asperity_friction_force_at_loads(model, kContacts, load_.data(), value_.data(), nullptr); });
        batch("mu and its slope in a batch", 36,
              [this, model] { return asperity_friction_at_loads(model, kContacts, load_.data(), value_.data(), slope_.data()); });
        batch("F and its slope in a batch", 33,
              [this, model] { return asperity_friction_force_at_loads(model, kContacts, load_.data(), value_.data(), slope_.data()); });
        batch("load at a gap in a batch", 33,
              [this, model] { return asperity_loads_at_gaps(model, kContacts, gap_.data(), value_.data(), nullptr); });
        steps("stuck", 830, 1e-5, 1.0);
        steps("slipping", 2390, 3.0, 1.0);
        steps("stuck under changing load", 2650, 1e-5, 1.1);
        steps("slipping under changing load", 3340, 0.1, 1.1);
        // The first of a model finds out more.
        for (const char *name : {"the first exact state of a model", "an exact state"}) {
            add(name, name[0] == 't' ? 0.65 : 0.071, "million", 1, [model] {
                asperity_state state;
                state.struct_size = sizeof state;
                require(asperity_state_at_load(model, 3.7, &state));
            });
        }
        text("summits", 2.7, "pair = \"steel/steel\"\nnominal_area = 1e-4\nheight_std = 1e-6\nsummit_radius = 1e-5\nsummit_density = 1e9\n");
        text("Sq and Sdq", 45, "pair = \"steel/steel\"\nnominal_area = 1e-4\n[roughness]\nSq = 0.4e-6\nSdq = 0.1\n");
        estimate("of metal", 24, "pair = \"steel/steel\"\nnominal_area = 1e-4\nmeasured = [1000, 0.16]\n"
                                 "[roughness]\nRa = 0.8e-6\nprocess = \"ground\"\n", {1.0, 10.0, 100.0, 1000.0});
        estimate("of what adheres", 57, "pair = \"Si/Si\"\nnominal_area = 1e-8\nmeasured = [1e-3, 0.3]\n"
                                         "[roughness]\nSq = 5e-9\nSdq = 0.05\n", {1e-5, 1e-4, 1e-3, 1e-2});
        estimate("of one device", 95, "specimens = 1\npair = \"Si/Si\"\nnominal_area = 60e-12\nmeasured = [1e-5, 0.27]\n"
                                       "[roughness]\nSq = 12e-9\nSdq = 0.2\n", {1e-6, 1e-5, 1e-4, 1e-3});
    }

    void estimate(const std::string &of, double limit, const std::string &text, const std::vector<double> &load) {
        add("an estimate at 4 loads " + of, limit, "million", 1, [text, load] {
            std::vector<asperity_estimate> found(load.size());
            for (asperity_estimate &one : found) one.struct_size = sizeof one;
            require(asperity_estimate_at_loads(text.data(), text.size(), load.size(), load.data(), found.data()));
        });
    }

    void text(const std::string &of, double limit, const std::string &text) {
        add("parameters from a text of " + of, limit, "million", 1, [text] {
            asperity_params params;
            require(asperity_params_init(&params, sizeof params));
            require(asperity_params_set_text(&params, text.data(), text.size()));
        });
    }

    // Steps of displacements of F/K_t times a part along one direction, the load of each second times a factor, after one that
    // begins the contact.
    void steps(const std::string &name, double limit, double part, double factor) {
        constexpr int kSteps = 32;
        const asperity_model *const model = model_.get();
        add("a step of a contact that remembers: " + name, limit, "", kSteps, [=] {
            double state[64] = {0.0};
            const double load = 10.0;
            const double length = asperity_friction_force_at_load(model, load) / asperity_tangential_stiffness_at_load(model, load);
            asperity_microslip out;
            out.struct_size = sizeof out;
            const double by[2] = {part * length, 0.0};
            for (int i = 0; i < kSteps; ++i)
                require(asperity_microslip_step(model, i % 2 ? factor * load : load, by, state, state, &out));
        });
    }

    Histogram histogram_;
    Model model_;
    std::vector<double> load_, gap_, value_, slope_;
    std::vector<Surface> surfaces_;
    std::vector<Cost> costs_;
};
