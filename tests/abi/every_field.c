/* Every field of every struct but the table, which tests/c/eval.c reads. */

#include "fields.h"

SEEN_BYTES(params);
SEEN_BYTES(state);
SEEN_BYTES(summary);
SEEN_BYTES(microslip);

static const double PI = 3.14159265358979323846;

static asperity_state state_at(const asperity_model *model, double load)
{
    asperity_state state = { .struct_size = sizeof state };

    needs(asperity_state_at_load(model, load, &state));
    return state;
}

/* ---- Parameters: read by name, or named where they are refused ---- */

#define NUMBERS(F)                                                                                                     \
    F(composite_modulus) F(effective_shear_modulus) F(work_of_adhesion) F(adhesion_range) F(burgers_vector)            \
    F(height_std) F(summit_radius) F(asperity_count) F(height_distribution) F(attraction) F(weibull_shape)             \
    F(radius_amplitude) F(radius_rate) F(slip_radius_1) F(slip_stress_1) F(slip_radius_2) F(slip_stress_2)             \
    F(max_friction_coefficient) F(skew) F(kurtosis) F(hardness) F(tangential_modulus) F(nominal_area) F(contact_law)   \
    F(slip_onset) F(pressure_coefficient) F(bandwidth) F(calibration_load) F(calibration_friction_force)               \
    F(calibration_error) F(summit_mean_height) F(rms_slope)

