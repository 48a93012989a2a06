/* A solver may run with floating-point traps on: the whole interface, given good and bad input, raises none of
 * invalid, divide-by-zero, overflow; nor underflow, for loads that are 0 or at least 1e-300. A trap ends the program with
 * the name of the call. Calls that answer from the compiled law set the flag "inexact", and no call another. */

#define _GNU_SOURCE
#include <asperity.h>

#include <fenv.h>
#include <limits.h>
#include <math.h>
#include <signal.h>
#include <stdint.h>
#include <stdlib.h>
#include <unistd.h>

#include "check.h"
#include "surfaces.h"

enum { SPECIALS = 25, TRAPS = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW };

/* Calls that compute in the caller's environment. */
static const char *const compiled[] = {
    "asperity_friction_at_load", "asperity_friction_force_at_load", "asperity_friction_at_loads",
    "asperity_friction_force_at_loads", "asperity_friction_and_slope_at_load", "asperity_friction_force_and_slope_at_load",
    "asperity_load_at_gap", "asperity_load_and_slope_at_gap", "asperity_loads_at_gaps",
    "asperity_friction_force_at_loads_of", "asperity_friction_at_pressure", "asperity_shear_stress_at_pressure",
    "asperity_slip_force", "asperity_tangential_stiffness_at_load", "asperity_tangential_stiffness_at_loads",
    "asperity_contact_radius_sum_at_load",
};

static double specials[SPECIALS];
/* Whether underflow is trapped too. */
static int trapping_underflow;
static volatile const char *volatile doing = "nothing yet";

static void trapped(int signal_number)
{
    const char *text = (const char *)doing;
    (void)signal_number;
    if (write(STDERR_FILENO, "floating-point trap in: ", 24) < 0 || write(STDERR_FILENO, text, strlen(text)) < 0 ||
        write(STDERR_FILENO, "\n", 1) < 0)
        _exit(3);
    _exit(2);
}

static double from_bits(uint64_t bits)
{
    double number;
    memcpy(&number, &bits, sizeof number);
    return number;
}

static void list_specials(void)
{
    const double ordinary[] = { 0.0, -0.0, 5e-324, -5e-324, 2.2250738585072014e-308, 1e-300, 1e-100, 1e-20, 1.0, -1.0,
                                -1e-3, 1e20, 1e100, 1e155, -1e155, 1e300, -1e300, 1.7976931348623157e308,
                                -1.7976931348623157e308 };
    const uint64_t bits[] = { UINT64_C(0x7ff0000000000000), UINT64_C(0xfff0000000000000),   /* infinities */
                              UINT64_C(0x7ff8000000000000), UINT64_C(0xfff8000000000000),   /* quiet NaN */
                              UINT64_C(0x7ff0000000000001), UINT64_C(0xfff4000000000000) }; /* signalling NaN */
    int n = 0;
    for (size_t i = 0; i < sizeof ordinary / sizeof *ordinary; i++)
        specials[n++] = ordinary[i];
    for (size_t i = 0; i < sizeof bits / sizeof *bits; i++)
        specials[n++] = from_bits(bits[i]);
    CHECK(n == SPECIALS, "%d special numbers are listed", n);
}

/* Begins another call, and says what flags the one before must not have set, of numbers that are tiny or not. */
static void call(const char *name, int is_tiny)
{
    const char *before = (const char *)doing;
    const int flags = fetestexcept(FE_ALL_EXCEPT);
    int allowed = 0;

    for (size_t i = 0; i < sizeof compiled / sizeof *compiled; i++)
        if (strcmp(before, compiled[i]) == 0)
            allowed = FE_INEXACT | (is_tiny ? FE_UNDERFLOW : 0);
    CHECK(strcmp(before, "between calls") == 0 || (flags & ~allowed) == 0, "%s: flags %#x", before, (unsigned)flags);
    feclearexcept(FE_ALL_EXCEPT);
    doing = name;
}

/* Not 0, and so small that products of it with numbers of a size underflow; told without arithmetic. */
static int is_tiny(double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits << 1 != 0 && (bits << 1 >> 1) < UINT64_C(0x01a56e1fc2f8f359); /* 1e-300 */
}

