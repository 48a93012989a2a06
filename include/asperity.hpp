// asperity for C++17: friction laws from contact physics, callable from any solver.
//
// Values, ownership and exceptions over the C interface in asperity.h, whose units, parameters and threading rules hold
// here too. Header only: link libasperity, nothing else.
//
//     asperity::Params params; // SI units: N, m, Pa
//     params.set_pair("Si/Si").height_std(5e-9).summit_radius(1e-6).asperity_count(1e5);
//     params.calibrate(1e-2, 0.25); // a friction coefficient that was measured, and its load
//     const asperity::Model model(params);
//     double mu = model.friction_at_load(1e-3);
//
// C: Params::c() and Model::c() are what functions of asperity.h take; check() makes an exception of their status.
// Errors, one rule each:
//   Calls that return a number return one for every load, and never throw for a load: NaN where there is no answer.
//   Batch calls into memory of the caller return a Status, which is [[nodiscard]]: look at it, or pass it to check().
//   All other calls throw asperity::Error, with the status and the message of the library.
//   A Model that was moved from throws asperity::MovedFrom from every call but c(), until a model is assigned to it.
// Macros: other headers may have macros check, Status and the like; where they have, write (asperity::check)(...) and asperity_status.
// Threads: a const Model may be shared. Floating point: no call raises invalid, divide-by-zero or overflow.

#ifndef ASPERITY_HPP
#define ASPERITY_HPP

#if !(__cplusplus >= 201703L || (defined(_MSVC_LANG) && _MSVC_LANG >= 201703L))
#error "asperity.hpp needs C++17 or later; asperity.h works with every C++"
#endif

// Other headers have macros of these names, as <X11/Xlib.h>, <curses.h> and Perl's; at the end they are what they were before.
#pragma push_macro("Error")
#undef Error
#pragma push_macro("Model")
#undef Model
#pragma push_macro("Span")
#undef Span
#pragma push_macro("State")
#undef State
#pragma push_macro("Status")
#undef Status
#pragma push_macro("T")
#undef T
#pragma push_macro("Table")
#undef Table
#pragma push_macro("check")
#undef check
#pragma push_macro("clear")
#undef clear
#pragma push_macro("copy")
#undef copy
#pragma push_macro("count")
#undef count
#pragma push_macro("data")
#undef data
#pragma push_macro("describe")
#undef describe
#pragma push_macro("empty")
#undef empty
#pragma push_macro("end")
#undef end
#pragma push_macro("erase")
#undef erase
#pragma push_macro("error")
#undef error
#pragma push_macro("get")
#undef get
#pragma push_macro("index")
#undef index
#pragma push_macro("insert")
#undef insert
#pragma push_macro("length")
#undef length
#pragma push_macro("max")
#undef max
#pragma push_macro("min")
#undef min
#pragma push_macro("move")
#undef move
#pragma push_macro("open")
#undef open
#pragma push_macro("read")
#undef read
#pragma push_macro("reset")
#undef reset
#pragma push_macro("set")
#undef set
#pragma push_macro("size")
#undef size
#pragma push_macro("status")
#undef status
#pragma push_macro("string")
#undef string
#pragma push_macro("table")
#undef table
#pragma push_macro("text")
#undef text
#pragma push_macro("version")
#undef version

#include "asperity.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace asperity {

/// What a call of the C interface returns: ASPERITY_OK or why it failed.
using Status = asperity_status;
/// The exact state of a contact; its fields are described in asperity.h.
using State = asperity_state;
/// Constants of a model; its fields are described in asperity.h.
using Summary = asperity_summary;
/// A view of the compiled law, for asperity_eval.h; its fields are described in asperity.h.
using Table = asperity_table;
/// What resists a displacement in a step of a contact that remembers; its fields are described in asperity.h.
using Microslip = asperity_microslip;
/// Friction at one load, with its band; estimates() fills it.
using Estimate = asperity_estimate;
/// Single specimens under one load; its fields are described in asperity.h.
using Specimens = asperity_specimens;

/// Specimens at loads, one by one: the loads of one specimen are next to each other. NaN is the gap of one that is apart.
struct EachSpecimen {
    std::vector<double> friction_force, tangential_stiffness, normal_stiffness, gap, contacts, pull_off_force;
};

// ---- Versions ----

/// Version of the library loaded, "major.minor.patch".
inline const char *version() noexcept { return asperity_version(); }

/// Binary interface of the library loaded; a program compiled against another one, ASPERITY_ABI_VERSION of the header,
/// must be compiled again.
inline std::uint32_t abi_version() noexcept { return asperity_abi_version(); }

// ---- Errors ----

/// What a status means, in a few words; a constant string.
inline const char *status_string(Status status) noexcept { return asperity_status_string(status); }

namespace detail {

/// The text that a function of the C interface copies out.
template <class Copy>
std::string copied(Copy copy) {
    std::string text(copy(nullptr, 0), '\0');
    copy(text.data(), text.size() + 1);
    return text;
}

} // namespace detail

/// What the bits ASPERITY_WARNING_ of a state say, a line for each.
inline std::string warnings_text(std::uint64_t warnings) {
    return detail::copied([=](char *buffer, std::size_t length) { return asperity_warnings_text(warnings, buffer, length); });
}

/// Why a call failed: the status, and in what() a message that names parameter, value and what is allowed.
class Error : public std::runtime_error {
public:
    /// An error with this status and message.
    Error(Status status, const std::string &message) : std::runtime_error(message), status_(status) {}

    /// One of the ASPERITY_ constants, never ASPERITY_OK.
    Status status() const noexcept { return status_; }

private:
    Status status_;
};

/// A Model was used after it was moved from; its status is ASPERITY_NULL_POINTER.
class MovedFrom : public Error {
public:
    /// The error, which says what to do.
    MovedFrom() : Error(ASPERITY_NULL_POINTER, "Model was moved from: assign a model to it before you use it") {}
};

/// The message of the last call on this thread that failed; empty if none did.
inline std::string last_error() { return detail::copied(asperity_last_error); }

/// Throws Error with this thread's last message unless the status, just returned by a C call, is ASPERITY_OK.
inline void check(Status status) {
    if (status != ASPERITY_OK) {
        throw Error(status, last_error());
    }
}

namespace detail {

/// The same where an empty text says that something is refused.
template <class Copy>
std::string copied_or_thrown(Copy copy) {
    std::string text = copied(copy);
    if (text.empty()) {
        throw Error(ASPERITY_INVALID_PARAMETER, last_error());
    }
    return text;
}

} // namespace detail

// ---- Arrays ----

/// A view of contiguous elements that somebody else owns: a pointer and a number, as std::span of C++20.
///
/// Made from any container with data() and size() (std::vector, std::array, std::span, Eigen::VectorXd, ...), from a C
/// array, or from pointer and size.
template <class T>
class Span {
    template <class Range>
    using Element = std::remove_pointer_t<decltype(std::data(std::declval<Range &>()))>;

    // The array conversion T(*)[] lets const be added, but no derived class pass for its base.
    template <class Range>
    using IfRange = std::enable_if_t<
        !std::is_same_v<std::remove_cv_t<std::remove_reference_t<Range>>, Span> &&
        std::is_convertible_v<Element<std::remove_reference_t<Range>> (*)[], T (*)[]>>;

public:
    /// No elements.
    constexpr Span() noexcept = default;

    /// `size` elements from `data` on.
    constexpr Span(T *data, std::size_t size) noexcept : data_(data), size_(size) {}

