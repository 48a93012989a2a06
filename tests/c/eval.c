/* asperity_eval.h gives the bits that the library gives where its table answers, and what its rules say elsewhere.
 *
 * One source for every compiler: C99, C++17, CUDA, HIP. On a GPU, where there is one, a kernel is put to the same test.
 * Which row a load belongs to is found here by search among the edges of the rows, not from the bits of the load.
 */
#ifndef _GNU_SOURCE
#define _GNU_SOURCE
#endif
#include <asperity.h>
#include <asperity_eval.h>

#include <fenv.h>
#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#if defined(__CUDACC__)
#include <cuda_runtime.h>
#define GPU(name) cuda##name
#elif defined(__HIPCC__)
#include <hip/hip_runtime.h>
#define GPU(name) hip##name
#endif

#ifndef __GLIBC__ /* whose function turns floating-point traps on */
#define feenableexcept(exceptions) ((void)0)
#endif

/* Compiled with -ffast-math or the like, in which a comparison finds no NaN: the tests are of bits too. */
#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#define FAST 1
#else
#define FAST 0
#endif

#define LOADS 200000
#define SPECIAL 24

static int failures = 0;

static void require(int holds, const char *what)
{
    if (!holds) {
        fprintf(stderr, "tests/c/eval.c: %s\n", what);
        ++failures;
    }
}

static int same_bits(double a, double b)
{
    return memcmp(&a, &b, sizeof a) == 0;
}

/* The same bits; or within the last few of a sum of terms of this size, where the compiler may reorder and contract. */
static int same(double a, double b, double size)
{
    return same_bits(a, b) || (FAST && fabs(a - b) <= 1e-14 * size);
}

static double double_of(uint64_t bits)
{
    double x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

/* Without arithmetic, which would raise a flag for a signalling NaN. */
static int is_finite(const double *x)
{
    uint64_t bits;
    memcpy(&bits, x, sizeof bits);
    return (bits >> 52 & 2047) != 2047;
}

static int is_nan(const double *x)
{
    uint64_t bits;
    memcpy(&bits, x, sizeof bits);
    return bits << 1 > UINT64_C(2047) << 53;
}

/* ---- Surfaces ---- */

static void gaussian(asperity_params *params)
{
    (void)params;
}

static void weibull(asperity_params *params)
{
    asperity_params_set_skew(params, -0.7);
}

static void hertz(asperity_params *params)
{
    params->work_of_adhesion = 0.0;
}

static void radius_grows(asperity_params *params)
{
    params->radius_amplitude = 0.6;
    params->radius_rate = 1.5;
}

static void strong_adhesion(asperity_params *params)
{
    asperity_params_set_dimensionless(params, 0.003, 3000.0, 0.01, 1.0, 0.3);
}

/* Polysilicon, 100 um x 100 um, in SI units. */
static void polysilicon(asperity_params *params)
{
    asperity_params_set_materials(params, 160e9, 0.22, 160e9, 0.22);
    params->work_of_adhesion = 0.063;
    params->adhesion_range = 0.384e-9;
    params->burgers_vector = 0.384e-9;
    params->height_std = 5e-9;
    params->summit_radius = 1e-6;
    params->asperity_count = 1e5;
}

static void no_attraction_low_cap(asperity_params *params)
{
    params->attraction = 0;
    params->max_friction_coefficient = 2.0;
}

static void skewed_radius_grows_uncapped(asperity_params *params)
{
    asperity_params_set_skew(params, 1.2);
    params->radius_amplitude = -0.4;
    params->max_friction_coefficient = INFINITY;
}

/* Those below have rows in parts, where the law bends. */
static void yields(asperity_params *params)
{
    asperity_params_init(params, sizeof *params);
    asperity_params_set_pair(params, "steel/steel");
    params->height_std = 0.4e-6;
    params->summit_radius = 20e-6;
    params->asperity_count = 5e5;
    params->work_of_adhesion = 0.0;
    params->contact_law = ASPERITY_CONTACT_ELASTIC_PLASTIC;
}

static void one_summit(asperity_params *params)
{
    asperity_params_init(params, sizeof *params);
    asperity_params_set_pair(params, "Si/Si");
    params->height_std = 1e-13;
    params->summit_radius = 30e-9;
    params->asperity_count = 1.0;
    params->adhesion_range = 0.25e-9;
}

static void worn(asperity_params *params)
{
    static const double height[5] = {-1, -0.5, 0, 0.5, 1}, density[5] = {0, 1, 1, 1, 0};
    polysilicon(params);
    params->work_of_adhesion = 0.0;
    params->height_distribution = ASPERITY_HEIGHTS_TABULATED;
    params->table_height = height;
    params->table_density = density;
    params->table_length = 5;
}

static const struct {
    const char *name;
    void (*set)(asperity_params *);
} surfaces[] = {
    {"Gaussian", gaussian},
    {"Weibull", weibull},
    {"Hertz", hertz},
    {"radius grows with height", radius_grows},
    {"strong adhesion", strong_adhesion},
    {"polysilicon, SI", polysilicon},
    {"no attraction, low cap", no_attraction_low_cap},
    {"Weibull, radius falls with height, no cap", skewed_radius_grows_uncapped},
    {"ground steel, yields", yields},
    {"one summit", one_summit},
    {"worn: tabulated heights", worn},
};

/* ---- Loads ---- */

/* Uniform in [0, 1): splitmix64. */
static double uniform(void)
{
    static uint64_t state = 0;
    uint64_t z = (state += UINT64_C(0x9e3779b97f4a7c15));
    z = (z ^ z >> 30) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ z >> 27) * UINT64_C(0x94d049bb133111eb);
    return (double)((z ^ z >> 31) >> 11) * 0x1p-53;
}

