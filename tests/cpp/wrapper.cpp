// What asperity.hpp promises, called from C++ with floating-point traps on.
//
// Reference figures: case "fig3 beta=1000 noncontacting=True" at separation 1 sigma of tests/reference/cases.json,
// which an independent program computed; loads there are in E* b^2, friction in G* b^2.

#include <asperity.hpp>
#include <asperity_eval.h>

#include <fenv.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <limits>
#include <string>
#include <thread>
#include <type_traits>
#include <vector>

#ifndef __GLIBC__ // whose function turns floating-point traps on
#define feenableexcept(exceptions) static_cast<void>(0)
#endif

namespace {

using asperity::Error;
using asperity::Model;
using asperity::Params;

int failures = 0;

void expect(bool holds, const char *claim, int line) {
    if (!holds) {
        std::fprintf(stderr, "tests/cpp/wrapper.cpp:%d: does not hold: %s\n", line, claim);
        ++failures;
    }
}

#define EXPECT(claim) expect(claim, #claim, __LINE__)

bool close(double value, double expected, double tolerance) {
    return std::fabs(value - expected) <= tolerance * std::fabs(expected);
}

/// The status and message that a call throws; ASPERITY_OK if it throws nothing.
template <class Call>
Error thrown_by(Call call) {
    try {
        call();
    } catch (const Error &error) {
        return error;
    }
    return Error(ASPERITY_OK, "nothing was thrown");
}

bool begins(const char *text, const char *with) { return std::strncmp(text, with, std::strlen(with)) == 0; }

constexpr double INF = std::numeric_limits<double>::infinity();
constexpr double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();

// ---- Versions and errors ----

void what_is_looked_up_is_a_string() {
    EXPECT(std::strcmp(asperity::version(), ASPERITY_VERSION) == 0 && asperity::abi_version() == ASPERITY_ABI_VERSION);
    EXPECT(std::strcmp(asperity::status_string(ASPERITY_OK), "success") == 0 && asperity::warnings_text(0) == "no warning");
    const std::vector<std::string> materials = asperity::names(asperity::Kind::materials);
    EXPECT(materials.size() > 20 && materials.front() == "Si");
    EXPECT(begins(asperity::describe(asperity::Kind::materials, "Si").c_str(), "name = \"Si\"\nyoung = "));
    EXPECT(thrown_by([] { (void)asperity::describe(asperity::Kind::materials, "stel"); }).status() == ASPERITY_INVALID_PARAMETER);
}

void an_error_carries_status_and_message() {
    const Error error = thrown_by([] { Model(Params::paper().height_std(-2.0)); });
    EXPECT(error.status() == ASPERITY_INVALID_PARAMETER);
    EXPECT(begins(error.what(), "height_std = -2: must be "));
    EXPECT(asperity::last_error() == error.what());

    const std::exception &base = error;
    EXPECT(std::strcmp(base.what(), error.what()) == 0);
    asperity::check(ASPERITY_OK);
    EXPECT(thrown_by([] { asperity::check(ASPERITY_SEPARATED); }).status() == ASPERITY_SEPARATED);

    std::string elsewhere = "not asked";
    std::thread([&] { elsewhere = asperity::last_error(); }).join();
    EXPECT(elsewhere.empty());
}

// ---- Parameters ----

/// Every setter of Params changes its own field of the C struct and no other.
template <class Value>
void field_is_set(Params &(Params::*set)(Value) noexcept, Value (Params::*get)() const noexcept, Value value,
                  std::size_t offset) {
    Params params;
    const Params before;
    EXPECT(&(params.*set)(value) == &params);
    EXPECT((params.*get)() == value);
    EXPECT((before.*get)() != value);

    std::array<unsigned char, sizeof(asperity_params)> bytes{}, old{};
    std::memcpy(bytes.data(), &params.c(), bytes.size());
    std::memcpy(old.data(), &before.c(), old.size());
    const std::size_t size = sizeof(Value) == sizeof(double) ? sizeof(double) : sizeof(std::int32_t);
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        EXPECT(bytes[i] == old[i] || (i >= offset && i < offset + size));
    }
}

#define FIELD(name, value) \
    field_is_set<decltype(Params().name())>(&Params::name, &Params::name, value, offsetof(asperity_params, name))

