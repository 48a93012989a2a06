/* The answers of the library as a list: for each surface a hash of its table, of each kind of call, of exact states, of
 * sensitivities and of the summary. Machines that print the same list give the same bits.
 *
 * Hashes are of numbers, not of bytes, so that they are those of big-endian machines too. The program's own arithmetic
 * is a few sums and products, which no compiler may fuse: -ffp-contract=off. */

#include "../harden/answers.h"

#include <inttypes.h>
#include <stdlib.h>

enum { OTHERS = 8 };

static const char *const OTHER_NAMES[OTHERS] = {
    "Weibull heights, skew 1.5", "Johnson heights, bounded", "Johnson heights, unbounded", "measured heights",
    "spectral moments", "summits that yield", "polysilicon, mm-N-MPa", "soft, strong adhesion, few summits",
};

/* Surfaces of the kinds that surfaces.h leaves out. */
static asperity_params other(int which)
{
    static const double height[] = {-3, -2, -1, -0.25, 0.5, 1.25, 2, 3};
    static const double density[] = {0, 0.05, 0.2, 0.4, 0.37, 0.21, 0.06, 0.0};
    asperity_params p = surface(0);

    switch (which) {
    case 0: asperity_params_set_skew(&p, 1.5); break;
    case 1:
        p.height_distribution = ASPERITY_HEIGHTS_JOHNSON;
        p.skew = -0.4;
        p.kurtosis = 2.6;
        break;
    case 2:
        p.height_distribution = ASPERITY_HEIGHTS_JOHNSON;
        p.skew = 0.7;
        p.kurtosis = 5;
        break;
    case 3:
        p.height_distribution = ASPERITY_HEIGHTS_TABULATED;
        p.table_height = height;
        p.table_density = density;
        p.table_length = sizeof height / sizeof height[0];
        break;
    case 4:
        p = surface(8);
        CHECK(asperity_params_set_spectral_moments(&p, 2.5e-17, 1.5e-3, 4.4e11, 1e-8) == ASPERITY_OK, "moments");
        break;
    case 5:
        CHECK(asperity_params_set_elastic_plastic(&p, 0.02 * p.composite_modulus) == ASPERITY_OK, "yielding");
        break;
    case 6:
        p = surface(8);
        asperity_params_set_materials(&p, 160e3, 0.22, 160e3, 0.22);
        p.work_of_adhesion = 0.063e-3;
        p.adhesion_range = p.burgers_vector = 0.384e-6;
        p.height_std = 5e-6;
        p.summit_radius = 1e-3;
        break;
    default:
        asperity_params_set_dimensionless(&p, 0.1, 100, 0.05, 1.0, 0.3);
        p.asperity_count = 12.5;
        p.radius_amplitude = 0.4;
        break;
    }
    return p;
}

/* FNV-1a over the bytes of numbers, the lowest first. */
static uint64_t hash_on(uint64_t hash, const void *words, size_t size)
{
    for (size_t i = 0; i < size; i += 8) {
        uint64_t word;
        memcpy(&word, (const char *)words + i, sizeof word);
        for (int byte = 0; byte < 8; byte++)
            hash = (hash ^ (word >> 8 * byte & 0xff)) * UINT64_C(0x100000001b3);
    }
    return hash;
}

static const uint64_t EMPTY = UINT64_C(0xcbf29ce484222325);
static uint64_t all_hashes = UINT64_C(0xcbf29ce484222325);
static unsigned long numbers;

/* One line: the surface, the kind of answer, the hash of numbers. */
static void line(const char *name, const char *kind, const void *words, size_t size)
{
    const uint64_t hash = hash_on(EMPTY, words, size);

    all_hashes = hash_on(all_hashes, &hash, sizeof hash);
    numbers += (unsigned long)(size / 8);
    printf("%-36s %-12s %016" PRIx64 "\n", name, kind, hash);
}

#define LINE(name, kind, array) line(name, kind, array, sizeof array)