    /// The elements of a container, which must outlive the view.
    template <class Range, class = IfRange<Range>>
    constexpr Span(Range &&range) noexcept
        : data_(std::data(range)), size_(static_cast<std::size_t>(std::size(range))) {}

    /// The first element; may be null if there is none.
    constexpr T *data() const noexcept { return data_; }

    /// The number of elements.
    constexpr std::size_t size() const noexcept { return size_; }

private:
    T *data_ = nullptr;
    std::size_t size_ = 0;
};

/// A friction coefficient or force at one load, or a load at one gap, and its derivative with respect to that.
struct ValueAndSlope {
    double value;
    double slope;
};

/// Friction coefficients or forces at many loads, and their derivatives with respect to the load.
struct ValuesAndSlopes {
    std::vector<double> value;
    std::vector<double> slope;
};

// ---- Names ----

namespace detail {

/// A struct of the C interface that says its size.
template <class Struct>
Struct sized() noexcept {
    Struct made{};
    made.struct_size = sizeof made;
    return made;
}

} // namespace detail

/// What has names.
enum class Kind : std::int32_t {
    parameters = ASPERITY_NAMES_PARAMETERS,
    materials = ASPERITY_NAMES_MATERIALS,
    pairs = ASPERITY_NAMES_PAIRS,
    interfaces = ASPERITY_NAMES_INTERFACES,
    warnings = ASPERITY_NAMES_WARNINGS,
    statuses = ASPERITY_NAMES_STATUSES,
};

/// The names of all parameters, materials, pairs, ... that the library knows.
inline std::vector<std::string> names(Kind kind) {
    std::vector<std::string> all;
    while (const char *name = asperity_name(static_cast<std::int32_t>(kind), all.size())) {
        all.emplace_back(name);
    }
    return all;
}

/// What is known of one of them, as lines of TOML with units and source: asperity_describe. Throws Error
/// (ASPERITY_INVALID_PARAMETER), whose message has the nearest name.
inline std::string describe(Kind kind, const std::string &name) {
    return detail::copied_or_thrown([&](char *buffer, std::size_t length) {
        return asperity_describe(static_cast<std::int32_t>(kind), name.c_str(), buffer, length);
    });
}

// ---- One call ----

/// Friction at loads with its band, from the text of a surface alone: asperity_estimate_at_loads. Throws Error.
inline std::vector<Estimate> estimates(std::string_view surface, Span<const double> load) {
    std::vector<Estimate> found(load.size(), detail::sized<Estimate>());
    check(asperity_estimate_at_loads(surface.data(), surface.size(), load.size(), load.data(), found.data()));
    return found;
}

/// The same at one load.
inline Estimate estimate(std::string_view surface, double load) { return estimates(surface, {&load, 1}).front(); }

/// The same for people. Throws Error.
inline std::string estimate_text(std::string_view surface, Span<const double> load) {
    return detail::copied_or_thrown([&](char *buffer, std::size_t length) {
        return asperity_estimate_text(surface.data(), surface.size(), load.size(), load.data(), buffer, length);
    });
}

// ---- Parameters ----

// generated by packaging/declarations: enumerations, from asperity.h, by `make header`
/// Family of the asperity heights, one of `ASPERITY_HEIGHTS_`; Gaussian by default.
enum class Heights : std::int32_t {
    /// Gaussian heights, eq (17): the default.
    gaussian = ASPERITY_HEIGHTS_GAUSSIAN,
    /// Weibull heights, eqs (18)-(21): their skew follows from `weibull_shape`.
    weibull = ASPERITY_HEIGHTS_WEIBULL,
    /// Heights of Johnson's system: `skew` and `kurtosis` are set independently.
    johnson = ASPERITY_HEIGHTS_JOHNSON,
    /// Heights of a measured density: `table_height`, `table_density` and `table_length`.
    tabulated = ASPERITY_HEIGHTS_TABULATED,
    /// Summit heights and radii of a surface that is not Gaussian, by its heights and slopes at 13 normal scores, -3 to
    /// 3.
    at_scores = ASPERITY_HEIGHTS_AT_SCORES,
};

/// Law of one asperity in contact, one of `ASPERITY_CONTACT_`; Maugis' by default.
enum class ContactLaw : std::int32_t {
    /// Elastic asperities with adhesion after Maugis, or Hertz' law without adhesion: the default.
    maugis = ASPERITY_CONTACT_MAUGIS,
    /// Asperities that yield, after Zhao, Maietta and Chang (2000): needs `hardness` > 0 and `work_of_adhesion` = 0.
    elastic_plastic = ASPERITY_CONTACT_ELASTIC_PLASTIC,
};

/// How a contact begins to slip, one of `ASPERITY_SLIP_`; partial slip by default.
enum class SlipOnset : std::int32_t {
    /// Before gross slip each contact slips from its rim inwards, after Cattaneo (1938) and Mindlin (1949).
    partial = ASPERITY_SLIP_PARTIAL,
    /// Before gross slip each contact sticks until all of it slips: contacts so small that one dislocation moves them.
    whole = ASPERITY_SLIP_WHOLE,
};

/// What the waves are like, one of `ASPERITY_WAVINESS_`; unknown by default, and then the height must be 0.
enum class WavinessShape : std::int32_t {
    /// Waves whose shape is not known: there may be none.
    unknown = ASPERITY_WAVINESS_UNKNOWN,
    /// Waves with long crests side by side, as turning and grinding leave: cos x.
    ridges = ASPERITY_WAVINESS_RIDGES,
    /// Waves in two directions, as lapping and scraping leave: cos x + cos y.
    hills = ASPERITY_WAVINESS_HILLS,
};
// end of enumerations

/// Two rough elastic surfaces, in one consistent system of units of your choice.
///
/// A value. Each parameter has a reader and a setter of its name; setters can be chained and check nothing, Model does.
class Params {
public:
    /// Defaults for all but the eight physical inputs, composite_modulus to asperity_count. These are NaN until they are set:
    /// Model throws Error, "asperity_count: must be set", naming the first that is not.
    Params() { check(asperity_params_init(&c_, sizeof c_)); }

    /// The paper's case: alpha = 0.01, beta = 1000, gamma = 0.001, b/h = 1, nu = 0.3 in units b = G = 1, N = 1.
    static Params paper() { return dimensionless(0.01, 1000.0, 0.001); }

    // Without moves: what was moved from would point to a table that it no longer owns.
    Params(const Params &) = default;
    Params &operator=(const Params &) = default;

    /// A copy of initialised C parameters, with a table of its own if they have one.
    explicit Params(const asperity_params &params) : c_(params) {
        if (c_.height_distribution == ASPERITY_HEIGHTS_TABULATED && c_.table_height && c_.table_density) {
            const auto length = static_cast<std::size_t>(c_.table_length);
            table({c_.table_height, length}, {c_.table_density, length});
        }
    }

    /// The paper's case with other dimensionless groups; see set_dimensionless.
    static Params dimensionless(double alpha, double beta, double gamma, double b_over_h = 1.0, double poisson = 0.3) {
        Params params;
        params.set_dimensionless(alpha, beta, gamma, b_over_h, poisson);
        return params;
    }

    /// Sets material, adhesion and roughness from alpha = (sigma/R)^(1/2), beta = (R sigma)^(1/2)/b, gamma = w/(E* b),
    /// b/h and Poisson's ratio, in the paper's units b = G = 1, N = 1. The other parameters stay as they are.
    ///
    /// Throws Error (ASPERITY_INVALID_PARAMETER, ASPERITY_OUT_OF_RANGE); the parameters are then as before.
    Params &set_dimensionless(double alpha, double beta, double gamma, double b_over_h = 1.0, double poisson = 0.3) {
        return checked(asperity_params_set_dimensionless(&c_, alpha, beta, gamma, b_over_h, poisson));
    }