/* A special value as load, as displacement and in the state. */
static void microslip_at(const asperity_model *model, double x, int tiny)
{
    asperity_microslip out;
    double loads[2] = { 1.0, 1.0 }, by[4] = { 1e-3, -2e-3, 1.0, 2.0 }, states[84] = { 0.0 }, after[84], force[4], slope[8];

    out.struct_size = sizeof out;
    CHECK(asperity_microslip_length(model) == 42, "a state of another length");
    for (int which = 0; which < 5; which++) {
        double *where = which == 0 ? &loads[0] : which == 1 ? &by[1] : &states[which == 2 ? 5 : 37 + which], before = *where;
        memcpy(where, &x, sizeof x);
        call("asperity_microslip_step", tiny);
        asperity_microslip_step(model, loads[0], by, states, after, &out);
        call("asperity_microslip_steps", tiny);
        asperity_microslip_steps(model, 2, loads, by, states, after, force, slope);
        call("asperity_microslip_turn", tiny);
        asperity_microslip_turn(states, loads[0], 0.5);
        *where = before;
    }
}

/* Every evaluation at one number, taken as a load and as a separation. */
static void evaluate_at(const asperity_model *model, double x)
{
    const int tiny = is_tiny(x);
    asperity_state state;
    asperity_sensitivities sensitivities;
    double out[2], slope[2], radius[2], in[2];
    uint64_t warnings;

    if (trapping_underflow && tiny)
        return;
    memcpy(&in[0], &x, sizeof x);
    in[1] = 1.0;
    doing = "between calls";
    call("asperity_friction_at_load", tiny);
    asperity_friction_at_load(model, x);
    call("asperity_friction_force_at_load", tiny);
    asperity_friction_force_at_load(model, x);
    call("asperity_friction_and_slope_at_load", tiny);
    asperity_friction_and_slope_at_load(model, x, slope);
    call("asperity_friction_force_and_slope_at_load", tiny);
    asperity_friction_force_and_slope_at_load(model, x, slope);
    call("asperity_friction_at_pressure", tiny);
    asperity_friction_at_pressure(model, x, 0.7, slope);
    call("asperity_shear_stress_at_pressure", tiny);
    asperity_shear_stress_at_pressure(model, x, 0.7, slope);
    call("asperity_slip_force", tiny);
    asperity_slip_force(model, x, 1e-3, 1e-3, slope, radius);
    call("asperity_tangential_stiffness_at_load", tiny);
    asperity_tangential_stiffness_at_load(model, x);
    call("asperity_contact_radius_sum_at_load", tiny);
    asperity_contact_radius_sum_at_load(model, x);
    call("asperity_tangential_stiffness_at_loads", tiny);
    asperity_tangential_stiffness_at_loads(model, 2, in, out);
    call("asperity_contact_radius_sum_at_loads", tiny);
    asperity_contact_radius_sum_at_loads(model, 2, in, out, slope);
    call("asperity_tangential_at_load", tiny);
    asperity_tangential_at_load(model, x, 1e-9, out, slope);
    call("asperity_tangential_at_load", tiny);
    asperity_tangential_at_load(model, 1.0, x, out, slope);
    call("asperity_friction_at_loads", tiny);
    asperity_friction_at_loads(model, 2, in, out, slope);
    call("asperity_friction_force_at_loads", tiny);
    asperity_friction_force_at_loads(model, 2, in, out, slope);
    state.struct_size = sizeof state;
    call("asperity_state_at_load", tiny);
    asperity_state_at_load(model, x, &state);
    call("asperity_state_at_gap", tiny);
    asperity_state_at_gap(model, x, &state);
    sensitivities.struct_size = sizeof sensitivities;
    call("asperity_sensitivities_at_load", tiny);
    asperity_sensitivities_at_load(model, x, &sensitivities);
    call("asperity_check_loads", tiny);
    asperity_check_loads(model, x, x, &warnings);
    call("asperity_summits_at_overlaps", tiny);
    asperity_summits_at_overlaps(model, 2, in, in, out, slope, radius);
    microslip_at(model, x, tiny);
    call("asperity_load_at_gap", tiny);
    asperity_load_at_gap(model, x);
    call("asperity_load_and_slope_at_gap", tiny);
    asperity_load_and_slope_at_gap(model, x, slope);
    call("asperity_loads_at_gaps", tiny);
    asperity_loads_at_gaps(model, 2, in, out, slope);
    call("asperity_friction_force_at_loads_of", tiny);
    {
        const uint32_t which[] = {0, 1};
        asperity_friction_force_at_loads_of(&model, 1, 2, which, in, out, slope);
        asperity_friction_force_at_loads_of(&model, 1, 2, which, in, out, NULL);
    }
    call("asperity_friction_at_pressures", tiny);
    asperity_friction_at_pressures(model, 2, in, 0.7, out, slope);
    asperity_friction_at_pressures(model, 2, in, x, out, slope);
    call("asperity_shear_stresses_at_pressures", tiny);
    asperity_shear_stresses_at_pressures(model, 2, in, 0.7, out, slope);
    call("asperity_slip_forces", tiny);
    asperity_slip_forces(model, 2, in, in, 0.7, out, slope, radius);
    asperity_slip_forces(model, 2, in, in, x, out, slope, radius);
    call("between calls", tiny);
}

