// What friction costs a solver: the library's calls against libm exp, a GSL spline, a linear table and a Coulomb
// constant, all timed in one run; accuracy of the compiled law; memory and growth of cost. Prints Markdown.
//
// usage: solver_speed PLOT.svg              measure everything
//        solver_speed --microslip           contacts that remember alone
//        solver_speed --list                what can be counted: name, calls per pass, passes to add
//        solver_speed --only NAME PASSES    so many passes of one of them

#include "gap.hpp"
#include "interleaved.hpp"
#include "kinds_of_load.hpp"
#include "log_log_plot.hpp"
#include "microslip.hpp"
#include "rivals.hpp"
#include "surfaces.hpp"

#include <atomic>
#include <cmath>
#include <random>
#include <thread>

namespace {

constexpr double kLightest = 1e-3, kHeaviest = 1e3;
constexpr size_t kLoads = 16384;
constexpr Schedule kFastCalls = {9, 25, 3e-4};
constexpr Schedule kSlowCalls = {7, 3, 1e-4};
constexpr Schedule kGrowth = {7, 3, 1e-3};

// Keeps the compiler from dropping or merging passes.
void used(const std::vector<double> &values) { asm volatile("" : : "r"(values.data()) : "memory"); }

template <class Function>
void each(const std::vector<double> &in, std::vector<double> &out, const Function &function) {
    for (size_t i = 0; i < in.size(); ++i) out[i] = function(in[i]);
    used(out);
}

class Random {
public:
    double uniform(double from, double to) { return std::uniform_real_distribution<double>(from, to)(engine_); }
    double log_uniform(double from, double to) {
        return std::min(std::max(std::exp(uniform(std::log(from), std::log(to))), from), to);
    }

private:
    std::mt19937_64 engine_{20051};
};

std::vector<double> random_loads(size_t count) {
    Random random;
    std::vector<double> loads(count);
    for (double &load : loads) load = random.log_uniform(kLightest, kHeaviest);
    return loads;
}

// What a solver has: a model, the loads of its contacts, room for what it asks.
struct Solver {
    Model model = make_model(default_surface());
    std::vector<double> load, close_load, value, slope, exponent;

    explicit Solver(size_t contacts)
        : load(random_loads(contacts)), close_load(contacts), value(contacts), slope(contacts), exponent(contacts) {
        Random random;
        for (double &p : close_load) p = random.uniform(1.0, 1.01);
        for (double &x : exponent) x = random.uniform(-10.0, 10.0);
    }
    double contacts() const { return double(load.size()); }

