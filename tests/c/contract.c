/* The contract of the C interface, clause by clause: what is written and what is not, what a status means, what a
 * message says, what friction is at and below zero load, how a batch behaves. Where fields lie: tests/abi. */

#include <asperity.h>

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "check.h"
#include "surfaces.h"

static char message[512];

static const char *last_message(void)
{
    asperity_last_error(message, sizeof message);
    return message;
}

static int says(const char *text)
{
    return strstr(last_message(), text) != NULL;
}

static asperity_model *model_of(asperity_params p)
{
    asperity_model *model = NULL;
    CHECK(asperity_create(&p, &model) == ASPERITY_OK, "no model: %s", last_message());
    if (model == NULL)
        exit(1);
    return model;
}

static asperity_summary summary_of(const asperity_model *model)
{
    asperity_summary summary;
    summary.struct_size = sizeof summary;
    CHECK(asperity_summary_of(model, &summary) == ASPERITY_OK, "no summary: %s", last_message());
    return summary;
}

static asperity_state state_at(const asperity_model *model, double load)
{
    asperity_state state;
    state.struct_size = sizeof state;
    CHECK(asperity_state_at_load(model, load, &state) == ASPERITY_OK, "load %g: %s", load, last_message());
    return state;
}

static int close_to(double a, double b, double relative)
{
    return fabs(a - b) <= relative * fabs(b);
}

static void versions_agree_with_the_header(void)
{
    char version[32];
    snprintf(version, sizeof version, "%d.%d.%d", ASPERITY_VERSION_MAJOR, ASPERITY_VERSION_MINOR,
             ASPERITY_VERSION_PATCH);
    CHECK(strcmp(asperity_version(), version) == 0, "%s, not %s", asperity_version(), version);
    CHECK(strcmp(ASPERITY_VERSION, version) == 0, "%s, not %s", ASPERITY_VERSION, version);
    CHECK(asperity_abi_version() == ASPERITY_ABI_VERSION, "%u", asperity_abi_version());
}

static void every_status_has_its_own_words(void)
{
    const asperity_status known[] = { ASPERITY_OK, ASPERITY_NULL_POINTER, ASPERITY_INVALID_PARAMETER,
                                      ASPERITY_INVALID_LOAD, ASPERITY_SEPARATED, ASPERITY_OUT_OF_RANGE,
                                      ASPERITY_NOT_CONVERGED, ASPERITY_INTERNAL };
    const int n = sizeof known / sizeof *known;
    for (int i = 0; i < n; i++) {
        const char *words = asperity_status_string(known[i]);
        CHECK(words != NULL && *words != '\0' && strcmp(words, "unknown status") != 0, "status %d", known[i]);
        for (int k = 0; k < i; k++)
            CHECK(strcmp(words, asperity_status_string(known[k])) != 0, "%d and %d are both '%s'", i, k, words);
    }
    CHECK(strcmp(asperity_status_string(-1), "unknown status") == 0, "%s", asperity_status_string(-1));
    CHECK(strcmp(asperity_status_string(8), "unknown status") == 0, "%s", asperity_status_string(8));
}

static void every_warning_says_what_fails_and_what_to_do(void)
{
    const uint64_t all = ASPERITY_WARNING_PLASTIC | ASPERITY_WARNING_CROWDED | ASPERITY_WARNING_STEEP |
                         ASPERITY_WARNING_ATOMIC | ASPERITY_WARNING_FEW | ASPERITY_WARNING_ADHESIVE |
                         ASPERITY_WARNING_UNCALIBRATED | ASPERITY_WARNING_BROAD | ASPERITY_WARNING_STRONG |
                         ASPERITY_WARNING_FEW_WAVES;
    const char *advice[] = { "; use ", "; measure friction once and calibrate with it",
                             "; give the mean squares of height and slope", "; calibrate with a measured friction force" };
    for (int bit = 0; bit < 64; bit++) {
        const uint64_t warning = UINT64_C(1) << bit;
        const char *text = asperity_warning_string(warning);
        CHECK((strcmp(text, "unknown warning") != 0) == ((all & warning) != 0), "bit %d: '%s'", bit, text);
        int advised = 0;
        for (int k = 0; k < 4; k++)
            advised += strstr(text, advice[k]) != NULL;
        CHECK((advised > 0) == ((all & warning) != 0), "bit %d: '%s'", bit, text);
        for (int k = 0; (all & warning) != 0 && k < bit; k++)
            CHECK(strcmp(text, asperity_warning_string(UINT64_C(1) << k)) != 0, "bits %d and %d agree", bit, k);
    }
    CHECK(strcmp(asperity_warning_string(0), "no warning") == 0, "%s", asperity_warning_string(0));
    CHECK(strcmp(asperity_warning_string(3), "unknown warning") == 0, "%s", asperity_warning_string(3));
}

/* A line for each, in the order of the bits; cut to fit, with its whole length told. */
static void the_text_of_warnings_has_a_line_for_each(void)
{
    const uint64_t unknown = UINT64_C(1) << 40;
    char text[4096], expected[4096] = "", cut[20];

    CHECK(asperity_warnings_text(0, text, sizeof text) == 10 && strcmp(text, "no warning") == 0, "'%s'", text);
    for (uint64_t bit = 1; bit <= ASPERITY_WARNING_FEW_WAVES; bit *= 2) {
        const size_t length = strlen(expected);
        snprintf(expected + length, sizeof expected - length, "%s%s", length ? "\n" : "", asperity_warning_string(bit));
        CHECK(asperity_warnings_text(bit, text, sizeof text) == strlen(asperity_warning_string(bit)), "%d", (int)bit);
        CHECK(strcmp(text, asperity_warning_string(bit)) == 0, "'%s'", text);
        CHECK(asperity_warnings_text(2 * bit - 1, text, sizeof text) == strlen(expected), "up to %d", (int)bit);
        CHECK(strcmp(text, expected) == 0, "'%s', not '%s'", text, expected);
    }
    CHECK(asperity_warnings_text(unknown | 1, text, sizeof text) == strlen(asperity_warning_string(1)) + 16, "unknown");
    CHECK(strcmp(text + strlen(text) - 16, "\nunknown warning") == 0, "'%s'", text);
    CHECK(asperity_warnings_text(1023, NULL, 0) == strlen(expected), "the length alone");
    CHECK(asperity_warnings_text(1023, NULL, 100) == strlen(expected), "no buffer, whatever its length");
    memset(cut, 'x', sizeof cut);
    CHECK(asperity_warnings_text(1023, cut, 10) == strlen(expected) && strlen(cut) == 9 && cut[10] == 'x', "'%.20s'", cut);
    CHECK(strncmp(cut, expected, 9) == 0, "'%s'", cut);
    memset(cut, 'x', sizeof cut);
    CHECK(asperity_warnings_text(1023, cut, 0) == strlen(expected) && cut[0] == 'x', "a buffer of no length");
}

/* ---- Parameters ---- */

static void init_sets_every_default_and_no_physical_input(void)
{
    asperity_params p;

    memset(&p, 0xa5, sizeof p);
    CHECK(asperity_params_init(&p, sizeof p) == ASPERITY_OK, "%s", last_message());
    CHECK(p.struct_size == sizeof p, "struct_size %llu", (unsigned long long)p.struct_size);
    for (const double *input = &p.composite_modulus; input <= &p.asperity_count; input++)
        CHECK(isnan(*input), "input %d is %g", (int)(input - &p.composite_modulus), *input);
    CHECK(p.height_distribution == ASPERITY_HEIGHTS_GAUSSIAN && p.attraction == 1, "heights, attraction");
    CHECK(p.weibull_shape == 3.602 && p.skew == 0 && p.kurtosis == 3, "shapes of heights");
    CHECK(p.radius_amplitude == 0 && p.radius_rate == 0.5, "epsilon, rho");
    CHECK(p.slip_radius_1 == 28 && p.slip_stress_1 == 1.0 / 43, "first slip constants");
    CHECK(p.slip_radius_2 == 8e4 && p.slip_stress_2 == 1.0 / 1290, "second slip constants");
    CHECK(p.max_friction_coefficient == 1000, "cap %g", p.max_friction_coefficient);
    CHECK(p.table_height == NULL && p.table_density == NULL && p.table_length == 0, "a table");
    CHECK(p.hardness == 0 && p.tangential_modulus == 0 && p.nominal_area == 0 && p.bandwidth == 0, "what is not known");
    CHECK(p.contact_law == ASPERITY_CONTACT_MAUGIS && p.slip_onset == ASPERITY_SLIP_PARTIAL, "laws");
    CHECK(p.pressure_coefficient == 0, "kappa %g", p.pressure_coefficient);
    CHECK(p.calibration_load == 0 && p.calibration_friction_force == 0 && p.calibration_error == 0.05, "a calibration");
}

/* Of all calls that take or fill parameters. */
static void only_the_size_of_the_struct_is_taken(void)
{
    const size_t whole = sizeof(asperity_params), wrong[] = { 0, 8, whole - 8, whole - 1, whole + 8, SIZE_MAX };
    const asperity_params good = surface(0);
    asperity_model *model = model_of(good), *made = NULL;
    asperity_params p, guard;

    memset(&guard, 0xa5, sizeof guard);
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        const int newer = wrong[i] == whole + 8;
        p = guard;
        CHECK(asperity_params_init(&p, wrong[i]) == ASPERITY_INVALID_PARAMETER && SAME(p, guard), "init: %s", last_message());
        CHECK(says("struct_size = ") && says(newer ? "the header is newer than the library" : ": must be sizeof(asperity_params)"),
              "'%s'", last_message());
        p.struct_size = guard.struct_size = wrong[i];
        CHECK(asperity_get_params(model, &p) == ASPERITY_INVALID_PARAMETER && SAME(p, guard), "get: %s", last_message());
        CHECK(says("struct_size = "), "'%s'", last_message());
        p = good;
        p.struct_size = wrong[i];
        CHECK(asperity_create(&p, &made) == ASPERITY_INVALID_PARAMETER && says("struct_size = ") && made == NULL, "create");
        CHECK(asperity_set_params(model, &p) == ASPERITY_INVALID_PARAMETER && says("struct_size = "), "set_params");
        CHECK(asperity_params_set_skew(&p, 0) == ASPERITY_INVALID_PARAMETER && says("struct_size = "), "set_skew");
    }
    CHECK(asperity_params_init(NULL, whole) == ASPERITY_NULL_POINTER && says("params is NULL"), "'%s'", last_message());
    asperity_free(model);
}

/* A plugin host keeps functions in a table of pointers. */
static void a_pointer_to_init_gives_the_whole_struct(void)
{
    asperity_status (*const init)(asperity_params *, size_t) = asperity_params_init;
    asperity_params p, direct;

    memset(&p, 0xa5, sizeof p);
    asperity_params_init(&direct, sizeof direct);
    CHECK(init(&p, sizeof p) == ASPERITY_OK && SAME(p, direct), "%s", last_message());
}

static void what_was_never_set_is_named(void)
{
    static const char *const names[] = { "composite_modulus", "effective_shear_modulus", "work_of_adhesion", "adhesion_range",
                                         "burgers_vector", "height_std", "summit_radius", "asperity_count" };
    const asperity_params whole = surface(0);
    asperity_params p;
    asperity_model *model = NULL;
    char expected[64];
    double *inputs = &p.composite_modulus;

    asperity_params_init(&p, sizeof p);
    for (int i = 0; i < 8; i++) {
        snprintf(expected, sizeof expected, "%s: must be set; ", names[i]);
        CHECK(asperity_create(&p, &model) == ASPERITY_INVALID_PARAMETER && says(expected), "'%s'",
              last_message());
        CHECK(asperity_params_calibrate(&p, 1, 0.5) == ASPERITY_INVALID_PARAMETER && says(expected),
              "'%s'", last_message());
        inputs[i] = (&whole.composite_modulus)[i];
    }
    CHECK(asperity_create(&p, &model) == ASPERITY_OK, "%s", last_message());
    asperity_free(model);
    p.height_std = NAN; /* a result of the caller's, and not one that was forgotten */
    CHECK(asperity_create(&p, &model) == ASPERITY_INVALID_PARAMETER && says("height_std = NaN: must be"), "'%s'",
          last_message());
}