void each_setter_sets_its_own_field() {
    FIELD(composite_modulus, 3.5);
    FIELD(effective_shear_modulus, 3.5);
    FIELD(work_of_adhesion, 3.5);
    FIELD(adhesion_range, 3.5);
    FIELD(burgers_vector, 3.5);
    FIELD(height_std, 3.5);
    FIELD(summit_radius, 3.5);
    FIELD(asperity_count, 3.5);
    FIELD(height_distribution, asperity::Heights::weibull);
    FIELD(attraction, false);
    FIELD(weibull_shape, 2.0);
    FIELD(radius_amplitude, 0.25);
    FIELD(radius_rate, 2.0);
    FIELD(slip_radius_1, 30.0);
    FIELD(slip_stress_1, 0.02);
    FIELD(slip_radius_2, 9e4);
    FIELD(slip_stress_2, 7e-4);
    FIELD(max_friction_coefficient, INF);
    FIELD(skew, 0.5);
    FIELD(kurtosis, 4.0);
    FIELD(hardness, 9e9);
    FIELD(tangential_modulus, 3e10);
    FIELD(nominal_area, 1e-8);
    FIELD(contact_law, asperity::ContactLaw::elastic_plastic);
    FIELD(slip_onset, asperity::SlipOnset::whole);
    FIELD(pressure_coefficient, 0.1);
    FIELD(bandwidth, 3.0);
    FIELD(calibration_load, 20.0);
    FIELD(calibration_friction_force, 3.2);
    FIELD(calibration_error, 0.1);
    FIELD(summit_mean_height, 2e-9);
    FIELD(rms_slope, 0.1);
}

void a_table_is_copied_and_shared() {
    const std::vector<double> heights{1.0, 2.0, 3.0, 4.0, 5.0}, densities{0.0, 1.0, 2.0, 1.0, 0.0};
    EXPECT(Params().table_height().size() == 0 && Params().table_density().data() == nullptr);
    Params copy;
    {
        Params params = Params::paper();
        params.table(std::vector<double>(heights), std::vector<double>(densities));
        copy = params;
        params.table(densities, densities);
    }
    EXPECT(copy.height_distribution() == asperity::Heights::tabulated);
    EXPECT(copy.table_height().size() == 5 && copy.table_height().data()[4] == 5.0);
    EXPECT(copy.table_density().size() == 5 && copy.table_density().data()[2] == 2.0);
    EXPECT(copy.table_height().data() != heights.data());
    // From C and back: the copy has a table of its own.
    const Params again(copy.c());
    EXPECT(again.table_height().data() != copy.table_height().data() && again.table_density().data()[1] == 1.0);

    // The model copies it once more, and its parameters a last time.
    Params back;
    {
        const Model model(copy);
        EXPECT(std::fabs(model.summary().skew) < 1e-12 && model.friction_at_load(10.0) > 0.0);
        back = model.params();
    }
    EXPECT(back.table_height().data()[4] == 5.0 && back.table_density().data()[2] == 2.0);

    const Error error = thrown_by([&] { copy.table(heights, {densities.data(), 4}); });
    EXPECT(error.status() == ASPERITY_INVALID_PARAMETER);
    EXPECT(begins(error.what(), "size of densities = 4: must be the number of heights, 5"));
    EXPECT(copy.table_height().size() == 5);
}

void one_measured_point_sets_the_strength() {
    const Params before = Params::paper().calibration_error(0.1);
    Params params = before;
    params.calibrate(20.0, 0.16);
    EXPECT(close(Model(params).friction_at_load(20.0), 0.16, 1e-9));
    EXPECT(params.calibration_load() == 20.0 && close(params.calibration_friction_force(), 3.2, 1e-15));
    // The model remembers the measurement, an interface by its name forgets it.
    const Params kept = Model(params).params();
    EXPECT(kept.calibration_load() == 20.0 && kept.calibration_error() == 0.1);
    EXPECT(kept.calibration_friction_force() == params.calibration_friction_force());
    params.effective_shear_modulus(80e9).set_text("interface = \"MoS2 film in dry air\"");
    EXPECT(params.calibration_load() == 0.0 && params.calibration_friction_force() == 0.0);

    params = before;
    EXPECT(params.set({{"calibration_friction_coefficient", 0.16}, {"calibration_load", 20.0}}).slip_stress_1() ==
           kept.slip_stress_1());
    // Where nothing presses, the force: as much as it was.
    const double adhesive = Model(before).friction_force_at_load(0.0);
    EXPECT(close(Params(before).calibrate_force(0.0, 2.0 * adhesive).slip_stress_1(), 2.0 * before.slip_stress_1(), 1e-7));
}