    /// Sets E*, G* and the tangential modulus from Young's moduli [stress] and Poisson's ratios of the two bodies; infinity is
    /// a rigid body.
    ///
    /// Throws Error (ASPERITY_INVALID_PARAMETER, ASPERITY_OUT_OF_RANGE); the parameters are then as before.
    Params &set_materials(double E1, double nu1, double E2, double nu2) {
        return checked(asperity_params_set_materials(&c_, E1, nu1, E2, nu2));
    }

    /// Sets what is known of two materials, in SI units, as asperity_params_set_pair does; you set the roughness.
    ///
    /// Throws Error (ASPERITY_INVALID_PARAMETER); the parameters are then as before.
    Params &set_pair(const std::string &name) {
        return checked(asperity_params_set_pair(&c_, name.c_str()));
    }

    /// Sets the asperities of a surface, rough on however many scales, and nominal_area, from the variances of height [length^2], slope
    /// and curvature [1/length^2], 0 if that is not known, along a profile; those of two surfaces add.
    ///
    /// Throws Error (ASPERITY_INVALID_PARAMETER, ASPERITY_OUT_OF_RANGE); the parameters are then as before.
    Params &set_spectral_moments(double m0, double m2, double m4, double nominal_area) {
        return checked(asperity_params_set_spectral_moments(&c_, m0, m2, m4, nominal_area));
    }

    /// Sets the strength of the interface from one measured point: scales both slip stresses so that the friction coefficient at
    /// this load [force], > 0, is the one measured, at most 20. Set the surfaces that were measured first, and call this last.
    ///
    /// The measurement is kept in calibration_load and calibration_friction_force. Takes milliseconds. Throws Error
    /// (ASPERITY_INVALID_PARAMETER with the numbers, if no strength gives that coefficient; those of Model); the parameters are
    /// then as before.
    Params &calibrate(double load, double friction_coefficient) {
        return checked(asperity_params_calibrate(&c_, load, friction_coefficient));
    }

    /// As calibrate, from the friction force [force] that was measured: at zero load, or where the load pulls.
    Params &calibrate_force(double load, double friction_force) {
        return checked(asperity_params_calibrate_force(&c_, load, friction_force));
    }

    /// Sets what a surface file gives, in SI units unless set_units follows; what it does not give stays as it is.
    ///
    /// docs/solvers.md has the keys. Throws Error, "film.toml: line 3: slip_onset = ...", as asperity_params_read refuses; the
    /// parameters are then as before.
    Params &read(const std::string &path) { return checked(asperity_params_read(&c_, path.c_str())); }

    /// The same from the text of a surface file.
    Params &set_text(std::string_view text) { return checked(asperity_params_set_text(&c_, text.data(), text.size())); }

    /// The text of a surface file, which read and set_text make these parameters from.
    ///
    /// Throws Error (ASPERITY_INVALID_PARAMETER) if a choice is none of the constants.
    std::string text() const {
        return detail::copied_or_thrown(
            [this](char *buffer, std::size_t length) { return asperity_params_text(&c_, buffer, length); });
    }

    /// Converts all parameters into other units, of which one is so many of the present ones: from SI into mm, N and MPa with 1e-3
    /// and 1.
    ///
    /// Throws Error (ASPERITY_INVALID_PARAMETER, ASPERITY_OUT_OF_RANGE); the parameters are then as before.
    Params &set_units(double length, double force) { return checked(asperity_params_set_units(&c_, length, force)); }

    /// Sets a parameter by its name, one of names(Kind::parameters); skew is that of Weibull heights.
    ///
    /// Throws Error (ASPERITY_INVALID_PARAMETER, ASPERITY_OUT_OF_RANGE); the parameters are then as before.
    Params &set(const std::string &name, double value) {
        const char *const c_name = name.c_str();
        return checked(asperity_params_set_values(&c_, 1, &c_name, &value));
    }

    /// Sets parameters by their names, in any order, all or none, as asperity_params_set_values does: the way to set those
    /// that go together, params.set({{"E1", 160e9}, {"nu1", 0.22}, {"E2", 160e9}, {"nu2", 0.22}}).
    ///
    /// Throws Error (ASPERITY_INVALID_PARAMETER, ASPERITY_OUT_OF_RANGE); the parameters are then as before.
    Params &set(const std::vector<std::pair<std::string, double>> &parameters) {
        std::vector<const char *> names;
        std::vector<double> values;
        for (const auto &[name, value] : parameters) {
            names.push_back(name.c_str());
            values.push_back(value);
        }
        return checked(asperity_params_set_values(&c_, names.size(), names.data(), values.data()));
    }

    /// A parameter by its name. Throws Error (ASPERITY_INVALID_PARAMETER).
    double get(const std::string &name) const {
        double value = 0.0;
        check(asperity_params_get_value(&c_, name.c_str(), &value));
        return value;
    }

    // generated by packaging/declarations: parameters, from asperity.h, by `make header`
    /// E* [stress], > 0: reduced modulus, 1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2. No default: set it, or call
    /// `asperity_params_set_materials`.
    double composite_modulus() const noexcept { return c_.composite_modulus; }
    /// Sets it.
    Params &composite_modulus(double value) noexcept { return assign(c_.composite_modulus, value); }

    /// G* [stress], > 0: 2 G1 G2/(G1 + G2). No default: set it, or call `asperity_params_set_materials`.
    double effective_shear_modulus() const noexcept { return c_.effective_shear_modulus; }
    /// Sets it.
    Params &effective_shear_modulus(double value) noexcept { return assign(c_.effective_shear_modulus, value); }

    /// w [force/length], >= 0: work of adhesion; 0 is Hertzian contact. No default.
    double work_of_adhesion() const noexcept { return c_.work_of_adhesion; }
    /// Sets it.
    Params &work_of_adhesion(double value) noexcept { return assign(c_.work_of_adhesion, value); }

    /// h [length], > 0: range of adhesion, within which surfaces attract with the stress w/h. No default; the paper
    /// takes b.
    double adhesion_range() const noexcept { return c_.adhesion_range; }
    /// Sets it.
    Params &adhesion_range(double value) noexcept { return assign(c_.adhesion_range, value); }

    /// b [length], > 0: Burgers vector, the length in which the slip radii are given. No default.
    double burgers_vector() const noexcept { return c_.burgers_vector; }
    /// Sets it.
    Params &burgers_vector(double value) noexcept { return assign(c_.burgers_vector, value); }

    /// sigma [length], > 0: standard deviation of the asperity heights. No default.
    double height_std() const noexcept { return c_.height_std; }
    /// Sets it.
    Params &height_std(double value) noexcept { return assign(c_.height_std, value); }

    /// R [length], > 0: mean radius of curvature of the asperities. No default.
    double summit_radius() const noexcept { return c_.summit_radius; }
    /// Sets it.
    Params &summit_radius(double value) noexcept { return assign(c_.summit_radius, value); }

    /// N [-], > 0: number of asperities, i.e. their density times the nominal area; need not be an integer. No default.
    double asperity_count() const noexcept { return c_.asperity_count; }
    /// Sets it.
    Params &asperity_count(double value) noexcept { return assign(c_.asperity_count, value); }