static void a_slip_of_units_is_told(void)
{
    asperity_params p = surface(8);
    asperity_model *model = NULL;

    p.work_of_adhesion *= 1e3;
    CHECK(asperity_create(&p, &model) == ASPERITY_OUT_OF_RANGE && says("is it in mJ/m^2?"), "'%s'", last_message());
    p = surface(8);
    p.summit_radius *= 1e6;
    CHECK(asperity_create(&p, &model) == ASPERITY_OUT_OF_RANGE && says("is it in mm, um or nm?"), "'%s'", last_message());
    p = surface(8);
    p.hardness = 12;
    CHECK(asperity_create(&p, &model) == ASPERITY_OUT_OF_RANGE && says("is hardness in GPa"), "'%s'", last_message());
    p = surface(8);
    p.slip_radius_1 = 10.75e-9;
    CHECK(asperity_create(&p, &model) == ASPERITY_INVALID_PARAMETER &&
          says("slip_radius_1 = 1.075e-8: must be at least 1; is it a length? It is a ratio to burgers_vector"), "'%s'",
          last_message());
    p = surface(8);
    p.nominal_area = 1e-2; /* mm^2 */
    CHECK(asperity_create(&p, &model) == ASPERITY_OUT_OF_RANGE && says("is nominal_area in mm^2"), "'%s'", last_message());
    p.nominal_area = 1e-22;
    CHECK(asperity_create(&p, &model) == ASPERITY_OUT_OF_RANGE && says("bandwidth = ") && says("must be at most 1e6"), "'%s'", last_message());
}

static void setters_set_what_they_say_and_nothing_else(void)
{
    asperity_params p = surface(8), expected;

    p.radius_amplitude = 0.25;
    p.max_friction_coefficient = 7;
    expected = p;
    CHECK(asperity_params_set_dimensionless(&p, 0.02, 500, 0.003, 0.5, 0.2) == ASPERITY_OK, "%s", last_message());
    CHECK(close_to(p.composite_modulus, 2 / 0.8, 1e-15) && p.effective_shear_modulus == 2, "moduli");
    CHECK(close_to(p.height_std, 10, 1e-15) && close_to(p.summit_radius, 25000, 1e-15), "sigma, R");
    CHECK(close_to(p.work_of_adhesion, 0.0075, 1e-15) && p.adhesion_range == 2, "w, h");
    CHECK(p.burgers_vector == 1 && p.asperity_count == 1, "b, N");
    CHECK(p.tangential_modulus == 0, "G^ is the default again");
    p.tangential_modulus = expected.tangential_modulus;
    CHECK(memcmp(&p.height_distribution, &expected.height_distribution,
                 sizeof p - offsetof(asperity_params, height_distribution)) == 0, "the rest changed");

    p = expected;
    CHECK(asperity_params_set_materials(&p, 200e9, 0.3, 70e9, 0.34) == ASPERITY_OK, "%s", last_message());
    CHECK(close_to(p.composite_modulus, 1 / ((1 - 0.09) / 200e9 + (1 - 0.1156) / 70e9), 1e-14), "E*");
    {
        const double g1 = 200e9 / 2.6, g2 = 70e9 / 2.68;
        CHECK(close_to(p.effective_shear_modulus, 2 * g1 * g2 / (g1 + g2), 1e-14), "G*");
        CHECK(close_to(p.tangential_modulus, 1 / ((2 - 0.3) / g1 + (2 - 0.34) / g2), 1e-14), "G^");
    }
    expected.composite_modulus = p.composite_modulus;
    expected.effective_shear_modulus = p.effective_shear_modulus;
    expected.tangential_modulus = p.tangential_modulus;
    CHECK(SAME(p, expected), "set_materials changed another field");
    CHECK(asperity_params_set_materials(&p, 200e9, 0.3, INFINITY, 0.3) == ASPERITY_OK, "%s", last_message());
    CHECK(close_to(p.composite_modulus, 200e9 / 0.91, 1e-14), "E* against a rigid body");
    CHECK(close_to(p.effective_shear_modulus, 2 * 200e9 / 2.6, 1e-14), "G* against a rigid body is 2 G");

    /* Asperities by their dimensions, with L = (m0/(2 m2))^(1/2); m4 changes the radius alone, by the power -0.043. */
    expected = p;
    CHECK(asperity_params_set_spectral_moments(&p, 3, 0.5, 0.7, 11) == ASPERITY_OK, "%s", last_message());
    CHECK(close_to(p.height_std, sqrt(3), 0.2) && close_to(p.summit_mean_height, 2.3, 0.2), "heights");
    CHECK(p.radius_amplitude < -0.3 && p.radius_amplitude > -0.9 && p.radius_rate > 0.3, "higher asperities are sharper");
    CHECK(p.asperity_count > 0.01 * 11 / 3 && p.asperity_count < 0.05 * 11 / 3, "N = %.9g", p.asperity_count);
    CHECK(p.nominal_area == 11 && p.rms_slope == 1 && p.bandwidth == 0, "what warnings judge");
#define SUMMITS(F)                                                                                                     \
    F(height_std) F(summit_radius) F(asperity_count) F(nominal_area) F(bandwidth) F(radius_amplitude) F(radius_rate)   \
    F(summit_mean_height) F(rms_slope)
#define TAKE(field) expected.field = p.field;
    SUMMITS(TAKE)
    CHECK(SAME(p, expected), "set_spectral_moments changed another field");
    CHECK(asperity_params_set_spectral_moments(&p, 3, 0.5, 0, 11) == ASPERITY_OK, "%s", last_message());
    CHECK(close_to(p.summit_radius, expected.summit_radius, 0.05) && p.summit_radius != expected.summit_radius, "R without m4");
    expected.summit_radius = p.summit_radius;
    CHECK(SAME(p, expected), "m4 changed more than the radius");

    CHECK(asperity_params_set_mccool_summits(&p, 3, 0.5, 0.7, 11) == ASPERITY_OK, "%s", last_message());
    CHECK(close_to(p.height_std * p.height_std, 3 - 0.8968 * 0.25 / 0.7, 1e-4), "sigma = %g", p.height_std);
    CHECK(close_to(p.summit_radius, 0.375 * sqrt(3.14159265358979324 / 0.7), 1e-14), "R = %.9g", p.summit_radius);
    CHECK(close_to(p.asperity_count, 0.7 * 11 / (3 * sqrt(3) * 3.14159265358979324), 1e-14), "N = %.9g", p.asperity_count);
    CHECK(close_to(p.bandwidth, 3 * 0.7 / 0.25, 1e-14), "bandwidth = %.9g", p.bandwidth);
    CHECK(close_to(p.summit_mean_height, 4 * sqrt(3 / (3.14159265358979324 * p.bandwidth)), 1e-14), "mean height");
    CHECK(p.nominal_area == 11 && p.rms_slope == 1 && p.radius_amplitude == 0, "the rest");
    SUMMITS(TAKE)
    CHECK(SAME(p, expected), "set_mccool_summits changed another field");

    expected = p;
    CHECK(asperity_params_set_skew(&p, 0) == ASPERITY_OK, "%s", last_message());
    CHECK(p.height_distribution == ASPERITY_HEIGHTS_WEIBULL, "heights");
    CHECK(fabs(p.weibull_shape - 3.602) < 6e-4, "omega = %g without skew", p.weibull_shape);
    expected.height_distribution = p.height_distribution;
    expected.weibull_shape = p.weibull_shape;
    expected.skew = 0;
    expected.kurtosis = 3;
    CHECK(SAME(p, expected), "set_skew changed another field");

    expected = p;
    CHECK(p.work_of_adhesion > 0 && asperity_params_set_elastic_plastic(&p, 7.5e9) == ASPERITY_OK, "%s", last_message());
    expected.contact_law = ASPERITY_CONTACT_ELASTIC_PLASTIC;
    expected.hardness = 7.5e9;
    expected.work_of_adhesion = 0;
    CHECK(SAME(p, expected), "set_elastic_plastic sets other fields");
}