void parameters_are_set_and_read_by_name() {
    Params params;
    EXPECT(params.set("hardness", 3.0).get("hardness") == 3.0);
    EXPECT(params.hardness() == 3.0);
    params.set({{"nu2", 0.22}, {"E1", 160e9}, {"nu1", 0.3}, {"E2", 70e9}, {"skew", -0.5}});
    EXPECT(params.composite_modulus() == Params().set_materials(160e9, 0.3, 70e9, 0.22).composite_modulus());
    EXPECT(params.height_distribution() == asperity::Heights::weibull && params.weibull_shape() != 3.602);
    Params copy;
    for (const std::string &name : asperity::names(asperity::Kind::parameters)) {
        copy.set(name, params.get(name));
    }
    EXPECT(std::memcmp(&copy.c(), &params.c(), sizeof(asperity_params)) == 0);
    const Error error = thrown_by([&] { params.set("hardnes", 4.0); });
    EXPECT(error.status() == ASPERITY_INVALID_PARAMETER);
    EXPECT(std::string(error.what()) == "hardnes: no parameter has this name; the nearest is hardness");
    EXPECT(begins(thrown_by([&] { params.set("E1", 4.0); }).what(), "nu1: must be given too"));
    EXPECT(begins(thrown_by([&] { params.get("E1"); }).what(), "E1: is not kept"));
    EXPECT(params.hardness() == 3.0);
}

constexpr const char *STEEL = "pair = \"steel/steel\"\n"
                              "contact_law = \"elastic-plastic\"\n"
                              "work_of_adhesion = 0\n"
                              "nominal_area = 1e-4\n"
                              "calibration_load = 1000\n"
                              "calibration_friction_coefficient = 0.16\n"
                              "[roughness]\n"
                              "m0 = 1e-12\n"
                              "m2 = 0.02\n"
                              "m4 = 4e9\n";

void a_surface_is_a_text() {
    const Params params = Params().set_text(STEEL);
    EXPECT(close(Model(params).friction_at_load(1000.0), 0.16, 1e-9) && params.calibration_load() == 1000.0);
    Params by_hand;
    by_hand.set_pair("steel/steel").contact_law(asperity::ContactLaw::elastic_plastic).work_of_adhesion(0.0);
    by_hand.set_spectral_moments(1e-12, 0.02, 4e9, 1e-4);
    by_hand.calibrate(1000.0, 0.16);
    EXPECT(std::memcmp(&params.c(), &by_hand.c(), sizeof(asperity_params)) == 0);
    EXPECT(std::memcmp(&Params().set_text(params.text()).c(), &params.c(), sizeof(asperity_params)) == 0);

    Params other = Params::paper();
    const Error error = thrown_by([&] { other.set_text("hardness = 1\nslip_onset = \"hole\"\n"); });
    EXPECT(error.status() == ASPERITY_INVALID_PARAMETER);
    EXPECT(std::string(error.what()) == "line 2: slip_onset = \"hole\": must be \"partial\" or \"whole\"");
    EXPECT(std::memcmp(&other.c(), &Params::paper().c(), sizeof(asperity_params)) == 0);
    other.contact_law(static_cast<asperity::ContactLaw>(7));
    EXPECT(thrown_by([&] { (void)other.text(); }).status() == ASPERITY_INVALID_PARAMETER);
}

constexpr const char *GROUND = "pair = \"steel/steel\"\n"
                               "nominal_area = 1e-4\n"
                               "measured = [1000, 0.16]\n"
                               "[roughness]\n"
                               "process = \"ground\"\n"
                               "Ra = 0.8e-6\n";

void an_estimate_needs_a_text_alone() {
    const std::vector<double> loads = {10.0, 1000.0};
    const std::vector<asperity::Estimate> found = asperity::estimates(GROUND, loads);
    EXPECT(found.size() == 2 && close(found[1].friction_coefficient, 0.16, 1e-6));
    EXPECT(0.16 < found[0].low && found[0].low < found[0].friction_coefficient && found[0].high < 0.23);
    EXPECT(found[0].strength_source == ASPERITY_STRENGTH_MEASURED && found[0].load == 10.0);
    EXPECT(close(asperity::estimate(GROUND, 10.0).friction_coefficient, found[0].friction_coefficient, 1e-7));
    EXPECT(begins(asperity::estimate_text(GROUND, loads).c_str(), "mu(10 N) = 0.194, 95 % band 0.167 to 0.221\n"));
    const Params params = Params::paper().set_estimate(GROUND);
    EXPECT(params.contact_law() == asperity::ContactLaw::elastic_plastic && params.calibration_load() == 1000.0);
    EXPECT(close(Model(params).friction_at_load(10.0), found[0].friction_coefficient, 3e-8) && found[0].contacts > 20.0);
    EXPECT(begins(thrown_by([] { Params().set_estimate("mu = 1"); }).what(), "line 1: mu: no such key"));
    const Error error = thrown_by([&] { (void)asperity::estimate("measured = 0.16", 1.0); });
    EXPECT(error.status() == ASPERITY_INVALID_PARAMETER && begins(error.what(), "line 1: measured = 0.16: must be points"));
    EXPECT(begins(thrown_by([&] { (void)asperity::estimate_text("", loads); }).what(), "line 1: "));
}

