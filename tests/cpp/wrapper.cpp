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
#include <memory>
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

void versions_are_those_of_the_header() {
    EXPECT(std::strcmp(asperity::version(), ASPERITY_VERSION) == 0);
    EXPECT(asperity::abi_version() == ASPERITY_ABI_VERSION);
    const std::string numbers = std::to_string(ASPERITY_VERSION_MAJOR) + "." + std::to_string(ASPERITY_VERSION_MINOR) +
                                "." + std::to_string(ASPERITY_VERSION_PATCH);
    EXPECT(numbers == ASPERITY_VERSION);
}

void every_status_has_its_own_words() {
    EXPECT(std::strcmp(asperity::status_string(ASPERITY_OK), "success") == 0);
    EXPECT(std::strcmp(asperity::status_string(77), "unknown status") == 0);
    const std::array<asperity::Status, 7> statuses{ASPERITY_NULL_POINTER, ASPERITY_INVALID_PARAMETER,
                                                   ASPERITY_INVALID_LOAD, ASPERITY_SEPARATED, ASPERITY_OUT_OF_RANGE,
                                                   ASPERITY_NOT_CONVERGED, ASPERITY_INTERNAL};
    for (const asperity::Status a : statuses) {
        for (const asperity::Status b : statuses) {
            EXPECT((a == b) == (std::strcmp(asperity::status_string(a), asperity::status_string(b)) == 0));
        }
    }
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

void materials_give_the_moduli_of_both_bodies() {
    // Steel on a rigid body: E* = E/(1 - nu^2), G* = 2 G with G = E/(2 (1 + nu)).
    const Params params = Params().set_materials(210e9, 0.3, INF, 0.3);
    EXPECT(close(params.composite_modulus(), 210e9 / 0.91, 1e-15));
    EXPECT(close(params.effective_shear_modulus(), 210e9 / 1.3, 1e-15));

    Params changed = params;
    EXPECT(thrown_by([&] { changed.set_materials(-1.0, 0.3, INF, 0.3); }).status() == ASPERITY_INVALID_PARAMETER);
    EXPECT(changed.composite_modulus() == params.composite_modulus());
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
    params.effective_shear_modulus(80e9).set_interface("MoS2 film in dry air");
    EXPECT(params.calibration_load() == 0.0 && params.calibration_friction_force() == 0.0);

    params = before;
    EXPECT(params.set({{"calibration_friction_coefficient", 0.16}, {"calibration_load", 20.0}}).slip_stress_1() ==
           kept.slip_stress_1());
    // Where nothing presses, the force: as much as it was.
    const double adhesive = Model(before).friction_force_at_load(0.0);
    EXPECT(close(Params(before).calibrate_force(0.0, 2.0 * adhesive).slip_stress_1(), 2.0 * before.slip_stress_1(), 1e-7));
}

void what_is_no_measurement_is_refused() {
    Params params = Params::paper();
    const auto refusal = [&](double load, double coefficient) {
        const Error error = thrown_by([&] { params.calibrate(load, coefficient); });
        EXPECT(error.status() == ASPERITY_INVALID_PARAMETER);
        return std::string(error.what());
    };
    EXPECT(begins(refusal(20.0, 20.1).c_str(), "calibration_friction_coefficient = 20.1: must be > 0 and at most 20; is it a force?"));
    EXPECT(begins(refusal(20.0, -0.1).c_str(), "calibration_friction_coefficient = -0.1: must be > 0"));
    EXPECT(begins(refusal(0.0, 0.16).c_str(), "calibration_load = 0: must be > 0; at zero load"));
    EXPECT(thrown_by([&] { params.calibrate(NOT_A_NUMBER, 0.16); }).status() == ASPERITY_INVALID_LOAD);
    const Error strong = thrown_by([&] { params.calibrate_force(5.0, 1e6); });
    EXPECT(begins(strong.what(), "friction_force = 1000000 at load = 5: must be at most"));
    EXPECT(std::memcmp(&params.c(), &Params::paper().c(), sizeof(asperity_params)) == 0);
    EXPECT(begins(thrown_by([] { Model(Params::paper().calibration_error(0.0)); }).what(), "calibration_error = 0: must be"));
}

void a_strength_that_nobody_measured_is_warned_of_whatever_the_count() {
    for (const double count : {1.0, 1e9}) {
        Params params = Params::paper().asperity_count(count);
        const auto uncalibrated = [&] {
            return (Model(params).check_loads(count, 2.0 * count) & ASPERITY_WARNING_UNCALIBRATED) != 0;
        };
        EXPECT(uncalibrated());
        params.slip_radius_1(30.0).slip_radius_2(9e4);
        EXPECT(uncalibrated());
        params.calibrate(count, 0.3);
        EXPECT(!uncalibrated());
    }
}

void a_slip_radius_is_a_ratio() {
    EXPECT(std::string(thrown_by([] { Model(Params::paper().slip_radius_1(10.75e-9)); }).what()) ==
           "slip_radius_1 = 1.075e-8: must be at least 1; is it a length? It is a ratio to burgers_vector");
}

void bounds_are_those_that_the_pages_say() {
    const auto allowed = [](const Params &params) { return thrown_by([&] { Model{params}; }).status() == ASPERITY_OK; };
    const auto weibull = [](double shape) {
        return Params::paper().height_distribution(asperity::Heights::weibull).weibull_shape(shape);
    };
    EXPECT(allowed(weibull(1.0)) && allowed(weibull(200.0)) && !allowed(weibull(0.99)) && !allowed(weibull(201.0)));
    const auto johnson = [](double skew, double kurtosis) {
        return Params::paper().height_distribution(asperity::Heights::johnson).skew(skew).kurtosis(kurtosis);
    };
    EXPECT(allowed(johnson(0.0, 1.87)) && allowed(johnson(0.0, 100.0)) && allowed(johnson(2.0, 6.87)));
    EXPECT(!allowed(johnson(0.0, 1.86)) && !allowed(johnson(0.0, 101.0)) && !allowed(johnson(2.0, 6.86)));
}

void spectral_moments_give_the_summits() {
    const Params unknown = Params().set_spectral_moments(3.0, 0.5, 0.0, 11.0);
    EXPECT(unknown.rms_slope() == 1.0 && unknown.radius_amplitude() < 0.0 && unknown.summit_mean_height() > 1.7);
    const Params params = Params().set_mccool_summits(3.0, 0.5, 0.7, 11.0);
    EXPECT(close(params.height_std() * params.height_std(), 3.0 - 0.8968 * 0.25 / 0.7, 1e-4));
    EXPECT(close(params.summit_radius(), 0.375 * std::sqrt(3.14159265358979324 / 0.7), 1e-14));
    EXPECT(close(params.asperity_count(), 0.7 * 11.0 / (6.0 * 3.14159265358979324 * std::sqrt(3.0) * 0.5), 1e-14));
    Params changed = params;
    const Error error = thrown_by([&] { changed.set_spectral_moments(1.0, 1.0, 1.25, 1.0); });
    EXPECT(error.status() == ASPERITY_INVALID_PARAMETER);
    EXPECT(begins(error.what(), "bandwidth m0 m4/m2^2 = 1.25: must be at least 1.5"));
    EXPECT(changed.summit_radius() == params.summit_radius());
    EXPECT(thrown_by([&] { changed.set_mccool_summits(1.0, 1.0, 1.25, 1.0); }).status() == ASPERITY_INVALID_PARAMETER);
}

void dimensionless_groups_come_back_from_the_model() {
    const asperity::Summary summary = Model(Params::dimensionless(0.02, 500.0, 0.002, 0.8, 0.25)).summary();
    EXPECT(close(summary.alpha, 0.02, 1e-14));
    EXPECT(close(summary.beta, 500.0, 1e-14));
    EXPECT(close(summary.gamma, 0.002, 1e-14));
    EXPECT(summary.skew == 0.0);
    EXPECT(summary.kurtosis == 3.0);

    Params params = Params::paper().asperity_count(50.0).radius_amplitude(0.5);
    params.set_dimensionless(0.02, 500.0, 0.002);
    EXPECT(params.asperity_count() == 1.0);
    EXPECT(params.radius_amplitude() == 0.5);
}

void parameters_are_set_and_read_by_name() {
    Params params;
    EXPECT(params.set("hardness", 3.0).get("hardness") == 3.0);
    EXPECT(params.hardness() == 3.0);
    params.set({{"nu2", 0.22}, {"E1", 160e9}, {"nu1", 0.3}, {"E2", 70e9}, {"skew", -0.5}});
    EXPECT(params.composite_modulus() == Params().set_materials(160e9, 0.3, 70e9, 0.22).composite_modulus());
    EXPECT(params.weibull_shape() == Params().set_skew(-0.5).weibull_shape());
    Params copy;
    for (const std::string &name : Params::names()) {
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
    by_hand.set_pair("steel/steel").set_elastic_plastic(by_hand.hardness()).set_spectral_moments(1e-12, 0.02, 4e9, 1e-4);
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

void skew_chooses_the_weibull_shape() {
    // Table 1 of the paper: no skew at omega = 3.602. Rayleigh's distribution, omega = 2, has the skew
    // 2 pi^(1/2) (pi - 3)/(4 - pi)^(3/2).
    Params params;
    EXPECT(params.height_distribution() == asperity::Heights::gaussian);
    EXPECT(close(params.set_skew(0.0).weibull_shape(), 3.602, 2e-4));
    EXPECT(params.height_distribution() == asperity::Heights::weibull);
    EXPECT(close(params.set_skew(0.6311106578189364).weibull_shape(), 2.0, 1e-9));
    const Error error = thrown_by([&] { params.set_skew(-1.2); });
    EXPECT(error.status() == ASPERITY_INVALID_PARAMETER);
    EXPECT(begins(error.what(), "skew = -1.2: must be "));
}

void johnson_heights_have_a_skew_and_a_kurtosis_of_their_own() {
    const Params params = Params::paper().height_distribution(asperity::Heights::johnson).skew(0.4).kurtosis(3.8);
    const asperity::Summary summary = Model(params).summary();
    EXPECT(close(summary.skew, 0.4, 1e-9) && close(summary.kurtosis, 3.8, 1e-9));
    EXPECT(thrown_by([&] { Model(Params(params).kurtosis(1.0)); }).status() == ASPERITY_INVALID_PARAMETER);
}

// ---- The model ----

/// Without adhesion and with one shear strength F = tau A, in which E* takes from F what it adds to the load.
void sensitivities_are_those_of_the_friction_force() {
    const Params params = Params::paper().work_of_adhesion(0.0).slip_radius_1(1e6).slip_radius_2(1e7);
    const Model model(params);
    const asperity::Sensitivities found = model.sensitivities_at_load(10.0);
    const asperity::State state = model.state_at_load(10.0);
    EXPECT(close(found.composite_modulus, -10.0 * state.dforce_dload / state.friction_force, 1e-9));
    EXPECT(found.effective_shear_modulus == 1.0 && close(found.slip_stress_1, 1.0, 1e-12));
    EXPECT(found.work_of_adhesion == 0.0 && found.skew == 0.0);
    EXPECT(thrown_by([&] { model.sensitivities_at_load(0.0); }).status() == ASPERITY_OUT_OF_RANGE);
}

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
        [&] { first.friction_at_pressure(1.0, 1.0); },
        [&] { first.friction_and_slope_at_pressure(1.0, 1.0); },
        [&] { first.shear_stress_at_pressure(1.0, 1.0); },
        [&] { first.shear_stress_and_slope_at_pressure(1.0, 1.0); },
        [&] { first.slip_force(1.0, 1.0, 1.0); },
        [&] { first.slip_force_and_slopes(1.0, 1.0, 1.0); },
        [&] { (void)first.friction_at_load(loads, out); },
        [&] { (void)first.friction_force_at_load(loads, out); },
        [&] { (void)first.tangential_stiffness_at_load(loads, out); },
        [&] { first.friction_at_load(loads); },
        [&] { first.friction_force_and_slope_at_load(loads); },
        [&] { first.tangential_stiffness_at_load(1.0); },
        [&] { first.contact_radius_sum_at_load(1.0); },
        [&] { (void)first.contact_radius_sum_at_load(loads, out); },
        [&] { first.tangential_stiffness_at_load(loads); },
        [&] { first.tangential_at_load(1.0, 1.0); },
        [&] { first.state_at_load(1.0); },
        [&] { first.state_at_gap(1.0); },
        [&] { first.sensitivities_at_load(1.0); },
        [&] { first.check_loads(1.0, 2.0); },
        [&] { first.warning_loads(ASPERITY_WARNING_FEW); },
        [&] { first.summits_at_overlaps(loads); },
        [&] { first.summary(); },
        [&] { first.table(); },
        [&] { first.load_table(); },
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

void states_are_those_of_the_reference() {
    const Model model(Params::paper());
    const asperity::State state = model.state_at_gap(model.params().height_std());
    EXPECT(close(state.load, REFERENCE_LOAD, 1e-7));
    EXPECT(close(state.friction_force, REFERENCE_FORCE, 1e-7));
    EXPECT(close(state.real_area, 318699.2525830931, 1e-7));
    EXPECT(close(state.contacting, 0.17776420898559706, 1e-7));
    EXPECT(close(state.attraction_load, -2.1044486779808658 * (2.0 / 0.7), 1e-6));

    EXPECT(close(state.mean_asperity_pressure, (state.load - state.attraction_load) / state.real_area, 1e-12));
    // 18 % of the summits touch, at a strength that was not measured.
    EXPECT(state.plasticity_index == 0.0 && state.warnings == ASPERITY_WARNING_UNCALIBRATED);
    const Model soft(Params::paper().hardness(0.01));
    EXPECT((soft.state_at_load(state.load).warnings & ASPERITY_WARNING_PLASTIC) != 0);

    const asperity::State same = model.state_at_load(state.load);
    EXPECT(close(same.gap, state.gap, 1e-9));
    EXPECT(close(same.friction_force, state.friction_force, 1e-9));
}

void materials_and_pairs_are_those_of_the_table() {
    const asperity::Material steel = asperity::material("steel");
    EXPECT(steel.young == 205e9 && steel.struct_size == sizeof steel);
    EXPECT(asperity::pair("Au/mica").slip_stress_1 == 0.0108);
    EXPECT(asperity::material_names().size() == 30 && asperity::material_names().front() == "Si");
    EXPECT(asperity::pair_names().size() == 26 && asperity::pair_names().front() == "Si/Si");
    const Params params = Params().set_pair("steel/steel").height_std(1e-7).summit_radius(1e-5);
    EXPECT(params.work_of_adhesion() == 0.049 && params.hardness() == 7.5e9);
    EXPECT(thrown_by([&] { (void)asperity::material("stel"); }).status() == ASPERITY_INVALID_PARAMETER);
    EXPECT(thrown_by([&] { (void)asperity::pair("stel"); }).status() == ASPERITY_INVALID_PARAMETER);
    EXPECT(thrown_by([&] { Params().set_pair("PDMS/stel"); }).status() == ASPERITY_INVALID_PARAMETER);
    EXPECT(std::isnan(Params().set_pair("WC/SiC").work_of_adhesion()));
}

void interfaces_are_those_of_the_table() {
    const asperity::InterfaceData film = asperity::interface_of("MoS2 film in dry air");
    EXPECT(film.shear_strength == 24.8e6 && film.pressure_coefficient == 0.001 && film.struct_size == sizeof film);
    EXPECT(asperity::interface_names().size() == 39 && asperity::interface_names().front() == film.name);
    const Params params = Params().set_pair("steel/steel").set_interface(film.name);
    EXPECT(params.slip_stress_1() == 24.8e6 / params.effective_shear_modulus());
    EXPECT(params.slip_stress_2() == params.slip_stress_1() && params.pressure_coefficient() == 0.001);
    EXPECT(thrown_by([&] { (void)asperity::interface_of("MoS2"); }).status() == ASPERITY_INVALID_PARAMETER);
    EXPECT(thrown_by([&] { Params(params).set_interface("steel/steel dry"); }).status() == ASPERITY_INVALID_PARAMETER);
}

void a_range_of_loads_warns_of_what_fails_in_it() {
    const Model model(Params::paper().asperity_count(1e9).slip_stress_1(0.02));
    EXPECT((model.check_loads(1e9, 100e9) & ASPERITY_WARNING_CROWDED) == 0);
    EXPECT((model.check_loads(1e9, 1e9 * REFERENCE_LOAD) & ASPERITY_WARNING_CROWDED) != 0);
    const auto crowded = model.warning_loads(ASPERITY_WARNING_CROWDED);
    EXPECT(crowded.first > 100e9 && crowded.first < 1e9 * REFERENCE_LOAD && crowded.second > crowded.first);
    EXPECT(std::isnan(model.warning_loads(ASPERITY_WARNING_UNCALIBRATED).first));
    EXPECT(thrown_by([&] { (void)model.warning_loads(3); }).status() == ASPERITY_INVALID_PARAMETER);
    EXPECT(asperity::warnings_text(0) == "no warning");
    EXPECT(asperity::warnings_text(3) == std::string(asperity::warning_string(1)) + "\n" + asperity::warning_string(2));
    EXPECT(thrown_by([&] { (void)model.check_loads(2.0, 1.0); }).status() == ASPERITY_INVALID_PARAMETER);
    EXPECT(thrown_by([&] { (void)model.check_loads(NOT_A_NUMBER, 1.0); }).status() == ASPERITY_INVALID_LOAD);
    EXPECT(std::strstr(asperity::warning_string(ASPERITY_WARNING_CROWDED), "summits do not act independently") != nullptr);
    EXPECT(std::strcmp(asperity::warning_string(3), "unknown warning") == 0);
}

/// By Hertz' closed forms, without adhesion: a^2 = R u, P = 4/3 E* R^(1/2) u^(3/2).
void single_summits_are_those_of_hertz() {
    const Params params = Params::paper().work_of_adhesion(0.0);
    const Model model(params);
    const std::vector<double> overlaps{-1.0, 2.0, 8.0}, heights{0.0, 20.0};
    const asperity::Summits found = model.summits_at_overlaps(overlaps);
    EXPECT(found.load[0] == 0.0 && found.force[0] == 0.0 && found.radius[0] == 0.0);
    for (std::size_t i = 1; i < overlaps.size(); ++i) {
        const double radius = std::sqrt(params.summit_radius() * overlaps[i]);
        EXPECT(close(found.radius[i], radius, 1e-13));
        EXPECT(close(found.load[i], 4.0 / 3.0 * params.composite_modulus() * radius * overlaps[i], 1e-13));
        EXPECT(found.force[i] > 0.0);
    }
    EXPECT(thrown_by([&] { model.summits_at_overlaps(overlaps, heights); }).status() == ASPERITY_INVALID_PARAMETER);
    const std::vector<double> none{1.0, NOT_A_NUMBER};
    EXPECT(thrown_by([&] { model.summits_at_overlaps(none); }).status() == ASPERITY_INVALID_PARAMETER);
}

void friction_is_defined_at_every_load() {
    const Model model(Params::paper());
    const double pull_off = model.summary().pull_off_load;
    EXPECT(pull_off < 0.0);
    EXPECT(model.friction_at_load(0.0) == 1000.0);
    EXPECT(model.friction_force_at_load(pull_off) > 0.0);
    EXPECT(model.friction_at_load(2.0 * pull_off) == 0.0);
    EXPECT(model.friction_force_at_load(2.0 * pull_off) == 0.0);
    EXPECT(std::isnan(model.friction_at_load(NOT_A_NUMBER)));
    EXPECT(std::isnan(model.friction_force_at_load(INF)));
    EXPECT(model.friction_force_and_slope_at_load(2.0 * pull_off).value == 0.0);
    EXPECT(thrown_by([&] { model.state_at_load(2.0 * pull_off); }).status() == ASPERITY_SEPARATED);
    EXPECT(thrown_by([&] { model.state_at_load(INF); }).status() == ASPERITY_INVALID_LOAD);
    EXPECT(thrown_by([&] { model.state_at_gap(NOT_A_NUMBER); }).status() == ASPERITY_INVALID_PARAMETER);
}

void pressure_is_load_per_area_of_the_summits() {
    const Model model(Params::paper());
    const double area = 250.0, pressure = REFERENCE_LOAD / area;
    const double mu = REFERENCE_FORCE / REFERENCE_LOAD;
    EXPECT(close(model.friction_at_pressure(pressure, area), mu, 1e-7));
    EXPECT(close(model.shear_stress_at_pressure(pressure, area), REFERENCE_FORCE / area, 1e-7));

    const asperity::ValueAndSlope coefficient = model.friction_and_slope_at_pressure(pressure, area);
    EXPECT(coefficient.value == model.friction_at_pressure(pressure, area));
    EXPECT(close(coefficient.slope, (REFERENCE_SLOPE - mu) / pressure, 1e-5));
    const asperity::ValueAndSlope stress = model.shear_stress_and_slope_at_pressure(pressure, area);
    EXPECT(stress.value == model.shear_stress_at_pressure(pressure, area));
    EXPECT(close(stress.slope, REFERENCE_SLOPE, 1e-6));

    const double pull_off = model.summary().pull_off_load;
    EXPECT(model.shear_stress_at_pressure(0.0, area) > 0.0);
    EXPECT(model.shear_stress_and_slope_at_pressure(2.0 * pull_off / area, area).value == 0.0);
    EXPECT(std::isnan(model.friction_at_pressure(pressure, 0.0)));
    EXPECT(std::isnan(model.friction_and_slope_at_pressure(pressure, -area).slope));
    EXPECT(std::isnan(model.shear_stress_and_slope_at_pressure(NOT_A_NUMBER, area).slope));
}

void slip_gives_the_force_a_smooth_sign() {
    const Model model(Params::paper());
    const double rate = 0.02, transition = 0.05;
    const double sign = std::tanh(rate / transition);
    const asperity::SlipForce force = model.slip_force_and_slopes(REFERENCE_LOAD, rate, transition);
    EXPECT(force.value == model.slip_force(REFERENCE_LOAD, rate, transition));
    EXPECT(close(force.value, REFERENCE_FORCE * sign, 1e-7));
    EXPECT(close(force.dforce_dload, REFERENCE_SLOPE * sign, 1e-6));
    // tanh' = 1 - tanh^2
    EXPECT(close(force.dforce_dslip_rate, REFERENCE_FORCE * (1.0 - sign * sign) / transition, 1e-7));

    EXPECT(model.slip_force(REFERENCE_LOAD, -rate, transition) == -force.value);
    EXPECT(model.slip_force(REFERENCE_LOAD, 0.0, transition) == 0.0);
    EXPECT(model.slip_force_and_slopes(model.summary().pull_off_load, 0.0, transition).dforce_dload == 0.0);
    EXPECT(close(model.slip_force(REFERENCE_LOAD, 1e3, transition), REFERENCE_FORCE, 1e-7));
    EXPECT(std::isnan(model.slip_force(REFERENCE_LOAD, INF, transition)));
    EXPECT(std::isnan(model.slip_force_and_slopes(REFERENCE_LOAD, rate, 0.0).dforce_dslip_rate));
}

void contacts_stick_before_they_slip() {
    const Model model(Params::paper());
    const double stiffness = model.tangential_stiffness_at_load(REFERENCE_LOAD);
    const asperity::State state = model.state_at_load(REFERENCE_LOAD);
    EXPECT(close(stiffness, state.tangential_stiffness, 1e-10));
    const double length = REFERENCE_FORCE / stiffness;
    const asperity::ValueAndSlope start = model.tangential_at_load(REFERENCE_LOAD, 1e-8 * length);
    EXPECT(close(start.value, 1e-8 * REFERENCE_FORCE, 1e-6) && close(start.slope, stiffness, 1e-6));
    EXPECT(model.tangential_at_load(REFERENCE_LOAD, -length).value ==
           -model.tangential_at_load(REFERENCE_LOAD, length).value);
    EXPECT(close(model.tangential_at_load(REFERENCE_LOAD, 1e4 * length).value, REFERENCE_FORCE, 1e-7));
    EXPECT(thrown_by([&] { model.tangential_at_load(REFERENCE_LOAD, INF); }).status() == ASPERITY_INVALID_PARAMETER);
    const double open = 2.0 * model.summary().pull_off_load;
    EXPECT(thrown_by([&] { model.tangential_at_load(open, length); }).status() == ASPERITY_SEPARATED);

    const std::vector<double> loads{1.0, REFERENCE_LOAD, open};
    const std::vector<double> many = model.tangential_stiffness_at_load(loads);
    EXPECT(many.size() == 3 && many[1] == stiffness && many[2] == 0.0);
    std::vector<double> into(3);
    EXPECT(model.tangential_stiffness_at_load(loads, into) == ASPERITY_SEPARATED && into == many);
    std::vector<double> few(2);
    EXPECT(thrown_by([&] { (void)model.tangential_stiffness_at_load(loads, few); }).status() == ASPERITY_INVALID_PARAMETER);
}

void the_sum_of_contact_radii_is_the_stiffness_over_8_moduli() {
    const Params params = Params::paper();
    const Model model(params);
    const double E = params.composite_modulus(), G = params.effective_shear_modulus();
    const double modulus = E * G / (2.0 * (E + G)); // of two bodies alike
    const double sum = model.contact_radius_sum_at_load(REFERENCE_LOAD);
    EXPECT(close(sum, model.tangential_stiffness_at_load(REFERENCE_LOAD) / (8.0 * modulus), 1e-12));
    EXPECT(close(sum, model.state_at_load(REFERENCE_LOAD).contact_radius_sum, 1e-9));
    const std::vector<double> loads{0.999 * REFERENCE_LOAD, REFERENCE_LOAD, 1.001 * REFERENCE_LOAD};
    const std::vector<double> sums = model.contact_radius_sum_at_load(loads);
    std::vector<double> into(3), slopes(3);
    EXPECT(model.contact_radius_sum_at_load(loads, into, slopes) == ASPERITY_OK && into == sums && sums[1] == sum);
    EXPECT(close(slopes[1], (sums[2] - sums[0]) / (loads[2] - loads[0]), 1e-6));
    EXPECT(std::isnan(model.contact_radius_sum_at_load(INF)));
}

void a_contact_remembers() {
    const Model model(Params::paper());
    const std::size_t length = model.microslip_length();
    const double stiffness = model.tangential_stiffness_at_load(REFERENCE_LOAD);
    const double slip = REFERENCE_FORCE / stiffness;
    std::vector<double> state(length), after(length);
    const double small[2] = {1e-3 * slip, 0.0}, large[2] = {0.0, 10.0 * slip};
    const asperity::Microslip begun = model.microslip_step(REFERENCE_LOAD, small, state, after);
    EXPECT(close(begun.force[0], stiffness * small[0], 1e-12) && begun.force[1] == 0.0 && begun.dissipated == 0.0);
    EXPECT(close(begun.stiffness[0], stiffness, 1e-12) && state != after);
    // A trial step keeps no state, one that is accepted may be in place.
    const asperity::Microslip trial = model.microslip_step(REFERENCE_LOAD, large, after, {});
    const std::vector<double> before = after;
    const asperity::Microslip ended = model.microslip_step(REFERENCE_LOAD, large, after, after);
    EXPECT(trial.force[1] == ended.force[1] && close(ended.slipping, 1.0, 1e-12) && ended.dissipated > 0.0);
    EXPECT(close(std::hypot(ended.force[0], ended.force[1]), REFERENCE_FORCE, 1e-7));

    // Over a quarter: the state is as if all had been displaced along the other direction.
    std::vector<double> turned(before);
    model.microslip_turn(turned, 0.0, 1.0);
    const double back[2] = {-large[1], 0.0};
    const asperity::Microslip aside = model.microslip_step(REFERENCE_LOAD, back, turned, {});
    EXPECT(aside.force[0] == -ended.force[1] && aside.force[1] == ended.force[0]);
    EXPECT(thrown_by([&] { model.microslip_turn(turned, INF, 0.0); }).status() == ASPERITY_INVALID_PARAMETER);

    const double open = 2.0 * model.summary().pull_off_load;
    const std::vector<double> loads{REFERENCE_LOAD, open}, increment{large[0], large[1], 0.0, 0.0};
    std::vector<double> states(before), force(4), tangents(8);
    states.resize(2 * length, 1.0);
    EXPECT(model.microslip_steps(loads, increment, states, states, force, tangents) == ASPERITY_SEPARATED);
    EXPECT(force[0] == ended.force[0] && force[1] == ended.force[1] && tangents[3] == ended.stiffness[3]);
    EXPECT(std::vector<double>(states.begin(), states.begin() + std::ptrdiff_t(length)) == after);
    EXPECT(std::vector<double>(states.begin() + std::ptrdiff_t(length), states.end()) == std::vector<double>(length));
    EXPECT(model.microslip_steps(loads, increment, states, {}, {}, {}) == ASPERITY_SEPARATED);
    EXPECT(model.microslip_step(open, small, state, after).force[0] == 0.0 && after == state);

    const double endless[2] = {INF, 0.0};
    EXPECT(thrown_by([&] { model.microslip_step(REFERENCE_LOAD, endless, state, after); }).status() ==
           ASPERITY_INVALID_PARAMETER);
    EXPECT(thrown_by([&] { model.microslip_step(REFERENCE_LOAD, small, loads, after); }).status() ==
           ASPERITY_INVALID_PARAMETER);
    EXPECT(thrown_by([&] { (void)model.microslip_steps(loads, loads, states, {}, {}, {}); }).status() ==
           ASPERITY_INVALID_PARAMETER);
}

void a_gap_has_a_load() {
    const Model model(Params::paper());
    const asperity::State state = model.state_at_load(REFERENCE_LOAD);
    const asperity::ValueAndSlope load = model.load_and_slope_at_gap(state.gap);
    EXPECT(close(load.value, REFERENCE_LOAD, 1e-9) && close(load.slope, state.dload_dgap, 1e-7));
    EXPECT(model.load_at_gap(state.gap) == load.value);
    const std::vector<double> gaps{state.gap, 1e6, 0.0};
    const std::vector<double> loads = model.load_at_gap(gaps);
    EXPECT(loads[0] == load.value && loads[1] == 0.0 && loads[2] > loads[0]);
    std::vector<double> into(3), slopes(3);
    EXPECT(model.load_at_gap(gaps, into, slopes) == ASPERITY_SEPARATED && into == loads);
    EXPECT(slopes[0] == load.slope && slopes[1] == 0.0);
    EXPECT(model.load_table().row_count > 0);
    const std::vector<double> wrong{1e6, NAN};
    EXPECT(thrown_by([&] { model.load_at_gap(wrong); }).status() == ASPERITY_INVALID_PARAMETER);
    EXPECT(thrown_by([&] { model.load_at_gap(std::vector<double>{INF}); }).status() == ASPERITY_INVALID_PARAMETER);
}

void batches_have_the_answers_of_one_contact() {
    const Model model(Params::paper());
    const std::vector<double> pressures{1.0, REFERENCE_LOAD}, rates{0.3, -0.2};
    std::vector<double> value(2), slope(2), by_rate(2);
    EXPECT(model.friction_at_pressure(pressures, 2.0, value, slope) == ASPERITY_OK);
    EXPECT(value[1] == model.friction_at_pressure(REFERENCE_LOAD, 2.0));
    EXPECT(slope[1] == model.friction_and_slope_at_pressure(REFERENCE_LOAD, 2.0).slope);
    EXPECT(model.shear_stress_at_pressure(pressures, 2.0, value, slope) == ASPERITY_OK);
    EXPECT(value[1] == model.shear_stress_at_pressure(REFERENCE_LOAD, 2.0));
    EXPECT(model.shear_stress_at_pressure(pressures, -1.0, value) == ASPERITY_INVALID_PARAMETER && std::isnan(value[0]));
    EXPECT(model.slip_force(pressures, rates, 0.5, value, slope, by_rate) == ASPERITY_OK);
    const asperity::SlipForce one = model.slip_force_and_slopes(REFERENCE_LOAD, -0.2, 0.5);
    EXPECT(value[1] == one.value && slope[1] == one.dforce_dload && by_rate[1] == one.dforce_dslip_rate);
    std::vector<double> few(1);
    EXPECT(thrown_by([&] { (void)model.slip_force(pressures, few, 0.5, value); }).status() == ASPERITY_INVALID_PARAMETER);
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

void summits_that_yield_need_a_hardness_and_no_adhesion() {
    Params params = Params::paper().work_of_adhesion(0.0).contact_law(asperity::ContactLaw::elastic_plastic);
    EXPECT(thrown_by([&] { Model{params}; }).status() == ASPERITY_INVALID_PARAMETER);
    const double hardness = 0.005 * params.composite_modulus();
    params = Params::paper().set_elastic_plastic(hardness);
    EXPECT(params.contact_law() == asperity::ContactLaw::elastic_plastic && params.hardness() == hardness);
    const asperity::State state = Model(params).state_at_load(REFERENCE_LOAD);
    EXPECT(state.fraction_elastic > 0.0 && state.fraction_elastic < 1.0 && state.fraction_flowing < 1.0);
    params.work_of_adhesion(1e-3);
    EXPECT(thrown_by([&] { Model{params}; }).status() == ASPERITY_INVALID_PARAMETER);
    EXPECT(thrown_by([&] { params.set_elastic_plastic(0.0); }).status() == ASPERITY_INVALID_PARAMETER);
}

void c_functions_take_what_cpp_made() {
    const Params params = Params::paper();
    const Model model(params);
    static_assert(std::is_same_v<decltype(model.c()), const asperity_model *>);
    EXPECT(asperity_friction_at_load(model.c(), REFERENCE_LOAD) == model.friction_at_load(REFERENCE_LOAD));
    asperity_table view{};
    view.struct_size = sizeof view;
    asperity::check(asperity_table_of(model.c(), &view));
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

void a_surface_is_refused_until_all_is_set() {
    Params params;
    EXPECT(params.c().struct_size == sizeof(asperity_params) && params.max_friction_coefficient() == 1000.0);
    const auto refusal = [&] { return std::string(thrown_by([&] { Model{params}; }).what()); };
    EXPECT(begins(refusal().c_str(), "composite_modulus: must be set; "));
    EXPECT(thrown_by([&] { params.calibrate(1e-3, 0.3); }).what() == refusal());
    params.set_materials(160e9, 0.22, 160e9, 0.22);
    EXPECT(begins(refusal().c_str(), "work_of_adhesion: must be set; "));
    params.set_pair("Si/Si");
    EXPECT(begins(refusal().c_str(), "height_std: must be set; "));
    params.height_std(5e-9).summit_radius(1e-6);
    EXPECT(begins(refusal().c_str(), "asperity_count: must be set; "));
    EXPECT(Model(params.asperity_count(1e5)).friction_at_load(1e-3) > 0.5);
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
    versions_are_those_of_the_header();
    every_status_has_its_own_words();
    an_error_carries_status_and_message();
    each_setter_sets_its_own_field();
    a_table_is_copied_and_shared();
    materials_give_the_moduli_of_both_bodies();
    one_measured_point_sets_the_strength();
    what_is_no_measurement_is_refused();
    a_strength_that_nobody_measured_is_warned_of_whatever_the_count();
    a_slip_radius_is_a_ratio();
    bounds_are_those_that_the_pages_say();
    spectral_moments_give_the_summits();
    dimensionless_groups_come_back_from_the_model();
    parameters_are_set_and_read_by_name();
    a_surface_is_a_text();
    an_estimate_needs_a_text_alone();
    a_text_may_have_a_table();
    a_surface_file_is_read(std::string(arguments[0]) + ".toml");
    a_surface_in_other_units_has_the_same_friction();
    skew_chooses_the_weibull_shape();
    johnson_heights_have_a_skew_and_a_kurtosis_of_their_own();
    sensitivities_are_those_of_the_friction_force();
    a_model_moves_and_does_not_copy();
    a_model_that_was_moved_from_says_so();
    parameters_change_all_or_nothing();
    friction_is_that_of_the_reference();
    states_are_those_of_the_reference();
    materials_and_pairs_are_those_of_the_table();
    interfaces_are_those_of_the_table();
    a_range_of_loads_warns_of_what_fails_in_it();
    single_summits_are_those_of_hertz();
    friction_is_defined_at_every_load();
    pressure_is_load_per_area_of_the_summits();
    slip_gives_the_force_a_smooth_sign();
    contacts_stick_before_they_slip();
    the_sum_of_contact_radii_is_the_stiffness_over_8_moduli();
    a_contact_remembers();
    a_gap_has_a_load();
    batches_have_the_answers_of_one_contact();
    contacts_of_several_models_in_one_call();
    summits_that_yield_need_a_hardness_and_no_adhesion();
    c_functions_take_what_cpp_made();
    the_table_answers_as_the_model();
    every_contiguous_range_will_do();
    a_surface_is_refused_until_all_is_set();
    a_solver_gets_every_element_and_the_first_invalid();
    arrays_of_other_sizes_are_refused_before_anything_is_written();
    threads_share_a_model();
    return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
