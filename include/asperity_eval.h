/* asperity_eval.h: evaluates a table of asperity where the library cannot be called: in GPU kernels, OpenMP target
 * regions, loops that a compiler shall vectorise.
 *
 *     asperity_table table;
 *     table.struct_size = sizeof table;
 *     asperity_table_of(model, &table);
 *     double force = asperity_eval_friction_force(&table, load, NULL);
 *
 * Self-contained but for the declaration of asperity_table: C99, C++, CUDA, HIP; no libm, and no branch on data but for
 * rows in parts, loads beside the table and the caps. For a kernel, copy table.total_count * 8 doubles from table.rows to
 * the device and point a copy of the struct there.
 *
 * Where the library answers from the table, these functions give the same bits, provided that the compiler does not
 * contract a*b + c into a fused multiply-add: GCC does so with -march of a processor that has it, unless -std=c99 or
 * -ffp-contract=off is given; with contraction the last bit or two may differ. Clang, CUDA and HIP are told below.
 *
 * There is no library to ask in a kernel, so every load has its rule:
 *
 *   below pull-off             as the library: force and coefficient 0; slope table.separated_slope (0 with adhesion)
 *   zero                       as the library
 *   pulling, pull-off to zero  from the table; the coefficient is the cap
 *   lighter than the table     a straight line from the force at pull-off to the table's lightest load, with the slope of
 *                              that line. Where the table reaches pull-off, such loads lie within 1e-9 of the pull-off
 *                              load above it and the force is right to 1e-4; elsewhere they are below 1e-24 of the load
 *                              at which half the summits touch, and the coefficient is about that of the lightest load
 *   heavier than the table     the force of the heaviest load, slope 0: a bound, 1e12 and more times beyond the load at
 *                              which half the summits touch. The library evaluates such loads exactly
 *   not finite                 NaN
 *
 * NaN is left for a finite load in the few rows, if any, that could not be made (the library evaluates them exactly): with
 * adhesion or without, Gaussian heights have none below 1e9 times the load at which half the summits touch.
 */
#ifndef ASPERITY_EVAL_H
#define ASPERITY_EVAL_H

#include <stdint.h>
#include <string.h>

#include "asperity.h"

#if defined(__CUDACC__) || defined(__HIPCC__)
#define ASPERITY_EVAL_FUNCTION static inline __host__ __device__
#else
#define ASPERITY_EVAL_FUNCTION static inline
#endif

#if defined(__CUDA_ARCH__)
/* Rounded after each operation, never contracted. HIP's functions of these names may be: there the pragma tells. */
#define ASPERITY_EVAL_ADD(a, b) __dadd_rn((a), (b))
#define ASPERITY_EVAL_MUL(a, b) __dmul_rn((a), (b))
#else
#define ASPERITY_EVAL_ADD(a, b) ((a) + (b))
#define ASPERITY_EVAL_MUL(a, b) ((a) * (b))
#endif

#if defined(__clang__) && !defined(__CUDA_ARCH__)
#define ASPERITY_EVAL_NO_CONTRACTION _Pragma("clang fp contract(off)")
#else
#define ASPERITY_EVAL_NO_CONTRACTION
#endif

#if defined(__HIPCC__) && !defined(__CUDACC__)
/* memcpy itself is there for the device only where hip_runtime.h came first. */
#define ASPERITY_EVAL_COPY __builtin_memcpy
#else
#define ASPERITY_EVAL_COPY memcpy
#endif

#define ASPERITY_EVAL_MANTISSA ((UINT64_C(1) << 52) - 1)
#define ASPERITY_EVAL_ONE (UINT64_C(1023) << 52)
#define ASPERITY_EVAL_TWICE_BIAS (UINT64_C(2046) << 52)
#define ASPERITY_EVAL_EXPONENT (UINT64_C(2047) << 52)
#define ASPERITY_EVAL_OFFSET ((UINT64_C(1) << 51) - 1)

ASPERITY_EVAL_FUNCTION uint64_t asperity_eval_bits(double x)
{
    uint64_t bits;
    ASPERITY_EVAL_COPY(&bits, &x, sizeof bits);
    return bits;
}

ASPERITY_EVAL_FUNCTION double asperity_eval_double(uint64_t bits)
{
    double x;
    ASPERITY_EVAL_COPY(&x, &bits, sizeof x);
    return x;
}

/* a + b t */
ASPERITY_EVAL_FUNCTION double asperity_eval_line(double a, double b, double t)
{
    ASPERITY_EVAL_NO_CONTRACTION
    return ASPERITY_EVAL_ADD(a, ASPERITY_EVAL_MUL(b, t));
}

