/* Where the library finds each field of the structs is where the header's compiler puts it.
 *
 * Sizes and offsets: fields follow one another without gaps up to the end of the struct. Inputs: a field made invalid
 * is the one that the library names. Outputs: no byte past struct_size is written, and every field holds its own
 * quantity, known from tests/reference/cases.json (case "fig3 beta=1000 noncontacting=True" at 1 sigma: loads in
 * E* b^2, friction in G* b^2), from closed forms, or from another call. Exit status: 0 where all of it holds. */

#define _GNU_SOURCE

#include <asperity.h>

#include <fenv.h>
#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct field {
    const char *name;
    size_t offset, size;
} field;

#define FIELD(type, name) { #name, offsetof(type, name), sizeof ((type *)NULL)->name }
#define COUNT(array) (sizeof (array) / sizeof *(array))

static const field PARAMS[] = {
    FIELD(asperity_params, struct_size),        FIELD(asperity_params, composite_modulus),
    FIELD(asperity_params, effective_shear_modulus), FIELD(asperity_params, work_of_adhesion),
    FIELD(asperity_params, adhesion_range),     FIELD(asperity_params, burgers_vector),
    FIELD(asperity_params, height_std),         FIELD(asperity_params, summit_radius),
    FIELD(asperity_params, asperity_count),     FIELD(asperity_params, height_distribution),
    FIELD(asperity_params, attraction),         FIELD(asperity_params, weibull_shape),
    FIELD(asperity_params, radius_amplitude),   FIELD(asperity_params, radius_rate),
    FIELD(asperity_params, slip_radius_1),      FIELD(asperity_params, slip_stress_1),
    FIELD(asperity_params, slip_radius_2),      FIELD(asperity_params, slip_stress_2),
    FIELD(asperity_params, max_friction_coefficient), FIELD(asperity_params, skew),
    FIELD(asperity_params, kurtosis),           FIELD(asperity_params, hardness),
    FIELD(asperity_params, table_height),       FIELD(asperity_params, table_density),
    FIELD(asperity_params, table_length),       FIELD(asperity_params, tangential_modulus),
    FIELD(asperity_params, nominal_area),       FIELD(asperity_params, contact_law),
    FIELD(asperity_params, slip_onset),         FIELD(asperity_params, pressure_coefficient),
    FIELD(asperity_params, bandwidth),
};

static const field STATE[] = {
    FIELD(asperity_state, struct_size),         FIELD(asperity_state, load),
    FIELD(asperity_state, separation),          FIELD(asperity_state, friction_force),
    FIELD(asperity_state, friction_coefficient), FIELD(asperity_state, dforce_dload),
    FIELD(asperity_state, dmu_dload),           FIELD(asperity_state, dload_dseparation),
    FIELD(asperity_state, real_area),           FIELD(asperity_state, contacting),
    FIELD(asperity_state, attracted),           FIELD(asperity_state, attraction_load),
    FIELD(asperity_state, mean_contact_radius), FIELD(asperity_state, max_contact_radius),
    FIELD(asperity_state, fraction_below_slip_radius_1), FIELD(asperity_state, fraction_between_slip_radii),
    FIELD(asperity_state, fraction_above_slip_radius_2), FIELD(asperity_state, fraction_in_contact),
    FIELD(asperity_state, mean_asperity_pressure), FIELD(asperity_state, plasticity_index),
    FIELD(asperity_state, warnings),            FIELD(asperity_state, tangential_stiffness),
    FIELD(asperity_state, fraction_elastic),    FIELD(asperity_state, fraction_flowing),
    FIELD(asperity_state, contact_radius_sum),  FIELD(asperity_state, hertz_load),
    FIELD(asperity_state, friction_scatter),    FIELD(asperity_state, friction_bias),
};