    /// Family of the asperity heights, one of `ASPERITY_HEIGHTS_`; Gaussian by default.
    Heights height_distribution() const noexcept { return static_cast<Heights>(c_.height_distribution); }
    /// Sets it.
    Params &height_distribution(Heights value) noexcept {
        return assign(c_.height_distribution, static_cast<std::int32_t>(value));
    }

    /// true: asperities out of contact attract (the default, as in the paper); false: they do not.
    bool attraction() const noexcept { return c_.attraction != 0; }
    /// Sets it.
    Params &attraction(bool value) noexcept { return assign(c_.attraction, value ? 1 : 0); }

    /// omega [-], 1 to 200: shape of the Weibull heights; 3.602, the default, has no skew. Read only for
    /// `ASPERITY_HEIGHTS_WEIBULL`.
    double weibull_shape() const noexcept { return c_.weibull_shape; }
    /// Sets it.
    Params &weibull_shape(double value) noexcept { return assign(c_.weibull_shape, value); }

    /// epsilon [-], -1 to 1: how the radius grows with height, R (1 + epsilon tanh(rho z/sigma)); 0 by default.
    double radius_amplitude() const noexcept { return c_.radius_amplitude; }
    /// Sets it.
    Params &radius_amplitude(double value) noexcept { return assign(c_.radius_amplitude, value); }

    /// rho [-], > 0, per standard deviation of height: how fast the radius changes; 0.5 by default. 1e-6 to 1000 where
    /// `radius_amplitude` is not 0.
    double radius_rate() const noexcept { return c_.radius_rate; }
    /// Sets it.
    Params &radius_rate(double value) noexcept { return assign(c_.radius_rate, value); }

    /// a_1/b [-], at least 1: contact radius up to which the shear strength is `slip_stress_1`, eq (13); 28 by default.
    double slip_radius_1() const noexcept { return c_.slip_radius_1; }
    /// Sets it.
    Params &slip_radius_1(double value) noexcept { return assign(c_.slip_radius_1, value); }

    /// tau_1/G* [-], > 0 and at most 1; 1/43 by default, which was not measured on your interface: call
    /// `asperity_params_calibrate`.
    double slip_stress_1() const noexcept { return c_.slip_stress_1; }
    /// Sets it.
    Params &slip_stress_1(double value) noexcept { return assign(c_.slip_stress_1, value); }

    /// a_2/b [-], > a_1/b: contact radius from which the shear strength is `slip_stress_2`; 8e4 by default.
    double slip_radius_2() const noexcept { return c_.slip_radius_2; }
    /// Sets it.
    Params &slip_radius_2(double value) noexcept { return assign(c_.slip_radius_2, value); }

    /// tau_2/G* [-], > 0 and at most 1; 1/1290 by default. tau_2 a_2^2 must not be below tau_1 a_1^2.
    double slip_stress_2() const noexcept { return c_.slip_stress_2; }
    /// Sets it.
    Params &slip_stress_2(double value) noexcept { return assign(c_.slip_stress_2, value); }

    /// Upper bound of every friction coefficient returned [-], > 0; 1000 by default, INFINITY allowed. F/P grows
    /// without bound towards zero load.
    double max_friction_coefficient() const noexcept { return c_.max_friction_coefficient; }
    /// Sets it.
    Params &max_friction_coefficient(double value) noexcept { return assign(c_.max_friction_coefficient, value); }

    /// Skew of Johnson's asperity heights [-], -3 to 3; 0 by default. Other `height_distribution`s refuse any other
    /// value; by its name it also chooses Weibull heights: `asperity_params_set_values`.
    double skew() const noexcept { return c_.skew; }
    /// Sets it.
    Params &skew(double value) noexcept { return assign(c_.skew, value); }

    /// Kurtosis of Johnson's asperity heights [-], 1.87 + 1.25 skew^2 to 100; 3 by default, which with skew 0 is
    /// Gaussian. Other `height_distribution`s refuse any other value.
    double kurtosis() const noexcept { return c_.kurtosis; }
    /// Sets it.
    Params &kurtosis(double value) noexcept { return assign(c_.kurtosis, value); }

    /// H [stress], 1e-5 E* to 100 E*: indentation hardness of the softer body; 0, the default, means not known.
    /// Warnings compare pressures with it; the friction of elastic asperities does not depend on it, that of
    /// `ASPERITY_CONTACT_ELASTIC_PLASTIC` does.
    double hardness() const noexcept { return c_.hardness; }
    /// Sets it.
    Params &hardness(double value) noexcept { return assign(c_.hardness, value); }

    /// G^ [stress], >= 0: 1/G^ = (2 - nu1)/G1 + (2 - nu2)/G2, for the stiffness of contacts that stick; 0, the default,
    /// means E* G* / (2 (E* + G*)). `asperity_params_set_materials` sets it.
    double tangential_modulus() const noexcept { return c_.tangential_modulus; }
    /// Sets it.
    Params &tangential_modulus(double value) noexcept { return assign(c_.tangential_modulus, value); }

    /// Nominal area A_0 of contact [length^2], >= 0; 0, the default, means not known. Warnings compare the real area A
    /// with it. Where it is known, neighbours share the elastic compliance: stiffness and the sum of contact radii are
    /// those of lone contacts over chi = (1 - (A/A_0)^(1/2))^1.8, and the gap changes less (docs/model.md). A/A_0
    /// counts as 0.5 at most.
    double nominal_area() const noexcept { return c_.nominal_area; }
    /// Sets it.
    Params &nominal_area(double value) noexcept { return assign(c_.nominal_area, value); }

    /// Law of one asperity in contact, one of `ASPERITY_CONTACT_`; Maugis' by default.
    ContactLaw contact_law() const noexcept { return static_cast<ContactLaw>(c_.contact_law); }
    /// Sets it.
    Params &contact_law(ContactLaw value) noexcept { return assign(c_.contact_law, static_cast<std::int32_t>(value)); }

    /// How a contact begins to slip, one of `ASPERITY_SLIP_`; partial slip by default. Friction does not depend on it,
    /// the tangential force before gross slip does: `asperity_tangential_at_load`, `asperity_microslip_step`.
    SlipOnset slip_onset() const noexcept { return static_cast<SlipOnset>(c_.slip_onset); }
    /// Sets it.
    Params &slip_onset(SlipOnset value) noexcept { return assign(c_.slip_onset, static_cast<std::int32_t>(value)); }

    /// kappa [-], 0 to 1000: the pressure coefficient of the interface; 0, the default, is a strength that does not
    /// grow with pressure. The friction force of a contact is pi a^2 tau(a) + kappa P_H. P_H is the load that Hertz'
    /// contact of the same radius carries. Boundary films have 0.02 to 0.2. Where it is > 0, both slip stresses may be
    /// 0: Amontons' law.
    double pressure_coefficient() const noexcept { return c_.pressure_coefficient; }
    /// Sets it.
    Params &pressure_coefficient(double value) noexcept { return assign(c_.pressure_coefficient, value); }

    /// Nayak's bandwidth m0 m4/m2^2 of a surface whose summits were counted [-], at least 1.5, with which warnings
    /// judge whether they act independently; 0, the default, means not known. The library then takes it from
    /// `nominal_area`, if that is known.
    double bandwidth() const noexcept { return c_.bandwidth; }
    /// Sets it.
    Params &bandwidth(double value) noexcept { return assign(c_.bandwidth, value); }

    /// Load of the measurement that set the strength of the interface [force]; 0 if there was none.
    /// `asperity_params_calibrate` sets it.
    double calibration_load() const noexcept { return c_.calibration_load; }
    /// Sets it.
    Params &calibration_load(double value) noexcept { return assign(c_.calibration_load, value); }