static void evaluate(const asperity_model *model)
{
    asperity_summary summary;
    double pull_off;

    summary.struct_size = sizeof summary;
    doing = "asperity_summary_of";
    CHECK(asperity_summary_of(model, &summary) == ASPERITY_OK, "asperity_summary_of");
    pull_off = summary.pull_off_load;
    doing = "between calls";
    for (int i = 0; i < SPECIALS; i++)
        evaluate_at(model, specials[i]);
    {
        /* Some are tiny, which the program's own arithmetic may make. */
        const int traps = fedisableexcept(FE_UNDERFLOW);
        const double edges[] = {
            pull_off, nextafter(pull_off, INFINITY), nextafter(pull_off, -INFINITY), 2 * pull_off, 0.5 * pull_off,
            0.999999999999 * pull_off, summary.min_table_load, nextafter(summary.min_table_load, -INFINITY),
            summary.max_table_load, nextafter(summary.max_table_load, INFINITY),
            summary.max_table_load < 1e300 ? 2 * summary.max_table_load : 1e300,
        };
        uint64_t warnings;
        feclearexcept(FE_ALL_EXCEPT);
        feenableexcept(traps);
        doing = "asperity_check_loads";
        asperity_check_loads(model, pull_off < 0 ? pull_off : summary.min_table_load, summary.max_table_load, &warnings);
        asperity_check_loads(model, 2, 1, &warnings);
        doing = "asperity_warning_loads";
        double ends[2];
        for (int bit = 0; bit < 9; bit++)
            asperity_warning_loads(model, UINT64_C(1) << bit, &ends[0], &ends[1]);
        feclearexcept(FE_ALL_EXCEPT);
        for (size_t i = 0; i < sizeof edges / sizeof *edges; i++)
            evaluate_at(model, edges[i]);
    }
}

/* Makes a model if it can be made, evaluates it, and gives the parameters to another model. */
static int try_params(const asperity_params *p, asperity_model *other, int thoroughly)
{
    asperity_model *model = NULL;
    asperity_status made;

    doing = "asperity_create";
    made = asperity_create(p, &model);
    if (made == ASPERITY_OK) {
        if (thoroughly)
            evaluate(model);
        else
            evaluate_at(model, 1.0);
    }
    doing = "asperity_free";
    asperity_free(model);
    if (other != NULL) {
        doing = "asperity_set_params";
        CHECK(asperity_set_params(other, p) == made, "create gives %d, set_params another status", made);
    }
    doing = "between calls";
    return made == ASPERITY_OK;
}

static void every_surface(void)
{
    for (int i = 0; i < SURFACES; i++) {
        const asperity_params p = surface(i);
        CHECK(try_params(&p, NULL, 1), "%s: no model", SURFACE_NAMES[i]);
    }
}