static const field SUMMARY[] = {
    FIELD(asperity_summary, struct_size),       FIELD(asperity_summary, alpha),
    FIELD(asperity_summary, beta),              FIELD(asperity_summary, gamma),
    FIELD(asperity_summary, lambda),            FIELD(asperity_summary, skew),
    FIELD(asperity_summary, kurtosis),          FIELD(asperity_summary, pull_off_load),
    FIELD(asperity_summary, pull_off_friction_force), FIELD(asperity_summary, zero_load_friction_force),
    FIELD(asperity_summary, min_table_load),    FIELD(asperity_summary, max_table_load),
    FIELD(asperity_summary, table_error),
};

static int failures;

static void expect(int holds, const char *what)
{
    if (!holds) {
        fprintf(stderr, "does not hold: %s\n", what);
        failures++;
    }
}

static void expect_near(const char *what, double value, double expected, double tolerance)
{
    if (!(fabs(value - expected) <= tolerance * fabs(expected))) {
        fprintf(stderr, "%s = %.17g, must be %.17g\n", what, value, expected);
        failures++;
    }
}

static void require_ok(asperity_status status, const char *call)
{
    if (status != ASPERITY_OK) {
        char message[256];
        asperity_last_error(message, sizeof message);
        fprintf(stderr, "%s: %s\n", call, message);
        exit(1);
    }
}

static asperity_model *create(const asperity_params *params)
{
    asperity_model *model = NULL;

    require_ok(asperity_create(params, &model), "asperity_create");
    return model;
}

/* ---- Layout ---- */

static void fields_fill_the_struct(const field *fields, size_t count, size_t size)
{
    size_t end = 0;

    for (size_t i = 0; i < count; i++) {
        expect(fields[i].offset == end, fields[i].name);
        end += fields[i].size;
    }
    expect(end == size, "the fields fill the struct");
}

/* ---- Inputs ---- */

static int32_t heights_that_read(const field *f)
{
    if (f->offset >= offsetof(asperity_params, table_height))
        return ASPERITY_HEIGHTS_TABULATED;
    if (f->offset == offsetof(asperity_params, skew) || f->offset == offsetof(asperity_params, kurtosis))
        return ASPERITY_HEIGHTS_JOHNSON;
    return ASPERITY_HEIGHTS_WEIBULL;
}

static void library_names_the_field_made_invalid(const field *f)
{
    const double height[] = { 0, 1, 2, 3, 4 }, density[] = { 0, 1, 2, 1, 0 };
    const double not_a_number = NAN;
    const int32_t no_choice = 77;
    const int is_pointer = f->offset == offsetof(asperity_params, table_height) ||
                           f->offset == offsetof(asperity_params, table_density);
    /* The bits of NaN are a length beyond what is taken. */
    const int is_length = f->offset == offsetof(asperity_params, table_length);
    const asperity_status refusal = is_pointer ? ASPERITY_NULL_POINTER
                                    : is_length ? ASPERITY_OUT_OF_RANGE
                                                : ASPERITY_INVALID_PARAMETER;
    asperity_params params;
    asperity_model *model = NULL;
    char message[256], begin[64];

    asperity_params_init(&params);
    params.height_distribution = heights_that_read(f);
    params.radius_amplitude = 0.5;
    params.table_height = height;
    params.table_density = density;
    params.table_length = COUNT(height);
    if (is_pointer)
        memset((char *)&params + f->offset, 0, f->size);
    else if (f->size == sizeof no_choice)
        memcpy((char *)&params + f->offset, &no_choice, sizeof no_choice);
    else
        memcpy((char *)&params + f->offset, &not_a_number, sizeof not_a_number);
    expect(asperity_create(&params, &model) == refusal, f->name);
    asperity_last_error(message, sizeof message);
    snprintf(begin, sizeof begin, is_pointer ? "%s is NULL: " : "%s = ", f->name);
    expect(strncmp(message, begin, strlen(begin)) == 0, f->name);
}

static void library_finds_every_parameter(void)
{
    asperity_params params;

    asperity_params_init(&params);
    expect(params.struct_size == sizeof params, "asperity_params_init sets the size of the header's struct");
    for (size_t i = 0; i < COUNT(PARAMS); i++)
        library_names_the_field_made_invalid(&PARAMS[i]);
}

/* ---- Outputs ---- */