/* The part of a row in which *t lies, and t in it; NULL if it is left out. */
ASPERITY_EVAL_FUNCTION const double *asperity_eval_part(const asperity_table *table, const double *row, double *t)
{
    ASPERITY_EVAL_NO_CONTRACTION
    double begin = 0.0;
    int i;

    while (row[0] != row[0]) {
        const uint64_t offset = asperity_eval_bits(row[0]) & ASPERITY_EVAL_OFFSET;
        const double *part = table->rows + offset / sizeof(double);
        if (offset == 0)
            return NULL;
        for (i = 2; i < 8 && *t >= row[i]; ++i) {
            begin = row[i];
            part += 8;
        }
        row = part;
    }
    *t = ASPERITY_EVAL_ADD(*t, -begin);
    return row;
}

/* Friction force beside the rows, and its slope. */
ASPERITY_EVAL_FUNCTION double asperity_eval_beside(const asperity_table *table, double load, double x, double *slope)
{
    ASPERITY_EVAL_NO_CONTRACTION
    *slope = 0.0;
    if (load == 0.0) {
        *slope = table->zero_slope;
        return table->zero_force;
    }
    if ((asperity_eval_bits(x) >> table->shift) > table->base)
        return table->heavy_force;
    *slope = table->light_slope;
    return asperity_eval_line(table->pull_off_force, table->light_slope, x);
}

/* Friction force at a load [force], and dF/d(load) unless NULL is given for it. */
ASPERITY_EVAL_FUNCTION double asperity_eval_friction_force(const asperity_table *table, double load,
                                                           double *dforce_dload)
{
    ASPERITY_EVAL_NO_CONTRACTION
    const double nan = asperity_eval_double(UINT64_C(0x7ff8000000000000));
    double x, t, t2, t4, force, slope;
    uint64_t bits, index;
    const double *c;

    if (dforce_dload)
        *dforce_dload = nan;
    if ((asperity_eval_bits(load) & ASPERITY_EVAL_EXPONENT) == ASPERITY_EVAL_EXPONENT)
        return nan;
    if (load < table->pull_off_load) {
        if (dforce_dload)
            *dforce_dload = table->separated_slope;
        return 0.0;
    }
    x = ASPERITY_EVAL_ADD(load, -table->pull_off_load);
    bits = asperity_eval_bits(x);
    index = (bits >> table->shift) - table->base;
    if (index >= table->row_count) {
        force = asperity_eval_beside(table, load, x, &slope);
        if (dforce_dload)
            *dforce_dload = slope;
        return force;
    }
    t = asperity_eval_double((bits & ((UINT64_C(1) << table->shift) - 1)) | ASPERITY_EVAL_ONE) - 1.0;
    c = asperity_eval_part(table, table->rows + 8 * index, &t);
    if (!c)
        return nan;
    t2 = ASPERITY_EVAL_MUL(t, t);
    t4 = ASPERITY_EVAL_MUL(t2, t2);
    force = asperity_eval_line(
        asperity_eval_line(asperity_eval_line(c[0], c[1], t), asperity_eval_line(c[2], c[3], t), t2),
        asperity_eval_line(asperity_eval_line(c[4], c[5], t), asperity_eval_line(c[6], c[7], t), t2), t4);
    if (dforce_dload) {
        double rate = asperity_eval_line(
            asperity_eval_line(asperity_eval_line(c[1], 2.0 * c[2], t), asperity_eval_line(3.0 * c[3], 4.0 * c[4], t),
                               t2),
            asperity_eval_line(asperity_eval_line(5.0 * c[5], 6.0 * c[6], t), 7.0 * c[7], t2), t4);
        double inverse_binade = asperity_eval_double(ASPERITY_EVAL_TWICE_BIAS - (bits & ~ASPERITY_EVAL_MANTISSA));
        *dforce_dload = ASPERITY_EVAL_MUL(rate, inverse_binade);
    }
    return force;
}

/* Friction coefficient at a load, capped as the library caps it, and d(mu)/d(load) [1/force] unless NULL is given
 * for it. Below pull-off both are 0. */
ASPERITY_EVAL_FUNCTION double asperity_eval_friction(const asperity_table *table, double load, double *dmu_dload)
{
    ASPERITY_EVAL_NO_CONTRACTION
    double slope = 0.0, mu, difference, size, divisor;
    double force = asperity_eval_friction_force(table, load, dmu_dload ? &slope : NULL);
    if (force != force || load < table->pull_off_load) {
        if (dmu_dload)
            *dmu_dload = force;
        return force;
    }
    if (load <= ASPERITY_EVAL_MUL(force, table->inverse_cap)) {
        if (dmu_dload)
            *dmu_dload = 0.0;
        return table->max_friction_coefficient;
    }
    mu = force / load;
    if (dmu_dload) {
        /* (dF/dP - F/P)/P, saturating where it would overflow. */
        difference = ASPERITY_EVAL_ADD(slope, -mu);
        size = difference < 0.0 ? -difference : difference;
        divisor = load < 1.0 ? load : 1.0;
        *dmu_dload = size >= ASPERITY_EVAL_MUL(1e300, divisor) ? (difference < 0.0 ? -1e300 : 1e300)
                                                                : difference / load;
    }
    return mu;
}

#endif