    /// Friction force measured at that load [force], >= 0; 0, the default: not calibrated. `asperity_params_calibrate`
    /// sets it.
    double calibration_friction_force() const noexcept { return c_.calibration_friction_force; }
    /// Sets it.
    Params &calibration_friction_force(double value) noexcept { return assign(c_.calibration_friction_force, value); }

    /// Relative standard error of that measurement [-], > 0 and at most 1; 0.05 by default.
    double calibration_error() const noexcept { return c_.calibration_error; }
    /// Sets it.
    Params &calibration_error(double value) noexcept { return assign(c_.calibration_error, value); }

    /// Height of the mean of the asperities above the mean plane of the surface [length], >= 0; 0, the default, means
    /// not known.
    double summit_mean_height() const noexcept { return c_.summit_mean_height; }
    /// Sets it.
    Params &summit_mean_height(double value) noexcept { return assign(c_.summit_mean_height, value); }

    /// Root mean square slope of the surface [-], Sdq, 0 to 5, with which warnings judge; 0, the default, means not
    /// known.
    double rms_slope() const noexcept { return c_.rms_slope; }
    /// Sets it.
    Params &rms_slope(double value) noexcept { return assign(c_.rms_slope, value); }

    /// Wq [length], >= 0: root mean square height of the waves on which the roughness stands, of both surfaces
    /// together; 0, the default, means none. A solver whose mesh carries the waves leaves it 0. From 0.01 to 30
    /// `height_std`, with `waviness_width`, `waviness_shape` and `nominal_area`, and without adhesion.
    double waviness_height() const noexcept { return c_.waviness_height; }
    /// Sets it.
    Params &waviness_height(double value) noexcept { return assign(c_.waviness_height, value); }

    /// WSm [length], the width of a wave, with which the bodies give way; 0 by default. At least 10 Wq, 4 times the
    /// distance of asperities, and the mean wave of the roughness; at most the root of `nominal_area`.
    double waviness_width() const noexcept { return c_.waviness_width; }
    /// Sets it.
    Params &waviness_width(double value) noexcept { return assign(c_.waviness_width, value); }

    /// What the waves are like, one of `ASPERITY_WAVINESS_`; unknown by default, and then the height must be 0.
    WavinessShape waviness_shape() const noexcept { return static_cast<WavinessShape>(c_.waviness_shape); }
    /// Sets it.
    Params &waviness_shape(WavinessShape value) noexcept {
        return assign(c_.waviness_shape, static_cast<std::int32_t>(value));
    }

    /// true: Gaussian heights stand for those of a surface that is known not to have them, as where honing left
    /// plateaus; false: not so (the default). States then have the warning `ASPERITY_WARNING_NOT_GAUSSIAN`. A text that
    /// names such a process sets it.
    bool taken_as_gaussian() const noexcept { return c_.taken_as_gaussian != 0; }
    /// Sets it.
    Params &taken_as_gaussian(bool value) noexcept { return assign(c_.taken_as_gaussian, value ? 1 : 0); }

    /// Unit of all lengths, in metres [-], > 0; 1 by default. `asperity_params_set_units` sets it.
    double length_unit() const noexcept { return c_.length_unit; }
    /// Sets it.
    Params &length_unit(double value) noexcept { return assign(c_.length_unit, value); }

    /// Unit of all forces, in newtons [-], > 0; 1 by default. `asperity_params_set_units` sets it.
    double force_unit() const noexcept { return c_.force_unit; }
    /// Sets it.
    Params &force_unit(double value) noexcept { return assign(c_.force_unit, value); }
    // end of parameters

    /// The heights of the table; none by default.
    Span<const double> table_height() const noexcept {
        return {c_.table_height, static_cast<std::size_t>(c_.table_length)};
    }
    /// The density at each of them.
    Span<const double> table_density() const noexcept {
        return {c_.table_density, static_cast<std::size_t>(c_.table_length)};
    }
    /// Chooses tabulated heights and copies their table, which copies of the parameters share.
    ///
    /// @param heights    strictly increasing, in any unit and from any origin
    /// @param densities  as many, >= 0, of any scale
    /// Throws Error (ASPERITY_INVALID_PARAMETER) for columns of different length; the parameters are then as before.
    Params &table(Span<const double> heights, Span<const double> densities) {
        if (heights.size() != densities.size()) {
            throw Error(ASPERITY_INVALID_PARAMETER, "size of densities = " + std::to_string(densities.size()) +
                                                        ": must be the number of heights, " +
                                                        std::to_string(heights.size()));
        }
        std::vector<double> columns(heights.data(), heights.data() + heights.size());
        columns.insert(columns.end(), densities.data(), densities.data() + densities.size());
        table_ = std::make_shared<const std::vector<double>>(std::move(columns));
        c_.height_distribution = ASPERITY_HEIGHTS_TABULATED;
        c_.table_height = table_->data();
        c_.table_density = table_->data() + heights.size();
        c_.table_length = heights.size();
        return *this;
    }

    /// The C struct, for functions of asperity.h: asperity_create(&params.c(), &model).
    const asperity_params &c() const noexcept { return c_; }

private:
    Params &checked(Status status) {
        check(status);
        return *this;
    }

    template <class T>
    Params &assign(T &field, T value) noexcept {
        field = value;
        return *this;
    }

    asperity_params c_;
    std::shared_ptr<const std::vector<double>> table_; // heights, then densities, where c_ has a table
};

// ---- The model ----

/// A friction law ready for use: owns the C model, moves, does not copy.
///
/// A Model that was moved from holds nothing. It may be assigned to or destroyed, and c() is null; every other call throws
/// MovedFrom.
class Model {
public:
    /// Checks the parameters and compiles the law, in milliseconds.
    ///
    /// Throws Error (ASPERITY_INVALID_PARAMETER, ASPERITY_OUT_OF_RANGE, ASPERITY_NOT_CONVERGED).
    explicit Model(const Params &params) {
        asperity_model *model = nullptr;
        check(asperity_create(&params.c(), &model));
        handle_.reset(model);
    }

    /// The same surfaces after a largest load [force]: up to it summits that yielded spring back elastically.
    ///
    /// Throws as the constructor, and Error (ASPERITY_INVALID_LOAD, ASPERITY_SEPARATED).
    Model unloaded(double largest_load) const {
        asperity_model *model = nullptr;
        check(asperity_unloaded(open(), largest_load, &model));
        return Model(model);
    }

    /// Gives the model other parameters, all or nothing: when it throws, the model is as before.
    ///
    /// Throws as the constructor. No other thread may use the model during the call.
    void set_params(const Params &params) { check(asperity_set_params(open(), &params.c())); }

    /// The parameters of the model, with a table of their own if it has one.
    Params params() const {
        auto params = detail::sized<asperity_params>();
        check(asperity_get_params(open(), &params));
        return Params(params);
    }

    /// Friction coefficient F/P at a normal load [force].
    ///
    /// At most max_friction_coefficient, which it is at and below zero load down to pull-off; 0 below pull-off; a quiet
    /// NaN for a NaN or infinite load.
    double friction_at_load(double load) const { return asperity_friction_at_load(open(), load); }

    /// Friction force F [force] at a normal load [force].
    ///
    /// Finite and positive down to pull-off; 0 below; a quiet NaN for a NaN or infinite load.
    double friction_force_at_load(double load) const {
        return asperity_friction_force_at_load(open(), load);
    }

