// What asperity.hpp adds to C: values that own, moves, exceptions with messages, ranges; and each of its calls once, for its arguments
// and its status. Floating-point traps are on. What the answers are is asked elsewhere.

#include <asperity.hpp>

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

bool close(double value, double expected, double tolerance) { return std::fabs(value - expected) <= tolerance * std::fabs(expected); }

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

/// Whether a call throws that its arguments are invalid.
template <class Call>
bool refused(Call call) { return thrown_by(call).status() == ASPERITY_INVALID_PARAMETER; }

bool begins(const char *text, const char *with) { return std::strncmp(text, with, std::strlen(with)) == 0; }

constexpr double INF = std::numeric_limits<double>::infinity();
constexpr double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();

void what_is_looked_up_is_a_string() {
    EXPECT(std::strcmp(asperity::version(), ASPERITY_VERSION) == 0 && asperity::abi_version() == ASPERITY_ABI_VERSION);
    EXPECT(std::strcmp(asperity::status_string(ASPERITY_OK), "success") == 0 && asperity::warnings_text(0) == "no warning");
    const std::vector<std::string> materials = asperity::names(asperity::Kind::materials);
    EXPECT(materials.size() > 20 && materials.front() == "Si");
    EXPECT(begins(asperity::describe(asperity::Kind::materials, "Si").c_str(), "name = \"Si\"\nyoung = "));
    EXPECT(refused([] { (void)asperity::describe(asperity::Kind::materials, "stel"); }));
}

void an_error_carries_status_and_message() {
    const Error error = thrown_by([] { Model(Params::paper().height_std(-2.0)); });
    EXPECT(error.status() == ASPERITY_INVALID_PARAMETER && begins(error.what(), "height_std = -2: must be "));
    EXPECT(asperity::last_error() == error.what());
    static_assert(std::is_base_of_v<std::exception, Error>);
    asperity::check(ASPERITY_OK);
    EXPECT(thrown_by([] { asperity::check(ASPERITY_SEPARATED); }).status() == ASPERITY_SEPARATED);
    std::string elsewhere = "not asked";
    std::thread([&] { elsewhere = asperity::last_error(); }).join();
    EXPECT(elsewhere.empty());
}

double other(double value) { return value == 3.5 ? 4.5 : 3.5; }
bool other(bool value) { return !value; }
template <class Choice>
Choice other(Choice value) { return static_cast<Choice>(static_cast<std::int32_t>(value) + 1); }

/// A setter of Params changes its own field of the C struct and no other.
template <class Value>
void field_is_set(Params &(Params::*set)(Value) noexcept, Value (Params::*get)() const noexcept, const char *name, std::size_t offset,
                  std::size_t size) {
    Params params;
    const Params before;
    const Value value = other((before.*get)());
    EXPECT(&(params.*set)(value) == &params);
    EXPECT((params.*get)() == value && params.get(name) == static_cast<double>(value));
    const auto *bytes = reinterpret_cast<const unsigned char *>(&params.c()), *old = reinterpret_cast<const unsigned char *>(&before.c());
    EXPECT(std::memcmp(bytes, old, offset) == 0);
    EXPECT(std::memcmp(bytes + offset + size, old + offset + size, sizeof(asperity_params) - offset - size) == 0);
}

#define FIELDS(F)                                                                                                                        \
    F(composite_modulus) F(effective_shear_modulus) F(work_of_adhesion) F(adhesion_range) F(burgers_vector) F(height_std)                \
    F(summit_radius) F(asperity_count) F(height_distribution) F(attraction) F(weibull_shape) F(radius_amplitude) F(radius_rate)          \
    F(slip_radius_1) F(slip_stress_1) F(slip_radius_2) F(slip_stress_2) F(max_friction_coefficient) F(skew) F(kurtosis) F(hardness)      \
    F(tangential_modulus) F(nominal_area) F(contact_law) F(slip_onset) F(pressure_coefficient) F(bandwidth) F(calibration_load)          \
    F(calibration_friction_force) F(calibration_error) F(summit_mean_height) F(rms_slope) F(waviness_height)        \
    F(waviness_width) F(waviness_shape) F(taken_as_gaussian) F(length_unit) F(force_unit)