/* Where a row begins, as load above pull-off. */
static double edge(const asperity_table *table, uint64_t row)
{
    return double_of((table->base + row) << table->shift);
}

/* Loads of every kind: anywhere in a row, next to its ends, pulling, and over all decades. */
static double load_of_kind(const asperity_table *table, unsigned long i)
{
    const uint64_t row = i / 4 % table->row_count;
    const double begin = edge(table, row), end = edge(table, row + 1);
    const double lightest = edge(table, 0), heaviest = edge(table, table->row_count);
    switch (i % 4) {
    case 0:
        return table->pull_off_load + (begin + uniform() * (end - begin));
    case 1:
        return nextafter(table->pull_off_load + begin, uniform() < 0.5 ? -INFINITY : INFINITY);
    case 2:
        return table->pull_off_load * 1.1 * pow(uniform(), 3.0);
    default:
        return lightest * 0.01 * exp(uniform() * log(heaviest / lightest * 1000.0));
    }
}

static void fill(const asperity_table *table, const asperity_summary *summary, double *load)
{
    const double pull_off = table->pull_off_load, min = summary->min_table_load, max = summary->max_table_load;
    const double special[SPECIAL] = {
        0.0, -0.0, DBL_MIN, -DBL_MIN, DBL_MAX, -DBL_MAX, 0x1p-1074, 1.0,
        pull_off, nextafter(pull_off, -INFINITY), nextafter(pull_off, INFINITY), 2.0 * pull_off - DBL_MIN,
        min, nextafter(min, -INFINITY), nextafter(min, INFINITY), 0.5 * (pull_off + min),
        max, nextafter(max, -INFINITY), nextafter(max, INFINITY), 2.0 * max,
        INFINITY, -INFINITY, NAN, 0.0,
    };
    const uint64_t signalling = UINT64_C(0x7ff0000000000001);
    unsigned long i;
    memcpy(load, special, sizeof special);
    memcpy(load + SPECIAL - 1, &signalling, sizeof signalling);
    for (i = SPECIAL; i < LOADS; ++i)
        load[i] = load_of_kind(table, i);
}

/* ---- Evaluation ---- */

struct answers {
    double force, dforce_dload, force_alone, mu, dmu_dload, mu_alone;
};

ASPERITY_EVAL_FUNCTION struct answers answers_at(const asperity_table *table, double load)
{
    struct answers a;
    a.force = asperity_eval_friction_force(table, load, &a.dforce_dload);
    a.force_alone = asperity_eval_friction_force(table, load, NULL);
    a.mu = asperity_eval_friction(table, load, &a.dmu_dload);
    a.mu_alone = asperity_eval_friction(table, load, NULL);
    return a;
}

static void evaluate(const asperity_table *table, const double *load, struct answers *answers)
{
    unsigned long i;
    for (i = 0; i < LOADS; ++i)
        answers[i] = answers_at(table, load[i]);
}

