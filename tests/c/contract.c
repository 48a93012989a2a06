/* The contract of the C interface as a program in C meets it: what setters set, what a message says, what a name stands for, what
 * friction is at and below zero load. What holds for all functions alike, as NULL, sizes of structs and batches, is asked in
 * tests/c_api; where fields lie in tests/abi. */

#include <asperity.h>

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "check.h"
#include "surfaces.h"

static const char *last_message(void)
{
    static char message[512];
    asperity_last_error(message, sizeof message);
    return message;
}

static int says(const char *text)
{
    return strstr(last_message(), text) != NULL;
}

#define OK(call) CHECK((call) == ASPERITY_OK, "%s", last_message())
#define FAILS(call, status, text) CHECK((call) == ASPERITY_##status && says(text), "'%s' does not say '%s'", last_message(), text)

static asperity_model *model_of(asperity_params p)
{
    asperity_model *model = NULL;
    OK(asperity_create(&p, &model));
    if (model == NULL) exit(1);
    return model;
}

static asperity_summary summary_of(const asperity_model *model)
{
    asperity_summary summary = { .struct_size = sizeof summary };
    OK(asperity_summary_of(model, &summary));
    return summary;
}

static asperity_state state_at(const asperity_model *model, double load)
{
    asperity_state state = { .struct_size = sizeof state };
    OK(asperity_state_at_load(model, load, &state));
    return state;
}

static int close_to(double a, double b, double relative)
{
    return fabs(a - b) <= relative * fabs(b);
}

static double value_of(const asperity_params *p, const char *name)
{
    double value = -99;
    OK(asperity_params_get_value(p, name, &value));
    return value;
}

static asperity_status set_value(asperity_params *p, const char *name, double value)
{
    return asperity_params_set_values(p, 1, &name, &value);
}

static asperity_status set_text(asperity_params *p, const char *text)
{
    return asperity_params_set_text(p, text, strlen(text));
}

static void versions_agree_with_the_header(void)
{
    char version[32];
    snprintf(version, sizeof version, "%d.%d.%d", ASPERITY_VERSION_MAJOR, ASPERITY_VERSION_MINOR, ASPERITY_VERSION_PATCH);
    CHECK(strcmp(asperity_version(), version) == 0 && strcmp(ASPERITY_VERSION, version) == 0, "%s", asperity_version());
    CHECK(asperity_abi_version() == ASPERITY_ABI_VERSION, "%u", asperity_abi_version());
}

/* By its name and by its number: texts of their own, and of each warning what to do. */
static void statuses_and_warnings_are_named_as_their_constants(void)
{
    static const struct { const char *name; uint64_t number; } named[] = {
#define NAMED(prefix, name) { #name, prefix##name }
#define STATUS(name) NAMED(ASPERITY_, name)
#define WARNING(name) NAMED(ASPERITY_WARNING_, name)
        STATUS(OK), STATUS(NULL_POINTER), STATUS(INVALID_PARAMETER), STATUS(INVALID_LOAD), STATUS(SEPARATED), STATUS(OUT_OF_RANGE),
        STATUS(NOT_CONVERGED), STATUS(INTERNAL), WARNING(PLASTIC), WARNING(CROWDED), WARNING(STEEP), WARNING(ATOMIC), WARNING(FEW),
        WARNING(ADHESIVE), WARNING(UNCALIBRATED), WARNING(BROAD), WARNING(STRONG), WARNING(FEW_WAVES), WARNING(FLAT_TOP),
        WARNING(NOT_GAUSSIAN),
    };
    enum { STATUSES = 8, ALL = sizeof named / sizeof *named };
    static char text[4096], all[4096], described[4096], line[32];
    size_t whole = 0;

    for (size_t i = 0; i < ALL; i++) {
        const int is_status = i < STATUSES, kind = is_status ? ASPERITY_NAMES_STATUSES : ASPERITY_NAMES_WARNINGS;
        const char *name = asperity_name(kind, is_status ? i : i - STATUSES);
        CHECK(name != NULL && strcmp(name, named[i].name) == 0, "%s is named %s", named[i].name, name);
        if (is_status) snprintf(text, sizeof text, "%s", asperity_status_string((asperity_status)named[i].number));
        else asperity_warnings_text(named[i].number, text, sizeof text);
        CHECK(strchr(text, '\n') == NULL && strstr(all, text) == NULL && (is_status || strchr(text, ';') != NULL), "'%s'", text);
        asperity_describe(kind, name, described, sizeof described);
        snprintf(line, sizeof line, "%s = %d\n", is_status ? "status" : "bit", (int)named[i].number);
        CHECK(strstr(described, line) != NULL && strstr(described, text) != NULL, "'%s' does not say %s", described, line);
        if (is_status) continue;
        whole += strlen(text) + (whole > 0);
        CHECK(asperity_warnings_text(2 * named[i].number - 1, all, sizeof all) == whole, "another length than all together");
        CHECK(strcmp(all + whole - strlen(text), text) == 0, "'%s'", all);
    }
    CHECK(asperity_name(ASPERITY_NAMES_STATUSES, STATUSES) == NULL && asperity_name(ASPERITY_NAMES_WARNINGS, 12) == NULL, "more");
    CHECK(strcmp(asperity_status_string(7), "unknown status") == 0, "%s", asperity_status_string(7));
    CHECK(asperity_warnings_text(0, text, sizeof text) == 10 && strcmp(text, "no warning") == 0, "'%s'", text);
    asperity_warnings_text((UINT64_C(1) << 40) | 1, text, sizeof text);
    CHECK(strcmp(text + strlen(text) - 16, "\nunknown warning") == 0, "'%s'", text);
}

