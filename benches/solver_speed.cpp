// What friction costs a solver: the library's calls against exp of libm, against tables that an engineer would write and against a
// constant, all timed in one run; making a model; two threads; many models. Prints Markdown.
#include "costs.hpp"
#include "interleaved.hpp"
#include "rivals.hpp"

#include <atomic>
#include <random>
#include <thread>

namespace {

constexpr double kLightest = 1e-3, kHeaviest = 1e3;
constexpr size_t kLoads = 16384;
constexpr Schedule kFastCalls = {9, 25, 3e-4}, kSlowCalls = {7, 3, 1e-4}, kManyModels = {7, 3, 1e-3};

// Keeps the compiler from dropping or merging passes.
void used(const std::vector<double> &values) { asm volatile("" : : "r"(values.data()) : "memory"); }

template <class Function>
void each(const std::vector<double> &in, std::vector<double> &out, const Function &function) {
    for (size_t i = 0; i < in.size(); ++i) out[i] = function(in[i]);
    used(out);
}

std::vector<double> random_numbers(size_t count, double from, double to) {
    std::mt19937_64 engine{20051};
    std::uniform_real_distribution<double> one(from, to);
    std::vector<double> numbers(count);
    for (double &number : numbers) number = one(engine);
    return numbers;
}

// In so many decades, and never outside by rounding.
std::vector<double> random_loads(size_t count, double lightest = kLightest, double heaviest = kHeaviest) {
    std::vector<double> loads = random_numbers(count, std::log(lightest), std::log(heaviest));
    for (double &load : loads) load = std::min(std::max(std::exp(load), lightest), heaviest);
    return loads;
}

std::string with_digits(const char *format, double value) {
    char text[64];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

std::string duration(double seconds) {
    if (seconds < 1e-6) return with_digits("%.2f ns", seconds * 1e9);
    return seconds < 1e-3 ? with_digits("%.1f us", seconds * 1e6) : with_digits("%.2f ms", seconds * 1e3);
}

std::string spread(const Spread &s) {
    return with_digits("%.3g", s.median) + " (" + with_digits("%.3g", s.least) + " to " + with_digits("%.3g", s.most) + ")";
}

// ---- calls of a solver's loop, and what stands for them without the library

// A contact that remembers moves by up to half of F/K_t in any direction, so that some of its levels slip.
class Contacts {
public:
    explicit Contacts(const asperity_model *model)
        : load_(random_loads(kCount)), by_(2 * kCount), state_(kCount * asperity_microslip_length(model)), force_(2 * kCount), stiffness_(4 * kCount) {
        const std::vector<double> part = random_numbers(2 * kCount, -0.5, 0.5);
        for (size_t i = 0; i < 2 * kCount; ++i) {
            const double load = load_[i / 2];
            by_[i] = part[i] * asperity_friction_force_at_load(model, load) / asperity_tangential_stiffness_at_load(model, load);
        }
    }
    Contestant steps(const asperity_model *model) {
        return {"a step of a contact that remembers, in a batch", double(kCount), [this, model] {
                    for (double &one : by_) one = -one;
                    require(asperity_microslip_steps(model, kCount, load_.data(), by_.data(), state_.data(), state_.data(), force_.data(),
                                                     stiffness_.data()));
                }};
    }

private:
    static constexpr size_t kCount = 1024;
    std::vector<double> load_, by_, state_, force_, stiffness_;
};

double report_fast_calls() {
    const Model model = make_model(default_surface());
    const asperity_model *const m = model.get();
    const std::vector<double> load = random_loads(kLoads), exponent = random_numbers(kLoads, -10.0, 10.0);
    std::vector<double> value(kLoads), slope(kLoads);
    const auto force = [m](double p) { return asperity_friction_force_at_load(m, p); };
    const auto dforce = [m](double p) {
        double dforce_dload;
        asperity_friction_force_and_slope_at_load(m, p, &dforce_dload);
        return dforce_dload;
    };
    const EvenCubic cubic = accurate([&](size_t n) { return EvenCubic(force, dforce, kLightest, kHeaviest, n); }, force, kLightest,
                                     kHeaviest, 64, summary_of(model).table_error);
    const LinearTable linear(force, kLightest, kHeaviest, 1000);
    // Read at every pass, so that it is no constant to the compiler.
    static volatile double coulomb_mu = 0.5;
    Contacts contacts(m);

    const double n = double(kLoads);
    const auto scalar = [&](const char *name, const auto &call) { return Contestant{name, n, [&load, &value, call] { each(load, value, call); }}; };
    const auto batch = [&](const char *name, auto call, bool has_slope) {
        return Contestant{name, n, [&, m, call, has_slope] { require(call(m, kLoads, load.data(), value.data(), has_slope ? slope.data() : nullptr)); }};
    };
    const std::string knots = ", " + std::to_string(cubic.knots()) + " knots";
    const Interleaved times(
        {{"exp", n, [&] { each(exponent, value, [](double x) { return std::exp(x); }); }},
         scalar("mu", [m](double p) { return asperity_friction_at_load(m, p); }),
         scalar("F", force),
         scalar("mu and its slope", [m, &slope](double p) { return asperity_friction_and_slope_at_load(m, p, slope.data()); }),
         scalar("F and its slope", [m, &slope](double p) { return asperity_friction_force_and_slope_at_load(m, p, slope.data()); }),
         batch("mu in a batch", asperity_friction_at_loads, false),
         batch("F in a batch", asperity_friction_force_at_loads, false),
         batch("F and its slope in a batch", asperity_friction_force_at_loads, true),
         contacts.steps(m),
         scalar("cubic table of F", [&cubic](double p) { return cubic(p); }),
         {"cubic table of F in a batch", n, [&] { cubic.batch(load, value); used(value); }},
         scalar("linear table of F, 1000 knots", [&linear](double p) { return linear(p); }),
         {"a constant times the load", n, [&] { each(load, value, [mu = double(coulomb_mu)](double p) { return mu * p; }); }}},
        kFastCalls);

    const auto median = [&](const char *name, const char *other) { return times.ratio(name, other).median; };
    std::printf("- A scalar call costs %.2f `exp`: it returns the friction coefficient at a load; with its slope %.2f, the force with its slope %.2f.\n"
                "- A contact in a batch costs %.2f `exp`, the force with its slope %.2f.\n"
                "- A cubic table of your own, well written and as accurate, takes %.1f times as long per call and %.1f times in a batch.\n",
                median("mu", "exp"), median("mu and its slope", "exp"), median("F and its slope", "exp"), median("mu in a batch", "exp"),
                median("F and its slope in a batch", "exp"), median("cubic table of F", "F"), median("cubic table of F in a batch", "F in a batch"));
    std::printf("\n| call | time | in calls of `exp`: median (least to most) |\n|---|---|---|\n");
    for (const std::string &name : times.names())
        std::printf("| %s%s | %s | %s |\n", name.c_str(), name == "cubic table of F" ? knots.c_str() : "",
                    duration(times.seconds(name).median).c_str(), spread(times.ratio(name, "exp")).c_str());
    return times.seconds("exp").median;
}

// ---- models

void report_models(double exp_seconds) {
    const Costs costs;
    std::vector<Contestant> calls;
    for (const Surface &surface : costs.surfaces())
        calls.push_back({surface.name, 1, [&surface] { make_model(surface.params); }});
    const Interleaved times(std::move(calls), kSlowCalls);
    std::printf("\n| a model | time to make it | KiB |\n|---|---|---|\n");
    for (const Surface &surface : costs.surfaces())
        std::printf("| %s | %s | %.0f |\n", surface.name.c_str(), duration(times.seconds(surface.name).median).c_str(),
                    bytes_of(surface.params) / 1024.0);

    const Surface &measured = *std::find_if(costs.surfaces().begin(), costs.surfaces().end(),
                                            [](const Surface &surface) { return surface.name == "Sq and Sdq, plastic"; });
    std::printf("\n| models from Sq and Sdq, each asked for one contact in turn | in calls of `exp` |\n|---|---|\n");
    for (size_t count : {1, 100, 10000}) {
        std::vector<Model> models;
        for (size_t i = 0; i < count; ++i) {
            asperity_params params = measured.params;
            params.height_std *= 1.0 + double(i) / double(count);
            models.push_back(make_model(params));
        }
        const std::vector<double> load = random_loads(10000, 1e-2, 1e2);
        std::vector<double> mu(load.size());
        const Interleaved passes({{"mu", double(load.size()), [&] {
                                       for (size_t i = 0; i < load.size(); ++i) mu[i] = asperity_friction_at_load(models[i % count].get(), load[i]);
                                       used(mu);
                                   }}}, kManyModels);
        std::printf("| %zu | %.3g |\n", count, passes.seconds("mu").median / exp_seconds);
    }
}

// ---- two threads

// Seconds of so many threads for batches of their own on one model.
double seconds_of(const asperity_model *model, size_t count) {
    std::atomic<size_t> ready{0};
    std::vector<double> start(count), end(count);
    std::vector<std::thread> threads;
    for (size_t t = 0; t < count; ++t) {
        threads.emplace_back([&, t] {
            const std::vector<double> load = random_loads(kLoads);
            std::vector<double> mu(kLoads);
            const auto pass = [&] { require(asperity_friction_at_loads(model, kLoads, load.data(), mu.data(), nullptr)); };
            pass();
            ++ready;
            while (ready < count) {
            }
            start[t] = now();
            for (int i = 0; i < 50; ++i) pass();
            end[t] = now();
        });
    }
    for (std::thread &thread : threads) thread.join();
    return *std::max_element(end.begin(), end.end()) - *std::min_element(start.begin(), start.end());
}

void report_threads() {
    const Model model = make_model(default_surface());
    double one = HUGE_VAL, two = HUGE_VAL;
    for (int i = 0; i < 300; ++i) {
        one = std::min(one, seconds_of(model.get(), 1));
        two = std::min(two, seconds_of(model.get(), 2));
    }
    std::printf("\nTwo threads on one model do %.1f times the work of one: the fastest of 300 trials of each.\n", 2.0 * one / two);
}

}  // namespace

int main() {
    report_models(report_fast_calls());
    report_threads();
    return 0;
}