// A table of the text belongs to the library: copies, and what comes after, have it too.
void a_text_may_have_a_table() {
    const std::string text = "table_height = [1.0, 2.0, 3.0, 4.0, 5.0]\ntable_density = [0.0, 1.0, 2.0, 1.0, 0.0]\n";
    const Params copy = Params(Params::paper().set_text(text)).set_text("radius_amplitude = 0.1");
    EXPECT(copy.height_distribution() == asperity::Heights::tabulated && copy.table_height().data()[4] == 5.0);
    EXPECT(copy.radius_amplitude() == 0.1 && Model(copy).friction_at_load(10.0) > 0.0);
    EXPECT(Params().set_text(copy.text()).table_density().data()[2] == 2.0);
}

void a_surface_file_is_read(const std::string &path) {
    std::FILE *file = std::fopen(path.c_str(), "wb");
    EXPECT(file != nullptr && std::fputs(STEEL, file) >= 0 && std::fclose(file) == 0);
    const Params read = Params().read(path);
    EXPECT(std::memcmp(&read.c(), &Params().set_text(STEEL).c(), sizeof(asperity_params)) == 0);
    EXPECT(std::remove(path.c_str()) == 0);
    const Error error = thrown_by([&] { Params().read(path); });
    EXPECT(error.status() == ASPERITY_INVALID_PARAMETER && begins(error.what(), (path + ": ").c_str()));
}

void a_surface_in_other_units_has_the_same_friction() {
    const Params metres = Params().set_text(STEEL);
    const Params millimetres = Params(metres).set_units(1e-3, 1.0);
    EXPECT(close(millimetres.composite_modulus(), 1e-6 * metres.composite_modulus(), 1e-14));
    EXPECT(close(millimetres.nominal_area(), 100.0, 1e-14));
    EXPECT(close(Model(millimetres).friction_at_load(10.0), Model(metres).friction_at_load(10.0), 1e-10));
    EXPECT(thrown_by([&] { Params(metres).set_units(0.0, 1.0); }).status() == ASPERITY_INVALID_PARAMETER);
}

// ---- The model ----

void a_model_moves_and_does_not_copy() {
    static_assert(!std::is_copy_constructible_v<Model> && !std::is_copy_assignable_v<Model>);
    static_assert(std::is_nothrow_move_constructible_v<Model> && std::is_nothrow_move_assignable_v<Model>);

    Model first(Params::paper());
    const double mu = first.friction_at_load(100.0);
    Model second(std::move(first));
    EXPECT(second.friction_at_load(100.0) == mu);
    EXPECT(first.c() == nullptr && second.c() != nullptr);
    first = std::move(second);
    EXPECT(first.friction_at_load(100.0) == mu);
}

// Each call of a model, by one and by many loads, on one that was moved from.
void a_model_that_was_moved_from_says_so() {
    Model first(Params::paper());
    const Model second(std::move(first));
    std::vector<double> loads{1.0}, out(1);
    const std::vector<std::function<void()>> calls{
        [&] { first.set_params(Params::paper()); },
        [&] { first.params(); },
        [&] { first.friction_at_load(1.0); },
        [&] { first.friction_force_at_load(1.0); },
        [&] { first.friction_and_slope_at_load(1.0); },
        [&] { first.friction_force_and_slope_at_load(1.0); },
        [&] { (void)first.friction_at_load(loads, out); },
        [&] { (void)first.friction_force_at_load(loads, out); },
        [&] { (void)first.tangential_stiffness_at_load(loads, out); },
        [&] { first.friction_at_load(loads); },
        [&] { first.friction_force_and_slope_at_load(loads); },
        [&] { first.tangential_stiffness_at_load(1.0); },
        [&] { first.tangential_stiffness_at_load(loads); },
        [&] { first.tangential_at_load(1.0, 1.0); },
        [&] { first.state_at_load(1.0); },
        [&] { first.state_at_gap(1.0); },
        [&] { first.check_loads(1.0, 2.0); },
        [&] { first.summits_at_overlaps(loads); },
        [&] { first.summary(); },
        [&] { first.table(); },
    };
    for (const auto &call : calls) {
        bool says_so = false;
        try {
            call();
        } catch (const asperity::MovedFrom &error) {
            says_so = error.status() == ASPERITY_NULL_POINTER &&
                      std::strcmp(error.what(), "Model was moved from: assign a model to it before you use it") == 0;
        }
        EXPECT(says_so);
    }
    EXPECT(out[0] == 0.0 && second.friction_at_load(1.0) > 0.0);
}