/* An output struct of a program compiled against an older header, which ended at any of the fields. */
static void nothing_is_written_past_struct_size(const asperity_model *model)
{
    for (size_t i = 1; i < COUNT(STATE); i++) {
        unsigned char bytes[sizeof(asperity_state)];
        const uint64_t size = STATE[i].offset + STATE[i].size;

        memset(bytes, 0xA5, sizeof bytes);
        memcpy(bytes, &size, sizeof size);
        require_ok(asperity_state_at_load(model, 1.0, (asperity_state *)(void *)bytes), "asperity_state_at_load");
        for (size_t k = size; k < sizeof bytes; k++)
            expect(bytes[k] == 0xA5, STATE[i].name);
        for (size_t k = 1; k <= i; k++)
            expect(memcmp(bytes + STATE[k].offset, "\xA5\xA5\xA5\xA5\xA5\xA5\xA5\xA5", 8) != 0, STATE[k].name);
    }
}

static void state_fields_hold_their_quantities(void)
{
    const double modulus = 2 / (1 - 0.3), shear = 2;    /* E* and G* of the default case */
    asperity_params params;
    asperity_state state, other;
    asperity_model *model;
    double mu_slope, force_slope;

    asperity_params_init(&params);
    params.hardness = 0.02;
    model = create(&params);
    state.struct_size = other.struct_size = sizeof state;
    require_ok(asperity_state_at_separation(model, params.height_std, &state), "asperity_state_at_separation");
    expect_near("separation", state.separation, 10.0, 1e-15);    /* sigma = alpha beta */
    expect_near("load", state.load, 939.4461111241189 * modulus, 1e-7);
    expect_near("friction_force", state.friction_force, 1711.9722909384257 * shear, 1e-7);
    expect_near("friction_coefficient", state.friction_coefficient, state.friction_force / state.load, 1e-14);
    expect_near("dforce_dload", state.dforce_dload, 1.5229765753034687 * shear / modulus, 1e-6);
    expect_near("dmu_dload", state.dmu_dload, (state.dforce_dload - state.friction_coefficient) / state.load, 1e-12);
    expect_near("dload_dseparation", state.dload_dseparation, -1985.457342351477 * modulus / 10, 1e-6);
    expect_near("real_area", state.real_area, 318699.2525830931, 1e-7);
    expect_near("contacting", state.contacting, 0.17776420898559706, 1e-7);
    expect_near("attraction_load", state.attraction_load, -2.1044486779808658 * modulus, 1e-6);
    expect_near("fraction_in_contact", state.fraction_in_contact, state.contacting, 1e-15);    /* N = 1 */
    expect_near("mean_asperity_pressure", state.mean_asperity_pressure,
                (state.load - state.attraction_load) / state.real_area, 1e-12);
    expect_near("regimes", state.fraction_below_slip_radius_1 + state.fraction_between_slip_radii +
                               state.fraction_above_slip_radius_2, 1, 1e-12);
    expect(state.fraction_between_slip_radii > state.fraction_below_slip_radius_1, "most contacts are wider than 28 b");
    expect(state.fraction_above_slip_radius_2 == 0, "and none than 8e4 b");
    expect(state.mean_contact_radius > 0 && state.mean_contact_radius < sqrt(state.real_area / state.contacting / 3.14159),
           "the mean radius is below that of the mean area");
    expect(state.max_contact_radius == state.mean_contact_radius, "the largest of one contact or less is the mean");
    expect_near("plasticity_index", state.plasticity_index, modulus / params.hardness * 0.01, 1e-14);
    expect((state.warnings & ASPERITY_WARNING_PLASTIC) != 0 && (state.warnings & ASPERITY_WARNING_CROWDED) == 0,
           "a plasticity index above 1 warns; that 18 % of the summits touch does not where loads are those of one");
    expect_near("contact_radius_sum", state.contact_radius_sum, state.contacting * state.mean_contact_radius, 1e-12);
    expect(state.hertz_load > state.load, "adhesion presses too");
    expect(state.friction_scatter == 0 && state.friction_bias == 0, "one summit has no scatter");
    expect(state.attracted > 0 && state.attracted < 1 - state.contacting, "some of the other summits are attracted");

    require_ok(asperity_state_at_load(model, state.load, &other), "asperity_state_at_load");
    expect_near("separation at that load", other.separation, state.separation, 1e-9);
    require_ok(asperity_friction_at_loads(model, 1, &state.load, NULL, &mu_slope), "asperity_friction_at_loads");
    require_ok(asperity_friction_force_at_loads(model, 1, &state.load, NULL, &force_slope),
               "asperity_friction_force_at_loads");
    expect_near("slope of the coefficient", mu_slope, state.dmu_dload, 1e-6);
    expect_near("slope of the force", force_slope, state.dforce_dload, 1e-6);
    nothing_is_written_past_struct_size(model);
    asperity_free(model);
}