    /// Friction coefficient as friction_at_load, and its slope d(mu)/d(load) [1/force]: 0 where it is capped.
    ValueAndSlope friction_and_slope_at_load(double load) const {
        ValueAndSlope mu;
        mu.value = asperity_friction_and_slope_at_load(open(), load, &mu.slope);
        return mu;
    }

    /// Friction force as friction_force_at_load, and its slope dF/d(load): infinite at the pull-off load itself.
    ValueAndSlope friction_force_and_slope_at_load(double load) const {
        ValueAndSlope force;
        force.value = asperity_friction_force_and_slope_at_load(open(), load, &force.slope);
        return force;
    }

    /// Load [force] at a gap [length] between the mean planes, from the compiled law.
    ///
    /// Negative where adhesion pulls; 0 at pull-off and beyond; a quiet NaN for a NaN or infinite gap.
    double load_at_gap(double gap) const { return asperity_load_and_slope_at_gap(open(), gap, nullptr); }

    /// Load as load_at_gap, and its slope d(load)/d(gap) [force/length]: minus the normal stiffness.
    ValueAndSlope load_and_slope_at_gap(double gap) const {
        ValueAndSlope load;
        load.value = asperity_load_and_slope_at_gap(open(), gap, &load.slope);
        return load;
    }

    /// Loads at many gaps, into memory of the caller; for the inner loop: allocates nothing.
    ///
    /// Every element is as load_at_gap gives it, also when the status is not ASPERITY_OK.
    ///
    /// @param gaps        gaps [length]
    /// @param load        receives as many loads [force]; may be `gaps` itself
    /// @param dload_dgap  receives as many slopes [force/length]; none by default
    /// @return ASPERITY_OK, or what is wrong with the first gap that has no load: ASPERITY_SEPARATED (at pull-off or
    ///         beyond, the load is 0), ASPERITY_INVALID_PARAMETER (NaN, infinite) or ASPERITY_OUT_OF_RANGE; last_error()
    ///         names its index
    /// Throws Error (ASPERITY_INVALID_PARAMETER) for arrays of other sizes, before anything is written.
    [[nodiscard]] Status load_at_gap(Span<const double> gaps, Span<double> load, Span<double> dload_dgap = {}) const {
        return many(asperity_loads_at_gaps, gaps, load, dload_dgap);
    }

    /// Loads [force] at many gaps.
    ///
    /// 0 at pull-off and beyond. Throws Error (ASPERITY_INVALID_PARAMETER, ASPERITY_OUT_OF_RANGE) that names the first
    /// gap that has no answer.
    std::vector<double> load_at_gap(Span<const double> gaps) const {
        std::vector<double> load(gaps.size());
        const Status status = many(asperity_loads_at_gaps, gaps, load, {});
        // An open contact is an answer, but may hide a gap without one.
        for (std::size_t i = 0; status == ASPERITY_SEPARATED && i < load.size(); ++i) {
            double value;
            if (is_nan(load[i])) {
                const Status why = asperity_loads_at_gaps(open(), 1, gaps.data() + i, &value, nullptr);
                throw Error(why, "element " + std::to_string(i) + " of the gaps: " + last_error());
            }
        }
        if (status != ASPERITY_SEPARATED) {
            check(status);
        }
        return load;
    }

    /// Friction coefficients at many loads, into memory of the caller; for the inner loop: allocates nothing.
    ///
    /// Every element is as friction_at_load gives it, also when the status is not ASPERITY_OK.
    ///
    /// @param loads      normal loads [force]
    /// @param mu         receives as many coefficients; may be `loads` itself
    /// @param dmu_dload  receives as many slopes [1/force]; none by default
    /// @return ASPERITY_OK, or what is wrong with the first load that has no friction: ASPERITY_SEPARATED (below
    ///         pull-off), ASPERITY_INVALID_LOAD (NaN, infinite) or ASPERITY_OUT_OF_RANGE (too heavy to be evaluated,
    ///         NaN); last_error() names its index
    /// Throws Error (ASPERITY_INVALID_PARAMETER) for arrays of other sizes, before anything is written.
    [[nodiscard]] Status friction_at_load(Span<const double> loads, Span<double> mu, Span<double> dmu_dload = {}) const {
        return many(asperity_friction_at_loads, loads, mu, dmu_dload);
    }

    /// Friction forces at many loads, into memory of the caller; for the inner loop: allocates nothing.
    ///
    /// Every element is as friction_force_at_load gives it, also when the status is not ASPERITY_OK.
    ///
    /// @param loads         normal loads [force]
    /// @param force         receives as many forces [force]; may be `loads` itself
    /// @param dforce_dload  receives as many slopes; none by default
    /// @return as for coefficients
    /// Throws Error (ASPERITY_INVALID_PARAMETER) for arrays of other sizes, before anything is written.
    [[nodiscard]] Status friction_force_at_load(Span<const double> loads, Span<double> force,
                                                Span<double> dforce_dload = {}) const {
        return many(asperity_friction_force_at_loads, loads, force, dforce_dload);
    }

    /// Friction coefficients at many loads.
    ///
    /// 0 below pull-off, where the contact is open. Throws Error (ASPERITY_INVALID_LOAD, ASPERITY_OUT_OF_RANGE) that names
    /// the first load that is NaN, infinite or too heavy to be evaluated.
    std::vector<double> friction_at_load(Span<const double> loads) const {
        std::vector<double> mu(loads.size());
        answered(asperity_friction_at_loads, loads, mu, {});
        return mu;
    }

    /// Friction forces [force] at many loads.
    ///
    /// 0 below pull-off, where the contact is open. Throws Error (ASPERITY_INVALID_LOAD, ASPERITY_OUT_OF_RANGE) that names
    /// the first load that is NaN, infinite or too heavy to be evaluated.
    std::vector<double> friction_force_at_load(Span<const double> loads) const {
        std::vector<double> force(loads.size());
        answered(asperity_friction_force_at_loads, loads, force, {});
        return force;
    }

    /// Friction coefficients at many loads and their slopes [1/force].
    ///
    /// 0 below pull-off, where the contact is open. Throws Error (ASPERITY_INVALID_LOAD, ASPERITY_OUT_OF_RANGE) that names
    /// the first load that is NaN, infinite or too heavy to be evaluated.
    ValuesAndSlopes friction_and_slope_at_load(Span<const double> loads) const {
        ValuesAndSlopes result{std::vector<double>(loads.size()), std::vector<double>(loads.size())};
        answered(asperity_friction_at_loads, loads, result.value, result.slope);
        return result;
    }

    /// Friction forces [force] at many loads and their slopes.
    ///
    /// 0 below pull-off, where the contact is open. Throws Error (ASPERITY_INVALID_LOAD, ASPERITY_OUT_OF_RANGE) that names
    /// the first load that is NaN, infinite or too heavy to be evaluated.
    ValuesAndSlopes friction_force_and_slope_at_load(Span<const double> loads) const {
        ValuesAndSlopes result{std::vector<double>(loads.size()), std::vector<double>(loads.size())};
        answered(asperity_friction_force_at_loads, loads, result.value, result.slope);
        return result;
    }

    /// Tangential stiffness K_t [force/length] at a normal load [force]: force by displacement while all contacts stick.
    ///
    /// Positive down to pull-off; 0 below and, without adhesion, at zero load; a quiet NaN for a NaN or infinite load.
    double tangential_stiffness_at_load(double load) const {
        return asperity_tangential_stiffness_at_load(open(), load);
    }