void parameters_change_all_or_nothing() {
    Model model(Params::paper());
    EXPECT(model.params().asperity_count() == 1.0);
    const double force = model.friction_force_at_load(100.0);
    EXPECT(thrown_by([&] { model.set_params(Params::paper().summit_radius(0.0)); }).status() == ASPERITY_INVALID_PARAMETER);
    EXPECT(model.friction_force_at_load(100.0) == force);

    // Twice the summits carry twice the load with twice the friction.
    model.set_params(Params::paper().asperity_count(2.0));
    EXPECT(model.params().asperity_count() == 2.0);
    EXPECT(close(model.friction_force_at_load(200.0), 2.0 * force, 1e-9));
}

// ---- Friction ----

constexpr double REFERENCE_LOAD = 939.4461111241189 * (2.0 / 0.7); // E* = 2/(1 - 0.3)
constexpr double REFERENCE_FORCE = 1711.9722909384257 * 2.0;       // G* = 2
constexpr double REFERENCE_SLOPE = 1.5229765753034687 * 0.7;

void friction_is_that_of_the_reference() {
    const Model model(Params::dimensionless(0.01, 1000.0, 0.001));
    const double mu = REFERENCE_FORCE / REFERENCE_LOAD;
    EXPECT(close(model.friction_force_at_load(REFERENCE_LOAD), REFERENCE_FORCE, 1e-7));
    EXPECT(close(model.friction_at_load(REFERENCE_LOAD), mu, 1e-7));

    const asperity::ValueAndSlope force = model.friction_force_and_slope_at_load(REFERENCE_LOAD);
    EXPECT(close(force.value, REFERENCE_FORCE, 1e-7) && close(force.slope, REFERENCE_SLOPE, 1e-6));
    // d(F/P)/dP = (dF/dP - F/P)/P
    const asperity::ValueAndSlope coefficient = model.friction_and_slope_at_load(REFERENCE_LOAD);
    EXPECT(close(coefficient.value, mu, 1e-7));
    EXPECT(close(coefficient.slope, (REFERENCE_SLOPE - mu) / REFERENCE_LOAD, 1e-5));
}

void contacts_of_several_models_in_one_call() {
    const Model first(Params::paper()), second(Params::paper().work_of_adhesion(0.0));
    const std::vector<const Model *> models{&first, &second};
    const std::vector<std::uint32_t> which{1, 0, 1};
    const std::vector<double> loads{1.0, REFERENCE_LOAD, REFERENCE_LOAD};
    std::vector<double> force(3), slope(3);
    EXPECT(asperity::friction_force_at_load(models, which, loads, force, slope) == ASPERITY_OK);
    EXPECT(force[1] == first.friction_force_at_load(REFERENCE_LOAD));
    EXPECT(force[2] == second.friction_force_at_load(REFERENCE_LOAD));
    EXPECT(slope[0] == second.friction_force_and_slope_at_load(1.0).slope);
    const std::vector<std::uint32_t> unknown{0, 2, 1};
    EXPECT(asperity::friction_force_at_load(models, unknown, loads, force) == ASPERITY_INVALID_PARAMETER);
    EXPECT(std::isnan(force[1]));
    const std::vector<const Model *> none{&first, nullptr};
    EXPECT(thrown_by([&] { (void)asperity::friction_force_at_load(none, which, loads, force); }).status() == ASPERITY_NULL_POINTER);
    const std::vector<const Model *> many(65, &second);
    EXPECT(asperity::friction_force_at_load(many, which, loads, force) == ASPERITY_OK && force[0] == second.friction_force_at_load(1.0));
}