#ifdef GPU
__global__ void evaluate_in_kernel(asperity_table table, const double *load, struct answers *answers)
{
    const unsigned long i = blockIdx.x * (unsigned long)blockDim.x + threadIdx.x;
    if (i < LOADS)
        answers[i] = answers_at(&table, load[i]);
}

static int device_is_there(void)
{
    int count = 0;
    return GPU(GetDeviceCount)(&count) == GPU(Success) && count > 0;
}

static void evaluate_on_device(asperity_table table, const double *load, struct answers *answers)
{
    const size_t rows_size = table.total_count * 8 * sizeof(double);
    double *rows = NULL, *loads = NULL;
    struct answers *results = NULL;
    int good = GPU(Malloc)((void **)&rows, rows_size) == GPU(Success);
    good &= GPU(Malloc)((void **)&loads, LOADS * sizeof *loads) == GPU(Success);
    good &= GPU(Malloc)((void **)&results, LOADS * sizeof *results) == GPU(Success);
    good &= GPU(Memcpy)(rows, table.rows, rows_size, GPU(MemcpyHostToDevice)) == GPU(Success);
    good &= GPU(Memcpy)(loads, load, LOADS * sizeof *loads, GPU(MemcpyHostToDevice)) == GPU(Success);
    table.rows = rows;
    evaluate_in_kernel<<<(LOADS + 255) / 256, 256>>>(table, loads, results);
    good &= GPU(GetLastError)() == GPU(Success);
    good &= GPU(Memcpy)(answers, results, LOADS * sizeof *results, GPU(MemcpyDeviceToHost)) == GPU(Success);
    good &= GPU(Free)(rows) == GPU(Success) && GPU(Free)(loads) == GPU(Success) && GPU(Free)(results) == GPU(Success);
    require(good, "the device failed");
}
#endif

/* ---- The claims ---- */

struct tally {
    unsigned long compared, pulling, capped, separated, beside, unanswered, wrong;
};

static void complain(struct tally *tally, const char *what, const double *load)
{
    if (tally->wrong++ < 5)
        fprintf(stderr, "tests/c/eval.c: %s at load %a\n", what, is_finite(load) ? *load : NAN);
}

/* The row of x = load - pull_off_load; row_count where there is none. */
static uint64_t row_of(const asperity_table *table, double x)
{
    uint64_t low = 0, high = table->row_count;
    if (x < edge(table, low) || x >= edge(table, high))
        return table->row_count;
    while (high - low > 1) {
        const uint64_t middle = low + (high - low) / 2;
        if (x < edge(table, middle))
            high = middle;
        else
            low = middle;
    }
    return low;
}

/* A row that is left out is NaN with an offset of nothing; parts of a row may be, which the library says by other bits. */
static int is_left_out(const double *row)
{
    uint64_t bits;
    memcpy(&bits, row, sizeof bits);
    return is_nan(row) && (bits & ((UINT64_C(1) << 51) - 1)) == 0;
}

/* Whether the part of a row to which x belongs is there, x searched for among where parts begin. */
static int part_answers(const asperity_table *table, const double *row, double begin, double binade, double x)
{
    uint64_t bits, part = 0;
    if (is_left_out(row))
        return 0;
    if (!is_nan(row))
        return 1;
    memcpy(&bits, row, sizeof bits);
    while (part < 6 && x >= begin + row[2 + part] * binade)
        ++part;
    bits = (bits & ((UINT64_C(1) << 51) - 1)) / (8 * sizeof *row) + part;
    return bits < table->total_count && part_answers(table, table->rows + 8 * bits, begin, binade, x);
}

static int table_answers(const asperity_table *table, double load)
{
    const double x = load - table->pull_off_load;
    const uint64_t row = row_of(table, x);
    if (row >= table->row_count)
        return 0;
    return part_answers(table, table->rows + 8 * row, edge(table, row), exp2(ilogb(edge(table, row))), x);
}