    /// Tangential stiffnesses at many loads, into memory of the caller; for the inner loop: allocates nothing.
    ///
    /// Every element is as tangential_stiffness_at_load gives it, also when the status is not ASPERITY_OK.
    ///
    /// @param loads      normal loads [force]
    /// @param stiffness  receives as many stiffnesses [force/length]; may be `loads` itself
    /// @return as for coefficients
    /// Throws Error (ASPERITY_INVALID_PARAMETER) for arrays of other sizes, before anything is written.
    [[nodiscard]] Status tangential_stiffness_at_load(Span<const double> loads, Span<double> stiffness) const {
        return many(stiffnesses, loads, stiffness, {});
    }

    /// Tangential stiffnesses [force/length] at many loads.
    ///
    /// 0 below pull-off, where the contact is open. Throws Error (ASPERITY_INVALID_LOAD, ASPERITY_OUT_OF_RANGE) that names
    /// the first load that is NaN, infinite or too heavy to be evaluated.
    std::vector<double> tangential_stiffness_at_load(Span<const double> loads) const {
        std::vector<double> stiffness(loads.size());
        answered(stiffnesses, loads, stiffness, {});
        return stiffness;
    }

    /// The tangential force T [force] at a load and a displacement [length], and dT/d(displacement) [force/length], exact.
    ///
    /// T rises from K_t times the displacement to the friction force: small contacts slip first. It is an odd function of
    /// the displacement. After a reversal at displacement r: T = T_r - 2 T((r - displacement)/2).
    /// Throws Error (ASPERITY_INVALID_PARAMETER, ASPERITY_INVALID_LOAD, ASPERITY_SEPARATED, ASPERITY_OUT_OF_RANGE,
    /// ASPERITY_NOT_CONVERGED).
    ValueAndSlope tangential_at_load(double load, double displacement) const {
        ValueAndSlope force;
        check(asperity_tangential_at_load(open(), load, displacement, &force.value, &force.slope));
        return force;
    }

    /// How many doubles the state of a contact that remembers takes; all 0 is one that has just closed.
    std::size_t microslip_length() const { return asperity_microslip_length(open()); }

    /// One step of a contact that remembers: the tangential force at a load [force] after a displacement [length] along both
    /// directions since `before`, with its tangents.
    ///
    /// Below the pull-off load the contact is open, which is an answer: force, tangents and `after` are 0.
    ///
    /// @param before  the state before the step, of microslip_length() doubles
    /// @param after   receives the state after it; may be `before` itself; none to skip
    /// Throws Error (ASPERITY_INVALID_PARAMETER, ASPERITY_INVALID_LOAD, ASPERITY_OUT_OF_RANGE), before anything is written.
    Microslip microslip_step(double load, const double (&increment)[2], Span<const double> before,
                             Span<double> after) const {
        require_state("before", before.size(), 1);
        if (after.data() != nullptr) {
            require_state("after", after.size(), 1);
        }
        auto out = detail::sized<Microslip>();
        const Status status =
            asperity_microslip_step(open(), load, increment, before.data(), after.data(), &out);
        if (status != ASPERITY_SEPARATED) {
            check(status);
        }
        return out;
    }

    /// Turns the state of a contact with its directions, by the angle from the first to the second of a cosine and a sine.
    ///
    /// Throws Error (ASPERITY_INVALID_PARAMETER) for what is not finite, an angle of no length, a state of another length.
    void microslip_turn(Span<double> state, double cosine, double sine) const {
        require_state("state", state.size(), 1);
        check(asperity_microslip_turn(state.data(), cosine, sine));
    }

    /// The step of microslip_step of many contacts, into memory of the caller; for the inner loop: allocates nothing.
    ///
    /// Every element is as microslip_step gives it, to the bit, also when the status is not ASPERITY_OK; force and stiffness of one
    /// that is not in order are NaN, and its state is not written.
    ///
    /// @param loads      normal loads [force]
    /// @param increment  two displacements [length] for each
    /// @param before     the states before the step, one after another
    /// @param after      receives as many states; may be `before` itself; none to skip
    /// @param force      receives two forces for each; none to skip
    /// @param stiffness  receives four tangents for each, row by row; none to skip
    /// @return as for coefficients
    /// Throws Error (ASPERITY_INVALID_PARAMETER) for arrays of other sizes, before anything is written.
    [[nodiscard]] Status microslip_steps(Span<const double> loads, Span<const double> increment,
                                         Span<const double> before, Span<double> after, Span<double> force,
                                         Span<double> stiffness) const {
        const std::size_t n = loads.size();
        require_state("before", before.size(), n);
        if (after.data() != nullptr) {
            require_state("after", after.size(), n);
        }
        require_size("increment", increment.size(), 2 * n, "both displacements of each load");
        if (force.data() != nullptr) {
            require_size("force", force.size(), 2 * n, "both forces of each load");
        }
        if (stiffness.data() != nullptr) {
            require_size("stiffness", stiffness.size(), 4 * n, "four tangents for each load");
        }
        return asperity_microslip_steps(open(), n, loads.data(), increment.data(), before.data(), after.data(), force.data(),
                                        stiffness.data());
    }

    /// The exact state at a load [force], from the pull-off load upwards: integrates the model, uses no table.
    ///
    /// Throws Error (ASPERITY_INVALID_LOAD, ASPERITY_SEPARATED, ASPERITY_OUT_OF_RANGE, ASPERITY_NOT_CONVERGED).
    State state_at_load(double load) const {
        auto state = detail::sized<State>();
        check(asperity_state_at_load(open(), load, &state));
        return state;
    }

    /// The exact state at a gap [length] between the mean planes, also beyond the pull-off point.
    ///
    /// Throws Error (ASPERITY_INVALID_PARAMETER, ASPERITY_OUT_OF_RANGE).
    State state_at_gap(double gap) const {
        auto state = detail::sized<State>();
        check(asperity_state_at_gap(open(), gap, &state));
        return state;
    }

    /// The bits ASPERITY_WARNING_ of all states from one load [force] to a heavier one: whether the model holds for a contact
    /// that meets these loads; 0 if nothing is known to fail.
    ///
    /// Takes milliseconds. Throws Error as state_at_load, and ASPERITY_INVALID_PARAMETER if lightest is above heaviest.
    std::uint64_t check_loads(double lightest, double heaviest) const {
        std::uint64_t warnings = 0;
        check(asperity_check_loads(open(), lightest, heaviest, &warnings));
        return warnings;
    }

    /// Single specimens with the summits that they happen to have: mean, deviation and quantiles of friction force, stiffness, gap,
    /// contacts and pull-off force at each load [force], ASPERITY_SPREAD_MEAN to ASPERITY_SPREAD_HIGH.
    ///
    /// @param load       in any order; also 0 and, with adhesion, negative ones
    /// @param specimens  how many; 400 give means within 1 %
    /// @param seed       of the random numbers: the same specimens for the same seed
    /// Throws Error (ASPERITY_INVALID_PARAMETER, ASPERITY_INVALID_LOAD, ASPERITY_OUT_OF_RANGE, ASPERITY_NOT_CONVERGED).
    std::vector<Specimens> specimens_at_loads(Span<const double> load, std::size_t specimens = 400, std::uint64_t seed = 0) const {
        std::vector<Specimens> found(load.size(), detail::sized<Specimens>());
        check(asperity_specimens_at_loads(open(), specimens, seed, load.size(), load.data(), found.data()));
        return found;
    }