// What C answers is asked elsewhere: here that each call reaches it with its arguments in order, and throws its status.
void every_call_answers_as_the_library() {
    Params steel = Params::paper().asperity_count(50.0);
    EXPECT(steel.set_dimensionless(0.01, 1000.0, 0.001).asperity_count() == 1.0);
    EXPECT(close(steel.set_materials(210e9, 0.3, INF, 0.3).composite_modulus(), 210e9 / 0.91, 1e-15));
    EXPECT(thrown_by([&] { steel.set_materials(-1.0, 0.3, INF, 0.3); }).status() == ASPERITY_INVALID_PARAMETER);
    const Model model(Params::paper());
    const asperity::State state = model.state_at_load(REFERENCE_LOAD);
    EXPECT(close(model.state_at_gap(state.gap).load, REFERENCE_LOAD, 1e-9));
    EXPECT(close(model.load_and_slope_at_gap(state.gap).value, REFERENCE_LOAD, 1e-9));
    const std::vector<double> gaps{state.gap, 1e6}, loads{1.0, REFERENCE_LOAD};
    std::vector<double> into(2), slopes(2);
    EXPECT(model.load_at_gap(gaps)[0] == model.load_at_gap(state.gap));
    EXPECT(model.load_at_gap(gaps, into, slopes) == ASPERITY_SEPARATED && slopes[0] < 0.0 && slopes[1] == 0.0);
    EXPECT(thrown_by([&] { model.load_at_gap(std::vector<double>{INF}); }).status() == ASPERITY_INVALID_PARAMETER);
    const double stiffness = model.tangential_stiffness_at_load(REFERENCE_LOAD);
    EXPECT(close(stiffness, model.summary().stiffness_per_radius * state.contact_radius_sum, 1e-7));
    EXPECT(model.tangential_stiffness_at_load(loads)[1] == stiffness);
    EXPECT(model.tangential_stiffness_at_load(loads, into) == ASPERITY_OK && into[1] == stiffness);
    const double length = REFERENCE_FORCE / stiffness;
    EXPECT(close(model.tangential_at_load(REFERENCE_LOAD, 1e-8 * length).slope, stiffness, 1e-6));
    EXPECT(thrown_by([&] { model.tangential_at_load(REFERENCE_LOAD, INF); }).status() == ASPERITY_INVALID_PARAMETER);
    EXPECT(model.table(ASPERITY_TABLE_LOAD_AT_GAP).row_count > 0 && model.table().rows != model.table(1).rows);
    EXPECT((model.check_loads(1.0, 2.0) & ASPERITY_WARNING_UNCALIBRATED) != 0);
    EXPECT(thrown_by([&] { (void)model.check_loads(2.0, 1.0); }).status() == ASPERITY_INVALID_PARAMETER);
    const std::vector<double> overlaps{-1e9, 8.0}, heights{0.0, 20.0}, none{1.0, NOT_A_NUMBER};
    const asperity::Summits summits = model.summits_at_overlaps(overlaps, heights);
    EXPECT(summits.force[0] == 0.0 && summits.force[1] > 0.0 && summits.radius[1] > 0.0 && summits.load.size() == 2);
    EXPECT(thrown_by([&] { model.summits_at_overlaps(none); }).status() == ASPERITY_INVALID_PARAMETER);

    // A trial step keeps no state, one that is accepted may be in place; a turned state resists as if turned before.
    std::vector<double> at(model.microslip_length()), forces(2), tangents(4);
    const double step[2] = {0.0, 10.0 * length}, back[2] = {-step[1], 0.0};
    const asperity::Microslip trial = model.microslip_step(REFERENCE_LOAD, step, at, {});
    EXPECT(model.microslip_steps({&REFERENCE_LOAD, 1}, step, at, {}, forces, tangents) == ASPERITY_OK);
    EXPECT(forces[1] == trial.force[1] && tangents[3] == trial.stiffness[3]);
    std::vector<double> turned(at);
    EXPECT(model.microslip_step(REFERENCE_LOAD, step, at, at).force[1] == trial.force[1] && at != turned);
    EXPECT(model.microslip_steps({&REFERENCE_LOAD, 1}, step, at, at, {}, {}) == ASPERITY_OK);
    model.microslip_turn(turned, 0.0, 1.0);
    EXPECT(model.microslip_step(REFERENCE_LOAD, back, turned, {}).force[0] == -trial.force[1]);
    EXPECT(thrown_by([&] { model.microslip_turn(turned, INF, 0.0); }).status() == ASPERITY_INVALID_PARAMETER);
    EXPECT(thrown_by([&] { model.microslip_step(REFERENCE_LOAD, step, loads, at); }).status() == ASPERITY_INVALID_PARAMETER);
}

void c_functions_take_what_cpp_made() {
    const Params params = Params::paper();
    const Model model(params);
    static_assert(std::is_same_v<decltype(model.c()), const asperity_model *>);
    EXPECT(asperity_friction_at_load(model.c(), REFERENCE_LOAD) == model.friction_at_load(REFERENCE_LOAD));
    asperity_table view{};
    view.struct_size = sizeof view;
    asperity::check(asperity_table_of(model.c(), ASPERITY_TABLE_FRICTION, &view));
    EXPECT(view.rows == model.table().rows);
    EXPECT(asperity_eval_friction_force(&view, REFERENCE_LOAD, nullptr) == model.friction_force_at_load(REFERENCE_LOAD));
    asperity_model *own = nullptr;
    asperity::check(asperity_create(&params.c(), &own));
    EXPECT(asperity_friction_at_load(own, REFERENCE_LOAD) == model.friction_at_load(REFERENCE_LOAD));
    asperity_free(own);
}