/* Each number of the parameters in turn takes each special value. */
static void special_parameters(void)
{
    static const size_t offsets[] = {
        offsetof(asperity_params, composite_modulus), offsetof(asperity_params, effective_shear_modulus),
        offsetof(asperity_params, work_of_adhesion), offsetof(asperity_params, adhesion_range),
        offsetof(asperity_params, burgers_vector), offsetof(asperity_params, height_std),
        offsetof(asperity_params, summit_radius), offsetof(asperity_params, asperity_count),
        offsetof(asperity_params, weibull_shape), offsetof(asperity_params, radius_amplitude),
        offsetof(asperity_params, radius_rate), offsetof(asperity_params, slip_radius_1),
        offsetof(asperity_params, slip_stress_1), offsetof(asperity_params, slip_radius_2),
        offsetof(asperity_params, slip_stress_2), offsetof(asperity_params, max_friction_coefficient),
        offsetof(asperity_params, skew), offsetof(asperity_params, kurtosis), offsetof(asperity_params, hardness),
    };
    const asperity_params first = surface(0);
    asperity_model *other = NULL;

    CHECK(asperity_create(&first, &other) == ASPERITY_OK, "no model of the default case");
    for (size_t k = 0; k < sizeof offsets / sizeof *offsets; k++)
        for (int i = 0; i < SPECIALS; i++) {
            asperity_params p = surface(offsets[k] == offsetof(asperity_params, weibull_shape) ? 4 : 0);
            if (offsets[k] == offsetof(asperity_params, skew) || offsets[k] == offsetof(asperity_params, kurtosis))
                p.height_distribution = ASPERITY_HEIGHTS_JOHNSON;
            memcpy((char *)&p + offsets[k], &specials[i], sizeof(double));
            try_params(&p, other, 0);
        }
    asperity_free(other);
}

static void special_integers(void)
{
    const int32_t integers[] = { INT32_MIN, -1, 4, 5, 1000, INT32_MAX };
    const uint64_t sizes[] = { 0, 1, 8, offsetof(asperity_params, skew) - 8, sizeof(asperity_params) - 1,
                               sizeof(asperity_params) + 1, sizeof(asperity_params) + 8, UINT64_MAX };

    for (size_t i = 0; i < sizeof integers / sizeof *integers; i++) {
        asperity_params p = surface(0);
        p.height_distribution = integers[i];
        CHECK(!try_params(&p, NULL, 0), "height_distribution %d is accepted", integers[i]);
        p = surface(0);
        p.attraction = integers[i];
        CHECK(!try_params(&p, NULL, 0), "attraction %d is accepted", integers[i]);
        doing = "asperity_status_string";
        CHECK(asperity_status_string(integers[i]) != NULL, "status %d has no string", integers[i]);
    }
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        asperity_params p = surface(0);
        p.struct_size = sizes[i];
        CHECK(!try_params(&p, NULL, 0), "struct_size %llu is accepted", (unsigned long long)sizes[i]);
    }
}

/* Each argument of each setter in turn takes each special value. */
static void special_setter_arguments(void)
{
    for (int i = 0; i < SPECIALS; i++) {
        double x[5];
        for (int k = 0; k < 5; k++) {
            asperity_params p = surface(0);
            const double groups[5] = { 0.01, 1000, 0.001, 1, 0.3 };
            memcpy(x, groups, sizeof x);
            memcpy(&x[k], &specials[i], sizeof *x);
            doing = "asperity_params_set_dimensionless";
            asperity_params_set_dimensionless(&p, x[0], x[1], x[2], x[3], x[4]);
        }
        for (int k = 0; k < 4; k++) {
            asperity_params p = surface(0);
            const double materials[4] = { 200e9, 0.3, 70e9, 0.34 };
            memcpy(x, materials, 4 * sizeof *x);
            memcpy(&x[k], &specials[i], sizeof *x);
            doing = "asperity_params_set_materials";
            asperity_params_set_materials(&p, x[0], x[1], x[2], x[3]);
        }
        for (int k = 0; k < 4; k++) {
            asperity_params p = surface(0);
            const double moments[4] = { 3, 0.5, 0.7, 11 };
            memcpy(x, moments, sizeof moments);
            memcpy(&x[k], &specials[i], sizeof *x);
            doing = "asperity_params_set_spectral_moments";
            asperity_params_set_spectral_moments(&p, x[0], x[1], x[2], x[3]);
            doing = "asperity_params_set_mccool_summits";
            asperity_params_set_mccool_summits(&p, x[0], x[1], x[2], x[3]);
        }
        {
            asperity_params p = surface(0);
            doing = "asperity_params_set_skew";
            asperity_params_set_skew(&p, specials[i]);
            doing = "asperity_params_set_elastic_plastic";
            asperity_params_set_elastic_plastic(&p, specials[i]);
        }
        for (size_t name = 0; asperity_pair_name(name) != NULL; name++) {
            asperity_params p = surface(0);
            doing = "asperity_params_set_pair";
            asperity_params_set_pair(&p, asperity_pair_name(name));
        }
        for (size_t name = 0; asperity_interface_name(name) != NULL; name++) {
            asperity_params p = surface(0);
            p.effective_shear_modulus = specials[i];
            doing = "asperity_params_set_interface";
            asperity_params_set_interface(&p, asperity_interface_name(name));
        }
        for (size_t name = 0; asperity_params_name(name) != NULL; name++) {
            asperity_params p = surface(0);
            doing = "asperity_params_set_value";
            asperity_params_set_value(&p, asperity_params_name(name), specials[i]);
            doing = "asperity_params_get_value";
            asperity_params_get_value(&p, asperity_params_name(name), x);
        }
    }
    doing = "between calls";
}