static void bodies_and_interfaces_are_described_by_their_names(void)
{
    static const struct { int32_t kind; const char *name, *line; } known[] = {
        { ASPERITY_NAMES_PARAMETERS, "contact_law", "default = \"maugis\"\nchoices = [\"maugis\", \"elastic-plastic\"]\n" },
        { ASPERITY_NAMES_PARAMETERS, "composite_modulus", "unit = \"stress\"\n" },
        { ASPERITY_NAMES_MATERIALS, "steel", "hardness = 7500000000.0  # [Pa]\nhardness_low = 2000000000.0  # [Pa]\n" },
        { ASPERITY_NAMES_MATERIALS, "gold", "name = \"Au\"\n" },
        { ASPERITY_NAMES_PAIRS, "Au/mica", "name = \"mica/Au\"\nwork_of_adhesion = 0.172  # [J/m^2]\n" },
        { ASPERITY_NAMES_INTERFACES, "KCl film on iron in vacuum", "pressure_coefficient = 0.14  # [-]\n" },
        { ASPERITY_NAMES_INTERFACES, "steel/steel dry", "friction_coefficient = 0.57  # [-]\nload = 12.0  # [N]\n" },
    };
    const size_t counts[] = { 36, 30, 26, 39 };
    char text[2048];

    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        CHECK(asperity_describe(known[i].kind, known[i].name, text, sizeof text) == strlen(text), "%s", last_message());
        CHECK(strstr(text, known[i].line) != NULL, "'%s' does not say '%s'", text, known[i].line);
    }
    for (int32_t kind = 0; kind < 4; kind++) {
        size_t n = 0;
        for (const char *name; (name = asperity_name(kind, n)) != NULL; n++)
            CHECK(asperity_describe(kind, name, NULL, 0) > 20, "%s: %s", name, last_message());
        CHECK(n == counts[kind] && asperity_name(kind, SIZE_MAX) == NULL, "%zu names of kind %d", n, kind);
    }
    CHECK(asperity_name(-1, 0) == NULL && asperity_name(6, 0) == NULL, "names of no kind");
#define UNKNOWN(kind, name, words) CHECK(asperity_describe(kind, name, text, sizeof text) == 0 && says(words), "%s", last_message())
    UNKNOWN(ASPERITY_NAMES_MATERIALS, "Stel", "Stel: no material has this name; the nearest is steel");
    UNKNOWN(ASPERITY_NAMES_MATERIALS, "rubber", "rubber is viscoelastic");
    UNKNOWN(ASPERITY_NAMES_PAIRS, "Au/mika", "Au/mika: no pair has this name; the nearest is Au/mica");
    UNKNOWN(ASPERITY_NAMES_INTERFACES, "MoS2 film", "no interface has this name; the nearest is MoS2 film in dry air");
}