void the_table_answers_as_the_model() {
    Model made(Params::paper());
    const asperity::Table table = made.table();
    const Model model(std::move(made));
    EXPECT(table.layout_version == ASPERITY_TABLE_LAYOUT);
    EXPECT(table.pull_off_load == model.summary().pull_off_load);
    EXPECT(table.max_friction_coefficient == 1000.0);
    double slope = 0.0;
    EXPECT(close(asperity_eval_friction_force(&table, REFERENCE_LOAD, &slope), REFERENCE_FORCE, 1e-7));
    EXPECT(close(slope, REFERENCE_SLOPE, 1e-6));
    EXPECT(close(asperity_eval_friction(&table, REFERENCE_LOAD, nullptr), REFERENCE_FORCE / REFERENCE_LOAD, 1e-7));
    // Heavier loads than the table's: the force of its heaviest load.
    const double heaviest = model.summary().max_table_load;
    EXPECT(asperity_eval_friction_force(&table, 2.0 * heaviest, &slope) == table.heavy_force && slope == 0.0);
    EXPECT(close(table.heavy_force, model.friction_force_at_load(heaviest), 1e-12));
    EXPECT(std::isnan(asperity_eval_friction(&table, NOT_A_NUMBER, nullptr)));
}

// ---- Many loads ----

template <class Loads>
void a_range_gives_what_its_elements_give(const Model &model, const Loads &loads) {
    const std::vector<double> mu = model.friction_at_load(loads);
    const std::vector<double> force = model.friction_force_at_load(loads);
    const auto [mu_again, dmu] = model.friction_and_slope_at_load(loads);
    const auto [force_again, dforce] = model.friction_force_and_slope_at_load(loads);
    EXPECT(mu.size() == std::size(loads) && dforce.size() == std::size(loads));
    EXPECT(mu == mu_again && force == force_again);
    for (std::size_t i = 0; i < mu.size(); ++i) {
        const double load = std::data(loads)[i];
        EXPECT(mu[i] == model.friction_at_load(load) && force[i] == model.friction_force_at_load(load));
        EXPECT(dmu[i] == model.friction_and_slope_at_load(load).slope);
        EXPECT(dforce[i] == model.friction_force_and_slope_at_load(load).slope);
    }
}

void every_contiguous_range_will_do() {
    const Model model(Params::paper());
    const std::vector<double> vector{1e-3, 1.0, 1e3};
    double plain[] = {10.0, 20.0};
    a_range_gives_what_its_elements_give(model, vector);
    a_range_gives_what_its_elements_give(model, std::array<double, 4>{1.0, 2.0, 3.0, 4.0});
    a_range_gives_what_its_elements_give(model, plain);
    a_range_gives_what_its_elements_give(model, std::vector<double>{});
    EXPECT(model.friction_at_load({vector.data() + 1, 2}) == model.friction_at_load(std::vector<double>{1.0, 1e3}));

    static_assert(std::is_convertible_v<std::vector<double> &, asperity::Span<double>>);
    static_assert(!std::is_convertible_v<const std::vector<double> &, asperity::Span<double>>);
    static_assert(!std::is_convertible_v<std::vector<float> &, asperity::Span<const double>>);
    static_assert(!std::is_convertible_v<double, asperity::Span<const double>>);
}