static void parameters(void)
{
    const double height[] = { 0, 1, 2, 3, 4 }, density[] = { 0, 1, 2, 1, 0 };
    asperity_params p = paper(1);
    asperity_model *model = NULL;
    int number = 100;
    double value;

    HOLDS(params, p, struct_size, p.struct_size == sizeof p);
#define SET(field) p.field = number++;
#define READ(field)                                                                                                    \
    needs(asperity_params_get_value(&p, #field, &value));                                                              \
    NEAR(params, p, field, value, 0);
    NUMBERS(SET)
    /* Choices have few numbers: other ones for neighbours. */
    p.height_distribution = ASPERITY_HEIGHTS_JOHNSON, p.attraction = 0;
    p.contact_law = ASPERITY_CONTACT_ELASTIC_PLASTIC, p.slip_onset = ASPERITY_SLIP_PARTIAL;
    NUMBERS(READ)
    p = paper(1);
    p.height_distribution = ASPERITY_HEIGHTS_TABULATED;
    p.table_length = 2;
    HOLDS(params, p, table_length, asperity_create(&p, &model) == ASPERITY_INVALID_PARAMETER && says("table_length = 2"));
    p.table_length = 5;
    p.table_density = density;
    HOLDS(params, p, table_height, asperity_create(&p, &model) == ASPERITY_NULL_POINTER && says("table_height is NULL"));
    p.table_height = height;
    p.table_density = NULL;
    HOLDS(params, p, table_density, asperity_create(&p, &model) == ASPERITY_NULL_POINTER && says("table_density is NULL"));
    ALL_SEEN(params);
}

/* ---- The state: from calls of the solver's loop, and summed over single summits of Gaussian heights ---- */

typedef struct sums {
    double contacting, real_area, radii, below, between, above, attracted, attraction_load, hertz_load, variance, largest,
        elastic, flowing;
} sums;

static sums summed(const asperity_params *p, const asperity_model *model, const asperity_state *state)
{
    enum { HEIGHTS = 40000 };
    static double overlap[HEIGHTS], load[HEIGHTS], force[HEIGHTS], radius[HEIGHTS], number[HEIGHTS];
    const double sigma = p->height_std, step = 12 * sigma / HEIGHTS, slope = state->dforce_dload;
    /* The overlap of first yield, at which the mean pressure of Hertz' contact is 0.4 of the hardness. */
    const double yield = pow(0.3 * PI * p->hardness / p->composite_modulus, 2) * p->summit_radius;
    double tallest = 0;
    sums s = { .largest = 0 };

    for (int i = 0; i < HEIGHTS; i++) {
        const double height = -5 * sigma + (i + 0.5) * step, z = height / sigma;
        overlap[i] = height - state->gap;
        number[i] = p->asperity_count * exp(-z * z / 2) / sqrt(2 * PI) * step / sigma;
    }
    needs(asperity_summits_at_overlaps(model, HEIGHTS, overlap, NULL, load, force, radius));
    for (int i = 0; i < HEIGHTS; i++) {
        const double a = radius[i], n = a > 0 ? number[i] : 0, over = a / p->burgers_vector;
        s.contacting += n;
        s.real_area += n * PI * a * a;
        s.radii += n * a;
        s.hertz_load += n * 4 * p->composite_modulus * a * a * a / (3 * p->summit_radius);
        *(over < p->slip_radius_1 ? &s.below : over < p->slip_radius_2 ? &s.between : &s.above) += n;
        s.variance += number[i] * pow(force[i] - slope * load[i], 2);
        s.attracted += a == 0 && load[i] < 0 ? number[i] : 0;
        s.attraction_load += a == 0 ? number[i] * load[i] : 0;
        s.elastic += overlap[i] < yield ? n : 0;
        s.flowing += overlap[i] > 54 * yield ? n : 0;
    }
    for (int i = HEIGHTS; tallest < s.contacting / (s.contacting + 1);) {
        tallest += number[--i];
        s.largest = radius[i];
    }
    return s;
}

static void state_of_many_summits(void)
{
    const double load = 2e5;
    asperity_params p = paper(1000);
    asperity_model *model;
    asperity_state s;
    sums sum;
    double slope, mu_slope, n, expected;
    uint64_t warnings;

    p.slip_radius_1 = 200;
    p.slip_radius_2 = 400;
    p.slip_stress_2 = 0.01;
    p.hardness = 0.02 * p.composite_modulus;
    model = model_of(&p);
    s = state_at(model, load);
    sum = summed(&p, model, &s);
    n = sum.contacting;
    HOLDS(state, s, struct_size, s.struct_size == sizeof s);
    NEAR(state, s, load, load, 0);
    expected = asperity_load_and_slope_at_gap(model, s.gap, &slope);
    HOLDS(state, s, gap, fabs(expected / load - 1) < 1e-7);
    NEAR(state, s, dload_dgap, slope, 1e-5);
    NEAR(state, s, friction_force, asperity_friction_force_and_slope_at_load(model, load, &slope), 1e-9);
    NEAR(state, s, friction_coefficient, asperity_friction_and_slope_at_load(model, load, &mu_slope), 1e-9);
    NEAR(state, s, dforce_dload, slope, 1e-6);
    NEAR(state, s, dmu_dload, mu_slope, 1e-6);
    NEAR(state, s, tangential_stiffness, asperity_tangential_stiffness_at_load(model, load), 1e-8);
    NEAR(state, s, contacting, n, 1e-3);
    NEAR(state, s, real_area, sum.real_area, 1e-3);
    NEAR(state, s, contact_radius_sum, sum.radii, 1e-3);
    NEAR(state, s, mean_contact_radius, sum.radii / n, 1e-3);
    NEAR(state, s, max_contact_radius, sum.largest, 1e-3);
    NEAR(state, s, hertz_load, sum.hertz_load, 1e-3);
    NEAR(state, s, attracted, sum.attracted, 1e-2);
    NEAR(state, s, attraction_load, sum.attraction_load, 1e-2);
    NEAR(state, s, fraction_in_contact, n / p.asperity_count, 1e-3);
    NEAR(state, s, fraction_below_slip_radius_1, sum.below / n, 1e-2);
    NEAR(state, s, fraction_between_slip_radii, sum.between / n, 1e-2);
    NEAR(state, s, fraction_above_slip_radius_2, sum.above / n, 1e-2);
    NEAR(state, s, mean_asperity_pressure, (load - sum.attraction_load) / sum.real_area, 1e-3);
    NEAR(state, s, plasticity_index, p.composite_modulus / p.hardness * sqrt(p.height_std / p.summit_radius), 1e-12);
    /* For so many contacts the scatter is the first order; the bias is about 1.2 times it over the root of their number. */
    NEAR(state, s, friction_scatter, sqrt(sum.variance) / s.friction_force * n / (n + 2), 0.05);
    NEAR(state, s, friction_bias, 1.2 * sqrt(sum.variance) / s.friction_force / sqrt(n), 0.05);
    needs(asperity_check_loads(model, load, load, &warnings));
    HOLDS(state, s, warnings, s.warnings == warnings && warnings != 0);
    asperity_free(model);

    p = paper(1000);
    p.contact_law = ASPERITY_CONTACT_ELASTIC_PLASTIC;
    p.hardness = 0.002 * p.composite_modulus;
    p.work_of_adhesion = 0;
    model = model_of(&p);
    s = state_at(model, load);
    sum = summed(&p, model, &s);
    NEAR(state, s, fraction_elastic, sum.elastic / sum.contacting, 1e-2);
    NEAR(state, s, fraction_flowing, sum.flowing / sum.contacting, 1e-2);
    asperity_free(model);
    ALL_SEEN(state);
}

/* ---- The summary ---- */

static void summary(void)
{
    asperity_params p = paper(1);
    asperity_summary s = { .struct_size = sizeof s };
    asperity_model *model;
    asperity_table t = { .struct_size = sizeof t };
    double ends[2];

    needs(asperity_params_set_dimensionless(&p, 0.01, 1000, 0.02, 0.8, 0.25));
    p.height_distribution = ASPERITY_HEIGHTS_JOHNSON;
    p.skew = -0.4;
    p.kurtosis = 2.6;
    model = model_of(&p);
    needs(asperity_summary_of(model, &s));
    needs(asperity_table_of(model, ASPERITY_TABLE_FRICTION, &t));
    for (int end = 0; end < 2; end++) {
        const uint64_t bits = (t.base + (uint64_t)end * t.row_count) << t.shift;
        memcpy(&ends[end], &bits, sizeof bits);
    }
    HOLDS(summary, s, struct_size, s.struct_size == sizeof s);
    NEAR(summary, s, alpha, 0.01, 1e-12);
    NEAR(summary, s, beta, 1000, 1e-12);
    NEAR(summary, s, gamma, 0.02, 1e-12);
    NEAR(summary, s, lambda, cbrt(0.8 * 0.8 * 0.8 * 9 * 1000 * 0.02 * 0.02 / (2 * PI * 0.01)), 1e-12);
    NEAR(summary, s, skew, -0.4, 1e-9);
    NEAR(summary, s, kurtosis, 2.6, 1e-9);
    HOLDS(summary, s, pull_off_load, s.pull_off_load < 0 && asperity_friction_force_at_load(model, s.pull_off_load) > 0 &&
          asperity_friction_force_at_load(model, nextafter(s.pull_off_load, -INFINITY)) == 0);
    NEAR(summary, s, pull_off_friction_force, asperity_friction_force_at_load(model, s.pull_off_load), 1e-12);
    NEAR(summary, s, zero_load_friction_force, asperity_friction_force_at_load(model, 0), 1e-12);
    NEAR(summary, s, stiffness_per_radius, asperity_tangential_stiffness_at_load(model, 1) / state_at(model, 1).contact_radius_sum, 1e-7);
    NEAR(summary, s, min_table_load, s.pull_off_load + ends[0], 1e-12);
    NEAR(summary, s, max_table_load, s.pull_off_load + ends[1], 1e-12);
    HOLDS(summary, s, table_error, s.table_error > 0 && s.table_error < 1e-8);
    asperity_free(model);
    ALL_SEEN(summary);
}

/* ---- One step of a contact that remembers ---- */

static asperity_microslip stepped(const asperity_model *model, double load, const double *increment, const double *before)
{
    asperity_microslip out = { .struct_size = sizeof out };

    needs(asperity_microslip_step(model, load, increment, before, NULL, &out));
    return out;
}

static void microslip(void)
{
    const asperity_params p = paper(1000);
    asperity_model *model = model_of(&p);
    const double load = 300, strength = asperity_friction_force_at_load(model, load);
    const double length = strength / asperity_tangential_stiffness_at_load(model, load);
    const double increment[] = { 0.5 * length, 0.3 * length }, far[] = { 30 * length, 0 };
    double state[64] = { 0 }, force[2], stiffness[4], heavier;
    asperity_microslip s;

    CHECK(asperity_microslip_length(model) <= 64, "the state of a contact has grown");
    s = stepped(model, load, increment, state);
    needs(asperity_microslip_steps(model, 1, &load, increment, state, NULL, force, stiffness));
    HOLDS(microslip, s, struct_size, s.struct_size == sizeof s);
    HOLDS(microslip, s, force, memcmp(s.force, force, sizeof force) == 0 && force[0] > force[1] && force[1] > 0);
    HOLDS(microslip, s, stiffness, memcmp(s.stiffness, stiffness, sizeof stiffness) == 0 && stiffness[3] > stiffness[0]);
    for (int k = 0; k < 2; k++) {
        heavier = stepped(model, load * (1 + 1e-6), increment, state).force[k];
        near_to("microslip.dforce_dload", s.dforce_dload[k], (heavier - force[k]) / (1e-6 * load), 1e-3);
    }
    SEEN(microslip, dforce_dload);
    CHECK(s.slipping > 0 && s.slipping < 1, "microslip.slipping is %g before gross slip", s.slipping);
    /* In gross slip the strength times the displacement becomes heat. */
    needs(asperity_microslip_steps(model, 1, &load, far, state, state, NULL, NULL));
    s = stepped(model, load, far, state);
    NEAR(microslip, s, slipping, 1, 1e-12);
    NEAR(microslip, s, dissipated, strength * far[0], 1e-9);
    asperity_free(model);
    ALL_SEEN(microslip);
}

int main(void)
{
    parameters();
    state_of_many_summits();
    summary();
    microslip();
    return checks_report("every_field");
}