static void init_sets_every_default_and_no_physical_input(void)
{
    asperity_status (*const init)(asperity_params *, size_t) = asperity_params_init; /* as a plugin host keeps it */
    asperity_params p;

    memset(&p, 0xa5, sizeof p);
    OK(init(&p, sizeof p));
    CHECK(p.struct_size == sizeof p, "struct_size %llu", (unsigned long long)p.struct_size);
    for (const double *input = &p.composite_modulus; input <= &p.asperity_count; input++)
        CHECK(isnan(*input), "input %d is %g", (int)(input - &p.composite_modulus), *input);
    CHECK(p.height_distribution == ASPERITY_HEIGHTS_GAUSSIAN && p.attraction == 1 && p.weibull_shape == 3.602 && p.skew == 0 &&
          p.kurtosis == 3 && p.radius_amplitude == 0 && p.radius_rate == 0.5, "heights and radii");
    CHECK(p.slip_radius_1 == 28 && p.slip_stress_1 == 1.0 / 43 && p.slip_radius_2 == 8e4 && p.slip_stress_2 == 1.0 / 1290, "strengths");
    CHECK(p.max_friction_coefficient == 1000 && p.pressure_coefficient == 0, "cap, kappa");
    CHECK(p.table_height == NULL && p.table_density == NULL && p.table_length == 0, "a table");
    CHECK(p.hardness == 0 && p.tangential_modulus == 0 && p.nominal_area == 0 && p.bandwidth == 0 && p.summit_mean_height == 0 &&
          p.rms_slope == 0, "what is not known");
    CHECK(p.contact_law == ASPERITY_CONTACT_MAUGIS && p.slip_onset == ASPERITY_SLIP_PARTIAL, "laws");
    CHECK(p.calibration_load == 0 && p.calibration_friction_force == 0 && p.calibration_error == 0.05, "a calibration");
}

static void a_slip_of_units_is_told(void)
{
    static const struct { const char *name; double factor; const char *text; } slips[] = {
        { "work_of_adhesion", 1e3, "is it in mJ/m^2?" }, { "summit_radius", 1e6, "is it in mm, um or nm?" },
        { "hardness", 1e-9, "is hardness in GPa" }, { "nominal_area", 1e6, "is nominal_area in mm^2" },
        { "nominal_area", 1e-14, "must be at most 1e6" }, { "calibration_error", 100, "is it in per cent?" },
        { "slip_radius_1", 0.384e-9, "must be at least 1; is it a length? It is a ratio to burgers_vector" },
    };
    for (size_t i = 0; i < sizeof slips / sizeof *slips; i++) {
        asperity_params p = surface(8);
        asperity_model *model = NULL;
        p.hardness = 12e9;
        p.nominal_area = 1e-8;
        OK(set_value(&p, slips[i].name, value_of(&p, slips[i].name) * slips[i].factor));
        CHECK(asperity_create(&p, &model) != ASPERITY_OK && model == NULL && says(slips[i].text), "'%s'", last_message());
    }
}

static void setters_set_what_they_say_and_nothing_else(void)
{
    const double g1 = 200e9 / 2.6, g2 = 70e9 / 2.68;
    asperity_params p = surface(8), expected;

    p.radius_amplitude = 0.25;
    p.max_friction_coefficient = 7;
    expected = p;
    OK(asperity_params_set_dimensionless(&p, 0.02, 500, 0.003, 0.5, 0.2));
    CHECK(close_to(p.composite_modulus, 2 / 0.8, 1e-15) && p.effective_shear_modulus == 2, "moduli");
    CHECK(close_to(p.height_std, 10, 1e-15) && close_to(p.summit_radius, 25000, 1e-15), "sigma, R");
    CHECK(close_to(p.work_of_adhesion, 0.0075, 1e-15) && p.adhesion_range == 2, "w, h");
    CHECK(p.burgers_vector == 1 && p.asperity_count == 1 && p.tangential_modulus == 0, "b, N, and G^ as by default");
    p.tangential_modulus = expected.tangential_modulus;
    CHECK(memcmp(&p.height_distribution, &expected.height_distribution,
                 sizeof p - offsetof(asperity_params, height_distribution)) == 0, "the rest changed");

    p = expected;
    OK(asperity_params_set_materials(&p, 200e9, 0.3, 70e9, 0.34));
    CHECK(close_to(p.composite_modulus, 1 / ((1 - 0.09) / 200e9 + (1 - 0.1156) / 70e9), 1e-14), "E*");
    CHECK(close_to(p.effective_shear_modulus, 2 * g1 * g2 / (g1 + g2), 1e-14), "G*");
    CHECK(close_to(p.tangential_modulus, 1 / ((2 - 0.3) / g1 + (2 - 0.34) / g2), 1e-14), "G^");
#define TAKE(field) expected.field = p.field;
    TAKE(composite_modulus) TAKE(effective_shear_modulus) TAKE(tangential_modulus)
    CHECK(SAME(p, expected), "set_materials changed another field");
    OK(asperity_params_set_materials(&p, 200e9, 0.3, INFINITY, 0.3));
    CHECK(close_to(p.composite_modulus, 200e9 / 0.91, 1e-14), "E* against a rigid body");

    expected = p;
    OK(asperity_params_set_spectral_moments(&p, 3, 0.5, 0.7, 11));
    CHECK(close_to(p.height_std, sqrt(3), 0.2) && close_to(p.summit_mean_height, 2.3, 0.2), "heights");
    CHECK(p.radius_amplitude < -0.3 && p.radius_amplitude > -0.9 && p.radius_rate > 0.3, "higher asperities are sharper");
    CHECK(p.asperity_count > 0.01 * 11 / 3 && p.asperity_count < 0.05 * 11 / 3, "N = %.9g", p.asperity_count);
    CHECK(p.nominal_area == 11 && p.rms_slope == 1 && p.bandwidth == 0, "what warnings judge");
    TAKE(height_std) TAKE(summit_radius) TAKE(asperity_count) TAKE(nominal_area) TAKE(bandwidth) TAKE(radius_amplitude)
    TAKE(radius_rate) TAKE(summit_mean_height) TAKE(rms_slope)
    CHECK(SAME(p, expected), "set_spectral_moments changed another field");
    OK(asperity_params_set_spectral_moments(&p, 3, 0.5, 0, 11));
    CHECK(close_to(p.summit_radius, expected.summit_radius, 0.05) && p.summit_radius != expected.summit_radius, "R without m4");
    TAKE(summit_radius)
    CHECK(SAME(p, expected), "m4 changed more than the radius");
}