/* The law goes on as a power: near to exact states above the table, as the root of the distance to pull-off below it. */
static void force_beyond_the_table(const asperity_model *model, double load, double tolerance)
{
    asperity_state state;

    state.struct_size = sizeof state;
    require_ok(asperity_state_at_load(model, load, &state), "asperity_state_at_load");
    expect_near("force beyond the table", asperity_friction_force_at_load(model, load), state.friction_force, tolerance);
}

static void summary_fields_hold_their_quantities(void)
{
    const double pi = 3.14159265358979324;
    asperity_params params;
    asperity_summary s;
    asperity_model *model;

    asperity_params_init(&params);
    require_ok(asperity_params_set_dimensionless(&params, 0.02, 500, 0.002, 0.8, 0.25), "set_dimensionless");
    params.height_distribution = ASPERITY_HEIGHTS_WEIBULL;
    params.weibull_shape = 2;    /* Rayleigh's distribution */
    model = create(&params);
    s.struct_size = sizeof s;
    require_ok(asperity_summary_of(model, &s), "asperity_summary_of");
    expect_near("alpha", s.alpha, 0.02, 1e-14);
    expect_near("beta", s.beta, 500, 1e-14);
    expect_near("gamma", s.gamma, 0.002, 1e-14);
    expect_near("lambda", s.lambda, cbrt(0.8 * 0.8 * 0.8 * 9 * 500 * 0.002 * 0.002 / (2 * pi * 0.02)), 1e-12);
    expect_near("skew", s.skew, 2 * sqrt(pi) * (pi - 3) / pow(4 - pi, 1.5), 1e-12);
    expect_near("kurtosis", s.kurtosis, 3 - (6 * pi * pi - 24 * pi + 16) / ((4 - pi) * (4 - pi)), 1e-12);
    expect(s.pull_off_load < 0, "adhesion holds against a pull");
    expect(asperity_friction_force_at_load(model, s.pull_off_load * (1 + 1e-15)) == 0, "separated below pull-off");
    expect_near("pull_off_friction_force", s.pull_off_friction_force,
                asperity_friction_force_at_load(model, s.pull_off_load), 1e-9);
    expect_near("zero_load_friction_force", s.zero_load_friction_force, asperity_friction_force_at_load(model, 0),
                1e-9);
    expect(s.pull_off_friction_force < s.zero_load_friction_force, "friction grows with load");
    expect(s.pull_off_load < s.min_table_load && s.min_table_load < s.max_table_load, "the table covers a range");
    expect(s.table_error > 0 && s.table_error < 1e-6, "the table's error was measured");
    force_beyond_the_table(model, s.pull_off_load + 0.5 * (s.min_table_load - s.pull_off_load), 0.01);
    force_beyond_the_table(model, 1.5 * s.max_table_load, 1e-4);
    asperity_free(model);
}

int main(void)
{
    feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
    fields_fill_the_struct(PARAMS, COUNT(PARAMS), sizeof(asperity_params));
    fields_fill_the_struct(STATE, COUNT(STATE), sizeof(asperity_state));
    fields_fill_the_struct(SUMMARY, COUNT(SUMMARY), sizeof(asperity_summary));
    library_finds_every_parameter();
    state_fields_hold_their_quantities();
    summary_fields_hold_their_quantities();
    return failures != 0;
}