static void failing_setters_touch_nothing(void)
{
    const asperity_params before = surface(8);
    asperity_params p = before;
#define FAILS(call, status, text)                                                                                      \
    CHECK((call) == (status), "another status than " #status ": %s", last_message());                                  \
    CHECK(says(text), "'%s' does not say '%s'", last_message(), text);                                                 \
    CHECK(SAME(p, before), "the parameters changed")
    FAILS(asperity_params_set_dimensionless(&p, -1, 1000, 0.001, 1, 0.3), ASPERITY_INVALID_PARAMETER, "alpha = -1: ");
    FAILS(asperity_params_set_dimensionless(&p, 0.01, 0, 0.001, 1, 0.3), ASPERITY_INVALID_PARAMETER, "beta = 0: ");
    FAILS(asperity_params_set_dimensionless(&p, 0.01, 1000, -2, 1, 0.3), ASPERITY_INVALID_PARAMETER, "gamma = -2: ");
    FAILS(asperity_params_set_dimensionless(&p, 0.01, 1000, 0.001, NAN, 0.3), ASPERITY_INVALID_PARAMETER, "= NaN: ");
    FAILS(asperity_params_set_dimensionless(&p, 0.01, 1000, 0.001, 1, 0.6), ASPERITY_INVALID_PARAMETER, " = 0.6: ");
    FAILS(asperity_params_set_materials(&p, 0, 0.3, 1, 0.3), ASPERITY_INVALID_PARAMETER, "E1 = 0: ");
    FAILS(asperity_params_set_materials(&p, 1, 0.3, 1, -1), ASPERITY_INVALID_PARAMETER, "nu2 = -1: ");
    FAILS(asperity_params_set_materials(&p, INFINITY, 0.3, INFINITY, 0.3), ASPERITY_INVALID_PARAMETER, "E2 = inf: ");
    FAILS(asperity_params_set_spectral_moments(&p, 1, 1, 1.49, 1), ASPERITY_INVALID_PARAMETER,
          "bandwidth m0 m4/m2^2 = 1.49: must be at least 1.5");
    FAILS(asperity_params_set_spectral_moments(&p, 0, 1, 2, 1), ASPERITY_INVALID_PARAMETER, "m0 = 0: ");
    FAILS(asperity_params_set_spectral_moments(&p, 1, -1, 2, 1), ASPERITY_INVALID_PARAMETER, "m2 = -1: ");
    FAILS(asperity_params_set_spectral_moments(&p, 1, 1, NAN, 1), ASPERITY_INVALID_PARAMETER, "m4 = NaN: ");
    FAILS(asperity_params_set_mccool_summits(&p, 1, 1, 0, 1), ASPERITY_INVALID_PARAMETER, "m4 = 0: ");
    FAILS(asperity_params_set_spectral_moments(&p, 1, 1, -0.5, 1), ASPERITY_INVALID_PARAMETER, "m4 = -0.5: must be finite and >= 0");
    FAILS(asperity_params_set_spectral_moments(&p, 1, 1, 2, INFINITY), ASPERITY_INVALID_PARAMETER, "nominal_area = inf: ");
    FAILS(asperity_params_set_spectral_moments(&p, 1, 1e-41, 2, 1), ASPERITY_OUT_OF_RANGE, "m2 = 1e-41: ");
    FAILS(asperity_params_set_mccool_summits(&p, 1, 1, 1.49, 1), ASPERITY_INVALID_PARAMETER,
          "bandwidth m0 m4/m2^2 = 1.49: must be at least 1.5");
    FAILS(asperity_params_set_skew(&p, -1.2), ASPERITY_INVALID_PARAMETER, "skew = -1.2: ");
    FAILS(asperity_params_set_skew(&p, NAN), ASPERITY_INVALID_PARAMETER, "skew = NaN: ");
    FAILS(asperity_params_set_skew(&p, 1e6), ASPERITY_OUT_OF_RANGE, "skew = ");
    FAILS(asperity_params_set_elastic_plastic(&p, 0), ASPERITY_INVALID_PARAMETER, "hardness = 0: ");
    FAILS(asperity_params_set_elastic_plastic(&p, NAN), ASPERITY_INVALID_PARAMETER, "hardness = NaN: ");
#undef FAILS
    CHECK(asperity_params_set_elastic_plastic(NULL, 1) == ASPERITY_NULL_POINTER && says("params is NULL"), "'%s'", last_message());
}

/* ---- Parameters by name ---- */

static double value_of(const asperity_params *p, const char *name)
{
    double value = -99;
    CHECK(asperity_params_get_value(p, name, &value) == ASPERITY_OK, "%s: %s", name, last_message());
    return value;
}

enum { NAMES_OF_FIELDS = 30 };

static void names_are_those_of_the_fields(void)
{
    asperity_params p = surface(8);
    size_t count = 0;

    while (asperity_params_name(count) != NULL)
        count++;
    CHECK(count == NAMES_OF_FIELDS, "%d names", (int)count);
    CHECK(asperity_params_name(count + 1) == NULL && asperity_params_name(SIZE_MAX) == NULL, "names after the last");
    for (size_t i = 0; i < count; i++)
        for (size_t k = 0; k < i; k++)
            CHECK(strcmp(asperity_params_name(i), asperity_params_name(k)) != 0, "%s twice", asperity_params_name(i));
#define NAMES(field, value)                                                                                            \
    CHECK(value_of(&p, #field) == p.field, #field);                                                                    \
    CHECK(asperity_params_set_value(&p, #field, value) == ASPERITY_OK && p.field == value, #field ": %s", last_message())
    NAMES(composite_modulus, 2);
    NAMES(effective_shear_modulus, 2);
    NAMES(work_of_adhesion, 2);
    NAMES(adhesion_range, 2);
    NAMES(burgers_vector, 2);
    NAMES(height_std, 2);
    NAMES(summit_radius, 2);
    NAMES(asperity_count, 2);
    NAMES(attraction, 0);
    NAMES(radius_amplitude, 2);
    NAMES(radius_rate, 2);
    NAMES(slip_radius_1, 2);
    NAMES(slip_stress_1, 2);
    NAMES(slip_radius_2, 2);
    NAMES(slip_stress_2, 2);
    NAMES(max_friction_coefficient, 2);
    NAMES(hardness, 2);
    NAMES(tangential_modulus, 2);
    NAMES(nominal_area, 2);
    NAMES(pressure_coefficient, 2);
    NAMES(bandwidth, 2);
    NAMES(calibration_error, 2);
    NAMES(summit_mean_height, 2);
    NAMES(rms_slope, 2);
    NAMES(contact_law, 1);
    NAMES(slip_onset, 1);
    NAMES(weibull_shape, 2);
    NAMES(height_distribution, 2);
    NAMES(kurtosis, 2);
    NAMES(skew, 2);
#undef NAMES
    CHECK(asperity_params_set_value(&p, "attraction", 2) == ASPERITY_INVALID_PARAMETER && p.attraction == 0
              && says("attraction = 2: must be a whole number"), "%s", last_message());
}

/* Whatever heights the other surface has, and whatever heights this one had. */
static void setting_all_names_in_their_order_copies_a_surface(void)
{
    for (int from = 0; from < SURFACES; from++) {
        for (int to = 0; to < SURFACES; to++) {
            const asperity_params source = surface(from);
            asperity_params one_by_one = surface(to), at_once = one_by_one;
            const char *names[NAMES_OF_FIELDS];
            double values[NAMES_OF_FIELDS];
            for (int i = 0; i < NAMES_OF_FIELDS; i++) {
                const int at = NAMES_OF_FIELDS - 1 - i;
                names[at] = asperity_params_name((size_t)i);
                values[at] = value_of(&source, names[at]);
                CHECK(asperity_params_set_value(&one_by_one, names[at], values[at]) == ASPERITY_OK, "%s", last_message());
            }
            CHECK(asperity_params_set_values(&at_once, NAMES_OF_FIELDS, names, values) == ASPERITY_OK, "%s", last_message());
            CHECK(SAME(one_by_one, source) && SAME(at_once, source), "%d is not copied to %d", from, to);
        }
    }
}

static void names_that_go_together_are_as_the_setters(void)
{
    const char *names[] = { "nu2", "E1", "m4", "m0", "m2", "nominal_area", "nu1", "E2", "hardness" };
    const double values[] = { 0.34, 200e9, 0.7, 3, 0.5, 11, 0.3, 70e9, 7e9 };
    asperity_params p = surface(0), expected = p;

    CHECK(asperity_params_set_materials(&expected, 200e9, 0.3, 70e9, 0.34) == ASPERITY_OK, "%s", last_message());
    CHECK(asperity_params_set_spectral_moments(&expected, 3, 0.5, 0.7, 11) == ASPERITY_OK, "%s", last_message());
    expected.hardness = 7e9;
    CHECK(asperity_params_set_values(&p, 9, names, values) == ASPERITY_OK, "%s", last_message());
    CHECK(SAME(p, expected), "another surface than the setters make");
    CHECK(asperity_params_set_values(&p, 3, names + 2, values + 2) == ASPERITY_OK, "the area is known: %s",
          last_message());
    CHECK(asperity_params_set_values(&p, 0, NULL, NULL) == ASPERITY_OK && SAME(p, expected), "no names, yet a change");
}

/* Ra stands for m0, pi/2 Ra^2 of Gaussian heights. */
static void a_mean_roughness_stands_for_the_variance(void)
{
    const double pi = 3.14159265358979323846;
    const char *names[] = { "Ra", "m2", "m4", "m0" };
    const double values[] = { 2, 0.5, 0.7, 3 };
    asperity_params p = surface(0), expected = p;

    CHECK(asperity_params_set_spectral_moments(&expected, pi / 2 * 4, 0.5, 0.7, 11) == ASPERITY_OK, "%s", last_message());
    p.nominal_area = 11;
    CHECK(asperity_params_set_values(&p, 3, names, values) == ASPERITY_OK, "%s", last_message());
    CHECK(SAME(p, expected), "another surface than m0 makes");
    CHECK(asperity_params_set_values(&p, 4, names, values) == ASPERITY_INVALID_PARAMETER && says("Ra: must not be given"),
          "%s", last_message());
    CHECK(asperity_params_set_value(&p, "Ra", -1) == ASPERITY_INVALID_PARAMETER && says("Ra = -1: must be"), "%s",
          last_message());
    CHECK(asperity_params_set_value(&p, "Ra", 1) == ASPERITY_INVALID_PARAMETER && says("m2: must be given too"), "%s",
          last_message());
}

static double force_at(const asperity_params *params, double load)
{
    asperity_model *model = NULL;
    asperity_state state = { .struct_size = sizeof state };
    CHECK(asperity_create(params, &model) == ASPERITY_OK, "%s", last_message());
    CHECK(asperity_state_at_load(model, load, &state) == ASPERITY_OK, "%s", last_message());
    asperity_free(model);
    return state.friction_force;
}

/* One measured point, by the calls and by name, on every kind of surface. It is remembered, also by a model. */
static void a_calibrated_surface_meets_the_measured_point(void)
{
    const char *by_coefficient[] = { "calibration_friction_coefficient", "calibration_load" };
    const char *by_force[] = { "calibration_friction_force", "calibration_load" };
    const double load = 5, coefficient = 0.4, force = coefficient * load, coefficients[] = { coefficient, load },
                 forces[] = { force, load };

    for (int which = 0; which < SURFACES; which++) {
        const asperity_params before = surface(which);
        asperity_params p = before, named = before, forced = before, forced_by_name = before, kept = { .struct_size = sizeof kept };
        asperity_model *model;
        const asperity_status status = asperity_params_calibrate(&p, load, coefficient);
        CHECK(asperity_params_calibrate_force(&forced, load, force) == status, "%s", last_message());
        CHECK(asperity_params_set_values(&named, 2, by_coefficient, coefficients) == status, "%s", last_message());
        CHECK(asperity_params_set_values(&forced_by_name, 2, by_force, forces) == status, "%s", last_message());
        CHECK(SAME(named, p) && SAME(forced, p) && SAME(forced_by_name, p), "surface %d: another strength by name", which);
        if (status != ASPERITY_OK) {
            CHECK(SAME(p, before), "surface %d: changed in spite of the error", which);
            CHECK(says("friction_force = 2 at load = 5: must be"), "surface %d: %s", which, last_message());
            continue;
        }
        CHECK(fabs(force_at(&p, load) / force - 1) < 1e-12, "surface %d: %.17g", which, force_at(&p, load));
        CHECK(p.calibration_load == load && p.calibration_friction_force == force && p.calibration_error == 0.05,
              "surface %d: %g, %g, %g", which, p.calibration_load, p.calibration_friction_force, p.calibration_error);
        p.calibration_error = 0.1;
        model = model_of(p);
        CHECK(asperity_get_params(model, &kept) == ASPERITY_OK && SAME(kept, p), "surface %d: not remembered", which);
        CHECK(close_to(asperity_friction_at_load(model, load), coefficient, 1e-9), "surface %d: mu", which);
        CHECK((state_at(model, load).warnings & ASPERITY_WARNING_UNCALIBRATED) == 0, "surface %d: a warning", which);
        asperity_free(model);
    }
}

/* Ground steel, in SI units. */
static void a_coefficient_measured_at_20_newtons_is_that_of_the_model(void)
{
    asperity_params p;
    asperity_model *model;

    asperity_params_init(&p, sizeof p);
    CHECK(asperity_params_set_pair(&p, "steel/steel") == ASPERITY_OK, "%s", last_message());
    CHECK(asperity_params_set_elastic_plastic(&p, p.hardness) == ASPERITY_OK, "%s", last_message());
    p.height_std = 0.4e-6;
    p.summit_radius = 20e-6;
    p.nominal_area = 1e-4;
    p.asperity_count = 5e9 * p.nominal_area;
    CHECK(asperity_params_calibrate(&p, 20.0, 0.16) == ASPERITY_OK, "%s", last_message());
    model = model_of(p);
    CHECK(close_to(asperity_friction_at_load(model, 20.0), 0.16, 1e-9), "mu %.12g", asperity_friction_at_load(model, 20.0));
    asperity_free(model);
}

static void the_measured_point_is_read_by_name(void)
{
    asperity_params p = surface(0);

    CHECK(value_of(&p, "calibration_load") == 0 && value_of(&p, "calibration_friction_force") == 0, "a point of nobody's");
    CHECK(isnan(value_of(&p, "calibration_friction_coefficient")), "a coefficient of nobody's");
    CHECK(asperity_params_calibrate(&p, 50, 0.5) == ASPERITY_OK, "%s", last_message());
    CHECK(value_of(&p, "calibration_load") == 50 && value_of(&p, "calibration_friction_force") == 25 &&
          value_of(&p, "calibration_friction_coefficient") == 0.5, "another point");
}

static void adhering_surfaces_are_calibrated_where_no_load_presses(void)
{
    const double loads[] = { 0, 0.5 };
    const asperity_params before = surface(2);
    asperity_model *model = model_of(before);
    const double pull_off = summary_of(model).pull_off_load;

    for (int i = 0; i < 2; i++) {
        const double load = loads[i] * pull_off, force = 0.7 * asperity_friction_force_at_load(model, load);
        asperity_params p = before;
        CHECK(asperity_params_calibrate(&p, load, 0.5) == ASPERITY_INVALID_PARAMETER && SAME(p, before) &&
              says("must be > 0; at zero load, or where the load pulls, calibrate with the friction force"), "%s", last_message());
        CHECK(asperity_params_calibrate_force(&p, load, force) == ASPERITY_OK, "%s", last_message());
        CHECK(fabs(force_at(&p, load) / force - 1) < 1e-12 && p.calibration_load == load, "at %g", load);
    }
    asperity_free(model);
}

/* Slip radii say nothing of the strength; one tip has one as well as many. */
static void a_strength_of_nobodys_is_warned_of(void)
{
    asperity_params p = surface(0);
    asperity_model *model = model_of(p);

#define UNCALIBRATED (state_at(model, 10).warnings & ASPERITY_WARNING_UNCALIBRATED)
    CHECK(p.asperity_count == 1 && UNCALIBRATED, "one tip");
    p.slip_radius_1 = 20;
    p.slip_radius_2 = 1e5;
    CHECK(asperity_set_params(model, &p) == ASPERITY_OK && UNCALIBRATED, "other slip radii: %s", last_message());
    p.pressure_coefficient = 0.1;
    CHECK(asperity_set_params(model, &p) == ASPERITY_OK && !UNCALIBRATED, "a pressure coefficient: %s", last_message());
    p.pressure_coefficient = 0;
    p.slip_stress_1 = 0.02;
    CHECK(asperity_set_params(model, &p) == ASPERITY_OK && !UNCALIBRATED, "a slip stress: %s", last_message());
    p = surface(0);
    CHECK(asperity_params_calibrate_force(&p, 10, force_at(&p, 10)) == ASPERITY_OK, "%s", last_message());
    CHECK(asperity_set_params(model, &p) == ASPERITY_OK && !UNCALIBRATED, "measured to be the default");
#undef UNCALIBRATED
    asperity_free(model);
}

static void a_point_that_no_strength_gives_is_refused(void)
{
    const asperity_params before = surface(0);
    asperity_params p = before;
    asperity_model *model = NULL;
    const char *alone[] = { "calibration_load", "calibration_friction_force", "calibration_friction_coefficient" };
    const double values[] = { 5, 2, 0.4 };

#define FAILS(call, status, text)                                                                                      \
    CHECK((call) == (status), "another status than " #status ": %s", last_message());                                  \
    CHECK(says(text), "'%s' does not say '%s'", last_message(), text);                                                 \
    CHECK(SAME(p, before), "the parameters changed")
    FAILS(asperity_params_calibrate(&p, 5, -1), ASPERITY_INVALID_PARAMETER, "calibration_friction_coefficient = -1: must be > 0");
    FAILS(asperity_params_calibrate(&p, 5, NAN), ASPERITY_INVALID_PARAMETER, "calibration_friction_coefficient = NaN: ");
    FAILS(asperity_params_calibrate(&p, 5, 20.1), ASPERITY_INVALID_PARAMETER,
          "calibration_friction_coefficient = 20.1: must be > 0 and at most 20; is it a force?");
    FAILS(asperity_params_calibrate(&p, NAN, 1), ASPERITY_INVALID_LOAD, "load = NaN");
    FAILS(asperity_params_calibrate_force(&p, 5, -1), ASPERITY_INVALID_PARAMETER, "must be finite and above 0");
    FAILS(asperity_params_calibrate_force(&p, 5, NAN), ASPERITY_INVALID_PARAMETER, "friction_force = NaN at load = 5");
    FAILS(asperity_params_calibrate_force(&p, 5, 1e30), ASPERITY_INVALID_PARAMETER, "must be at most ");
    FAILS(asperity_params_calibrate_force(&p, NAN, 1), ASPERITY_INVALID_LOAD, "load = NaN");
    FAILS(asperity_params_calibrate_force(&p, -1e9, 1), ASPERITY_SEPARATED, "load = -1000000000");
    FAILS(asperity_params_set_values(&p, 1, alone, values), ASPERITY_INVALID_PARAMETER, "must be given together with");
    FAILS(asperity_params_set_values(&p, 3, alone, values), ASPERITY_INVALID_PARAMETER, "with one of the two alone");
    FAILS(asperity_params_set_value(&p, "calibration_friction_force", 1), ASPERITY_INVALID_PARAMETER, "calibration_load: ");
#undef FAILS
    CHECK(asperity_params_calibrate(NULL, 1, 1) == ASPERITY_NULL_POINTER, "a status for NULL");
    CHECK(asperity_params_calibrate_force(NULL, 1, 1) == ASPERITY_NULL_POINTER, "a status for NULL");
    p.calibration_error = 5;
    CHECK(asperity_create(&p, &model) == ASPERITY_OUT_OF_RANGE && says("calibration_error = 5: must be at most 1") &&
          says("is it in per cent?"), "%s", last_message());
}

static void refuses_shape(asperity_params p, const char *says)
{
    asperity_model *model = NULL;

    CHECK(asperity_create(&p, &model) == ASPERITY_INVALID_PARAMETER && strstr(last_message(), says), "%s", last_message());
}

static void names_of_heights_choose_them(void)
{
    const char *gaussian[] = { "height_distribution", "skew" };
    const double skewed[] = { ASPERITY_HEIGHTS_GAUSSIAN, -1 };
    const char *both[] = { "skew", "kurtosis" }, *all[] = { "height_distribution", "weibull_shape", "kurtosis" };
    const double two[] = { -2, 12 }, three[] = { ASPERITY_HEIGHTS_GAUSSIAN, 2, 5 };
    asperity_params p = surface(0), expected = p;

    CHECK(asperity_params_set_skew(&expected, -0.5) == ASPERITY_OK, "%s", last_message());
    CHECK(asperity_params_set_value(&p, "skew", -0.5) == ASPERITY_OK && SAME(p, expected), "skew is not set_skew");
    CHECK(asperity_params_set_values(&p, 2, both, two) == ASPERITY_OK, "%s", last_message());
    CHECK(p.height_distribution == ASPERITY_HEIGHTS_JOHNSON && p.skew == -2 && p.kurtosis == 12, "Johnson's heights");
    CHECK(asperity_params_set_value(&p, "skew", 1) == ASPERITY_OK && p.skew == 1, "the skew of Johnson's heights");
    CHECK(p.height_distribution == ASPERITY_HEIGHTS_JOHNSON, "Johnson's heights are lost");
    CHECK(asperity_params_set_value(&p, "weibull_shape", 3) == ASPERITY_OK && p.weibull_shape == 3, "Weibull's shape");
    CHECK(p.height_distribution == ASPERITY_HEIGHTS_WEIBULL && p.skew == 0 && p.kurtosis == 3, "Weibull's heights");
    CHECK(asperity_params_set_values(&p, 3, all, three) == ASPERITY_OK, "%s", last_message());
    CHECK(p.height_distribution == ASPERITY_HEIGHTS_GAUSSIAN && p.weibull_shape == 2 && p.kurtosis == 5, "last word");
    refuses_shape(p, "kurtosis = 5: must be 3 unless heights are Johnson's");
    p.kurtosis = 3;
    CHECK(asperity_params_set_value(&p, "skew", -1) == ASPERITY_OK, "%s", last_message());
    asperity_free(model_of(p));
    p.skew = -1;
    refuses_shape(p, "skew = -1: must be 0 unless heights are Johnson's");
    p = surface(0);
    CHECK(asperity_params_set_values(&p, 2, gaussian, skewed) == ASPERITY_OK, "%s", last_message());
    refuses_shape(p, "choose those, or the weibull_shape of this skew");
}

static void names_are_refused_with_the_nearest_and_nothing_changes(void)
{
    const asperity_params before = surface(8);
    asperity_params p = before;
    char endless[64], longest[80];
    const char *names[] = { "hardness", "E1", "nu1", "nu2" }, *missing[] = { "hardness", NULL };
    const double values[] = { 1, 2e11, 0.3, 0.3 };
    double value = 5;

    memset(endless, 'x', sizeof endless);
    memset(longest, 'x', sizeof longest);
    longest[sizeof longest - 1] = '\0';
#define FAILS(call, status, text)                                                                                      \
    CHECK((call) == (status), "another status than " #status ": %s", last_message());                                  \
    CHECK(says(text), "'%s' does not say '%s'", last_message(), text);                                                 \
    CHECK(SAME(p, before), "the parameters changed")
    FAILS(asperity_params_set_value(&p, "sumit_radius", 1), ASPERITY_INVALID_PARAMETER,
          "sumit_radius: no parameter has this name; the nearest is summit_radius");
    FAILS(asperity_params_set_value(&p, "e1", 1), ASPERITY_INVALID_PARAMETER, "the nearest is E1");
    FAILS(asperity_params_set_value(&p, "Height_Std", 1), ASPERITY_INVALID_PARAMETER, "the nearest is height_std");
    FAILS(asperity_params_set_value(&p, "struct_size", 1), ASPERITY_INVALID_PARAMETER, "no parameter has this name");
    FAILS(asperity_params_set_value(&p, "", 1), ASPERITY_INVALID_PARAMETER, ": no parameter has this name");
    FAILS(asperity_params_set_value(&p, "a\n\xff", 1), ASPERITY_INVALID_PARAMETER, "a\\n\\xff: no parameter");
    FAILS(asperity_params_set_value(&p, endless, 1), ASPERITY_INVALID_PARAMETER, "xxx: no parameter has this name");
    FAILS(asperity_params_set_value(&p, longest, 1), ASPERITY_INVALID_PARAMETER, "xxx: no parameter has this name");
    FAILS(asperity_params_set_value(&p, "E1", 2e11), ASPERITY_INVALID_PARAMETER, "nu1: must be given too: E1, nu1, E2");
    FAILS(asperity_params_set_values(&p, 4, names, values), ASPERITY_INVALID_PARAMETER, "E2: must be given too");
    FAILS(asperity_params_set_value(&p, "m2", 2), ASPERITY_INVALID_PARAMETER, "m0: must be given too");
    FAILS(asperity_params_set_value(&p, "attraction", 0.5), ASPERITY_INVALID_PARAMETER, "attraction = 0.5: must be a whole");
    FAILS(asperity_params_set_value(&p, "contact_law", NAN), ASPERITY_INVALID_PARAMETER, "contact_law = NaN: ");
    FAILS(asperity_params_set_value(&p, "contact_law", 1e300), ASPERITY_INVALID_PARAMETER, "contact_law = 1e300: ");
    FAILS(asperity_params_set_values(&p, 2, missing, values), ASPERITY_NULL_POINTER, "name is NULL");
    FAILS(asperity_params_set_values(&p, 1, NULL, values), ASPERITY_NULL_POINTER, "names is NULL");
    FAILS(asperity_params_set_values(&p, 1, names, NULL), ASPERITY_NULL_POINTER, "values is NULL");
    FAILS(asperity_params_get_value(&p, "hardnes", &value), ASPERITY_INVALID_PARAMETER, "the nearest is hardness");
    FAILS(asperity_params_get_value(&p, "E1", &value), ASPERITY_INVALID_PARAMETER, "E1: is not kept");
    FAILS(asperity_params_get_value(&p, "skew", NULL), ASPERITY_NULL_POINTER, "value is NULL");
    CHECK(value == 5, "a value in spite of the error");
#undef FAILS
    CHECK(asperity_params_set_value(&p, "height_std", NAN) == ASPERITY_OK && isnan(p.height_std), "%s", last_message());
}

/* ---- Materials ---- */

static void materials_are_found_by_their_names(void)
{
    asperity_material_data steel = { .struct_size = sizeof steel }, other = { .struct_size = sizeof other };
    asperity_material_data untouched = other;
    size_t count = 0;

    CHECK(asperity_material("steel", &steel) == ASPERITY_OK, "%s", last_message());
    CHECK(steel.young == 205e9 && steel.poisson == 0.3 && steel.hardness == 7.5e9 && steel.burgers_vector == 0.248e-9,
          "steel is %g %g %g %g", steel.young, steel.poisson, steel.hardness, steel.burgers_vector);
    CHECK(steel.young_low == 190e9 && steel.young_high == 210e9 && steel.hardness_low == 2e9 && steel.hardness_high == 9e9,
          "its ranges");
    CHECK(strcmp(steel.name, "steel") == 0 && strstr(steel.reference, "AISI 52100") != NULL, "%s", steel.reference);
    for (; asperity_material_name(count) != NULL; count++) {
        CHECK(asperity_material(asperity_material_name(count), &other) == ASPERITY_OK, "%s", last_message());
        CHECK(strcmp(other.name, asperity_material_name(count)) == 0 && other.young > 0 && strlen(other.reference) > 20,
              "%s", other.name);
    }
    CHECK(count == 30 && asperity_material_name(SIZE_MAX) == NULL, "%d materials", (int)count);

    other = untouched;
    CHECK(asperity_material("Stel", &other) == ASPERITY_INVALID_PARAMETER &&
          says("Stel: no material has this name; the nearest is steel"), "%s", last_message());
    CHECK(asperity_material("rubber", &other) == ASPERITY_INVALID_PARAMETER &&
          says("rubber: no material has this name; rubber is viscoelastic"), "%s", last_message());
    CHECK(asperity_material("steel/steel", &other) == ASPERITY_INVALID_PARAMETER, "a pair is no material");
    CHECK(asperity_material(NULL, &other) == ASPERITY_NULL_POINTER && says("name is NULL"), "%s", last_message());
    CHECK(asperity_material("steel", NULL) == ASPERITY_NULL_POINTER && says("material is NULL"), "%s", last_message());
    other.struct_size = 0;
    CHECK(asperity_material("steel", &other) == ASPERITY_INVALID_PARAMETER && says("struct_size = 0"), "%s", last_message());
    other.struct_size = 16;
    CHECK(asperity_material("steel", &other) == ASPERITY_OK && other.young == 205e9 && other.poisson == untouched.poisson,
          "written further than struct_size");
}

static void pairs_are_found_in_either_order(void)
{
    asperity_pair_data one = { .struct_size = sizeof one }, other = { .struct_size = sizeof other };
    size_t count = 0;

    CHECK(asperity_pair("mica/Au", &one) == ASPERITY_OK, "%s", last_message());
    CHECK(asperity_pair("Au/mica", &other) == ASPERITY_OK && SAME(one, other), "%s", last_message());
    CHECK(one.work_of_adhesion == 0.172 && one.work_of_adhesion_low == 0.02 && one.work_of_adhesion_high == 0.18 &&
          one.hamaker == 17.6e-20 && one.slip_stress_1 == 0.0108 && strcmp(one.name, "mica/Au") == 0, "mica/Au");
    for (; asperity_pair_name(count) != NULL; count++)
        CHECK(asperity_pair(asperity_pair_name(count), &other) == ASPERITY_OK && other.work_of_adhesion > 0, "%s",
              last_message());
    CHECK(count == 26 && asperity_pair_name(SIZE_MAX) == NULL, "%d pairs", (int)count);
    CHECK(asperity_pair("stel/steel", &other) == ASPERITY_INVALID_PARAMETER &&
          says("stel/steel: no pair has this name; the nearest is steel/steel"), "%s", last_message());
    CHECK(asperity_pair("Au/mika", &other) == ASPERITY_INVALID_PARAMETER &&
          says("Au/mika: no pair has this name; the nearest is Au/mica"), "%s", last_message());
    CHECK(asperity_pair("Steel", &other) == ASPERITY_INVALID_PARAMETER &&
          says("Steel: no pair has this name; the nearest is steel/steel"), "%s", last_message());
    CHECK(asperity_pair("WC/SiC", &other) == ASPERITY_INVALID_PARAMETER &&
          says("work_of_adhesion: none is known for WC/SiC: give that of your surfaces, 0 for none"), "%s", last_message());
    CHECK(asperity_pair(NULL, &other) == ASPERITY_NULL_POINTER && says("name is NULL"), "%s", last_message());
    CHECK(asperity_pair("Si/Si", NULL) == ASPERITY_NULL_POINTER && says("pair is NULL"), "%s", last_message());
}

/* All but the roughness, which stays as it was; what is not known is left to set. */
static void a_pair_sets_what_it_tells_and_nothing_else(void)
{
    asperity_params p = surface(8), expected = p, refused, part;
    asperity_model *model = NULL;

    CHECK(asperity_params_set_materials(&expected, 54e9, 0.1, 78e9, 0.44) == ASPERITY_OK, "%s", last_message());
    expected.work_of_adhesion = 0.172;
    expected.adhesion_range = expected.burgers_vector = 0.52e-9;
    expected.hardness = 0;
    expected.slip_stress_1 = 0.0108;
    CHECK(asperity_params_set_pair(&p, "mica/Au") == ASPERITY_OK && SAME(p, expected), "%s", last_message());
    expected = p;
    CHECK(asperity_params_set_materials(&expected, 205e9, 0.3, 416e9, 0.231) == ASPERITY_OK, "%s", last_message());
    expected.work_of_adhesion = 0.085;
    expected.adhesion_range = expected.burgers_vector = 0.476e-9;
    expected.hardness = 7.5e9;
    CHECK(asperity_params_set_pair(&p, "Al2O3/steel") == ASPERITY_OK && SAME(p, expected), "%s", last_message());
    part = p;
    CHECK(asperity_params_set_pair(&part, "PDMS/PDMS") == ASPERITY_OK && part.work_of_adhesion == 0.045 &&
          isnan(part.adhesion_range) && isnan(part.burgers_vector), "%s", last_message());
    CHECK(asperity_create(&part, &model) == ASPERITY_INVALID_PARAMETER && says("adhesion_range: must be set"), "%s", last_message());
    CHECK(asperity_params_set_pair(&part, "WC/SiC") == ASPERITY_OK && isnan(part.work_of_adhesion) &&
          part.burgers_vector == 0.308e-9 && part.adhesion_range == part.burgers_vector, "%s", last_message());
    CHECK(asperity_create(&part, &model) == ASPERITY_INVALID_PARAMETER && says("work_of_adhesion: must be set"), "%s", last_message());
    refused = p;
    CHECK(asperity_params_set_pair(&refused, "Si/Auu") == ASPERITY_INVALID_PARAMETER && SAME(refused, p) &&
          says("Si/Auu: no pair has this name; the nearest is Si/Au"), "%s", last_message());
    CHECK(asperity_params_set_pair(NULL, "Si/Si") == ASPERITY_NULL_POINTER && says("params is NULL"), "%s", last_message());
    CHECK(asperity_params_set_pair(&p, NULL) == ASPERITY_NULL_POINTER && says("name is NULL"), "%s", last_message());
}

/* ---- Interfaces ---- */

static void interfaces_are_found_by_their_names(void)
{
    asperity_interface_data film = { .struct_size = sizeof film }, other = { .struct_size = sizeof other };
    asperity_interface_data untouched = other;
    size_t count = 0;

    CHECK(asperity_interface("KCl film on iron in vacuum", &film) == ASPERITY_OK, "%s", last_message());
    CHECK(film.shear_strength == 65e6 && film.pressure_coefficient == 0.14 && film.friction_coefficient == 0 && film.load == 0,
          "the film has %g %g %g %g", film.shear_strength, film.pressure_coefficient, film.friction_coefficient, film.load);
    CHECK(strcmp(film.name, "KCl film on iron in vacuum") == 0 && strcmp(film.source, "read") == 0 &&
          strstr(film.conditions, "vacuum") != NULL && strstr(film.reference, "Garvey") != NULL, "%s", film.reference);
    for (; asperity_interface_name(count) != NULL; count++) {
        CHECK(asperity_interface(asperity_interface_name(count), &other) == ASPERITY_OK, "%s", last_message());
        CHECK(strcmp(other.name, asperity_interface_name(count)) == 0 && strlen(other.reference) > 20 &&
              (other.shear_strength > 0) != (other.friction_coefficient > 0), "%s", other.name);
    }
    CHECK(count == 39 && asperity_interface_name(SIZE_MAX) == NULL, "%d interfaces", (int)count);
    other = untouched;
    CHECK(asperity_interface("MoS2 film", &other) == ASPERITY_INVALID_PARAMETER && SAME(other, untouched) &&
          says("MoS2 film: no interface has this name; the nearest is MoS2 film in dry air"), "%s", last_message());
    CHECK(asperity_interface(NULL, &other) == ASPERITY_NULL_POINTER && says("name is NULL"), "%s", last_message());
    CHECK(asperity_interface("MoS2 bilayer", NULL) == ASPERITY_NULL_POINTER && says("data is NULL"), "%s", last_message());
    other.struct_size = 0;
    CHECK(asperity_interface("MoS2 bilayer", &other) == ASPERITY_INVALID_PARAMETER && says("struct_size = 0"), "%s",
          last_message());
}

/* The strength in Pa of all contacts, whatever their size, and nothing else; the model then says no more that it is a default. */
static void an_interface_sets_its_strength_and_nothing_else(void)
{
    asperity_params p, expected, refused;
    asperity_model *model;
    asperity_state state;

    CHECK(asperity_params_init(&p, sizeof p) == ASPERITY_OK && asperity_params_set_pair(&p, "steel/steel") == ASPERITY_OK, "%s",
          last_message());
    p.height_std = 0.4e-6;
    p.summit_radius = 20e-6;
    p.asperity_count = 5e5;
    p.work_of_adhesion = 0;
    expected = p;
    model = model_of(p);
    CHECK((state_at(model, 1).warnings & ASPERITY_WARNING_UNCALIBRATED) != 0, "no warning of a default");
    asperity_free(model);
    expected.slip_stress_1 = expected.slip_stress_2 = 65e6 / p.effective_shear_modulus;
    expected.pressure_coefficient = 0.14;
    CHECK(asperity_params_calibrate(&p, 10, 0.3) == ASPERITY_OK && p.calibration_load == 10, "%s", last_message());
    CHECK(asperity_params_set_interface(&p, "KCl film on iron in vacuum") == ASPERITY_OK && SAME(p, expected), "%s", last_message());
    for (double load = 1e-3; load < 1e3; load *= 10) {
        model = model_of(p);
        state = state_at(model, load);
        CHECK(close_to(state.friction_force, 65e6 * state.real_area + 0.14 * load, 1e-12), "F = %.15g at %g N",
              state.friction_force, load);
        CHECK((state.warnings & ASPERITY_WARNING_UNCALIBRATED) == 0, "a warning of a default at %g N", load);
        asperity_free(model);
    }
    expected.slip_stress_1 = expected.slip_stress_2 = 140e6 / p.effective_shear_modulus;
    expected.pressure_coefficient = 0;
    CHECK(asperity_params_set_interface(&p, "graphite layers") == ASPERITY_OK && SAME(p, expected), "a kappa of before is left");

    refused = p;
#define REFUSED(name, text) \
    CHECK(asperity_params_set_interface(&refused, name) == ASPERITY_INVALID_PARAMETER && SAME(refused, p) && says(text), "%s", \
          last_message())
    REFUSED("graphite", "graphite: no interface has this name; the nearest is ");
    REFUSED("steel/steel dry", "steel/steel dry: its shear strength is not known, only a friction coefficient of 0.57 at 12 N (ball");
    REFUSED("steel/steel dry", "): for surfaces like these calibrate with a friction force of 0.57 times the load");
    REFUSED("Al/Al greased", "only a friction coefficient of 0.3 (greasy");
    refused.effective_shear_modulus = p.effective_shear_modulus = 79e3 / 2; /* MPa */
    REFUSED("graphene bilayer", "effective_shear_modulus = 39500: must be in Pa and above the strength of the interface");
    refused.effective_shear_modulus = p.effective_shear_modulus = NAN;
    REFUSED("graphene bilayer", "effective_shear_modulus = NaN: must be in Pa");
#undef REFUSED
    CHECK(asperity_params_set_interface(NULL, "graphite layers") == ASPERITY_NULL_POINTER && says("params is NULL"), "%s",
          last_message());
    CHECK(asperity_params_set_interface(&p, NULL) == ASPERITY_NULL_POINTER && says("name is NULL"), "%s", last_message());
}

/* ---- Making and changing models ---- */

typedef struct refused {
    size_t offset;
    double value;
    asperity_status status;
    const char *text;
} refused;

#define FIELD(name) offsetof(asperity_params, name)

/* A message names parameter, value, and what is allowed. */
static const refused REFUSED[] = {
    { FIELD(composite_modulus), 0, ASPERITY_INVALID_PARAMETER, "composite_modulus = 0: must be finite and > 0" },
    { FIELD(effective_shear_modulus), -2, ASPERITY_INVALID_PARAMETER,
      "effective_shear_modulus = -2: must be finite and > 0" },
    { FIELD(work_of_adhesion), -0.5, ASPERITY_INVALID_PARAMETER, "work_of_adhesion = -0.5: must be finite and >= 0" },
    { FIELD(adhesion_range), INFINITY, ASPERITY_INVALID_PARAMETER, "adhesion_range = inf: must be finite and > 0" },
    { FIELD(burgers_vector), -1e-9, ASPERITY_INVALID_PARAMETER, "burgers_vector = -1e-9: must be finite and > 0" },
    { FIELD(height_std), -INFINITY, ASPERITY_INVALID_PARAMETER, "height_std = -inf: must be finite and > 0" },
    { FIELD(summit_radius), NAN, ASPERITY_INVALID_PARAMETER, "summit_radius = NaN: must be finite and > 0" },
    { FIELD(asperity_count), 0, ASPERITY_INVALID_PARAMETER, "asperity_count = 0: must be finite and > 0" },
    { FIELD(weibull_shape), -2, ASPERITY_INVALID_PARAMETER, "weibull_shape = -2: must be finite and > 0" },
    { FIELD(radius_amplitude), 1.5, ASPERITY_INVALID_PARAMETER, "radius_amplitude = 1.5: must be between -1 and 1" },
    { FIELD(radius_rate), 0, ASPERITY_INVALID_PARAMETER, "radius_rate = 0: must be finite and > 0" },
    { FIELD(slip_radius_1), -28, ASPERITY_INVALID_PARAMETER, "slip_radius_1 = -28: must be finite and > 0" },
    { FIELD(slip_stress_1), 0, ASPERITY_INVALID_PARAMETER, "slip_stress_1 = 0: must be finite and > 0" },
    { FIELD(slip_radius_2), 28, ASPERITY_INVALID_PARAMETER, "slip_radius_2 = 28: must be greater than slip_radius_1" },
    { FIELD(slip_stress_2), 1e-12, ASPERITY_INVALID_PARAMETER, "slip_stress_2 = 1e-12: must be at least" },
    { FIELD(max_friction_coefficient), 0, ASPERITY_INVALID_PARAMETER, "max_friction_coefficient = 0: must be > 0" },
    { FIELD(hardness), -1, ASPERITY_INVALID_PARAMETER, "hardness = -1: must be finite and >= 0" },
    { FIELD(hardness), NAN, ASPERITY_INVALID_PARAMETER, "hardness = NaN: must be finite and >= 0" },
    { FIELD(tangential_modulus), -1, ASPERITY_INVALID_PARAMETER, "tangential_modulus = -1: must be finite and >= 0" },
    { FIELD(nominal_area), NAN, ASPERITY_INVALID_PARAMETER, "nominal_area = NaN: must be finite and >= 0" },
    { FIELD(hardness), 1e41, ASPERITY_OUT_OF_RANGE, "hardness = 1e41: must be between 1e-40 and 1e40" },
    { FIELD(summit_radius), 1e-3, ASPERITY_OUT_OF_RANGE, "alpha = 100: " },
    { FIELD(work_of_adhesion), 1e3, ASPERITY_OUT_OF_RANGE, "gamma = " },
    { FIELD(adhesion_range), 1e6, ASPERITY_OUT_OF_RANGE, "b/h = " },
    { FIELD(weibull_shape), 1e9, ASPERITY_OUT_OF_RANGE, "weibull_shape = 1000000000: must be at most 200" },
};

enum { REFUSALS = sizeof REFUSED / sizeof *REFUSED };

static asperity_params refused_params(const refused *r)
{
    asperity_params p = surface(4);
    memcpy((char *)&p + r->offset, &r->value, sizeof r->value);
    return p;
}

static void create_refuses_by_name_and_leaves_the_pointer(void)
{
    for (int i = 0; i < REFUSALS; i++) {
        const asperity_params p = refused_params(&REFUSED[i]);
        asperity_model *const sentinel = (asperity_model *)(void *)message;
        asperity_model *model = sentinel;
        const asperity_status status = asperity_create(&p, &model);
        CHECK(status == REFUSED[i].status, "%s: status %d", REFUSED[i].text, status);
        CHECK(says(REFUSED[i].text), "'%s' does not say '%s'", last_message(), REFUSED[i].text);
        CHECK(model == sentinel, "%s: *model was written", REFUSED[i].text);
    }
}

enum { LOADS = 9 };

static void answers(const asperity_model *model, double out[2 * LOADS])
{
    static const double loads[LOADS] = { -1e9, -1e-3, 0, 1e-6, 0.01, 1, 37.5, 1e4, 1e9 };
    for (int i = 0; i < LOADS; i++) {
        out[2 * i] = asperity_friction_at_load(model, loads[i]);
        out[2 * i + 1] = asperity_friction_force_at_load(model, loads[i]);
    }
}

static void failing_set_params_leaves_the_model_bit_for_bit(void)
{
    asperity_model *model = model_of(surface(4));
    double before[2 * LOADS], after[2 * LOADS];
    const asperity_summary summary = summary_of(model);

    answers(model, before);
    for (int i = 0; i < REFUSALS; i++) {
        const asperity_params p = refused_params(&REFUSED[i]);
        asperity_params kept = { .struct_size = sizeof kept };
        asperity_summary now;
        const asperity_params original = surface(4);
        CHECK(asperity_set_params(model, &p) == REFUSED[i].status, "%s", REFUSED[i].text);
        CHECK(says(REFUSED[i].text), "'%s' does not say '%s'", last_message(), REFUSED[i].text);
        answers(model, after);
        now = summary_of(model);
        CHECK(SAME(before, after), "%s: other answers", REFUSED[i].text);
        CHECK(SAME(summary, now), "%s: another summary", REFUSED[i].text);
        CHECK(asperity_get_params(model, &kept) == ASPERITY_OK && SAME(kept, original), "other parameters are kept");
    }
    asperity_free(model);
}

static void set_params_makes_the_model_that_create_makes(void)
{
    for (int i = 0; i < SURFACES; i++) {
        const asperity_params p = surface(i);
        asperity_params kept;
        asperity_model *changed = model_of(surface(8)), *fresh = model_of(p);
        double a[2 * LOADS], b[2 * LOADS];

        CHECK(asperity_set_params(changed, &p) == ASPERITY_OK, "%s: %s", SURFACE_NAMES[i], last_message());
        answers(changed, a);
        answers(fresh, b);
        CHECK(SAME(a, b), "%s: other answers", SURFACE_NAMES[i]);
        memset(&kept, 0xa5, sizeof kept);
        kept.struct_size = sizeof kept;
        CHECK(asperity_get_params(changed, &kept) == ASPERITY_OK && SAME(kept, p), "%s: other parameters",
              SURFACE_NAMES[i]);
        asperity_free(changed);
        asperity_free(fresh);
    }
}

static void tables_are_refused_by_name(void)
{
    const double heights[] = { 0, 1, 2, 3, 4 }, densities[] = { 0, 1, 2, 1, 0 };
    asperity_params p = surface(0);
    asperity_model *model = NULL;

    p.height_distribution = ASPERITY_HEIGHTS_TABULATED;
    CHECK(asperity_create(&p, &model) == ASPERITY_INVALID_PARAMETER && says("table_length = 0: must be between "), "'%s'",
          last_message());
    p.table_length = UINT64_MAX;
    CHECK(asperity_create(&p, &model) == ASPERITY_OUT_OF_RANGE && says("table_length = "), "'%s'", last_message());
    p.table_length = 5;
    CHECK(asperity_create(&p, &model) == ASPERITY_NULL_POINTER && says("table_height is NULL"), "'%s'", last_message());
    p.table_height = heights;
    CHECK(asperity_create(&p, &model) == ASPERITY_NULL_POINTER && says("table_density is NULL"), "'%s'", last_message());
    p.table_density = densities;
    p.height_distribution = ASPERITY_HEIGHTS_GAUSSIAN;
    CHECK(asperity_create(&p, &model) == ASPERITY_OK, "a table that is not read: %s", last_message());
    asperity_free(model);
}

/* ---- Output structs ---- */

enum { GUARD = 0xa5, ROOM = 256 };

/* The number of leading bytes of a struct that a call changed, from a block filled with GUARD. */
static size_t bytes_written(const unsigned char *block)
{
    size_t n = ROOM;
    while (n > 0 && block[n - 1] == GUARD)
        n--;
    return n;
}

typedef asperity_status fill_call(const asperity_model *, void *);

static asperity_status fill_state(const asperity_model *model, void *out)
{
    return asperity_state_at_load(model, 1.0, out);
}

static asperity_status fill_state_at_gap(const asperity_model *model, void *out)
{
    return asperity_state_at_gap(model, 10.0, out);
}

static asperity_status fill_separated_state(const asperity_model *model, void *out)
{
    return asperity_state_at_load(model, -1e9, out);
}

static asperity_status fill_summary(const asperity_model *model, void *out)
{
    return asperity_summary_of(model, out);
}

static asperity_status fill_sensitivities(const asperity_model *model, void *out)
{
    return asperity_sensitivities_at_load(model, 1.0, out);
}

static void outputs_are_written_no_further_than_struct_size(void)
{
    fill_call *const calls[] = { fill_state, fill_state_at_gap, fill_summary, fill_sensitivities };
    const size_t sizes[] = { sizeof(asperity_state), sizeof(asperity_state), sizeof(asperity_summary),
                             sizeof(asperity_sensitivities) };
    asperity_model *model = model_of(surface(0));
    union { uint64_t size; unsigned char bytes[ROOM]; } block, filled;

    for (int k = 0; k < 4; k++) {
        for (uint64_t size = 16; size <= sizes[k]; size += 8) {
            memset(&block, GUARD, sizeof block);
            block.size = size;
            CHECK(calls[k](model, &block) == ASPERITY_OK, "size %llu: %s", (unsigned long long)size, last_message());
            CHECK(block.size == size, "struct_size was changed");
            CHECK(bytes_written(block.bytes) <= size, "%zu bytes written, not %llu", bytes_written(block.bytes),
                  (unsigned long long)size);
            if (size > 16)
                CHECK(memcmp(&block.bytes[8], &filled.bytes[8], (size_t)size - 16) == 0, "other fields");
            filled = block;
        }
        memset(&block, GUARD, sizeof block);
        block.size = 8;
        CHECK(calls[k](model, &block) == ASPERITY_INVALID_PARAMETER && says("struct_size = 8: "), "size 8");
        CHECK(bytes_written(block.bytes) <= 8, "written in spite of the error");
    }
    memset(&block, GUARD, sizeof block);
    block.size = sizeof(asperity_state);
    filled = block;
    CHECK(fill_separated_state(model, &block) == ASPERITY_SEPARATED, "no SEPARATED at -1e9");
    CHECK(SAME(block, filled), "the state was touched by a failing call");
    asperity_free(model);
}

static void failing_states_say_what_is_wrong(void)
{
    asperity_model *model = model_of(surface(0)), *hertz = model_of(surface(1));
    asperity_state state, before;

    memset(&state, GUARD, sizeof state);
    state.struct_size = sizeof state;
    before = state;
    CHECK(asperity_state_at_load(model, NAN, &state) == ASPERITY_INVALID_LOAD && says("load = NaN: "), "NaN load");
    CHECK(asperity_state_at_load(model, INFINITY, &state) == ASPERITY_INVALID_LOAD && says("load = inf: "), "inf load");
    CHECK(asperity_state_at_load(model, -1e9, &state) == ASPERITY_SEPARATED && says("load = -1000000000: "),
          "'%s'", last_message());
    CHECK(asperity_state_at_load(model, 1e200, &state) == ASPERITY_OUT_OF_RANGE && says("load = 1e200: "), "1e200");
    CHECK(asperity_state_at_load(hertz, 0, &state) == ASPERITY_OUT_OF_RANGE && says("load = 0: "), "Hertz at 0");
    CHECK(asperity_state_at_load(hertz, -1, &state) == ASPERITY_SEPARATED, "Hertz below 0");
    CHECK(asperity_state_at_gap(model, NAN, &state) == ASPERITY_INVALID_PARAMETER && says("gap = NaN: "),
          "NaN gap");
    CHECK(asperity_state_at_gap(model, -INFINITY, &state) == ASPERITY_INVALID_PARAMETER, "inf gap");
    CHECK(asperity_state_at_gap(model, 1e300, &state) == ASPERITY_OUT_OF_RANGE && says("gap = 1e300: "),
          "'%s'", last_message());
    CHECK(SAME(state, before), "the state was touched by a failing call");
    asperity_free(model);
    asperity_free(hertz);
}

static void failing_sensitivities_say_what_is_wrong(void)
{
    asperity_model *model = model_of(surface(0)), *hertz = model_of(surface(1));
    asperity_summary summary;
    asperity_sensitivities out, before;

    summary.struct_size = sizeof summary;
    CHECK(asperity_summary_of(model, &summary) == ASPERITY_OK, "no summary: %s", last_message());
    memset(&out, GUARD, sizeof out);
    out.struct_size = sizeof out;
    before = out;
#define REFUSED(model, load, status, words)                                                                            \
    CHECK(asperity_sensitivities_at_load(model, load, &out) == (status) && says(words), "%g: '%s'", (double)(load),    \
          last_message())
    REFUSED(model, NAN, ASPERITY_INVALID_LOAD, "load = NaN: ");
    REFUSED(model, -INFINITY, ASPERITY_INVALID_LOAD, "load = -inf: ");
    REFUSED(model, -1e9, ASPERITY_SEPARATED, "load = -1000000000: ");
    REFUSED(model, 1e200, ASPERITY_OUT_OF_RANGE, "load = 1e200: ");
    REFUSED(model, summary.pull_off_load, ASPERITY_OUT_OF_RANGE, "load = -");
    REFUSED(hertz, 0.0, ASPERITY_OUT_OF_RANGE, "load = 0: ");
    REFUSED(hertz, -1.0, ASPERITY_SEPARATED, "load = -1: ");
#undef REFUSED
    CHECK(SAME(out, before), "the sensitivities were touched by a failing call");
    CHECK(asperity_sensitivities_at_load(model, 0.0, &out) == ASPERITY_OK, "at zero load: %s", last_message());
    CHECK(out.effective_shear_modulus == 1.0 && out.work_of_adhesion > 0.0, "more adhesion, less friction");
    asperity_free(model);
    asperity_free(hertz);
}

/* ---- Warnings ---- */

static uint64_t warnings_between(const asperity_model *model, double lightest, double heaviest)
{
    uint64_t warnings = ~UINT64_C(0);
    CHECK(asperity_check_loads(model, lightest, heaviest, &warnings) == ASPERITY_OK, "%g to %g: %s", lightest, heaviest,
          last_message());
    return warnings;
}

static void warnings_of_a_range_are_those_of_its_states(void)
{
    asperity_params p = surface(0);
    asperity_model *model;
    asperity_state state;
    uint64_t seen = 0;

    p.asperity_count = 1e4;
    p.slip_stress_1 = 1e-3;
    p.hardness = 0.05 * p.composite_modulus;
    p.nominal_area = 1e10;
    p.bandwidth = 3;
    model = model_of(p);
    state.struct_size = sizeof state;
    for (double load = 1; load <= 1e7; load *= 1.5) {
        CHECK(asperity_state_at_load(model, load, &state) == ASPERITY_OK, "%s", last_message());
        CHECK(warnings_between(model, load, load) == state.warnings, "at %g", load);
        seen |= state.warnings;
        CHECK(warnings_between(model, 1, load) == seen, "up to %g: not %llu", load, (unsigned long long)seen);
    }
    CHECK(seen == (ASPERITY_WARNING_CROWDED | ASPERITY_WARNING_FEW | ASPERITY_WARNING_ADHESIVE), "%llu", (unsigned long long)seen);
    asperity_free(model);

    p.asperity_count = 1;
    model = model_of(p);
    CHECK((warnings_between(model, 1e-4, 1) & ASPERITY_WARNING_FEW) == 0, "few, though the load is that of a summit");
    asperity_free(model);

    /* The area alone. */
    p.asperity_count = 1e4;
    p.nominal_area = 0;
    model = model_of(p);
    CHECK(warnings_between(model, 1e6, 1e6) == 0, "%llu", (unsigned long long)warnings_between(model, 1e6, 1e6));
    CHECK(asperity_state_at_load(model, 1e6, &state) == ASPERITY_OK, "%s", last_message());
    p.nominal_area = 9 * state.real_area;
    CHECK(asperity_set_params(model, &p) == ASPERITY_OK, "%s", last_message());
    CHECK(warnings_between(model, 1e6, 1e6) == ASPERITY_WARNING_CROWDED, "a ninth of the area is not crowded");
    asperity_free(model);
}

static void a_warning_is_told_with_its_loads(void)
{
    asperity_params p = surface(0);
    asperity_model *model;
    asperity_summary summary = { .struct_size = sizeof summary };
    double lightest = 5, heaviest = 6;

    p.asperity_count = 1e4;
    p.slip_stress_1 = 0.02;
    model = model_of(p);
    CHECK(asperity_summary_of(model, &summary) == ASPERITY_OK, "%s", last_message());
#define FAILS(call, status, text)                                                                                      \
    CHECK((call) == (status) && says(text), "another status than " #status ", or '%s'", last_message());               \
    CHECK(lightest == 5 && heaviest == 6, "touched by a failing call")
    FAILS(asperity_warning_loads(NULL, 16, &lightest, &heaviest), ASPERITY_NULL_POINTER, "model is NULL");
    FAILS(asperity_warning_loads(model, 16, NULL, &heaviest), ASPERITY_NULL_POINTER, "lightest is NULL");
    FAILS(asperity_warning_loads(model, 16, &lightest, NULL), ASPERITY_NULL_POINTER, "heaviest is NULL");
    FAILS(asperity_warning_loads(model, 0, &lightest, &heaviest), ASPERITY_INVALID_PARAMETER, "warning = 0: must be one");
    FAILS(asperity_warning_loads(model, 3, &lightest, &heaviest), ASPERITY_INVALID_PARAMETER, "warning = 3: must be one");
    FAILS(asperity_warning_loads(model, 1024, &lightest, &heaviest), ASPERITY_INVALID_PARAMETER, "warning = 1024: ");
#undef FAILS
    CHECK(asperity_warning_loads(model, ASPERITY_WARNING_UNCALIBRATED, &lightest, &heaviest) == ASPERITY_OK && isnan(lightest) &&
          isnan(heaviest), "a strength of its own: %g to %g", lightest, heaviest);
    CHECK(asperity_warning_loads(model, ASPERITY_WARNING_FEW, &lightest, &heaviest) == ASPERITY_OK, "%s", last_message());
    CHECK(lightest == summary.min_table_load && heaviest > 0 && heaviest < summary.max_table_load, "%g to %g", lightest, heaviest);
    CHECK((warnings_between(model, 0.999 * heaviest, 0.999 * heaviest) & ASPERITY_WARNING_FEW) != 0, "few up to %g", heaviest);
    CHECK((warnings_between(model, 1.001 * heaviest, 1.001 * heaviest) & ASPERITY_WARNING_FEW) == 0, "few up to %g", heaviest);
    asperity_free(model);
}

static void loads_without_a_state_have_no_warnings(void)
{
    asperity_model *model = model_of(surface(0)), *hertz = model_of(surface(1));
    const uint64_t before = UINT64_C(0xa5a5a5a5a5a5a5a5);
    uint64_t warnings = before;

    CHECK(asperity_check_loads(NULL, 1, 2, &warnings) == ASPERITY_NULL_POINTER && says("model is NULL"), "no model");
    CHECK(asperity_check_loads(model, 1, 2, NULL) == ASPERITY_NULL_POINTER && says("warnings is NULL"), "no output");
    CHECK(asperity_check_loads(model, 2, 1, &warnings) == ASPERITY_INVALID_PARAMETER &&
          says("lightest = 2: must not be above heaviest"), "'%s'", last_message());
    CHECK(asperity_check_loads(model, NAN, 1, &warnings) == ASPERITY_INVALID_LOAD && says("lightest = NaN: "), "NaN");
    CHECK(asperity_check_loads(model, 1, NAN, &warnings) == ASPERITY_INVALID_LOAD, "NaN as the heaviest");
    CHECK(asperity_check_loads(model, 1, INFINITY, &warnings) == ASPERITY_INVALID_LOAD, "infinity");
    CHECK(asperity_check_loads(model, -1e9, 1, &warnings) == ASPERITY_SEPARATED && says("lightest = -1000000000: "),
          "'%s'", last_message());
    CHECK(asperity_check_loads(model, 1, 1e200, &warnings) == ASPERITY_OUT_OF_RANGE && says("heaviest = 1e200: "), "1e200");
    CHECK(asperity_check_loads(hertz, 0, 1, &warnings) == ASPERITY_OUT_OF_RANGE && says("lightest = 0: "), "Hertz at 0");
    CHECK(warnings == before, "warnings were touched by a failing call");
    asperity_free(model);
    asperity_free(hertz);
}

/* ---- Friction ---- */

static int quiet_nan(double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return isnan(x) && (bits >> 51 & 1) == 1;
}

static void friction_at_zero_negative_and_separated_loads(int which)
{
    asperity_model *model = model_of(surface(which));
    const asperity_summary s = summary_of(model);
    const double cap = surface(which).max_friction_coefficient, pull_off = s.pull_off_load;
    const double below = nextafter(pull_off, -INFINITY);
    const char *name = SURFACE_NAMES[which];

    CHECK(pull_off <= 0, "%s: pull-off load %g", name, pull_off);
    CHECK(asperity_friction_at_load(model, 0.0) == cap, "%s: mu at 0", name);
    CHECK(asperity_friction_at_load(model, -0.0) == cap, "%s: mu at -0", name);
    CHECK(asperity_friction_at_load(model, pull_off) == cap, "%s: mu at pull-off", name);
    CHECK(asperity_friction_at_load(model, 0.5 * pull_off) == cap, "%s: mu at half the pull-off load", name);
    CHECK(asperity_friction_force_at_load(model, 0.0) == s.zero_load_friction_force, "%s: F at 0", name);
    CHECK(close_to(asperity_friction_force_at_load(model, pull_off), s.pull_off_friction_force, 1e-12),
          "%s: F at pull-off", name);
    CHECK(asperity_friction_at_load(model, below) == 0, "%s: mu just below pull-off", name);
    CHECK(asperity_friction_force_at_load(model, below) == 0, "%s: F just below pull-off", name);
    CHECK(asperity_friction_at_load(model, -1e200) == 0, "%s: mu far below pull-off", name);
    CHECK(quiet_nan(asperity_friction_at_load(model, NAN)), "%s: mu at NaN", name);
    CHECK(quiet_nan(asperity_friction_at_load(model, INFINITY)), "%s: mu at infinity", name);
    CHECK(quiet_nan(asperity_friction_force_at_load(model, -INFINITY)), "%s: F at -infinity", name);
    CHECK(quiet_nan(asperity_friction_force_at_load(NULL, 1)), "F of NULL");
    CHECK(quiet_nan(asperity_friction_at_load(NULL, 1)), "mu of NULL");
    asperity_free(model);
}

static void mu_is_force_over_load_and_the_table_is_as_good_as_it_says(int which)
{
    asperity_params p = surface(which);
    const double unit = p.asperity_count * p.composite_modulus * p.burgers_vector * p.burgers_vector;
    const char *name = SURFACE_NAMES[which];
    asperity_model *model;
    asperity_summary s;

    p.max_friction_coefficient = INFINITY;
    model = model_of(p);
    s = summary_of(model);
    CHECK(s.table_error >= 0 && s.table_error < 4e-9, "%s: table_error %g", name, s.table_error);
    for (int k = -20; k <= 20; k++) {
        const double load = unit * pow(10, 0.31 * k);
        const double force = asperity_friction_force_at_load(model, load);
        const double mu = asperity_friction_at_load(model, load);
        const asperity_state state = state_at(model, load);
        double slope, mu_slope, f, m;

        CHECK(mu == force / load, "%s at %g: mu %g, F %g", name, load, mu, force);
        CHECK(close_to(force, state.friction_force, s.table_error + 1e-9), "%s at %g: F %.17g, exactly %.17g", name,
              load, force, state.friction_force);
        CHECK(close_to(state.load, load, 1e-15), "%s: load %.17g of the state at %.17g", name, state.load, load);
        CHECK(state.friction_coefficient == state.friction_force / state.load, "%s at %g: mu of the state", name, load);
        CHECK(asperity_friction_force_at_loads(model, 1, &load, &f, &slope) == ASPERITY_OK && f == force,
              "%s at %g: batch force", name, load);
        CHECK(asperity_friction_at_loads(model, 1, &load, &m, &mu_slope) == ASPERITY_OK && m == mu,
              "%s at %g: batch mu", name, load);
        CHECK(close_to(slope, state.dforce_dload, 4e-7), "%s at %g: dF/dP %.12g, exactly %.12g", name, load, slope,
              state.dforce_dload);
        CHECK(fabs(mu_slope - (slope - mu) / load) <= 1e-12 * mu / load, "%s at %g: dmu/dP", name, load);
        CHECK(fabs(state.dmu_dload - mu_slope) <= 4e-7 * mu / load, "%s at %g: dmu/dP of the state", name, load);
        CHECK(state.dload_dgap < 0, "%s at %g: no stiffness", name, load);
        {
            asperity_state again;
            again.struct_size = sizeof again;
            CHECK(asperity_state_at_gap(model, state.gap, &again) == ASPERITY_OK, "%s", last_message());
            CHECK(close_to(again.friction_force, state.friction_force, 1e-9), "%s at %g: not on the way back", name,
                  load);
        }
    }
    asperity_free(model);
}

static void beyond_the_table_the_law_goes_on_as_a_power_of_the_load(void)
{
    asperity_model *model = model_of(surface(0));
    const asperity_summary s = summary_of(model);
    const double end = nextafter(s.max_table_load, INFINITY);
    const double x = end - s.pull_off_load;
    double slope;
    const double force = asperity_friction_force_and_slope_at_load(model, end, &slope);
    const double power = slope * x / force;

    CHECK(s.max_table_load > 0 && s.min_table_load >= s.pull_off_load, "no table");
    CHECK(close_to(force, state_at(model, end).friction_force, 1e-8), "at %g: F %.17g", end, force);
    for (double factor = 10; factor < 1e7; factor *= 10) {
        const double load = s.pull_off_load + factor * x;
        const double heavier = asperity_friction_force_at_load(model, load);
        CHECK(close_to(heavier, force * pow(factor, power), 1e-6), "at %g: F %.17g", load, heavier);
    }
    asperity_free(model);
}

static void the_cap_holds_everywhere(void)
{
    asperity_params p = surface(0);
    asperity_model *model;
    double load = 1, mu, slope;

    p.max_friction_coefficient = 1.25;
    model = model_of(p);
    for (double x = 1e-6; x < 1e6; x *= 3)
        CHECK(asperity_friction_at_load(model, x) <= 1.25, "mu %g at %g", asperity_friction_at_load(model, x), x);
    CHECK(asperity_friction_at_load(model, 1e-6) == 1.25, "not capped at light load");
    CHECK(asperity_friction_at_load(model, 1e5) < 1.25, "capped at heavy load");
    load = 1e-6;
    CHECK(asperity_friction_at_loads(model, 1, &load, &mu, &slope) == ASPERITY_OK && mu == 1.25 && slope == 0,
          "slope %g of a capped coefficient", slope);
    asperity_free(model);

    p = surface(2);
    p.max_friction_coefficient = INFINITY;
    model = model_of(p);
    CHECK(asperity_friction_at_load(model, 0) == INFINITY, "mu at 0 without a cap");
    CHECK(asperity_friction_at_load(model, -1e-9) == INFINITY, "mu below 0 without a cap");
    asperity_free(model);
}

static void summary_gives_the_groups(void)
{
    asperity_model *model = model_of(surface(8));
    const asperity_params p = surface(8);
    const asperity_summary s = summary_of(model);
    const double pi = 3.14159265358979323846;

    CHECK(close_to(s.alpha, sqrt(p.height_std / p.summit_radius), 1e-14), "alpha %g", s.alpha);
    CHECK(close_to(s.beta, sqrt(p.height_std * p.summit_radius) / p.burgers_vector, 1e-14), "beta %g", s.beta);
    CHECK(close_to(s.gamma, p.work_of_adhesion / (p.composite_modulus * p.burgers_vector), 1e-14), "gamma %g", s.gamma);
    CHECK(close_to(s.lambda, cbrt(9 * s.beta * s.gamma * s.gamma / (2 * pi * s.alpha)), 1e-14), "lambda %g", s.lambda);
    CHECK(s.skew == 0 && s.kurtosis == 3, "moments of the Gaussian");
    asperity_free(model);
}

/* ---- Batches ---- */

typedef asperity_status batch_call(const asperity_model *, size_t, const double *, double *, double *);

enum { BATCH = 7 };

static void batch(batch_call *call, double scalar(const asperity_model *, double))
{
    asperity_model *model = model_of(surface(0));
    const asperity_summary s = summary_of(model);
    const double good[BATCH] = { 1e-3, 0, 0.5 * s.pull_off_load, 1, 10, 1e4, s.pull_off_load };
    const double bad[BATCH] = { 1, 2, 2 * s.pull_off_load, NAN, 5, INFINITY, 7 };
    double value[BATCH], slope[BATCH], again[BATCH], in_place[BATCH];

    CHECK(call(model, BATCH, good, value, slope) == ASPERITY_OK, "%s", last_message());
    for (int i = 0; i < BATCH; i++)
        CHECK(value[i] == scalar(model, good[i]), "element %d differs from the scalar call", i);
    CHECK(call(model, BATCH, good, again, NULL) == ASPERITY_OK && SAME(again, value), "without slopes");
    CHECK(call(model, BATCH, good, NULL, again) == ASPERITY_OK && SAME(again, slope), "slopes alone");
    CHECK(call(model, BATCH, good, NULL, NULL) == ASPERITY_OK, "neither");
    memcpy(in_place, good, sizeof good);
    CHECK(call(model, BATCH, in_place, in_place, again) == ASPERITY_OK && SAME(in_place, value) && SAME(again, slope),
          "values in place");
    memcpy(in_place, good, sizeof good);
    CHECK(call(model, BATCH, in_place, again, in_place) == ASPERITY_OK && SAME(in_place, slope) && SAME(again, value),
          "slopes in place");
    CHECK(call(model, 0, good, value, slope) == ASPERITY_OK, "n = 0");
    CHECK(call(model, 0, NULL, NULL, NULL) == ASPERITY_OK, "n = 0 with NULL");

    /* All elements are filled, then the first invalid one is reported with its index. */
    memset(value, GUARD, sizeof value);
    CHECK(call(model, BATCH, bad, value, slope) == ASPERITY_SEPARATED, "the first invalid load is element 2");
    CHECK(says("element 2: load = "), "'%s'", last_message());
    CHECK(value[2] == 0 && slope[2] == 0, "a separated contact has friction");
    CHECK(isnan(value[3]) && isnan(value[5]), "NaN and infinite load");
    CHECK(value[0] == scalar(model, 1) && value[4] == scalar(model, 5) && value[6] == scalar(model, 7),
          "the good elements are not filled");
    CHECK(call(model, BATCH - 3, bad + 3, value, slope) == ASPERITY_INVALID_LOAD && says("element 0: load = NaN"),
          "'%s'", last_message());
    CHECK(call(model, BATCH, bad, NULL, NULL) == ASPERITY_SEPARATED, "invalid without outputs");
    asperity_free(model);
}

/* ---- The last message ---- */

static void last_message_is_copied_out_whole_or_cut(void)
{
    asperity_params p = surface(4);
    asperity_model *model = NULL;
    char buffer[64], guard[64];
    size_t length;
    static const char whole[] = "weibull_shape = -2: must be finite and > 0";

    p.weibull_shape = -2;
    asperity_create(&p, &model);
    memset(guard, GUARD, sizeof guard);
    memcpy(buffer, guard, sizeof guard);
    length = asperity_last_error(buffer, sizeof buffer);
    CHECK(length == strlen(whole) && strcmp(buffer, whole) == 0, "'%s'", buffer);
    CHECK(asperity_last_error(NULL, 0) == length && asperity_last_error(NULL, 100) == length, "length without buffer");
    memcpy(buffer, guard, sizeof guard);
    CHECK(asperity_last_error(buffer, 0) == length && memcmp(buffer, guard, sizeof guard) == 0, "length 0");
    CHECK(asperity_last_error(buffer, 1) == length && buffer[0] == '\0' && buffer[1] == guard[1], "length 1");
    CHECK(asperity_last_error(buffer, 8) == length && strcmp(buffer, "weibull") == 0 && buffer[8] == guard[8],
          "length 8");
    CHECK(asperity_last_error(buffer, strlen(whole)) == length && strlen(buffer) == length - 1, "one byte short");
    memcpy(buffer, guard, sizeof guard);
    CHECK(asperity_last_error(buffer, length + 1) == length && strcmp(buffer, whole) == 0 &&
          buffer[length + 1] == guard[0], "exactly enough");

    p.weibull_shape = 3;
    CHECK(asperity_create(&p, &model) == ASPERITY_OK, "no model");
    CHECK(says(whole), "a call that succeeds changed the message to '%s'", last_message());
    CHECK(asperity_friction_at_loads(NULL, 1, NULL, NULL, NULL) == ASPERITY_NULL_POINTER && says("model is NULL"),
          "'%s'", last_message());
    CHECK(asperity_friction_at_loads(model, 1, NULL, NULL, NULL) == ASPERITY_NULL_POINTER && says("load is NULL"),
          "'%s'", last_message());
    p.height_distribution = 7;
    CHECK(asperity_set_params(model, &p) == ASPERITY_INVALID_PARAMETER && says("height_distribution = 7: must be"),
          "'%s'", last_message());
    p.height_distribution = 0;
    p.attraction = 2;
    CHECK(asperity_set_params(model, &p) == ASPERITY_INVALID_PARAMETER && says("attraction = 2: must be 0 or 1"),
          "'%s'", last_message());
    p.struct_size = 7;
    CHECK(asperity_set_params(model, &p) == ASPERITY_INVALID_PARAMETER && says("struct_size = 7: "), "'%s'",
          last_message());
    asperity_free(model);
}

int main(void)
{
    versions_agree_with_the_header();
    every_status_has_its_own_words();
    every_warning_says_what_fails_and_what_to_do();
    the_text_of_warnings_has_a_line_for_each();
    init_sets_every_default_and_no_physical_input();
    only_the_size_of_the_struct_is_taken();
    a_pointer_to_init_gives_the_whole_struct();
    what_was_never_set_is_named();
    a_slip_of_units_is_told();
    setters_set_what_they_say_and_nothing_else();
    failing_setters_touch_nothing();
    names_are_those_of_the_fields();
    setting_all_names_in_their_order_copies_a_surface();
    names_that_go_together_are_as_the_setters();
    a_mean_roughness_stands_for_the_variance();
    a_calibrated_surface_meets_the_measured_point();
    a_coefficient_measured_at_20_newtons_is_that_of_the_model();
    the_measured_point_is_read_by_name();
    adhering_surfaces_are_calibrated_where_no_load_presses();
    a_strength_of_nobodys_is_warned_of();
    a_point_that_no_strength_gives_is_refused();
    names_of_heights_choose_them();
    names_are_refused_with_the_nearest_and_nothing_changes();
    materials_are_found_by_their_names();
    pairs_are_found_in_either_order();
    a_pair_sets_what_it_tells_and_nothing_else();
    interfaces_are_found_by_their_names();
    an_interface_sets_its_strength_and_nothing_else();
    create_refuses_by_name_and_leaves_the_pointer();
    failing_set_params_leaves_the_model_bit_for_bit();
    set_params_makes_the_model_that_create_makes();
    tables_are_refused_by_name();
    outputs_are_written_no_further_than_struct_size();
    failing_states_say_what_is_wrong();
    failing_sensitivities_say_what_is_wrong();
    warnings_of_a_range_are_those_of_its_states();
    a_warning_is_told_with_its_loads();
    loads_without_a_state_have_no_warnings();
    for (int i = 0; i < SURFACES; i++) {
        friction_at_zero_negative_and_separated_loads(i);
        mu_is_force_over_load_and_the_table_is_as_good_as_it_says(i);
    }
    beyond_the_table_the_law_goes_on_as_a_power_of_the_load();
    the_cap_holds_everywhere();
    summary_gives_the_groups();
    batch(asperity_friction_at_loads, asperity_friction_at_load);
    batch(asperity_friction_force_at_loads, asperity_friction_force_at_load);
    last_message_is_copied_out_whole_or_cut();
    asperity_free(NULL);
    return checks_report("contract");
}