/* What the header says of loads beside the table. */
static int by_the_rules(const asperity_table *table, double load, const struct answers *a)
{
    const double x = load - table->pull_off_load;
    const int is_heavy = x >= edge(table, table->row_count);
    const double line = is_heavy ? 0.0 : table->pull_off_force + table->light_slope * x; /* which may overflow */
    const double force = load == 0.0 ? table->zero_force : is_heavy ? table->heavy_force : line;
    const double slope = load == 0.0 ? table->zero_slope : is_heavy ? 0.0 : table->light_slope;
    const double mu = load <= force * table->inverse_cap ? table->max_friction_coefficient : force / load;
    return fabs(a->force - force) <= 1e-15 * force && a->force_alone == a->force && a->dforce_dload == slope &&
           (same_bits(a->mu, mu) || fabs(a->mu - mu) <= 1e-15 * mu) && a->mu_alone == a->mu &&
           is_finite(&a->dmu_dload) && is_finite(&a->force);
}

/* The straight line is near to the library's force, the heaviest load's force below it. */
static int near_the_library(const asperity_model *model, const asperity_table *table, double load,
                            const struct answers *a)
{
    const double force = asperity_friction_force_at_load(model, load);
    if (load - table->pull_off_load >= edge(table, table->row_count))
        return is_nan(&force) || force >= a->force * (1 - 1e-9);
    if (load == 0.0)
        return same_bits(a->force, force);
    if (edge(table, 0) < 1e-8 * -table->pull_off_load)
        return fabs(a->force - force) <= 2e-4 * force;
    /* The line knows nothing of adhesion far below the table, nor has it digits next to the smallest number. */
    if (fabs(load) < 1e3 * -table->pull_off_load || fabs(load) < 1e-290)
        return is_finite(&a->force) && a->force >= 0.0 && a->force < 1e-12 * table->heavy_force;
    return a->force <= 10 * force && a->force >= 0.1 * force;
}

static int all_nan(const struct answers *a)
{
    return is_nan(&a->force) && is_nan(&a->dforce_dload) && is_nan(&a->force_alone) && is_nan(&a->mu) &&
           is_nan(&a->dmu_dload) && is_nan(&a->mu_alone);
}

static int as_the_library(const asperity_model *model, double load, const struct answers *a)
{
    double dforce_dload, dmu_dload;
    const double force = asperity_friction_force_and_slope_at_load(model, load, &dforce_dload);
    const double mu = asperity_friction_and_slope_at_load(model, load, &dmu_dload);
    const double slopes = fabs(dforce_dload) + fabs(mu);
    return same(a->force, force, force) && same(a->force_alone, force, force) && same(a->mu, mu, mu) &&
           same(a->mu_alone, mu, mu) && same(a->dforce_dload, dforce_dload, slopes) &&
           same(a->dmu_dload, dmu_dload, fabs(slopes / load)) &&
           same_bits(asperity_friction_force_at_load(model, load), force) &&
           same_bits(asperity_friction_at_load(model, load), mu);
}

/* Loads are rounded: one that is next to an end of the table may belong to either side of it. */
static int within_range(const asperity_summary *summary, double load)
{
    return load >= nextafter(summary->min_table_load, -INFINITY) &&
           load <= nextafter(summary->max_table_load, INFINITY);
}

static struct tally compare(const asperity_model *model, const asperity_table *table, const double *load,
                            const struct answers *answers)
{
    struct tally tally = {0, 0, 0, 0, 0, 0, 0};
    asperity_summary summary;
    unsigned long i;
    summary.struct_size = sizeof summary;
    require(asperity_summary_of(model, &summary) == ASPERITY_OK, "asperity_summary_of fails");
    for (i = 0; i < LOADS; ++i) {
        const struct answers *a = &answers[i];
        const int finite = is_finite(&load[i]);
        if (finite && load[i] < table->pull_off_load) {
            ++tally.separated;
            if (a->force != 0.0 || !as_the_library(model, load[i], a))
                complain(&tally, "friction below pull-off", &load[i]);
        } else if (finite && table_answers(table, load[i])) {
            ++tally.compared;
            tally.pulling += load[i] < 0.0;
            tally.capped += load[i] > 0.0 && a->mu == table->max_friction_coefficient;
            if (!within_range(&summary, load[i]))
                complain(&tally, "an answer outside the table's range", &load[i]);
            if (!as_the_library(model, load[i], a))
                complain(&tally, "other bits than the library's", &load[i]);
        } else if (finite && row_of(table, load[i] - table->pull_off_load) >= table->row_count) {
            ++tally.beside;
            if (!by_the_rules(table, load[i], a))
                complain(&tally, "not by the rules beside the table", &load[i]);
            if (!near_the_library(model, table, load[i], a))
                complain(&tally, "far from the library beside the table", &load[i]);
        } else {
            ++tally.unanswered;
            if (!FAST && !all_nan(a))
                complain(&tally, "a number where there is none", &load[i]);
        }
    }
    return tally;
}