    void batch_mu() { batch_mu_of(load); }
    void batch_mu_of(const std::vector<double> &loads) {
        require(asperity_friction_at_loads(model.get(), loads.size(), loads.data(), value.data(), nullptr));
    }
    void batch_force() {
        require(asperity_friction_force_at_loads(model.get(), load.size(), load.data(), value.data(), nullptr));
    }
    void batch_force_and_slope() {
        require(asperity_friction_force_at_loads(model.get(), load.size(), load.data(), value.data(), slope.data()));
    }
    void batch_mu_and_slope() {
        require(asperity_friction_at_loads(model.get(), load.size(), load.data(), value.data(), slope.data()));
    }
};

std::vector<Contestant> library_calls(Solver &s) {
    const asperity_model *model = s.model.get();
    const double n = s.contacts();
    const auto scalar = [&s, n, model](const char *name, double (*call)(const asperity_model *, double)) {
        return Contestant{name, n, [&s, model, call] {
                              each(s.load, s.value, [model, call](double load) { return call(model, load); });
                          }};
    };
    return {
        {"exp", n, [&s] { each(s.exponent, s.value, [](double x) { return std::exp(x); }); }},
        scalar("scalar mu", asperity_friction_at_load),
        scalar("scalar F", asperity_friction_force_at_load),
        {"batch mu", n, [&s] { s.batch_mu(); }},
        {"batch mu, loads within 1 %", n, [&s] { s.batch_mu_of(s.close_load); }},
        {"batch F", n, [&s] { s.batch_force(); }},
        {"batch F and dF/dP", n, [&s] { s.batch_force_and_slope(); }},
        {"batch mu and dmu/dP", n, [&s] { s.batch_mu_and_slope(); }},
    };
}

// ---- rows of tables

const char *verdict(bool met) { return met ? "met" : "**MISSED**"; }

std::string with_digits(const char *format, double value) {
    char text[64];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

std::string duration(double seconds) {
    if (seconds < 1e-6) return with_digits("%.2f ns", seconds * 1e9);
    if (seconds < 1e-3) return with_digits("%.1f us", seconds * 1e6);
    return with_digits("%.2f ms", seconds * 1e3);
}

std::string number(double value) {
    if (value < 100.0) return with_digits("%.2f", value);
    return with_digits(value < 1e4 ? "%.0f" : "%.2e", value);
}

std::string spread(const Spread &s) {
    return number(s.median) + " (" + number(s.least) + " to " + number(s.most) + ")";
}

void row(const std::string &what, const std::string &time, const Spread &ratio, double limit) {
    std::printf("| %s | %s | %s | %s | %s |\n", what.c_str(), time.c_str(), spread(ratio).c_str(),
                limit > 0.0 ? number(limit).c_str() : "", limit > 0.0 ? verdict(ratio.median <= limit) : "");
}

// ---- against exp

struct Rivals {
    Law law;
    std::unique_ptr<GslSpline> gsl_force, gsl_log_force;
    std::unique_ptr<LinearTable> linear_1000, linear_accurate;
    std::unique_ptr<EvenCubic> even_cubic;

    explicit Rivals(const Model &model)
        : law([m = model.get()](double load) { return asperity_friction_force_at_load(m, load); }) {
        const auto gsl = [this](GslSpline::Of of) {
            const auto make = [this, of](size_t n) {
                return std::make_unique<GslSpline>(law, kLightest, kHeaviest, n, of);
            };
            return accurate(make, law, kLightest, kHeaviest, 16, 1e-8);
        };
        const auto linear = [this](size_t n) { return std::make_unique<LinearTable>(law, kLightest, kHeaviest, n); };
        gsl_force = gsl(GslSpline::Of::Force);
        gsl_log_force = gsl(GslSpline::Of::LogForce);
        const auto slope = [m = model.get()](double load) {
            double dforce_dload;
            asperity_friction_force_and_slope_at_load(m, load, &dforce_dload);
            return dforce_dload;
        };
        const auto even = [&](size_t n) { return std::make_unique<EvenCubic>(law, slope, kLightest, kHeaviest, n); };
        even_cubic = accurate(even, law, kLightest, kHeaviest, 64, 1e-9);
        linear_1000 = linear(1000);
        linear_accurate = accurate(linear, law, kLightest, kHeaviest, 1000, 1e-6);
    }

    template <class Rival>
    double error(const Rival &rival) const {
        return error_of(rival, law, kLightest, kHeaviest);
    }
};

std::vector<Contestant> rival_calls(Solver &s, const Rivals &rivals) {
    const double n = s.contacts();
    const auto over_loads = [&s, n](const char *name, const auto &rival) {
        return Contestant{name, n, [&s, &rival] { each(s.load, s.value, rival); }};
    };
    // Read at every pass, so that it is no constant to the compiler.
    static volatile double coulomb_mu = 0.5;
    return {
        over_loads("gsl F", *rivals.gsl_force),
        over_loads("gsl ln F", *rivals.gsl_log_force),
        over_loads("even cubic", *rivals.even_cubic),
        {"even cubic batch", n,
         [&s, &rivals] {
             rivals.even_cubic->batch(s.load, s.value);
             used(s.value);
         }},
        over_loads("linear 1000", *rivals.linear_1000),
        over_loads("linear 1e-6", *rivals.linear_accurate),
        {"coulomb", n, [&s] { each(s.load, s.value, [mu = double(coulomb_mu)](double load) { return mu * load; }); }},
    };
}

// One set's create, set_params and exact state; set_params gets other values each time.
std::vector<Contestant> slow_calls(const Surface &surface, asperity_model *model, const std::vector<double> &loads) {
    return {
        {"create " + surface.name, 1, [&surface] { make_model(surface.params); }},
        {"set_params " + surface.name, 1,
         [&surface, model, turn = 0]() mutable {
             asperity_params params = surface.params;
             params.summit_radius *= 1.0 + 1e-3 * (turn++ % 5);
             require(asperity_set_params(model, &params));
         }},
        {"exact state " + surface.name, 1,
         [&loads, model, turn = size_t(0)]() mutable {
             asperity_state state;
             state.struct_size = sizeof state;
             require(asperity_state_at_load(model, loads[turn++ % loads.size()], &state));
         }},
    };
}

void report_slow_calls(const Interleaved &times, const std::vector<Surface> &surfaces) {
    std::printf("\n### Making a model, and exact states\n\n"
                "Times, and in brackets in `exp` calls: median (least to most).\n\n"
                "| surfaces | create | set_params | limit | | exact state at a load | limit | |\n"
                "|---|---|---|---|---|---|---|---|\n");
    for (const Surface &surface : surfaces) {
        const double make_limit = surface.equal_radii() ? 6.6e5 : 2.25e6;
        const double state_limit = surface.equal_radii() ? 1.5e4 : 1.5e5;
        const auto cell = [&](const char *call) {
            const std::string name = call + surface.name;
            return duration(times.seconds(name).median) + " [" + spread(times.ratio(name, "exp")) + "]";
        };
        const auto in_exp = [&](const char *call) { return times.ratio(call + surface.name, "exp").median; };
        std::printf("| %s | %s | %s | %s | %s | %s | %s | %s |\n", surface.name.c_str(), cell("create ").c_str(),
                    cell("set_params ").c_str(), number(make_limit).c_str(),
                    verdict(std::max(in_exp("create "), in_exp("set_params ")) <= make_limit),
                    cell("exact state ").c_str(), number(state_limit).c_str(),
                    verdict(in_exp("exact state ") <= state_limit));
    }
}

void report_against_exp(const Interleaved &times) {
    std::printf("### Against one call of libm `exp`\n\n"
                "| call | time | in `exp` calls: median (least to most) | limit | |\n|---|---|---|---|---|\n");
    struct {
        const char *name;
        double limit;
    } const calls[] = {
        {"exp", 0},
        {"scalar mu", 1.0},
        {"scalar F", 0},
        {"batch mu", 0.4},
        {"batch mu, loads within 1 %", 0},
        {"batch F", 0},
        {"batch F and dF/dP", 0.7},
        {"batch mu and dmu/dP", 0},
    };
    for (const auto &call : calls)
        row(call.name, duration(times.seconds(call.name).median), times.ratio(call.name, "exp"), call.limit);
}

void report_rivals(const Interleaved &times, const Rivals &rivals) {
    std::printf("\n### Against a table of one's own\n\n"
                "Friction force, the same loads, loop and repetitions. How many times slower than the library:\n\n"
                "| instead of the library | error | time | than batch F: median (least to most) | limit "
                "| | than scalar F |\n|---|---|---|---|---|---|---|\n");
    const auto rival_row = [&times](const std::string &what, const char *name, double error, double limit) {
        const Spread batch = times.ratio(name, "batch F"), scalar = times.ratio(name, "scalar F");
        std::printf("| %s | %s | %s | %s | %s | %s | %s |\n", what.c_str(),
                    error > 0.0 ? with_digits("%.1e", error).c_str() : "", duration(times.seconds(name).median).c_str(),
                    spread(batch).c_str(), limit > 0.0 ? number(limit).c_str() : "",
                    limit > 0.0 ? verdict(batch.median >= limit) : "", spread(scalar).c_str());
    };
    const auto knots = [](const auto &rival) { return std::to_string(rival.knots()) + " knots"; };
    // The limit is for the cheaper of the two.
    const bool force_is_cheaper = times.seconds("gsl F").median < times.seconds("gsl ln F").median;
    rival_row("GSL cubic spline of F over ln P, " + knots(*rivals.gsl_force), "gsl F", rivals.error(*rivals.gsl_force),
              force_is_cheaper ? 25.0 : 0.0);
    rival_row("GSL cubic spline of ln F over ln P, " + knots(*rivals.gsl_log_force), "gsl ln F",
              rivals.error(*rivals.gsl_log_force), force_is_cheaper ? 0.0 : 25.0);
    rival_row("cubic Hermite, even in ln P, index from `log`, " + knots(*rivals.even_cubic), "even cubic",
              rivals.error(*rivals.even_cubic), 0.0);
    rival_row("the same over arrays, logarithms first", "even cubic batch", rivals.error(*rivals.even_cubic), 0.0);
    rival_row("`std::lower_bound`, linear, " + knots(*rivals.linear_1000), "linear 1000",
              rivals.error(*rivals.linear_1000), 1.0);
    rival_row("`std::lower_bound`, linear, " + knots(*rivals.linear_accurate), "linear 1e-6",
              rivals.error(*rivals.linear_accurate), 1.0);
    rival_row("Coulomb, `mu * load`", "coulomb", 0.0, 0.0);
}

// ---- accuracy

constexpr double kForceLimit = 1e-8, kSlopeLimit = 1e-6;

struct Accuracy {
    double force = 0.0, slope = 0.0;      // largest relative errors
    double mean = 0.0, scatter = 0.0;     // of dF/dP, the largest around loads where it is above its limit
    size_t without_state = 0;         // loads that the exact evaluation refused
};

// Exact states at loads so near to another, in ln(load - pull-off), that neither law nor table change but evenly.
struct Neighbours {
    double mean;     // error of dF/dP of the table, averaged
    double scatter;  // of dF/dP of the exact states about a smooth curve, relative: by fourth differences
};

Neighbours neighbours_of(const asperity_model *model, double pull_off, double load) {
    constexpr size_t kCount = 25;
    constexpr double kApart = 2e-4;
    std::vector<double> exact(kCount);
    double sum = 0.0, squares = 0.0;
    for (size_t i = 0; i < kCount; ++i) {
        const double near = pull_off + (load - pull_off) * std::exp(kApart * (double(i) - double(kCount / 2)));
        asperity_state state;
        state.struct_size = sizeof state;
        require(asperity_state_at_load(model, near, &state));
        // Near pull-off dF/dP falls as the root of the distance, which has few digits: times that it is smooth.
        exact[i] = state.dforce_dload * std::sqrt(near - pull_off);
        double slope;
        asperity_friction_force_and_slope_at_load(model, near, &slope);
        sum += slope / state.dforce_dload - 1.0;
    }
    for (size_t i = 2; i + 2 < kCount; ++i) {
        const double difference = exact[i - 2] - 4 * exact[i - 1] + 6 * exact[i] - 4 * exact[i + 1] + exact[i + 2];
        squares += difference * difference / (exact[i] * exact[i]);
    }
    return {std::fabs(sum) / double(kCount), std::sqrt(squares / (70.0 * double(kCount - 4)))};
}

// Loads spaced evenly at random in the logarithm of load - pull-off.
Accuracy accuracy_over(const asperity_model *model, double pull_off, double nearest, double farthest, size_t count) {
    Random random;
    std::vector<double> loads(count), force(count), slope(count);
    for (double &load : loads) load = pull_off + random.log_uniform(nearest, farthest);
    require(asperity_friction_force_at_loads(model, count, loads.data(), force.data(), slope.data()));
    Accuracy accuracy;
    for (size_t i = 0; i < count; ++i) {
        asperity_state exact;
        exact.struct_size = sizeof exact;
        if (asperity_state_at_load(model, loads[i], &exact) != ASPERITY_OK) {
            ++accuracy.without_state;
            continue;
        }
        accuracy.force = std::max(accuracy.force, std::fabs(force[i] / exact.friction_force - 1.0));
        const double slope_error = std::fabs(slope[i] / exact.dforce_dload - 1.0);
        accuracy.slope = std::max(accuracy.slope, slope_error);
        if (slope_error > kSlopeLimit) {
            const Neighbours neighbours = neighbours_of(model, pull_off, loads[i]);
            accuracy.mean = std::max(accuracy.mean, neighbours.mean);
            accuracy.scatter = std::max(accuracy.scatter, neighbours.scatter);
        }
    }
    return accuracy;
}

void report_accuracy(const std::vector<Surface> &surfaces, size_t count) {
    std::printf("\n### Accuracy of the compiled law\n\n"
                "Largest relative error against `asperity_state_at_load`, of %zu loads of the table. Where dF/dP is off by "
                "more than its limit, exact states at 25 loads next to it, 2e-4 apart in "
                "ln(load - pull-off), tell why: *scatter* is the standard deviation of their dF/dP from a smooth "
                "curve, by fourth differences, *mean* the error of the law's dF/dP averaged over them, which is then what the "
                "limit is for. Of several such loads the largest is given.\n\n"
                "| surfaces | pull-off load | the table's loads | error of F | limit | "
                "error of dF/dP | limit | scatter | mean | no exact state | |\n"
                "|---|---|---|---|---|---|---|---|---|---|---|\n",
                count);
    for (const Surface &surface : surfaces) {
        const Model model = make_model(surface.params);
        const asperity_summary summary = summary_of(model);
        const double pull_off = summary.pull_off_load, heaviest = summary.max_table_load - pull_off;
        const Accuracy table = accuracy_over(model.get(), pull_off, summary.min_table_load - pull_off, heaviest, count);
        const bool is_above = table.slope > kSlopeLimit;
        std::printf("| %s | %.3g | %.3g to %.3g | %.1e | %.0e | %.1e | %.0e | %s | %s | %zu | %s |\n",
                    surface.name.c_str(), pull_off, summary.min_table_load, summary.max_table_load,
                    table.force, kForceLimit, table.slope, kSlopeLimit,
                    is_above ? with_digits("%.1e", table.scatter).c_str() : "",
                    is_above ? with_digits("%.1e", table.mean).c_str() : "", table.without_state,
                    verdict(table.without_state == 0 && table.force <= kForceLimit &&
                            (is_above ? table.mean : table.slope) <= kSlopeLimit));
    }
}

// ---- two threads

struct ThreadTimes {
    double wall, processor;  // seconds per contact; of all contacts, of each thread's own
};

double processor_seconds() {
    timespec time;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

// Each thread has arrays of its own; they share the model.
ThreadTimes threads_on(const asperity_model *model, size_t count, int passes) {
    std::atomic<size_t> ready{0};
    std::vector<double> start(count), end(count), processor(count);
    std::vector<std::thread> threads;
    for (size_t t = 0; t < count; ++t) {
        threads.emplace_back([&, t] {
            const std::vector<double> load = random_loads(kLoads);
            std::vector<double> mu(kLoads);
            const auto pass = [&] {
                require(asperity_friction_at_loads(model, kLoads, load.data(), mu.data(), nullptr));
            };
            pass();
            ++ready;
            while (ready < count) {
            }
            start[t] = now();
            const double processor_start = processor_seconds();
            for (int i = 0; i < passes; ++i) pass();
            processor[t] = processor_seconds() - processor_start;
            end[t] = now();
        });
    }
    for (std::thread &thread : threads) thread.join();
    const double wall = *std::max_element(end.begin(), end.end()) - *std::min_element(start.begin(), start.end());
    const double contacts = double(passes) * double(kLoads);
    return {wall / (double(count) * contacts), *std::max_element(processor.begin(), processor.end()) / contacts};
}

void report_threads(const Model &model, int trials, int passes) {
    std::vector<double> one_wall, two_wall, speedup, processor;
    for (int i = 0; i < trials; ++i) {
        const ThreadTimes one = threads_on(model.get(), 1, passes), two = threads_on(model.get(), 2, passes);
        one_wall.push_back(one.wall);
        two_wall.push_back(two.wall);
        speedup.push_back(one.wall / two.wall);
        processor.push_back(2.0 * one.processor / two.processor);
    }
    const double fastest = spread_of(one_wall).least / spread_of(two_wall).least;
    std::printf("\n### Two threads on one model\n\n"
                "Contacts per second of batch mu, two threads over one, %d trials.\n\n"
                "| | two over one | limit | |\n|---|---|---|---|\n"
                "| the fastest trial of each | %s | 1.9 | %s |\n"
                "| trials: median (least to most) | %s | | |\n"
                "| by processor time: median (least to most) | %s | | |\n",
                trials, number(fastest).c_str(), verdict(fastest >= 1.9), spread(spread_of(speedup)).c_str(),
                spread(spread_of(processor)).c_str());
}

// ---- memory and growth

std::string table_error_of(const asperity_params &params) {
    const Model model = make_model(params);
    asperity_summary summary;
    summary.struct_size = sizeof summary;
    require(asperity_summary_of(model.get(), &summary));
    char text[64];
    std::snprintf(text, sizeof text, "table_error %.1e", summary.table_error);
    return text;
}

void report_memory(const std::vector<Surface> &surfaces) {
    double most = 0.0;
    std::string set;
    for (const Surface &surface : surfaces) {
        const double bytes = bytes_of(surface.params);
        if (bytes > most) {
            most = bytes;
            set = surface.name;
        }
    }
    std::printf("\n### Memory of a model\n\n| | KiB | limit | |\n|---|---|---|---|\n| largest set: %s | %.1f | 64 | %s |\n",
                set.c_str(), most / 1024.0, verdict(most <= 64.0 * 1024.0));
    for (size_t bins : {20, 56, 100}) {
        const Histogram histogram(bins);
        std::printf("| heights as a histogram of %zu bins | %.1f | | %s |\n", bins, bytes_of(histogram.params()) / 1024.0,
                    table_error_of(histogram.params()).c_str());
    }
}

double seconds_per_pass(const std::function<void()> &pass) {
    return Interleaved({{"pass", 1, pass}}, kGrowth).seconds("pass").median;
}

Panel report_growth_with_contacts(size_t most) {
    std::printf("\n### Growth of cost with contacts\n\n| contacts in one batch call | ns per contact |\n|---|---|\n");
    Panel panel{"", "contacts per batch call", "time per contact [ns]", {}};
    for (size_t n = 1; n <= most; n *= 10) {
        Solver solver(n);
        const double ns = 1e9 * seconds_per_pass([&solver] { solver.batch_mu(); }) / double(n);
        std::printf("| %.0e | %.2f |\n", double(n), ns);
        panel.points.emplace_back(double(n), ns);
    }
    return panel;
}

Panel report_growth_with_models(size_t most) {
    constexpr size_t kContacts = 100;
    std::printf("\n### Growth of cost with models\n\nOne batch of %zu contacts for each model in turn.\n\n"
                "| models | ms per create | ns per contact |\n|---|---|---|\n", kContacts);
    Panel panel{"", "models, 100 contacts each", "time per contact [ns]", {}};
    for (size_t count = 1; count <= most; count *= 10) {
        const std::vector<double> load = random_loads(count * kContacts);
        std::vector<double> mu(load.size());
        std::vector<Model> models;
        const double start = now();
        for (size_t i = 0; i < count; ++i) {
            asperity_params params = default_surface();
            params.summit_radius *= 1.0 + double(i) / double(count);
            models.push_back(make_model(params));
        }
        const double create = (now() - start) / double(count);
        const double seconds = seconds_per_pass([&] {
            for (size_t i = 0; i < count; ++i) {
                const size_t first = i * kContacts;
                require(asperity_friction_at_loads(models[i].get(), kContacts, &load[first], &mu[first], nullptr));
            }
        });
        const double ns = 1e9 * seconds / double(count * kContacts);
        std::printf("| %.0e | %.3f | %.2f |\n", double(count), 1e3 * create, ns);
        panel.points.emplace_back(double(count), ns);
    }
    return panel;
}

// Returns the time of one call of exp in ns.
double report_times(const std::vector<Surface> &surfaces) {
    Solver solver(kLoads);
    const Rivals rivals(solver.model);
    std::vector<Contestant> fast = library_calls(solver), slow = {fast.front()};
    for (Contestant &call : rival_calls(solver, rivals)) fast.push_back(std::move(call));
    const Interleaved fast_times(std::move(fast), kFastCalls);
    report_against_exp(fast_times);
    report_rivals(fast_times, rivals);

    std::vector<Model> models;
    for (const Surface &surface : surfaces) {
        models.push_back(make_model(surface.params));
        for (Contestant &call : slow_calls(surface, models.back().get(), solver.load)) slow.push_back(std::move(call));
    }
    report_slow_calls(Interleaved(std::move(slow), kSlowCalls), surfaces);
    report_threads(solver.model, 300, 50);
    return 1e9 * fast_times.seconds("exp").median;
}

int measure(const std::string &plot) {
    const double start = now();
    const std::vector<Surface> surfaces = all_surfaces();
    const double exp_ns = report_times(surfaces);
    KindsOfLoad::report();
    MicroslipBench::report(surfaces);
    Gap::report();
    report_accuracy(surfaces, 6000);
    report_memory(surfaces);
    Panel contacts = report_growth_with_contacts(10000000), models = report_growth_with_models(10000);
    for (Panel *panel : {&contacts, &models}) {
        panel->level = exp_ns;
        panel->level_label = "one call of exp";
    }
    contacts.title = with_digits("In a large batch a contact costs %.2f exp", contacts.points.back().second / exp_ns);
    models.title = with_digits("With 10 000 models a contact costs %.1f exp", models.points.back().second / exp_ns);
    if (!LogLogPlot::write(plot, {contacts, models})) {
        std::fprintf(stderr, "solver_speed: cannot write %s\n", plot.c_str());
        return 1;
    }
    std::fprintf(stderr, "solver_speed: %.0f s\n", now() - start);
    return 0;
}

// ---- for counting instructions

int list() {
    Solver solver(kLoads);
    for (const Contestant &call : library_calls(solver)) std::printf("%s|%.0f|2\n", call.name.c_str(), call.calls);
    for (const Surface &surface : all_surfaces()) {
        std::printf("create %s|1|1\n", surface.name.c_str());
        std::printf("exact state %s|1|50\n", surface.name.c_str());
    }
    return 0;
}

int only(const std::string &name, int passes) {
    Solver solver(kLoads);
    const std::vector<Surface> surfaces = all_surfaces();
    std::vector<Contestant> calls = library_calls(solver);
    Model model;
    for (const Surface &surface : surfaces) {
        if (name == "exact state " + surface.name) model = make_model(surface.params);
        for (Contestant &call : slow_calls(surface, model.get(), solver.load)) calls.push_back(std::move(call));
    }
    for (const Contestant &call : calls) {
        if (call.name != name) continue;
        for (int i = 0; i < passes; ++i) call.pass();
        return 0;
    }
    std::fprintf(stderr, "solver_speed: no call '%s'\n", name.c_str());
    return 2;
}

}  // namespace

int main(int argc, char **argv) {
    if (argc == 2 && std::strcmp(argv[1], "--list") == 0) return list();
    if (argc == 2 && std::strcmp(argv[1], "--microslip") == 0) return MicroslipBench::report(all_surfaces()), 0;
    if (argc == 4 && std::strcmp(argv[1], "--only") == 0) return only(argv[2], std::atoi(argv[3]));
    if (argc == 2) return measure(argv[1]);
    std::fprintf(stderr, "usage: solver_speed PLOT.svg | --microslip | --list | --only NAME PASSES\n");
    return 2;
}