static void failing_setters_name_the_argument_and_touch_nothing(void)
{
    const asperity_params before = surface(8);
    asperity_params p = before;
    const char *given[] = { "calibration_load", "calibration_friction_force", "calibration_friction_coefficient" };
    const double values[] = { 5, 2, 0.4 };

    FAILS(asperity_params_set_dimensionless(&p, -1, 1000, 0.001, 1, 0.3), INVALID_PARAMETER, "alpha = -1: ");
    FAILS(asperity_params_set_dimensionless(&p, 0.01, 1000, 0.001, 1, 0.6), INVALID_PARAMETER, " = 0.6: ");
    FAILS(asperity_params_set_materials(&p, 1, 0.3, 1, -1), INVALID_PARAMETER, "nu2 = -1: ");
    FAILS(asperity_params_set_materials(&p, INFINITY, 0.3, INFINITY, 0.3), INVALID_PARAMETER, "E2 = inf: ");
    FAILS(asperity_params_set_spectral_moments(&p, 1, 1, 1.49, 1), INVALID_PARAMETER, "bandwidth m0 m4/m2^2 = 1.49: must be at least 1.5");
    FAILS(asperity_params_set_spectral_moments(&p, 1, 1, 2, INFINITY), INVALID_PARAMETER, "nominal_area = inf: ");
    FAILS(asperity_params_set_spectral_moments(&p, 1, 1e-41, 2, 1), OUT_OF_RANGE, "m2 = 1e-41: ");
    FAILS(asperity_params_set_pair(&p, "Si/Auu"), INVALID_PARAMETER, "Si/Auu: no pair has this name; the nearest is Si/Au");
    FAILS(asperity_params_set_values(&p, 1, given, values), INVALID_PARAMETER, "must be given together with");
    FAILS(asperity_params_set_values(&p, 3, given, values), INVALID_PARAMETER, "with one of the two alone");
    FAILS(set_value(&p, "sumit_radius", 1), INVALID_PARAMETER, "sumit_radius: no parameter has this name; the nearest is summit_radius");
    FAILS(set_value(&p, "a\n\xff", 1), INVALID_PARAMETER, "a\\n\\xff: no parameter");
    FAILS(set_value(&p, "E1", 2e11), INVALID_PARAMETER, "nu1: must be given too: E1, nu1, E2");
    FAILS(set_value(&p, "skew", -1.2), INVALID_PARAMETER, "skew = -1.2: ");
    FAILS(set_value(&p, "skew", 1e6), OUT_OF_RANGE, "skew = ");
    FAILS(set_value(&p, "attraction", 0.5), INVALID_PARAMETER, "attraction = 0.5: must be 0 or 1");
    FAILS(set_text(&p, "height_std = 1\nhardness = \"hard\""), INVALID_PARAMETER, "line 2: hardness");
    FAILS(set_text(&p, "interface = \"graphite\""), INVALID_PARAMETER, "graphite: no interface has this name; the nearest is ");
    CHECK(SAME(p, before), "the parameters changed");
}

enum { NAMES = 36 };