/* NULL wherever a pointer is taken. */
static void null_pointers(void)
{
    asperity_params p = surface(0);
    asperity_model *model = NULL;
    asperity_state state;
    asperity_summary summary;
    asperity_sensitivities sensitivities;
    uint64_t warnings;
    double x = 1.0, y = 1.0;
    char message[8];

    state.struct_size = sizeof state;
    summary.struct_size = sizeof summary;
    sensitivities.struct_size = sizeof sensitivities;
    doing = "a call with NULL";
    CHECK(asperity_create(&p, &model) == ASPERITY_OK, "no model");
#define REFUSES(call) CHECK((call) == ASPERITY_NULL_POINTER, "NULL is not refused")
    REFUSES(asperity_params_init(NULL, sizeof p));
    REFUSES(asperity_params_set_elastic_plastic(NULL, 1));
    REFUSES(asperity_params_calibrate(NULL, 1, 1));
    REFUSES(asperity_params_calibrate_force(NULL, 1, 1));
    REFUSES(asperity_params_set_spectral_moments(NULL, 3, 0.5, 0.7, 11));
    REFUSES(asperity_params_set_mccool_summits(NULL, 3, 0.5, 0.7, 11));
    REFUSES(asperity_params_set_dimensionless(NULL, 0.01, 1000, 0.001, 1, 0.3));
    REFUSES(asperity_params_set_materials(NULL, 1, 0.3, 1, 0.3));
    REFUSES(asperity_params_set_skew(NULL, 0));
    REFUSES(asperity_params_set_value(NULL, "skew", 0));
    REFUSES(asperity_params_set_value(&p, NULL, 0));
    REFUSES(asperity_params_set_values(NULL, 0, NULL, NULL));
    REFUSES(asperity_params_set_values(&p, 1, NULL, &x));
    REFUSES(asperity_params_get_value(NULL, "skew", &x));
    REFUSES(asperity_params_get_value(&p, NULL, &x));
    REFUSES(asperity_params_get_value(&p, "skew", NULL));
    REFUSES(asperity_params_set_pair(NULL, "Si/Si"));
    REFUSES(asperity_params_set_pair(&p, NULL));
    REFUSES(asperity_params_set_interface(NULL, "graphite layers"));
    REFUSES(asperity_params_set_interface(&p, NULL));
    REFUSES(asperity_material("Si", NULL));
    REFUSES(asperity_pair("Si/Si", NULL));
    REFUSES(asperity_interface("graphite layers", NULL));
    REFUSES(asperity_create(NULL, &model));
    REFUSES(asperity_create(&p, NULL));
    REFUSES(asperity_create(NULL, NULL));
    REFUSES(asperity_set_params(NULL, &p));
    REFUSES(asperity_set_params(model, NULL));
    REFUSES(asperity_get_params(NULL, &p));
    REFUSES(asperity_get_params(model, NULL));
    REFUSES(asperity_friction_at_loads(NULL, 1, &x, &y, NULL));
    REFUSES(asperity_friction_at_loads(model, 1, NULL, &y, NULL));
    REFUSES(asperity_friction_force_at_loads(NULL, 1, &x, &y, NULL));
    REFUSES(asperity_friction_force_at_loads(model, 1, NULL, &y, NULL));
    REFUSES(asperity_state_at_load(NULL, 1, &state));
    REFUSES(asperity_state_at_load(model, 1, NULL));
    REFUSES(asperity_state_at_gap(NULL, 1, &state));
    REFUSES(asperity_summits_at_overlaps(NULL, 1, &x, NULL, &y, NULL, NULL));
    REFUSES(asperity_summits_at_overlaps(model, 1, NULL, NULL, &y, NULL, NULL));
    REFUSES(asperity_state_at_gap(model, 1, NULL));
    REFUSES(asperity_check_loads(NULL, 1, 2, &warnings));
    REFUSES(asperity_check_loads(model, 1, 2, NULL));
    REFUSES(asperity_warning_loads(NULL, 64, &x, &y));
    REFUSES(asperity_warning_loads(model, 64, NULL, &y));
    REFUSES(asperity_warning_loads(model, 64, &x, NULL));
    REFUSES(asperity_summary_of(NULL, &summary));
    REFUSES(asperity_summary_of(model, NULL));
    REFUSES(asperity_sensitivities_at_load(NULL, 1, &sensitivities));
    REFUSES(asperity_sensitivities_at_load(model, 1, NULL));
#undef REFUSES
    CHECK(isnan(asperity_friction_at_load(NULL, 1)), "a NULL model has a friction coefficient");
    CHECK(isnan(asperity_friction_force_at_load(NULL, 1)), "a NULL model has a friction force");
    CHECK(asperity_last_error(NULL, 0) > 0 && asperity_last_error(NULL, 99) > 0, "no message");
    asperity_last_error(message, sizeof message);
    asperity_free(NULL);
    asperity_free(model);
    doing = "between calls";
}

