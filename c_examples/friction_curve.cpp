// Friction coefficient of a polysilicon MEMS contact against normal load, in SI units: the twin of
// friction_curve.c, where the sources of the parameters are named. Both print the same table, to the digit, and the same
// warnings if the model does not hold somewhere between the two loads.
//
// usage: friction_curve [LOADS [LOWEST [HIGHEST]]]
//   LOADS    number of loads, 2 to 100000 (33)
//   LOWEST   lowest load [N], > 0 (2e-4)
//   HIGHEST  highest load [N], > LOWEST (0.1)
// Exit status: 0, 1 if the library refuses or the table cannot be written, 2 for a wrong command line.

#include <asperity.hpp>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

constexpr int MAX_LOADS = 100000;

struct Options {
    int loads = 33;
    double lowest = 2e-4, highest = 0.1;
};

/// Two polysilicon surfaces that touch over a nominal area of 100 um x 100 um.
asperity::Params polysilicon() {
    constexpr double burgers = 0.384e-9;    // b [m]
    constexpr double density = 1e13;        // summits [1/m^2]
    constexpr double nominal_area = 1e-8;   // [m^2]

    asperity::Params params; // Model refuses what is forgotten here
    params.set_materials(160e9, 0.22, 160e9, 0.22); // [Pa]
    params.burgers_vector(burgers).adhesion_range(burgers);
    params.work_of_adhesion(0.063);         // [J/m^2]
    params.height_std(5e-9);                // [m]
    params.summit_radius(1e-6);             // [m]
    params.asperity_count(density * nominal_area);
    params.nominal_area(nominal_area).hardness(12e9); // [Pa]; these two are for warnings alone
    return params;
}

/// Loads evenly spaced in the logarithm.
std::vector<double> loads_of(const Options &options) {
    std::vector<double> loads;
    for (int i = 0; i < options.loads; ++i) {
        const double fraction = static_cast<double>(i) / (options.loads - 1);
        loads.push_back(options.lowest * std::pow(options.highest / options.lowest, fraction));
    }
    return loads;
}

void print_table(const asperity::Model &model, const std::vector<double> &loads) {
    const std::vector<double> mu = model.friction_at_load(loads);
    const std::vector<double> force = model.friction_force_at_load(loads);

    std::printf("# load [N], mu, friction force [N], real area [m^2], contacts\n");
    for (std::size_t i = 0; i < loads.size(); ++i) {
        const asperity::State state = model.state_at_load(loads[i]);
        std::printf("%.9e %.9e %.9e %.9e %.9e\n", loads[i], mu[i], force[i], state.real_area, state.contacting);
    }
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
        throw std::runtime_error("cannot write the table");
    }
}

/// Says what of the model does not hold at these loads, and what to do about it.
void print_warnings(const asperity::Model &model, double lightest, double heaviest) {
    const std::uint64_t warnings = model.check_loads(lightest, heaviest);
    for (std::uint64_t bit = 1; bit <= warnings; bit *= 2) {
        if ((warnings & bit) != 0) {
            std::fprintf(stderr, "friction_curve: warning: %s\n", asperity::warning_string(bit));
        }
    }
}

double number(const char *name, const std::string &text) {
    std::size_t end = 0;
    double value = 0.0;
    try {
        value = std::stod(text, &end);
    } catch (const std::logic_error &) { // not a number, or none that a double holds
        end = 0;
    }
    if (end == 0 || end != text.size() || !std::isfinite(value)) {
        throw std::invalid_argument(std::string(name) + " = '" + text + "': must be a finite number");
    }
    return value;
}

Options read_options(const std::vector<std::string> &arguments) {
    Options options;
    if (arguments.size() > 3) {
        throw std::invalid_argument(std::to_string(arguments.size()) + " arguments: at most 3");
    }
    if (!arguments.empty()) {
        const double loads = number("LOADS", arguments[0]);
        if (!(loads >= 2 && loads <= MAX_LOADS && loads == std::floor(loads))) {
            throw std::invalid_argument("LOADS = " + arguments[0] + ": must be a whole number, 2 to 100000");
        }
        options.loads = static_cast<int>(loads);
    }
    if (arguments.size() > 1) {
        options.lowest = number("LOWEST", arguments[1]);
    }
    if (arguments.size() > 2) {
        options.highest = number("HIGHEST", arguments[2]);
    }
    if (!(options.lowest > 0)) {
        throw std::invalid_argument("LOWEST: must be > 0, the loads are spaced in the logarithm");
    }
    if (!(options.highest > options.lowest && std::isfinite(options.highest / options.lowest))) {
        throw std::invalid_argument("HIGHEST: must be above LOWEST, and their ratio a finite number");
    }
    return options;
}

} // namespace

int main(int argc, char **argv) {
    try {
        const Options options = read_options({argv + 1, argv + argc});
        const asperity::Model model(polysilicon());
        print_table(model, loads_of(options));
        print_warnings(model, options.lowest, options.highest);
        return 0;
    } catch (const std::invalid_argument &error) {
        std::fprintf(stderr, "friction_curve: %s\nusage: friction_curve [LOADS [LOWEST [HIGHEST]]]\n", error.what());
        return 2;
    } catch (const std::exception &error) {
        std::fprintf(stderr, "friction_curve: %s\n", error.what());
        return 1;
    }
}
