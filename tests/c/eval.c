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

#include "surfaces.h"

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

#define LOADS 100000
#define SPECIAL 24

static int failures = 0;
static const char *surface_name = "";
static double loads[LOADS];


static int same_bits(double a, double b)
{
    return memcmp(&a, &b, sizeof a) == 0;
}

/* The same bits; or within the last few of a sum of terms of this size, where the compiler may reorder and contract. */
static int same(double a, double b, double size)
{
    return same_bits(a, b) || (FAST && fabs(a - b) <= 1e-14 * size);
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

static void claim(int holds, const char *what, const double *load)
{
    if (!holds && failures++ < 20)
        fprintf(stderr, "tests/c/eval.c: %s: %s at load %a\n", surface_name, what, is_finite(load) ? *load : NAN);
}

static void require(int holds, const char *what)
{
    claim(holds, what, &loads[0]);
}

static double uniform(void)
{
    static uint64_t state = 1;
    state = state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return (double)(state >> 11) * 0x1p-53;
}

/* Where a row begins, as load above pull-off. */
static double edge(const asperity_table *table, uint64_t row)
{
    const uint64_t bits = (table->base + row) << table->shift;
    double x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

/* Loads of every kind: anywhere in a row, next to its ends, pulling, and over all decades. */
static double load_of_kind(const asperity_table *table, unsigned long i)
{
    const uint64_t row = i / 4 % table->row_count;
    const double begin = edge(table, row), end = edge(table, row + 1);
    const double lightest = edge(table, 0), heaviest = edge(table, table->row_count);
    switch (i % 4) {
    case 0: return table->pull_off_load + (begin + uniform() * (end - begin));
    case 1: return nextafter(table->pull_off_load + begin, uniform() < 0.5 ? -INFINITY : INFINITY);
    case 2: return table->pull_off_load * 1.1 * pow(uniform(), 3.0);
    default: return lightest * 0.01 * exp(uniform() * log(heaviest / lightest * 1000.0));
    }
}

static void fill(const asperity_table *table, const asperity_summary *summary)
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
    memcpy(loads, special, sizeof special);
    memcpy(loads + SPECIAL - 1, &signalling, sizeof signalling);
    for (i = SPECIAL; i < LOADS; ++i) loads[i] = load_of_kind(table, i);
}

/* Force, slope, force alone, coefficient, slope, coefficient alone. */
struct answers {
    double of[6];
};

ASPERITY_EVAL_FUNCTION struct answers answers_at(const asperity_table *table, double load)
{
    struct answers a;
    a.of[0] = asperity_eval_friction_force(table, load, &a.of[1]);
    a.of[2] = asperity_eval_friction_force(table, load, NULL);
    a.of[3] = asperity_eval_friction(table, load, &a.of[4]);
    a.of[5] = asperity_eval_friction(table, load, NULL);
    return a;
}

#ifdef GPU
__global__ void evaluate_in_kernel(asperity_table table, const double *load, struct answers *answers)
{
    const unsigned long i = blockIdx.x * (unsigned long)blockDim.x + threadIdx.x;
    if (i < LOADS) answers[i] = answers_at(&table, load[i]);
}

static int device_is_there(void)
{
    int count = 0;
    return GPU(GetDeviceCount)(&count) == GPU(Success) && count > 0;
}

static void evaluate_on_device(asperity_table table, struct answers *answers)
{
    const size_t rows_size = table.total_count * 8 * sizeof(double);
    double *rows = NULL, *at = NULL;
    struct answers *results = NULL;
    int good = GPU(Malloc)((void **)&rows, rows_size) == GPU(Success);
    good &= GPU(Malloc)((void **)&at, sizeof loads) == GPU(Success);
    good &= GPU(Malloc)((void **)&results, LOADS * sizeof *results) == GPU(Success);
    good &= GPU(Memcpy)(rows, table.rows, rows_size, GPU(MemcpyHostToDevice)) == GPU(Success);
    good &= GPU(Memcpy)(at, loads, sizeof loads, GPU(MemcpyHostToDevice)) == GPU(Success);
    table.rows = rows;
    evaluate_in_kernel<<<(LOADS + 255) / 256, 256>>>(table, at, results);
    good &= GPU(GetLastError)() == GPU(Success);
    good &= GPU(Memcpy)(answers, results, LOADS * sizeof *results, GPU(MemcpyDeviceToHost)) == GPU(Success);
    good &= GPU(Free)(rows) == GPU(Success) && GPU(Free)(at) == GPU(Success) && GPU(Free)(results) == GPU(Success);
    require(good, "the device failed");
}
#endif

static struct tally {
    unsigned long compared, pulling, capped, separated, beside, linked;
} all;

/* The row of x = load - pull_off_load; row_count where there is none. */
static uint64_t row_of(const asperity_table *table, double x)
{
    uint64_t low = 0, high = table->row_count;
    if (x < edge(table, low) || x >= edge(table, high)) return table->row_count;
    while (high - low > 1) {
        const uint64_t middle = low + (high - low) / 2;
        *(x < edge(table, middle) ? &high : &low) = middle;
    }
    return low;
}

/* What the header says of loads beside the table. */
static int by_the_rules(const asperity_table *table, double load, const double *of)
{
    const double x = load - table->pull_off_load;
    const int is_heavy = x >= edge(table, table->row_count);
    const double line = is_heavy ? 0.0 : table->pull_off_force + table->light_slope * x; /* which may overflow */
    const double force = load == 0.0 ? table->zero_force : is_heavy ? table->heavy_force : line;
    const double slope = load == 0.0 ? table->zero_slope : is_heavy ? 0.0 : table->light_slope;
    const double mu = load <= force * table->inverse_cap ? table->max_friction_coefficient : force / load;
    return fabs(of[0] - force) <= 1e-15 * force && of[2] == of[0] && of[1] == slope &&
           (same_bits(of[3], mu) || fabs(of[3] - mu) <= 1e-15 * mu) && of[5] == of[3] && is_finite(&of[4]) && is_finite(&of[0]);
}

/* The straight line is near to the library's force, the heaviest load's force below it. */
static int near_the_library(const asperity_model *model, const asperity_table *table, double load, double found)
{
    const double force = asperity_friction_force_at_load(model, load), pull = -table->pull_off_load;
    if (load + pull >= edge(table, table->row_count)) return is_nan(&force) || force >= found * (1 - 1e-9);
    if (load == 0.0) return same_bits(found, force);
    if (edge(table, 0) < 1e-8 * pull) return fabs(found - force) <= 2e-4 * force;
    /* The line knows nothing of adhesion far below the table, nor has it digits next to the smallest number. */
    if (fabs(load) < 1e3 * pull || fabs(load) < 1e-290) return found >= 0.0 && found < 1e-12 * table->heavy_force;
    return found <= 10 * force && found >= 0.1 * force;
}

static int as_the_library(const asperity_model *model, double load, const double *of)
{
    double dforce, dmu;
    const double force = asperity_friction_force_and_slope_at_load(model, load, &dforce);
    const double mu = asperity_friction_and_slope_at_load(model, load, &dmu), slopes = fabs(dforce) + fabs(mu);
    return same(of[0], force, force) && same(of[1], dforce, slopes) && same(of[2], force, force) && same(of[3], mu, mu) &&
           same(of[4], dmu, fabs(slopes / load)) && same(of[5], mu, mu);
}

/* The claims on answers at all loads; of a table whose bits are those of the library. */
static void compare(const asperity_model *model, const asperity_table *table, const struct answers *answers)
{
    struct tally tally = {0, 0, 0, 0, 0, 0};
    asperity_summary summary;
    unsigned long i;
    summary.struct_size = sizeof summary;
    require(asperity_summary_of(model, &summary) == ASPERITY_OK, "asperity_summary_of fails");
    for (i = 0; i < LOADS; ++i) {
        const double *of = answers[i].of, load = is_finite(&loads[i]) ? loads[i] : 0.0;
        const uint64_t row = row_of(table, load - table->pull_off_load);
        int k;
        if (!is_finite(&loads[i])) {
            for (k = 0; k < 6; ++k) claim(FAST || is_nan(&of[k]), "a number where there is none", &loads[i]);
        } else if (load < table->pull_off_load) {
            ++tally.separated;
            claim(of[0] == 0.0 && as_the_library(model, load, of), "friction below pull-off", &load);
        } else if (row >= table->row_count) {
            ++tally.beside;
            claim(by_the_rules(table, load, of), "not by the rules beside the table", &load);
            claim(near_the_library(model, table, load, of[0]), "far from the library beside the table", &load);
        } else {
            ++tally.compared;
            tally.pulling += load < 0.0;
            tally.capped += load > 0.0 && of[3] == table->max_friction_coefficient;
            tally.linked += is_nan(&table->rows[8 * row]) != 0;
            /* Loads are rounded: one that is next to an end of the table may belong to either side of it. */
            claim(load >= nextafter(summary.min_table_load, -INFINITY) && load <= nextafter(summary.max_table_load, INFINITY),
                  "an answer outside the table's range", &load);
            claim(as_the_library(model, load, of), "other bits than the library's", &load);
        }
    }
    printf("  %-32s %4u rows, %u parts; loads: %lu with the library's bits (%lu in parts, %lu pulling), %lu beside the table\n",
           surface_name, (unsigned)table->row_count, (unsigned)(table->total_count - table->row_count), tally.compared,
           tally.linked, tally.pulling, tally.beside);
    require(tally.compared > LOADS / 2 && tally.beside > LOADS / 1000, "too few loads inside or outside the table");
    require(tally.separated > 2, "too few loads below pull-off");
    require(edge(table, 0) >= -table->pull_off_load || tally.pulling > LOADS / 20, "too few pulling loads");
    all.linked += tally.linked;
    all.capped += tally.capped;
}

static void check(const asperity_model *model, const asperity_table *table)
{
    static struct answers answers[LOADS];
    unsigned long i;
    for (i = 0; i < LOADS; ++i) answers[i] = answers_at(table, loads[i]);
    compare(model, table, answers);
#ifdef GPU
    if (device_is_there()) {
        memset(answers, 0, sizeof answers);
        evaluate_on_device(*table, answers);
        compare(model, table, answers);
    }
#endif
}

/* The load at a gap, from the table of loads: minus the gap stands for the load in its rows. */
static void check_loads_at_gaps(const asperity_model *model)
{
    asperity_table table;
    unsigned long i, compared = 0;
    table.struct_size = sizeof table;
    require(asperity_table_of(model, ASPERITY_TABLE_LOAD_AT_GAP, &table) == ASPERITY_OK, "no table of loads");
    for (i = 0; i < LOADS; ++i) {
        const double at = load_of_kind(&table, i);
        double slope, expected_slope, found, expected;
        if (row_of(&table, at - table.pull_off_load) == table.row_count) continue;
        found = asperity_eval_friction_force(&table, at, &slope);
        expected = asperity_load_and_slope_at_gap(model, -at, &expected_slope);
        claim(same(found, expected, fabs(expected) + fabs(table.zero_force)), "another load than the library's at minus a gap", &at);
        /* The library lets none rise with the gap. */
        claim(same(slope > 0.0 ? -slope : 0.0, expected_slope, fabs(expected_slope)), "another slope by the gap", &at);
        ++compared;
    }
    require(compared > LOADS / 2, "too few gaps in the table of loads");
}

/* The table of floats, for loads that floats are: by the rules beside it, and in it as near as the header says. */
static void check_floats(const asperity_model *model, const asperity_table *table)
{
    const uint32_t count = asperity_eval_make_float(table, NULL, NULL);
    float *rows = (float *)malloc(count * 8 * sizeof *rows);
    asperity_float_table single;
    unsigned long i, compared = 0, rounded_off = 0;
    if (!rows) abort();
    require(asperity_eval_make_float(table, rows, &single) == count && single.total_count == count, "two numbers of rows");
    for (i = 0; i < LOADS; ++i) {
        volatile float rounded; /* in fact: -ffast-math may take the float for the double that it was */
        float at, force, alone, slope, mu, mu_slope;
        double x, exact, exact_slope, off;
        if (!is_finite(&loads[i]) || fabs(loads[i]) > (double)FLT_MAX) continue;
        rounded = (float)loads[i];
        at = rounded;
        x = (double)at - table->pull_off_load;
        force = asperity_eval_friction_force_float(&single, at, &slope);
        mu = asperity_eval_friction_float(&single, at, &mu_slope);
        alone = asperity_eval_friction_force_float(&single, at, NULL);
        claim(memcmp(&alone, &force, sizeof force) == 0, "another force of floats without the slope", &loads[i]);
        if (x < 0.0 && -x > 1e-6 * fabs(table->pull_off_load))
            claim(force == 0.0f && mu == 0.0f, "friction of floats below pull-off", &loads[i]);
        if (at == 0.0f)
            claim(fabs((double)force - table->zero_force) <= 1e-7 * table->zero_force + 1e-45, "another force of floats", &loads[i]);
        if (x < 0x1p-100 || x > 0x1p100 || x < 1e-6 * fabs(table->pull_off_load) || row_of(table, x) == table->row_count) continue;
        exact = asperity_friction_force_and_slope_at_load(model, (double)at, &exact_slope);
        off = fabs((double)force / exact - 1.0);
        ++compared;
        claim(off < 1e-6, "a force of floats is off by more than 1e-6", &loads[i]);
        claim(at <= force * single.inverse_cap || fabs((double)mu * (double)at / exact - 1.0) < 1e-6, "another mu", &loads[i]);
        rounded_off += off > 2e-7 || fabs((double)slope / exact_slope - 1.0) > 2e-7;
    }
    require(compared > LOADS / 3 && rounded_off < compared / 200, "floats are off at too many loads");
    if (!FAST) {
        require(isnan(asperity_eval_friction_force_float(&single, (float)NAN, NULL)), "a number at no load");
        require(isnan(asperity_eval_friction_float(&single, (float)INFINITY, NULL)), "a number at an infinite load");
    }
    free(rows);
}

static void check_surface(int which)
{
    asperity_params params = surface(which);
    asperity_model *model = NULL;
    asperity_table table;
    asperity_summary summary;
    surface_name = SURFACE_NAMES[which];
    if (which == 6) params.max_friction_coefficient = INFINITY;
    if (which == 7) params.max_friction_coefficient = 2.0;
    table.struct_size = sizeof table;
    summary.struct_size = sizeof summary;
    if (asperity_create(&params, &model) != ASPERITY_OK || asperity_summary_of(model, &summary) != ASPERITY_OK ||
        asperity_table_of(model, ASPERITY_TABLE_FRICTION, &table) != ASPERITY_OK) {
        require(0, "no table");
        return;
    }
    require(table.layout_version == ASPERITY_TABLE_LAYOUT, "another layout than the header's");
    require((uintptr_t)table.rows % 64 == 0, "rows are not aligned to 64 bytes");
    require(table.pull_off_load == summary.pull_off_load, "two pull-off loads");
    fill(&table, &summary);
    check(model, &table);
    check_floats(model, &table);
    check_loads_at_gaps(model);
    asperity_free(model);
}

int main(void)
{
    int which;
#ifdef GPU
    printf("  %s\n", device_is_there() ? "evaluates on the host and on the device"
                                       : "no device: the kernel is compiled, and only the host's code is run");
#endif
    if (!FAST) /* which may compute ahead of a condition what the condition keeps from overflow */
        feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
    for (which = 0; which < SURFACES; ++which) check_surface(which);
    require(all.linked > LOADS / 50 && all.capped > LOADS / 10, "too few loads in parts of rows, or capped");
    return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