/* Set in their order, whatever heights this one had, all are those of another surface. */
static void names_are_those_of_the_fields(void)
{
    asperity_params p = surface(8);

#define FIELD(field, value)                                                                                            \
    CHECK(value_of(&p, #field) == p.field, #field);                                                                    \
    CHECK(set_value(&p, #field, value) == ASPERITY_OK && p.field == value, #field ": %s", last_message());
    FIELD(length_unit, 2) FIELD(force_unit, 2)
    FIELD(composite_modulus, 2) FIELD(effective_shear_modulus, 2) FIELD(work_of_adhesion, 2) FIELD(adhesion_range, 2)
    FIELD(burgers_vector, 2) FIELD(height_std, 2) FIELD(summit_radius, 2) FIELD(asperity_count, 2) FIELD(attraction, 0)
    FIELD(radius_amplitude, 2) FIELD(radius_rate, 2) FIELD(slip_radius_1, 2) FIELD(slip_stress_1, 2) FIELD(slip_radius_2, 2)
    FIELD(slip_stress_2, 2) FIELD(max_friction_coefficient, 2) FIELD(hardness, 2) FIELD(tangential_modulus, 2)
    FIELD(nominal_area, 2) FIELD(pressure_coefficient, 2) FIELD(bandwidth, 2) FIELD(calibration_error, 2)
    FIELD(summit_mean_height, 2) FIELD(rms_slope, 2) FIELD(waviness_height, 2) FIELD(waviness_width, 2)
    FIELD(waviness_shape, 2) FIELD(taken_as_gaussian, 0) FIELD(contact_law, 1) FIELD(slip_onset, 1) FIELD(weibull_shape, 2)
    FIELD(height_distribution, 2) FIELD(kurtosis, 2) FIELD(skew, 2)
    for (int i = 0; i < SURFACES * SURFACES; i++) {
        const asperity_params source = surface(i % SURFACES);
        asperity_params one_by_one = surface(i / SURFACES), at_once = one_by_one;
        const char *names[NAMES];
        double values[NAMES];
        if (source.table_height != one_by_one.table_height) continue;
        for (size_t k = 0; k < NAMES; k++) {
            names[k] = asperity_name(ASPERITY_NAMES_PARAMETERS, k);
            values[k] = value_of(&source, names[k]);
            OK(set_value(&one_by_one, names[k], values[k]));
        }
        OK(asperity_params_set_values(&at_once, NAMES, names, values));
        CHECK(SAME(one_by_one, source) && SAME(at_once, source), "%d is not copied to %d", i % SURFACES, i / SURFACES);
    }
}

static void names_that_go_together_are_as_the_setters(void)
{
    const char *names[] = { "nu2", "E1", "m4", "m0", "m2", "nominal_area", "nu1", "E2", "hardness" }, *mean[] = { "Ra", "m2", "m4", "m0" };
    const double values[] = { 0.34, 200e9, 0.7, 3, 0.5, 11, 0.3, 70e9, 7e9 }, means[] = { 2, 0.5, 0.7, 3 };
    asperity_params p = surface(0), expected = p;

    OK(asperity_params_set_materials(&expected, 200e9, 0.3, 70e9, 0.34));
    OK(asperity_params_set_spectral_moments(&expected, 3, 0.5, 0.7, 11));
    expected.hardness = 7e9;
    OK(asperity_params_set_values(&p, 9, names, values));
    CHECK(SAME(p, expected), "another surface than the setters make");
    OK(asperity_params_set_values(&p, 3, mean, means)); /* Ra stands for m0, pi/2 Ra^2; the area is known */
    OK(asperity_params_set_spectral_moments(&expected, 2 * 3.14159265358979323846, 0.5, 0.7, 11));
    CHECK(SAME(p, expected), "another surface than m0 makes");
    FAILS(asperity_params_set_values(&p, 4, mean, means), INVALID_PARAMETER, "Ra: must not be given");
}

static void names_of_heights_choose_them(void)
{
    const char *both[] = { "skew", "kurtosis" }, *all[] = { "height_distribution", "weibull_shape", "kurtosis" };
    const double two[] = { -2, 12 }, three[] = { ASPERITY_HEIGHTS_GAUSSIAN, 2, 5 };
    asperity_params p = surface(0);
    asperity_model *model = NULL;

    OK(set_value(&p, "skew", 0));
    CHECK(p.height_distribution == ASPERITY_HEIGHTS_WEIBULL && fabs(p.weibull_shape - 3.602) < 6e-4, "omega = %g", p.weibull_shape);
    OK(asperity_params_set_values(&p, 2, both, two));
    CHECK(p.height_distribution == ASPERITY_HEIGHTS_JOHNSON && p.skew == -2 && p.kurtosis == 12, "Johnson's heights");
    OK(set_value(&p, "skew", 1));
    CHECK(p.height_distribution == ASPERITY_HEIGHTS_JOHNSON && p.skew == 1, "Johnson's heights are lost");
    OK(set_value(&p, "weibull_shape", 3));
    CHECK(p.height_distribution == ASPERITY_HEIGHTS_WEIBULL && p.weibull_shape == 3 && p.skew == 0 && p.kurtosis == 3, "Weibull's");
    OK(asperity_params_set_values(&p, 3, all, three));
    CHECK(p.height_distribution == ASPERITY_HEIGHTS_GAUSSIAN && p.weibull_shape == 2 && p.kurtosis == 5, "last word");
    FAILS(asperity_create(&p, &model), INVALID_PARAMETER, "kurtosis = 5: must be 3 unless heights are Johnson's");
    p.kurtosis = 3;
    p.skew = -1;
    FAILS(asperity_create(&p, &model), INVALID_PARAMETER, "skew = -1: must be 0 unless heights are Johnson's");
}

/* By the calls and by name, on every kind of surface; adhering ones also where no load presses. */
static void a_calibrated_surface_meets_the_measured_point(void)
{
    const char *by_coefficient[] = { "calibration_friction_coefficient", "calibration_load" };
    const char *by_force[] = { "calibration_friction_force", "calibration_load" };

    for (int which = 0; which < SURFACES; which++) {
        asperity_params p = surface(which), named = p, forced = p, forced_by_name = p;
        asperity_model *model = model_of(p);
        double load = 1e-3 * summary_of(model).max_table_load, pull = 0.5 * summary_of(model).pull_off_load;
        while (asperity_friction_force_at_load(model, load) > 5 * load) load *= 2;
        const double force = 0.7 * state_at(model, load).friction_force, pulled = 0.7 * asperity_friction_force_at_load(model, pull);
        const double points[][2] = { { force / load, load }, { force / load * load, load } };
        OK(asperity_params_calibrate(&p, load, points[0][0]));
        OK(asperity_params_calibrate_force(&forced, load, points[1][0]));
        OK(asperity_params_set_values(&named, 2, by_coefficient, points[0]));
        OK(asperity_params_set_values(&forced_by_name, 2, by_force, points[1]));
        CHECK(SAME(named, p) && SAME(forced, p) && SAME(forced_by_name, p), "surface %d: another strength by name", which);
        CHECK(p.calibration_load == load && p.calibration_friction_force == points[1][0], "surface %d: another point", which);
        OK(asperity_set_params(model, &p));
        CHECK(close_to(state_at(model, load).friction_force, force, 1e-12), "surface %d: not met", which);
        CHECK((state_at(model, load).warnings & ASPERITY_WARNING_UNCALIBRATED) == 0, "surface %d: a warning", which);
        if (pulled > 1e-30) {
            FAILS(asperity_params_calibrate(&p, pull, 0.5), INVALID_PARAMETER, "where the load pulls, calibrate with the friction force");
            OK(asperity_params_calibrate_force(&p, pull, pulled));
            OK(asperity_set_params(model, &p));
            CHECK(close_to(state_at(model, pull).friction_force, pulled, 1e-12), "surface %d: pulled", which);
        }
        asperity_free(model);
    }
}

/* What a pair of bodies tells, and no roughness; what is not known is left to set. */
static void pairs_and_interfaces_set_what_they_tell_and_nothing_else(void)
{
    asperity_params p = surface(8), expected = p;
    asperity_model *model = NULL;

    OK(asperity_params_set_materials(&expected, 54e9, 0.1, 78e9, 0.44));
    expected.work_of_adhesion = 0.172;
    expected.adhesion_range = expected.burgers_vector = 0.52e-9;
    expected.slip_stress_1 = 0.0108;
    CHECK(asperity_params_set_pair(&p, "mica/Au") == ASPERITY_OK && SAME(p, expected), "%s", last_message());
    OK(asperity_params_set_pair(&p, "PDMS/PDMS"));
    CHECK(p.work_of_adhesion == 0.045 && isnan(p.adhesion_range) && isnan(p.burgers_vector), "of a rubber no lattice is known");
    FAILS(asperity_create(&p, &model), INVALID_PARAMETER, "adhesion_range: must be set");

    OK(asperity_params_set_pair(&p, "steel/steel"));
    p.work_of_adhesion = 0;
    expected = p;
    expected.slip_stress_1 = expected.slip_stress_2 = 65e6 / p.effective_shear_modulus;
    expected.pressure_coefficient = 0.14;
    CHECK(set_text(&p, "interface = \"KCl film on iron in vacuum\"") == ASPERITY_OK && SAME(p, expected), "%s", last_message());
    model = model_of(p);
    for (double load = 1e-6; load < 1; load *= 10) {
        const asperity_state state = state_at(model, load);
        CHECK(close_to(state.friction_force, 65e6 * state.real_area + 0.14 * load, 1e-12), "F = %.15g", state.friction_force);
        CHECK((state.warnings & ASPERITY_WARNING_UNCALIBRATED) == 0, "a warning of a default at %g N", load);
    }
    asperity_free(model);
}

static void a_refused_change_leaves_the_model_bit_for_bit(void)
{
    static const struct { const char *name; double value; asperity_status status; const char *text; } refused[] = {
        { "work_of_adhesion", -0.5, ASPERITY_INVALID_PARAMETER, "work_of_adhesion = -0.5: must be finite and >= 0" },
        { "slip_radius_2", 28, ASPERITY_INVALID_PARAMETER, "slip_radius_2 = 28: must be greater than slip_radius_1" },
        { "weibull_shape", 1e9, ASPERITY_OUT_OF_RANGE, "weibull_shape = 1000000000: must be at most 200" },
        { "hardness", 1e41, ASPERITY_OUT_OF_RANGE, "hardness = 1e41: must be between 1e-40 and 1e40" },
        { "summit_radius", 1e-3, ASPERITY_OUT_OF_RANGE, "alpha = 100: " },
    };
    asperity_model *model = model_of(surface(4));
    const asperity_summary before = summary_of(model);
    const double force = asperity_friction_force_at_load(model, 37.5);

    for (size_t i = 0; i < sizeof refused / sizeof *refused; i++) {
        asperity_params p = surface(4), kept = { .struct_size = sizeof kept };
        asperity_model *none = NULL;
        asperity_summary after;
        set_value(&p, refused[i].name, refused[i].value);
        CHECK(asperity_create(&p, &none) == refused[i].status && says(refused[i].text) && none == NULL, "'%s'", last_message());
        CHECK(asperity_set_params(model, &p) == refused[i].status && says(refused[i].text), "'%s'", last_message());
        after = summary_of(model);
        p = surface(4);
        OK(asperity_get_params(model, &kept));
        CHECK(SAME(before, after) && SAME(kept, p) && asperity_friction_force_at_load(model, 37.5) == force, "another model");
    }
    asperity_free(model);
}

/* At zero and negative loads, and at loads of all sizes; with the groups that the summary has. */
static void friction_is_force_and_coefficient(int which)
{
    asperity_params p = surface(which);
    const double unit = p.asperity_count * p.composite_modulus * p.burgers_vector * p.burgers_vector, cap = p.max_friction_coefficient;
    const char *name = SURFACE_NAMES[which];
    asperity_model *model = model_of(p);
    const asperity_summary s = summary_of(model);
    const double below = nextafter(s.pull_off_load, -INFINITY);

    CHECK(s.pull_off_load <= 0 && s.table_error >= 0 && s.table_error < 1e-6, "%s: error %g", name, s.table_error);
    CHECK(close_to(s.alpha, sqrt(p.height_std / p.summit_radius), 1e-14) && close_to(s.beta, p.height_std / s.alpha / p.burgers_vector, 1e-14) &&
          close_to(s.gamma, p.work_of_adhesion / (p.composite_modulus * p.burgers_vector), 1e-14) &&
          close_to(s.lambda, cbrt(9 * s.beta * s.gamma * s.gamma / (2 * 3.14159265358979323846 * s.alpha)), 1e-14), "%s: groups", name);
    CHECK(asperity_friction_at_load(model, 0.0) == cap && asperity_friction_at_load(model, -0.0) == cap &&
          asperity_friction_at_load(model, s.pull_off_load) == cap, "%s: mu where nothing presses", name);
    CHECK(asperity_friction_force_at_load(model, 0.0) == s.zero_load_friction_force, "%s: F at 0", name);
    CHECK(asperity_friction_at_load(model, below) == 0 && asperity_friction_force_at_load(model, below) == 0, "%s: apart", name);
    p.max_friction_coefficient = INFINITY;
    OK(asperity_set_params(model, &p));
    CHECK(asperity_friction_at_load(model, 0) == INFINITY, "%s: mu at 0 without a cap", name);
    for (double load = 1e-6 * unit; load < 1e6 * unit && load < s.max_table_load; load *= 10) {
        const asperity_state state = state_at(model, load);
        const double force = asperity_friction_force_at_load(model, load), mu = asperity_friction_at_load(model, load);
        CHECK(mu == force / load && close_to(force, state.friction_force, s.table_error + 1e-9), "%s at %g: F %.17g", name, load, force);
        CHECK(state.friction_coefficient == state.friction_force / state.load, "%s at %g: mu of the state", name, load);
        CHECK(close_to(s.stiffness_per_radius * state.contact_radius_sum, state.tangential_stiffness, 1e-12), "%s: K_t", name);
    }
    asperity_free(model);
}

/* An iteration over contacts would otherwise take a tangent of what is not there. The largest load overflows no difference. */
static void an_open_contact_has_neither_force_nor_tangent(int which)
{
    asperity_model *model = model_of(surface(which));
    asperity_summary s = { .struct_size = sizeof s };
    asperity_table table = { .struct_size = sizeof table };
    enum { LOADS = 8 };
    double load[LOADS], force[LOADS], slope[LOADS], mu[LOADS], mu_slope[LOADS];

    OK(asperity_summary_of(model, &s));
    OK(asperity_table_of(model, ASPERITY_TABLE_FRICTION, &table));
    CHECK(table.separated_slope == 0, "%s: the table's slope is %g", SURFACE_NAMES[which], table.separated_slope);
    for (int i = 0; i < LOADS; i++) load[i] = nextafter(s.pull_off_load, -INFINITY) - (i == 0 ? 0 : i == LOADS - 1 ? 1.7e308 : pow(10, 60 * (i - 5)));
    CHECK(asperity_friction_force_at_loads(model, LOADS, load, force, slope) == ASPERITY_SEPARATED, "status");
    CHECK(asperity_friction_at_loads(model, LOADS, load, mu, mu_slope) == ASPERITY_SEPARATED, "status");
    for (int i = 0; i < LOADS; i++) {
        double alone, mu_alone;
        const double found = asperity_friction_force_and_slope_at_load(model, load[i], &alone);
        CHECK(found == 0 && alone == 0 && force[i] == 0 && slope[i] == 0, "%s at %g: %g, %g; in a batch %g, %g",
              SURFACE_NAMES[which], load[i], found, alone, force[i], slope[i]);
        const double coefficient = asperity_friction_and_slope_at_load(model, load[i], &mu_alone);
        CHECK(coefficient == 0 && mu_alone == 0 && mu[i] == 0 && mu_slope[i] == 0, "%s at %g: mu", SURFACE_NAMES[which], load[i]);
    }
    asperity_free(model);
}

static void loads_without_an_answer_say_why(void)
{
    asperity_model *model = model_of(surface(0)), *hertz = model_of(surface(1));
    asperity_state state = { .struct_size = sizeof state };
    uint64_t warnings;

    CHECK(isnan(asperity_friction_at_load(model, NAN)) && isnan(asperity_friction_force_at_load(model, -INFINITY)), "a number");
    FAILS(asperity_state_at_load(model, NAN, &state), INVALID_LOAD, "load = NaN: ");
    FAILS(asperity_state_at_load(model, -1e9, &state), SEPARATED, "load = -1000000000: ");
    FAILS(asperity_state_at_load(model, 1e200, &state), OUT_OF_RANGE, "load = 1e200: ");
    FAILS(asperity_state_at_load(hertz, 0, &state), OUT_OF_RANGE, "load = 0: ");
    FAILS(asperity_state_at_gap(model, NAN, &state), INVALID_PARAMETER, "gap = NaN: ");
    FAILS(asperity_check_loads(model, 2, 1, &warnings), INVALID_PARAMETER, "lightest = 2: must not be above heaviest");
    FAILS(asperity_check_loads(hertz, 0, 1, &warnings), OUT_OF_RANGE, "lightest = 0: ");
    asperity_free(model);
    asperity_free(hertz);
}

int main(void)
{
    versions_agree_with_the_header();
    statuses_and_warnings_are_named_as_their_constants();
    bodies_and_interfaces_are_described_by_their_names();
    init_sets_every_default_and_no_physical_input();
    a_slip_of_units_is_told();
    setters_set_what_they_say_and_nothing_else();
    failing_setters_name_the_argument_and_touch_nothing();
    names_are_those_of_the_fields();
    names_that_go_together_are_as_the_setters();
    names_of_heights_choose_them();
    a_calibrated_surface_meets_the_measured_point();
    pairs_and_interfaces_set_what_they_tell_and_nothing_else();
    a_refused_change_leaves_the_model_bit_for_bit();
    for (int i = 0; i < SURFACES; i++) friction_is_force_and_coefficient(i);
    for (int i = 0; i < SURFACES; i++) an_open_contact_has_neither_force_nor_tangent(i);
    loads_without_an_answer_say_why();
    return checks_report("contract");
}