static double uniform(uint64_t *state, double lower, double upper)
{
    *state = *state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return lower + (upper - lower) * ((double)(*state >> 11) / 9007199254740992.0);
}

/* Surfaces from nanometres to a tenth of a millimetre, hard and soft, drawn with a fixed seed. */
static void random_surfaces(int count)
{
    uint64_t seed = 20050;
    int made = 0;

    for (int i = 0; i < count; i++) {
        asperity_params p;
        asperity_params_init(&p, sizeof p);
        asperity_params_set_dimensionless(&p, pow(10, uniform(&seed, -2.5, -0.5)), pow(10, uniform(&seed, 1.0, 5.0)),
                                          pow(10, uniform(&seed, -6.0, -2.0)), pow(10, uniform(&seed, -0.5, 0.5)), 0.3);
        p.asperity_count = pow(10, uniform(&seed, -3, 12));
        p.attraction = i % 4 != 0;
        if (i % 3 == 1)
            p.radius_amplitude = uniform(&seed, -1, 1);
        if (i % 3 == 2) {
            p.height_distribution = ASPERITY_HEIGHTS_WEIBULL;
            p.weibull_shape = pow(10, uniform(&seed, 0.1, 3));
        }
        feclearexcept(FE_ALL_EXCEPT);
        made += try_params(&p, NULL, 1);
    }
    printf("traps: %d of %d random surfaces have a model\n", made, count);
    CHECK(2 * made > count, "only %d of %d random surfaces have a model", made, count);
}

int main(void)
{
    list_specials();
    signal(SIGFPE, trapped);
    if (feenableexcept(TRAPS) == -1) {
        fprintf(stderr, "traps: this machine cannot trap floating-point exceptions\n");
        return 1;
    }
    every_surface();
    feenableexcept(FE_UNDERFLOW);
    trapping_underflow = 1;
    every_surface();
    fedisableexcept(FE_UNDERFLOW);
    trapping_underflow = 0;
    special_parameters();
    special_integers();
    special_setter_arguments();
    null_pointers();
    random_surfaces(30);
    CHECK(fetestexcept(TRAPS) == 0, "flags %#x are raised", fetestexcept(TRAPS));
    return checks_report("traps");
}