static void judge(const char *where, const asperity_table *table, struct tally tally)
{
    uint64_t row, left_out = 0;
    for (row = 0; row < table->row_count; ++row)
        left_out += is_left_out(table->rows + 8 * row) != 0;
    printf("  %-42s %4u rows, %u left out; loads: %lu with the library's bits (%lu pulling, %lu pushing and capped), "
           "%lu separated, %lu beside the table, %lu NaN\n",
           where, (unsigned)table->row_count, (unsigned)left_out, tally.compared, tally.pulling, tally.capped,
           tally.separated, tally.beside, tally.unanswered);
    require(tally.wrong == 0, where);
    require(tally.compared > LOADS / 2 && tally.beside > LOADS / 1000, "too few loads inside or outside the table");
    require(tally.separated > 2, "too few loads below pull-off");
    require(edge(table, 0) >= -table->pull_off_load || tally.pulling > LOADS / 20, "too few pulling loads");
}

static void check(const char *name, const asperity_model *model, const asperity_table *table, const double *load,
                  struct answers *answers)
{
    memset(answers, 0, LOADS * sizeof *answers);
    evaluate(table, load, answers);
    judge(name, table, compare(model, table, load, answers));
#ifdef GPU
    if (device_is_there()) {
        memset(answers, 0, LOADS * sizeof *answers);
        evaluate_on_device(*table, load, answers);
        judge("  the same, on the device", table, compare(model, table, load, answers));
    }
#endif
}

/* A copy of the table in which a row is left out answers as the table, but for that row. */
static void check_copy(const asperity_model *model, asperity_table table, const double *load, struct answers *answers)
{
    const size_t size = table.total_count * 8 * sizeof(double);
    double *rows = (double *)malloc(size);
    if (!rows)
        abort();
    memcpy(rows, table.rows, size);
    rows[8 * (table.row_count / 2)] = NAN;
    table.rows = rows;
    check("  a copy with one row more left out", model, &table, load, answers);
    free(rows);
}

/* The load at a gap, from the table of loads: minus the gap stands for the load in its rows. */
static void check_loads_at_gaps(const asperity_model *model)
{
    asperity_table table;
    unsigned long i, compared = 0;
    table.struct_size = sizeof table;
    require(asperity_load_table_of(model, &table) == ASPERITY_OK, "asperity_load_table_of fails");
    for (i = 0; i < LOADS; ++i) {
        const double at = load_of_kind(&table, i);
        double slope, expected_slope, load, expected;
        if (at < table.pull_off_load || !table_answers(&table, at))
            continue;
        load = asperity_eval_friction_force(&table, at, &slope);
        expected = asperity_load_and_slope_at_gap(model, -at, &expected_slope);
        require(same(load, expected, fabs(expected) + fabs(table.zero_force)), "another load at a gap than the library's");
        /* The library lets none rise with the gap. */
        require(same(slope > 0.0 ? -slope : 0.0, expected_slope, fabs(expected_slope)), "another slope by the gap");
        ++compared;
    }
    require(compared > LOADS / 2, "too few gaps in the table of loads");
}