/* The compiled law. */
static void list_table(const char *name, const asperity_model *model)
{
    asperity_table t = {.struct_size = sizeof t};
    CHECK(asperity_table_of(model, &t) == ASPERITY_OK, "surface %s", name);
    {
        const uint64_t integers[] = {t.row_count, t.base, t.shift, t.total_count};
        const double ends[] = {
            t.pull_off_load, t.max_friction_coefficient, t.inverse_cap, t.pull_off_force, t.light_slope, t.zero_force,
            t.zero_slope, t.separated_slope, t.heavy_force,
        };
        line(name, "table", t.rows, (size_t)t.total_count * 8 * sizeof *t.rows);
        LINE(name, "table size", integers);
        LINE(name, "table ends", ends);
    }
}

/* Load against separation, and its table. */
static void list_gaps(const char *name, const asperity_model *model, const answers *of)
{
    static double separation[LOADS], load[LOADS], slope[LOADS];
    asperity_table t = {.struct_size = sizeof t};

    CHECK(asperity_load_table_of(model, &t) == ASPERITY_OK, "surface %s", name);
    for (int i = 0; i < LOADS; i++)
        separation[i] = of->exact[0].gap + (1 - 0.04 * i) * fabs(of->exact[0].gap);
    asperity_loads_at_gaps(model, LOADS, separation, load, slope);
    for (int i = 0; i < LOADS; i++) {
        const double one = asperity_load_at_gap(model, separation[i]);
        CHECK(SAME(one, load[i]), "%s: %a alone, %a in a batch", name, one, load[i]);
    }
    line(name, "load table", t.rows, (size_t)t.total_count * 8 * sizeof *t.rows);
    LINE(name, "loads at", load);
    LINE(name, "stiffness at", slope);
}

/* One contact at a time, and many: the vectors of the processor against the scalar call. */
static void list_calls(const char *name, const asperity_model *model, const answers *of)
{
    static double mu[LOADS], stiffness[LOADS], radii[2][LOADS], slopes[4][LOADS], sliding[3][LOADS];

    CHECK(memcmp(of->batch, of->force, sizeof of->batch) == 0, "%s: a batch has other bits than its calls", name);
    LINE(name, "loads", of->load);
    LINE(name, "coefficient", of->mu);
    LINE(name, "force", of->batch);
    LINE(name, "force slope", of->slope);
    asperity_friction_at_loads(model, LOADS, of->load, mu, slopes[0]);
    CHECK(memcmp(mu, of->mu, sizeof mu) == 0, "%s: a batch has other bits than its calls", name);
    asperity_tangential_stiffness_at_loads(model, LOADS, of->load, stiffness);
    asperity_contact_radius_sum_at_loads(model, LOADS, of->load, radii[0], radii[1]);
    for (int i = 0; i < LOADS; i++) {
        const double load = of->load[i];
        const double sum = asperity_contact_radius_sum_at_load(model, load);
        const double one = asperity_friction_and_slope_at_load(model, load, &slopes[1][i]);
        CHECK(SAME(one, of->mu[i]), "%s: %a with a slope, %a without", name, one, of->mu[i]);
        CHECK(SAME(sum, radii[0][i]), "%s: radii %a alone, %a in a batch", name, sum, radii[0][i]);
        asperity_friction_at_pressure(model, load, 1.0, &slopes[2][i]);
        slopes[3][i] = asperity_shear_stress_at_pressure(model, load / 3, 3.0, NULL);
        sliding[0][i] = asperity_slip_force(model, load, 0.05 * i - 2, 0.7, &sliding[1][i], &sliding[2][i]);
    }
    LINE(name, "slopes", slopes);
    LINE(name, "stiffness", stiffness);
    LINE(name, "radii", radii);
    LINE(name, "sliding", sliding);
    list_gaps(name, model, of);
}