void a_solver_gets_every_element_and_the_first_invalid() {
    const Model model(Params::paper());
    const double pull_off = model.summary().pull_off_load;
    const std::vector<double> loads{1.0, 2.0 * pull_off, NOT_A_NUMBER, 100.0};
    std::array<double, 4> mu{}, dmu{}, force{}, dforce{};
    EXPECT(model.friction_at_load(loads, mu, dmu) == ASPERITY_SEPARATED);
    EXPECT(begins(asperity::last_error().c_str(), "element 1: "));
    EXPECT(model.friction_force_at_load(loads, force, dforce) == ASPERITY_SEPARATED);
    EXPECT(mu[0] == model.friction_at_load(1.0) && mu[1] == 0.0 && std::isnan(mu[2]));
    EXPECT(mu[3] == model.friction_at_load(100.0) && dmu[3] == model.friction_and_slope_at_load(100.0).slope);
    EXPECT(force[1] == 0.0 && force[3] == model.friction_force_at_load(100.0));

    // As vectors: an open contact is an answer, and hides no load that has none.
    const std::vector<double> open{1.0, 2.0 * pull_off, 100.0}, heavy{1.0, 2.0 * pull_off, 100.0, 1e300};
    const std::vector<double> heavy_alone{1.0, 1e300};
    EXPECT((model.friction_at_load(open) == std::vector<double>{mu[0], 0.0, mu[3]}));
    EXPECT((model.friction_force_at_load(open) == std::vector<double>{force[0], 0.0, force[3]}));
    EXPECT((model.friction_and_slope_at_load(open).slope == std::vector<double>{dmu[0], 0.0, dmu[3]}));
    EXPECT((model.friction_force_and_slope_at_load(open).slope == std::vector<double>{dforce[0], 0.0, dforce[3]}));
    for (const auto &ask : {
             +[](const Model &m, const std::vector<double> &l) { m.friction_at_load(l); },
             +[](const Model &m, const std::vector<double> &l) { m.friction_force_at_load(l); },
             +[](const Model &m, const std::vector<double> &l) { m.friction_and_slope_at_load(l); },
             +[](const Model &m, const std::vector<double> &l) { m.friction_force_and_slope_at_load(l); },
         }) {
        const Error invalid = thrown_by([&] { ask(model, loads); });
        EXPECT(invalid.status() == ASPERITY_INVALID_LOAD && begins(invalid.what(), "element 2: load = NaN"));
        const Error too_heavy = thrown_by([&] { ask(model, heavy); });
        EXPECT(too_heavy.status() == ASPERITY_OUT_OF_RANGE && begins(too_heavy.what(), "element 3: load = 1e300: "));
        const Error alone = thrown_by([&] { ask(model, heavy_alone); });
        EXPECT(alone.status() == ASPERITY_OUT_OF_RANGE && begins(alone.what(), "element 1: load = 1e300: "));
    }

    // Nothing but values, in place.
    std::vector<double> in_place{1.0, 100.0};
    EXPECT(model.friction_at_load(in_place, in_place) == ASPERITY_OK);
    EXPECT(in_place[1] == mu[3]);
}

void arrays_of_other_sizes_are_refused_before_anything_is_written() {
    const Model model(Params::paper());
    std::vector<double> mu(3, -1.0), slope(1, -1.0);
    const std::vector<double> loads{1.0, 2.0};
    const Error values = thrown_by([&] { (void)model.friction_at_load(loads, mu); });
    EXPECT(values.status() == ASPERITY_INVALID_PARAMETER);
    EXPECT(std::strcmp(values.what(), "size of values = 3: must be the number of loads, 2") == 0);
    mu.resize(2);
    EXPECT(thrown_by([&] { (void)model.friction_force_at_load(loads, mu, slope); }).status() == ASPERITY_INVALID_PARAMETER);
    EXPECT(mu[0] == -1.0 && slope[0] == -1.0);
}

void threads_share_a_model() {
    const Model model(Params::paper());
    const double expected = model.friction_at_load(REFERENCE_LOAD);
    std::array<double, 4> mu{};
    std::vector<std::thread> threads;
    for (double &own : mu) {
        threads.emplace_back([&] {
            feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
            own = model.friction_at_load(REFERENCE_LOAD);
        });
    }
    for (std::thread &thread : threads) {
        thread.join();
    }
    for (const double each : mu) {
        EXPECT(each == expected);
    }
}

} // namespace

int main(int, char **arguments) {
    feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
    what_is_looked_up_is_a_string();
    an_error_carries_status_and_message();
    each_setter_sets_its_own_field();
    a_table_is_copied_and_shared();
    one_measured_point_sets_the_strength();
    parameters_are_set_and_read_by_name();
    a_surface_is_a_text();
    an_estimate_needs_a_text_alone();
    a_text_may_have_a_table();
    a_surface_file_is_read(std::string(arguments[0]) + ".toml");
    a_surface_in_other_units_has_the_same_friction();
    a_model_moves_and_does_not_copy();
    every_call_answers_as_the_library();
    a_model_that_was_moved_from_says_so();
    parameters_change_all_or_nothing();
    friction_is_that_of_the_reference();
    contacts_of_several_models_in_one_call();
    c_functions_take_what_cpp_made();
    the_table_answers_as_the_model();
    every_contiguous_range_will_do();
    a_solver_gets_every_element_and_the_first_invalid();
    arrays_of_other_sizes_are_refused_before_anything_is_written();
    threads_share_a_model();
    return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