/* The table of floats, for loads that floats are: by the rules beside it, and in it as near as the header says. */
static void check_floats(const char *name, const asperity_model *model, const asperity_table *table, const double *load)
{
    const uint32_t count = asperity_eval_make_float(table, NULL, NULL);
    float *rows = (float *)malloc(count * 8 * sizeof *rows);
    asperity_float_table single;
    unsigned long i, compared = 0, rounded_off = 0, missing = 0, pulling = 0;
    double value_error = 0.0, slope_error = 0.0;
    if (!rows)
        abort();
    require(asperity_eval_make_float(table, rows, &single) == count && single.total_count == count, "two numbers of rows");
    for (i = 0; i < LOADS; ++i) {
        volatile float rounded; /* in fact: -ffast-math may take the float for the double that it was */
        float at, force, alone, slope, mu, mu_slope;
        double x, exact, exact_slope, exact_force, off, slope_off;
        if (!is_finite(&load[i]) || fabs(load[i]) > (double)FLT_MAX)
            continue;
        rounded = (float)load[i];
        at = rounded;
        x = (double)at - table->pull_off_load;
        force = asperity_eval_friction_force_float(&single, at, &slope);
        mu = asperity_eval_friction_float(&single, at, &mu_slope);
        alone = asperity_eval_friction_force_float(&single, at, NULL);
        require(memcmp(&alone, &force, sizeof force) == 0, "another force without the slope");
        if (x < 0.0 && -x > 1e-6 * fabs(table->pull_off_load))
            require(force == 0.0f && mu == 0.0f, "friction of floats below pull-off");
        if (at == 0.0f)
            require(fabs((double)force - table->zero_force) <= 1e-7 * table->zero_force + 1e-45, "another force at zero");
        if (x < 0x1p-100 || x > 0x1p100 || x < 1e-6 * fabs(table->pull_off_load) || !table_answers(table, (double)at))
            continue;
        exact = asperity_friction_force_and_slope_at_load(model, (double)at, &exact_slope);
        exact_force = (double)force;
        if (is_nan(&exact_force)) { /* next to a row that the doubles leave out */
            ++missing;
            continue;
        }
        off = fabs((double)force / exact - 1.0);
        slope_off = fabs((double)slope / exact_slope - 1.0);
        ++compared;
        pulling += at < 0.0f;
        require(off < 1e-6, "a force of floats is off by more than 1e-6");
        require(at <= force * single.inverse_cap || fabs((double)mu * (double)at / exact - 1.0) < 1e-6, "another mu");
        if (off > 2e-7 || slope_off > 2e-7) {
            ++rounded_off;
            continue;
        }
        value_error = off > value_error ? off : value_error;
        slope_error = slope_off > slope_error ? slope_off : slope_error;
    }
    printf("  %-42s %4u rows and %u parts of floats: force within %.1e, slope within %.1e at %lu loads (%lu pulling), %lu "
           "at kinks\n", name, (unsigned)single.row_count, (unsigned)(count - single.row_count), value_error,
           slope_error, compared - rounded_off, pulling, rounded_off);
    require(compared > LOADS / 3 && rounded_off + missing < compared / 200, "floats are off at too many loads");
    if (!FAST) {
        require(isnan(asperity_eval_friction_force_float(&single, (float)NAN, NULL)), "a number at no load");
        require(isnan(asperity_eval_friction_float(&single, (float)INFINITY, NULL)), "a number at an infinite load");
    }
    free(rows);
}

static void check_surface(const char *name, void (*set)(asperity_params *), double *load, struct answers *answers)
{
    asperity_params params;
    asperity_model *model = NULL;
    asperity_table table;
    asperity_summary summary;
    asperity_params_init(&params, sizeof params);
    asperity_params_set_dimensionless(&params, 0.01, 1000, 0.001, 1, 0.3);
    set(&params);
    table.struct_size = sizeof table;
    summary.struct_size = sizeof summary;
    if (asperity_create(&params, &model) != ASPERITY_OK || asperity_table_of(model, &table) != ASPERITY_OK ||
        asperity_summary_of(model, &summary) != ASPERITY_OK) {
        require(0, name);
        return;
    }
    require(table.layout_version == ASPERITY_TABLE_LAYOUT, "another layout than the header's");
    require((uintptr_t)table.rows % 64 == 0, "rows are not aligned to 64 bytes");
    require(table.pull_off_load == summary.pull_off_load, "two pull-off loads");
    fill(&table, &summary, load);
    check(name, model, &table, load, answers);
    check_copy(model, table, load, answers);
    check_floats("  the same in floats", model, &table, load);
    check_loads_at_gaps(model);
    asperity_free(model);
}

int main(void)
{
    double *load = (double *)malloc(LOADS * sizeof *load);
    struct answers *answers = (struct answers *)malloc(LOADS * sizeof *answers);
    size_t i;
    if (!load || !answers)
        abort();
#ifdef GPU
    printf("  %s\n", device_is_there() ? "evaluates on the host and on the device"
                                       : "no device: the kernel is compiled, and only the host's code is run");
#endif
    if (!FAST) /* which may compute ahead of a condition what the condition keeps from overflow */
        feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
    for (i = 0; i < sizeof surfaces / sizeof *surfaces; ++i)
        check_surface(surfaces[i].name, surfaces[i].set, load, answers);
    free(load);
    free(answers);
    return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