    /// The same specimens one by one, from `first` on: each at each load, the loads of one specimen next to each other. For threads, and
    /// for a rough sphere of radius R [length]; 0 is a plane.
    ///
    /// Throws Error as specimens_at_loads, and of a sphere that would flatten or bears on too few summits.
    EachSpecimen each_specimen_at_loads(Span<const double> load, double sphere_radius, std::uint64_t first, std::size_t specimens,
                                        std::uint64_t seed = 0) const {
        EachSpecimen found;
        for (auto *numbers : {&found.friction_force, &found.tangential_stiffness, &found.normal_stiffness, &found.gap,
                              &found.contacts, &found.pull_off_force})
            numbers->resize(specimens * load.size());
        check(asperity_each_specimen_at_loads(open(), sphere_radius, first, specimens, seed, load.size(), load.data(),
                                              found.friction_force.data(), found.tangential_stiffness.data(),
                                              found.normal_stiffness.data(), found.gap.data(), found.contacts.data(),
                                              found.pull_off_force.data()));
        return found;
    }

    /// The constants of the model: dimensionless groups, pull-off, extent and error of the compiled law.
    Summary summary() const {
        auto summary = detail::sized<Summary>();
        check(asperity_summary_of(open(), &summary));
        return summary;
    }

    /// A view of the compiled law, which asperity_eval.h evaluates where the library cannot be called.
    ///
    /// ASPERITY_TABLE_LOAD_AT_GAP is load against gap: minus the gap stands in place of a load, and the load in place of the
    /// friction force. Valid until set_params, and as long as the C model lives: moving the Model keeps it.
    Table table(std::int32_t kind = ASPERITY_TABLE_FRICTION) const {
        auto table = detail::sized<Table>();
        check(asperity_table_of(open(), kind, &table));
        return table;
    }

    /// The C model, for functions of asperity.h that ask it: asperity_friction_at_load(model.c(), load). Still owned by this
    /// object; null if that was moved from.
    const asperity_model *c() const noexcept { return handle_.get(); }

private:
    using Batch = asperity_status (*)(const asperity_model *, std::size_t, const double *, double *, double *);

    /// The C model, which a Model that was moved from lacks.
    asperity_model *open() const {
        if (!handle_) {
            throw MovedFrom();
        }
        return handle_.get();
    }

    struct Free {
        void operator()(asperity_model *model) const noexcept { asperity_free(model); }
    };

    static asperity_status stiffnesses(const asperity_model *model, std::size_t n, const double *load,
                                       double *stiffness, double *) {
        return asperity_tangential_stiffness_at_loads(model, n, load, stiffness);
    }

    static void require_sizes(Span<const double> loads, Span<double> value, Span<double> slope) {
        require_size("values", value.size(), loads.size());
        if (slope.data() != nullptr) {
            require_size("slopes", slope.size(), loads.size());
        }
    }

    Status many(Batch batch, Span<const double> loads, Span<double> value, Span<double> slope) const {
        require_sizes(loads, value, slope);
        return batch(open(), loads.size(), loads.data(), value.data(), slope.data());
    }

    /// An open contact is an answer. The library reports the first invalid load alone, so that one may hide a load that has none.
    void answered(Batch batch, Span<const double> loads, Span<double> value, Span<double> slope) const {
        const Status status = many(batch, loads, value, slope);
        if (status != ASPERITY_SEPARATED) {
            check(status);
            return;
        }
        for (std::size_t i = 0; i < loads.size(); ++i) {
            if (is_nan(value.data()[i])) {
                auto state = detail::sized<State>();
                const Status why = asperity_state_at_load(open(), loads.data()[i], &state);
                throw Error(why, "element " + std::to_string(i) + ": " + last_error());
            }
        }
    }

    // By its bits: a program may be compiled as if there were none.
    static bool is_nan(double x) noexcept {
        std::uint64_t bits;
        std::memcpy(&bits, &x, sizeof bits);
        return bits << 1 > std::uint64_t{0x7ff} << 53;
    }

    void require_state(const char *name, std::size_t size, std::size_t contacts) const {
        require_size(name, size, contacts * microslip_length(), "doubles in the states, microslip_length() for each");
    }

    friend Status friction_force_at_load(Span<const Model *const>, Span<const std::uint32_t>, Span<const double>,
                                         Span<double>, Span<double>);

    static void require_size(const char *name, std::size_t size, std::size_t count, const char *of = "loads") {
        if (size != count) {
            throw Error(ASPERITY_INVALID_PARAMETER, std::string("size of ") + name + " = " + std::to_string(size) +
                                                        ": must be the number of " + of + ", " +
                                                        std::to_string(count));
        }
    }

    explicit Model(asperity_model *model) noexcept : handle_(model) {}

    std::unique_ptr<asperity_model, Free> handle_;
};

/// Friction forces of contacts that belong to several models, into memory of the caller.
///
/// Every element is as Model::friction_force_at_load of its model gives it. For the inner loop: allocates nothing where the
/// models are 64 or fewer.
///
/// @param models        the models; none may be null
/// @param which         for each contact, the index of its model
/// @param loads         as many normal loads [force]
/// @param force         receives as many forces [force]; may be `loads` itself
/// @param dforce_dload  receives as many slopes; none by default
/// @return as Model::friction_force_at_load, and ASPERITY_INVALID_PARAMETER where `which` is not the index of a model
/// Throws Error (ASPERITY_INVALID_PARAMETER) for arrays of other sizes, ASPERITY_NULL_POINTER for a model that is null, before
/// anything is written.
[[nodiscard]] inline Status friction_force_at_load(Span<const Model *const> models, Span<const std::uint32_t> which,
                                     Span<const double> loads, Span<double> force, Span<double> dforce_dload = {}) {
    Model::require_size("which", which.size(), loads.size());
    Model::require_sizes(loads, force, dforce_dload);
    constexpr std::size_t FEW = 64;
    const asperity_model *few[FEW];
    std::vector<const asperity_model *> more(models.size() > FEW ? models.size() : 0);
    const asperity_model **const handles = models.size() > FEW ? more.data() : few;
    for (std::size_t i = 0; i < models.size(); ++i) {
        handles[i] = models.data()[i] == nullptr ? nullptr : models.data()[i]->c();
    }
    const Status status = asperity_friction_force_at_loads_of(handles, models.size(), loads.size(), which.data(),
                                                              loads.data(), force.data(), dforce_dload.data());
    if (status == ASPERITY_NULL_POINTER) {
        check(status);
    }
    return status;
}

} // namespace asperity

#pragma pop_macro("Error")
#pragma pop_macro("Model")
#pragma pop_macro("Span")
#pragma pop_macro("State")
#pragma pop_macro("Status")
#pragma pop_macro("T")
#pragma pop_macro("Table")
#pragma pop_macro("check")
#pragma pop_macro("clear")
#pragma pop_macro("copy")
#pragma pop_macro("count")
#pragma pop_macro("data")
#pragma pop_macro("describe")
#pragma pop_macro("empty")
#pragma pop_macro("end")
#pragma pop_macro("erase")
#pragma pop_macro("error")
#pragma pop_macro("get")
#pragma pop_macro("index")
#pragma pop_macro("insert")
#pragma pop_macro("length")
#pragma pop_macro("max")
#pragma pop_macro("min")
#pragma pop_macro("move")
#pragma pop_macro("open")
#pragma pop_macro("read")
#pragma pop_macro("reset")
#pragma pop_macro("set")
#pragma pop_macro("size")
#pragma pop_macro("status")
#pragma pop_macro("string")
#pragma pop_macro("table")
#pragma pop_macro("text")
#pragma pop_macro("version")

#endif // ASPERITY_HPP