/* A contact that goes round under changing loads, then all its loads in a batch. */
static void list_microslip(const char *name, const asperity_model *model, const answers *of)
{
    static asperity_microslip steps[LOADS];
    static double states[LOADS][42], increments[LOADS][2], after[LOADS][42], force[LOADS][2], stiffness[LOADS][4];
    static const double around[5][2] = {{1, 0}, {0.25, 0.5}, {-2, 0.125}, {0, -0.75}, {0.5, 0.5}};

    memset(states, 0, sizeof states);
    for (int i = 0; i < LOADS; i++) {
        const double stiff = asperity_tangential_stiffness_at_load(model, of->load[i]);
        const double length = stiff > 0 ? asperity_friction_force_at_load(model, of->load[i]) / stiff : 1;
        steps[i].struct_size = sizeof steps[i];
        for (int k = 0; k < 2; k++)
            increments[i][k] = around[i % 5][k] * length;
        asperity_microslip_step(model, of->load[i], increments[i], states[i], states[(i + 1) % LOADS], &steps[i]);
    }
    asperity_microslip_steps(model, LOADS, of->load, increments[0], states[0], after[0], force[0], stiffness[0]);
    LINE(name, "microslip", steps);
    LINE(name, "microslip forces", force);
    LINE(name, "microslip tangents", stiffness);
    LINE(name, "microslip states", after);
}

/* What is integrated over the summits at each call. */
static void list_exact(const char *name, const asperity_model *model, const answers *of)
{
    static asperity_state apart[3];
    static asperity_sensitivities sensitivities[2];
    double tangential[2][3], summits[3][4];
    double overlap[4];

    LINE(name, "states", of->exact);
    line(name, "summary", &of->summary, sizeof of->summary);
    for (int i = 0; i < 3; i++) {
        const asperity_state *at = &of->exact[2 * i];
        const double displacement = (0.2 + i) * at->friction_force / at->tangential_stiffness;
        apart[i].struct_size = sizeof apart[i];
        CHECK(asperity_state_at_gap(model, at->gap + (0.1 + i) * fabs(at->gap), &apart[i]) ==
                  ASPERITY_OK, "surface %s", name);
        CHECK(asperity_tangential_at_load(model, at->load, displacement, &tangential[0][i], &tangential[1][i]) ==
                  ASPERITY_OK, "surface %s", name);
    }
    for (int i = 0; i < 2; i++) {
        sensitivities[i].struct_size = sizeof sensitivities[i];
        CHECK(asperity_sensitivities_at_load(model, of->load[30 + 40 * i], &sensitivities[i]) == ASPERITY_OK,
              "surface %s", name);
    }
    for (int i = 0; i < 4; i++)
        overlap[i] = (i - 1) * 0.3 * of->exact[0].mean_contact_radius;
    asperity_summits_at_overlaps(model, 4, overlap, NULL, summits[0], summits[1], summits[2]);
    list_microslip(name, model, of);
    LINE(name, "separations", apart);
    LINE(name, "tangential", tangential);
    LINE(name, "sensitivity", sensitivities);
    LINE(name, "summits", summits);
}

static void list(const char *name, asperity_params p)
{
    static answers of;
    asperity_model *model = NULL;

    CHECK(asperity_create(&p, &model) == ASPERITY_OK, "surface %s", name);
    if (model == NULL)
        return;
    answer(model, &of);
    list_table(name, model);
    list_calls(name, model, &of);
    list_exact(name, model, &of);
    asperity_free(model);
}

/* same_bits [STEP]: every STEP-th surface, all of them without one. The sum of all hashes is that of the whole list alone. */
int main(int argc, char **argv)
{
    const int step = argc > 1 ? atoi(argv[1]) : 1;

    CHECK(step > 0, "no step: %s", argc > 1 ? argv[1] : "");
    for (int s = 0; step > 0 && s < SURFACES + OTHERS; s += step) {
        if (s < SURFACES)
            list(SURFACE_NAMES[s], surface(s));
        else
            list(OTHER_NAMES[s - SURFACES], other(s - SURFACES));
    }
    if (step == 1)
        printf("%lu numbers %016" PRIx64 "\n", numbers, all_hashes);
    return checks_report("same_bits");
}