#define FIELD(name)                                                                                                                      \
    field_is_set<decltype(Params().name())>(&Params::name, &Params::name, #name, offsetof(asperity_params, name), sizeof Params().c().name);

void each_setter_sets_its_own_field() { FIELDS(FIELD) }

void a_table_is_copied_and_shared() {
    const std::vector<double> heights{1.0, 2.0, 3.0, 4.0, 5.0}, densities{0.0, 1.0, 2.0, 1.0, 0.0};
    EXPECT(Params().table_height().size() == 0 && Params().table_density().data() == nullptr);
    Params copy = Params::paper();
    copy = Params(copy.table(std::vector<double>(heights), std::vector<double>(densities)));
    EXPECT(Params(copy).table(densities, heights).table_height().data()[4] == 0.0);
    EXPECT(copy.height_distribution() == asperity::Heights::tabulated && copy.table_height().data() != heights.data());
    EXPECT(copy.table_height().size() == 5 && copy.table_height().data()[4] == 5.0);
    EXPECT(copy.table_density().size() == 5 && copy.table_density().data()[2] == 2.0);
    // From C and back: the copy has a table of its own, and so have the parameters of a model that is gone.
    const Params again(copy.c()), back = Model(copy).params();
    EXPECT(again.table_height().data() != copy.table_height().data() && again.table_density().data()[1] == 1.0);
    EXPECT(back.table_height().data()[4] == 5.0 && back.table_density().data()[2] == 2.0);

    const Error error = thrown_by([&] { copy.table(heights, {densities.data(), 4}); });
    EXPECT(error.status() == ASPERITY_INVALID_PARAMETER && copy.table_height().size() == 5);
    EXPECT(begins(error.what(), "size of densities = 4: must be the number of heights, 5"));
    // A table of the text belongs to the library: copies, and what comes after, have it too.
    const std::string text = "table_height = [1.0, 2.0, 3.0, 4.0, 5.0]\ntable_density = [0.0, 1.0, 2.0, 1.0, 0.0]\n";
    const Params read = Params(Params::paper().set_text(text)).set_text("radius_amplitude = 0.1");
    EXPECT(read.height_distribution() == asperity::Heights::tabulated && read.table_height().data()[4] == 5.0);
    EXPECT(Params().set_text(read.text()).table_density().data()[2] == 2.0);
}

void parameters_are_set_and_read_by_name() {
    Params params;
    EXPECT(params.set("hardness", 3.0).get("hardness") == 3.0);
    params.set({{"nu2", 0.22}, {"E1", 160e9}, {"nu1", 0.3}, {"E2", 70e9}});
    EXPECT(params.composite_modulus() == Params().set_materials(160e9, 0.3, 70e9, 0.22).composite_modulus());
    EXPECT(begins(thrown_by([&] { params.set("hardnes", 4.0); }).what(), "hardnes: no parameter has this name; the nearest is hardness"));
    EXPECT(begins(thrown_by([&] { params.get("E1"); }).what(), "E1: is not kept"));
    EXPECT(params.hardness() == 3.0);
}

constexpr const char *STEEL = "pair = \"steel/steel\"\ncontact_law = \"elastic-plastic\"\nwork_of_adhesion = 0\nnominal_area = 1e-4\n"
                              "calibration_load = 1000\ncalibration_friction_coefficient = 0.16\nsize_effect = 1\npressure_coefficient = 0\n"
                              "[roughness]\nm0 = 1e-12\nm2 = 0.02\nm4 = 4e9\n";

void parameters_come_from_what_is_known(const std::string &path) {
    const auto same = [](const Params &a, const Params &b) { return std::memcmp(&a.c(), &b.c(), sizeof(asperity_params)) == 0; };
    const Params params = Params().set_text(STEEL);
    Params by_hand;
    by_hand.set_pair("steel/steel").contact_law(asperity::ContactLaw::elastic_plastic).work_of_adhesion(0.0);
    by_hand.set_spectral_moments(1e-12, 0.02, 4e9, 1e-4).calibrate(1000.0, 0.16);
    EXPECT(same(params, by_hand) && same(Params(by_hand).calibrate_force(1000.0, 160.0), by_hand));
    EXPECT(same(Params().set_text(params.text()), params));
    EXPECT(close(Params(params).set_units(1e-3, 1.0).nominal_area(), 100.0, 1e-14));
    EXPECT(refused([&] { Params(params).set_units(1e-3, 1.0).set_units(1e-3, 1.0); }));
    EXPECT(refused([&] { Params(params).set_units(1e-3, 1.0).set_text(STEEL); }));

    std::FILE *file = std::fopen(path.c_str(), "wb");
    EXPECT(file != nullptr && std::fputs(STEEL, file) >= 0 && std::fclose(file) == 0);
    EXPECT(same(Params().read(path), params) && std::remove(path.c_str()) == 0);
    EXPECT(begins(thrown_by([&] { Params().read(path); }).what(), (path + ": ").c_str()));

    Params other = Params::paper();
    const Error error = thrown_by([&] { other.set_text("hardness = 1\nslip_onset = \"hole\"\n"); });
    EXPECT(error.status() == ASPERITY_INVALID_PARAMETER && same(other, Params::paper()));
    EXPECT(std::string(error.what()) == "line 2: slip_onset = \"hole\": must be \"partial\" or \"whole\"");
    other.contact_law(static_cast<asperity::ContactLaw>(7));
    EXPECT(refused([&] { (void)other.text(); }));
    EXPECT(refused([&] { other.set_materials(-1.0, 0.3, INF, 0.3); }) && refused([&] { other.set_pair("steel/cheese"); }));
    EXPECT(refused([&] { other.set_spectral_moments(0.0, 1.0, 1.0, 1.0); }) && refused([&] { other.set_units(0.0, 1.0); }));
    EXPECT(refused([&] { other.calibrate(1.0, -1.0); }) && refused([&] { other.calibrate_force(1.0, -1.0); }));
    EXPECT(refused([&] { other.set_dimensionless(-1.0, 1000.0, 0.001); }));
}

void an_estimate_needs_a_text_alone() {
    constexpr const char *GROUND = "pair = \"steel/steel\"\nnominal_area = 1e-4\nmeasured = [1000, 0.16]\n"
                                   "[roughness]\nprocess = \"ground\"\nRa = 0.8e-6\n";
    const std::vector<double> loads = {10.0, 1000.0};
    const std::vector<asperity::Estimate> found = asperity::estimates(GROUND, loads);
    EXPECT(found.size() == 2 && found[0].load == 10.0 && close(found[1].friction_coefficient, 0.16, 1e-6));
    EXPECT(close(asperity::estimate(GROUND, 10.0).friction_coefficient, found[0].friction_coefficient, 1e-7));
    EXPECT(begins(asperity::estimate_text(GROUND, loads).c_str(), "mu(10 N) = "));
    EXPECT(Params::paper().set_text(GROUND).calibration_load() == 1000.0);
    EXPECT(begins(thrown_by([] { (void)asperity::estimate("mu = 1", 1.0); }).what(), "line 1: mu: no such key"));
    EXPECT(begins(thrown_by([&] { (void)asperity::estimate_text("mu = 1", loads); }).what(), "line 1: mu: no such key"));
}

void a_model_moves_and_does_not_copy() {
    static_assert(!std::is_copy_constructible_v<Model> && !std::is_copy_assignable_v<Model>);
    static_assert(std::is_nothrow_move_constructible_v<Model> && std::is_nothrow_move_assignable_v<Model>);

    Model first(Params::paper());
    const double mu = first.friction_at_load(100.0);
    const double *const rows = first.table().rows;
    Model second(std::move(first));
    EXPECT(second.friction_at_load(100.0) == mu && second.table().rows == rows && first.c() == nullptr);
    first = std::move(second);
    EXPECT(first.friction_at_load(100.0) == mu && second.c() == nullptr);
}

// Each call of a model, by one and by many loads, on one that was moved from.
void a_model_that_was_moved_from_says_so() {
    Model first(Params::paper());
    const Model second(std::move(first));
    std::vector<double> loads{1.0}, out(1);
    const std::vector<std::function<void()>> calls{
        [&] { first.set_params(Params::paper()); }, [&] { first.params(); }, [&] { first.friction_at_load(1.0); },
        [&] { first.friction_force_at_load(1.0); }, [&] { first.friction_and_slope_at_load(1.0); },
        [&] { first.friction_force_and_slope_at_load(1.0); }, [&] { (void)first.friction_at_load(loads, out); },
        [&] { (void)first.friction_force_at_load(loads, out); }, [&] { (void)first.tangential_stiffness_at_load(loads, out); },
        [&] { first.friction_at_load(loads); }, [&] { first.friction_force_and_slope_at_load(loads); },
        [&] { first.tangential_stiffness_at_load(1.0); }, [&] { first.tangential_stiffness_at_load(loads); },
        [&] { first.tangential_at_load(1.0, 1.0); }, [&] { first.state_at_load(1.0); }, [&] { first.state_at_gap(1.0); },
        [&] { first.check_loads(1.0, 2.0); }, [&] { first.specimens_at_loads(loads); }, [&] { first.summary(); },
        [&] { first.table(); }, [&] { first.load_at_gap(1.0); }, [&] { first.load_and_slope_at_gap(1.0); },
        [&] { first.load_at_gap(loads); }, [&] { (void)first.load_at_gap(loads, out); }, [&] { first.microslip_length(); },
        [&] { first.friction_force_at_load(loads); }, [&] { first.friction_and_slope_at_load(loads); },
    };
    for (const auto &call : calls) {
        const Error error = thrown_by(call);
        EXPECT(error.status() == ASPERITY_NULL_POINTER && begins(error.what(), "Model was moved from: assign a model to it"));
    }
    EXPECT(out[0] == 0.0 && second.friction_at_load(1.0) > 0.0);
    static_assert(std::is_base_of_v<Error, asperity::MovedFrom>);
}

void parameters_change_all_or_nothing() {
    Model model(Params::paper());
    const double force = model.friction_force_at_load(100.0);
    EXPECT(refused([&] { model.set_params(Params::paper().summit_radius(0.0)); }));
    EXPECT(model.friction_force_at_load(100.0) == force && model.params().asperity_count() == 1.0);
    EXPECT(thrown_by([&] { model.unloaded(1.0); }).status() == ASPERITY_OUT_OF_RANGE); // adhesive
    const Params yielding = Params::paper().work_of_adhesion(0.0).hardness(0.02);
    const Model joint(Params(yielding).contact_law(asperity::ContactLaw::elastic_plastic));
    const Model tightened = joint.unloaded(1.0);
    EXPECT(close(tightened.summary().largest_load, 1.0, 1e-15) && joint.summary().largest_load == 0.0);
    EXPECT(tightened.friction_force_at_load(0.3) > joint.friction_force_at_load(0.3));
    model.set_params(Params::paper().asperity_count(2.0));
    EXPECT(close(model.friction_force_at_load(200.0), 2.0 * force, 1e-9) && model.params().asperity_count() == 2.0);
}

constexpr double LOAD = 2684.0;

// What C answers is asked elsewhere: here that each call reaches it with its arguments in order, and throws its status.
void every_call_answers_as_the_library() {
    const Model model(Params::paper());
    const asperity_model *c = model.c();
    static_assert(std::is_same_v<decltype(model.c()), const asperity_model *>);
    double slope = 0.0;
    EXPECT(model.friction_at_load(LOAD) == asperity_friction_at_load(c, LOAD) && std::isnan(model.friction_at_load(NOT_A_NUMBER)));
    EXPECT(model.friction_force_at_load(LOAD) == asperity_friction_force_at_load(c, LOAD));
    const auto [mu, dmu] = model.friction_and_slope_at_load(LOAD);
    EXPECT(mu == asperity_friction_and_slope_at_load(c, LOAD, &slope) && dmu == slope);
    const auto [force, dforce] = model.friction_force_and_slope_at_load(LOAD);
    EXPECT(force == asperity_friction_force_and_slope_at_load(c, LOAD, &slope) && dforce == slope);
    const double stiffness = model.tangential_stiffness_at_load(LOAD), length = force / stiffness;
    EXPECT(stiffness == asperity_tangential_stiffness_at_load(c, LOAD));
    EXPECT(close(model.tangential_at_load(LOAD, 1e-8 * length).slope, stiffness, 1e-6));
    EXPECT(refused([&] { model.tangential_at_load(LOAD, INF); }));

    const asperity::State state = model.state_at_load(LOAD);
    EXPECT(close(state.contact_radius_sum * model.summary().stiffness_per_radius, stiffness, 1e-7));
    EXPECT(close(model.state_at_gap(state.gap).load, LOAD, 1e-9));
    EXPECT(thrown_by([&] { model.state_at_load(INF); }).status() == ASPERITY_INVALID_LOAD);
    EXPECT(refused([&] { model.state_at_gap(INF); }));
    const auto [load, dload] = model.load_and_slope_at_gap(state.gap);
    EXPECT(load == asperity_load_and_slope_at_gap(c, state.gap, &slope) && dload == slope && load == model.load_at_gap(state.gap));
    EXPECT((model.check_loads(1.0, 2.0) & ASPERITY_WARNING_UNCALIBRATED) != 0);
    EXPECT(refused([&] { (void)model.check_loads(2.0, 1.0); }));
    const std::vector<double> specimen_loads{LOAD, 0.0}, none{1.0, NOT_A_NUMBER};
    const std::vector<asperity::Specimens> specimens = model.specimens_at_loads(specimen_loads, 3);
    EXPECT(specimens.size() == 2 && specimens[1].load == 0.0 && specimens[0].contacts[ASPERITY_SPREAD_MEAN] == 1.0);
    EXPECT(close(specimens[0].friction_force[ASPERITY_SPREAD_HIGH], specimens[0].friction_force[ASPERITY_SPREAD_LOW], 1e-9));
    const asperity::EachSpecimen each = model.each_specimen_at_loads(specimen_loads, 0.0, 3, 2);
    EXPECT(each.friction_force.size() == 4 && each.friction_force[0] > 0.0 && each.pull_off_force[0] >= 0.0);
    EXPECT(thrown_by([&] { model.specimens_at_loads(none); }).status() == ASPERITY_INVALID_LOAD);
    EXPECT(model.table(ASPERITY_TABLE_LOAD_AT_GAP).rows != model.table().rows);
    EXPECT(refused([&] { model.table(2); }));
    asperity_model *own = nullptr;
    asperity::check(asperity_create(&model.params().c(), &own));
    EXPECT(asperity_friction_at_load(own, LOAD) == mu);
    asperity_free(own);

    // A trial step keeps no state, one that is accepted may be in place; a turned state resists as if turned before.
    std::vector<double> at(model.microslip_length()), forces(2), tangents(4);
    const double step[2] = {0.0, 0.6 * length}, same[2] = {-step[1], 0.0};
    const asperity::Microslip trial = model.microslip_step(LOAD, step, at, {});
    EXPECT(model.microslip_steps({&LOAD, 1}, step, at, {}, forces, tangents) == ASPERITY_OK);
    EXPECT(forces[1] == trial.force[1] && tangents[3] == trial.stiffness[3]);
    std::vector<double> turned(at);
    EXPECT(model.microslip_step(LOAD, step, at, at).force[1] == trial.force[1] && at != turned);
    EXPECT(model.microslip_steps({&LOAD, 1}, step, turned, turned, {}, {}) == ASPERITY_OK && at == turned);
    model.microslip_turn(turned, 0.0, 1.0);
    EXPECT(close(model.microslip_step(LOAD, same, turned, {}).force[0], -model.microslip_step(LOAD, step, at, {}).force[1], 1e-14));
    EXPECT(refused([&] { model.microslip_turn(turned, INF, 0.0); }) && refused([&] { model.microslip_step(LOAD, step, none, at); }));
    EXPECT(model.microslip_step(2.0 * model.summary().pull_off_load, step, at, {}).force[1] == 0.0);
}

void contacts_of_several_models_in_one_call() {
    const Model first(Params::paper()), second(Params::paper().work_of_adhesion(0.0));
    const std::vector<const Model *> models{&first, &second};
    const std::vector<std::uint32_t> which{1, 0, 1}, unknown{0, 2, 1};
    const std::vector<double> loads{1.0, LOAD, LOAD};
    std::vector<double> force(3), slope(3);
    EXPECT(asperity::friction_force_at_load(models, which, loads, force, slope) == ASPERITY_OK);
    EXPECT(force[1] == first.friction_force_at_load(LOAD) && force[2] == second.friction_force_at_load(LOAD));
    EXPECT(slope[0] == second.friction_force_and_slope_at_load(1.0).slope);
    EXPECT(asperity::friction_force_at_load(models, unknown, loads, force) == ASPERITY_INVALID_PARAMETER && std::isnan(force[1]));
    const std::vector<const Model *> none{&first, nullptr};
    EXPECT(thrown_by([&] { (void)asperity::friction_force_at_load(none, which, loads, force); }).status() == ASPERITY_NULL_POINTER);
    const std::vector<const Model *> many(65, &second);
    EXPECT(asperity::friction_force_at_load(many, which, loads, force) == ASPERITY_OK && force[0] == second.friction_force_at_load(1.0));
}

template <class Loads>
void a_range_gives_what_its_elements_give(const Model &model, const Loads &loads) {
    const std::vector<double> mu = model.friction_at_load(loads), force = model.friction_force_at_load(loads);
    const auto [mu_again, dmu] = model.friction_and_slope_at_load(loads);
    const auto [force_again, dforce] = model.friction_force_and_slope_at_load(loads);
    EXPECT(mu.size() == std::size(loads) && dforce.size() == std::size(loads) && mu == mu_again && force == force_again);
    for (std::size_t i = 0; i < mu.size(); ++i) {
        const double load = std::data(loads)[i];
        EXPECT(mu[i] == model.friction_at_load(load) && force[i] == model.friction_force_at_load(load));
        EXPECT(dmu[i] == model.friction_and_slope_at_load(load).slope && dforce[i] == model.friction_force_and_slope_at_load(load).slope);
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
    EXPECT(mu[0] == model.friction_at_load(1.0) && mu[1] == 0.0 && std::isnan(mu[2]) && force[1] == 0.0);
    EXPECT(mu[3] == model.friction_at_load(100.0) && dmu[3] == model.friction_and_slope_at_load(100.0).slope);

    // As vectors: an open contact is an answer, and hides no load that has none.
    const std::vector<double> open{1.0, 2.0 * pull_off, 100.0}, heavy{1.0, 2.0 * pull_off, 100.0, 1e300}, alone{1.0, 1e300};
    EXPECT((model.friction_at_load(open) == std::vector<double>{mu[0], 0.0, mu[3]}));
    EXPECT((model.friction_force_and_slope_at_load(open).slope == std::vector<double>{dforce[0], 0.0, dforce[3]}));
    for (const auto &ask : {
             +[](const Model &m, const std::vector<double> &l) { m.friction_at_load(l); },
             +[](const Model &m, const std::vector<double> &l) { m.friction_force_at_load(l); },
             +[](const Model &m, const std::vector<double> &l) { m.friction_and_slope_at_load(l); },
             +[](const Model &m, const std::vector<double> &l) { m.friction_force_and_slope_at_load(l); },
             +[](const Model &m, const std::vector<double> &l) { m.tangential_stiffness_at_load(l); },
         }) {
        EXPECT(begins(thrown_by([&] { ask(model, loads); }).what(), "element 2: load = NaN"));
        EXPECT(begins(thrown_by([&] { ask(model, heavy); }).what(), "element 3: load = 1e300: "));
        EXPECT(thrown_by([&] { ask(model, heavy); }).status() == ASPERITY_OUT_OF_RANGE);
        EXPECT(begins(thrown_by([&] { ask(model, alone); }).what(), "element 1: load = 1e300: "));
    }
    const std::vector<double> gaps{1.0, 1e6}, no_gaps{1.0, 1e6, NOT_A_NUMBER};
    std::vector<double> into(2), slopes(2);
    EXPECT(model.load_at_gap(gaps, into, slopes) == ASPERITY_SEPARATED && slopes[0] < 0.0 && slopes[1] == 0.0);
    EXPECT(model.load_at_gap(gaps) == into && into[0] == model.load_at_gap(1.0));
    EXPECT(begins(thrown_by([&] { model.load_at_gap(no_gaps); }).what(), "element 2 of the gaps: "));

    std::vector<double> in_place{1.0, 100.0};
    EXPECT(model.friction_at_load(in_place, in_place) == ASPERITY_OK && in_place[1] == mu[3]);
}

void arrays_of_other_sizes_are_refused_before_anything_is_written() {
    const Model model(Params::paper());
    std::vector<double> mu(3, -1.0), slope(1, -1.0);
    const std::vector<double> loads{1.0, 2.0};
    const char *const said = "size of values = 3: must be the number of loads, 2";
    EXPECT(begins(thrown_by([&] { (void)model.friction_at_load(loads, mu); }).what(), said));
    mu.resize(2);
    EXPECT(refused([&] { (void)model.friction_force_at_load(loads, mu, slope); }));
    EXPECT(mu[0] == -1.0 && slope[0] == -1.0);
}

void threads_share_a_model() {
    const Model model(Params::paper());
    std::array<double, 4> mu{};
    std::vector<std::thread> threads;
    for (double &own : mu) {
        threads.emplace_back([&] { own = model.friction_at_load(LOAD); });
    }
    for (std::size_t i = 0; i < mu.size(); ++i) {
        threads[i].join();
        EXPECT(mu[i] == model.friction_at_load(LOAD));
    }
}

} // namespace

int main(int, char **arguments) {
    feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
    what_is_looked_up_is_a_string();
    an_error_carries_status_and_message();
    each_setter_sets_its_own_field();
    a_table_is_copied_and_shared();
    parameters_are_set_and_read_by_name();
    an_estimate_needs_a_text_alone();
    parameters_come_from_what_is_known(std::string(arguments[0]) + ".toml");
    a_model_moves_and_does_not_copy();
    every_call_answers_as_the_library();
    a_model_that_was_moved_from_says_so();
    parameters_change_all_or_nothing();
    contacts_of_several_models_in_one_call();
    every_contiguous_range_will_do();
    a_solver_gets_every_element_and_the_first_invalid();
    arrays_of_other_sizes_are_refused_before_anything_is_written();
    threads_share_a_model();
    return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
