/* asperity_eval.h: evaluates a table of asperity where a program cannot call the library: in GPU kernels, OpenMP target
 * regions, loops that a compiler shall vectorise.
 *
 *     asperity_table table;
 *     table.struct_size = sizeof table;
 *     asperity_table_of(model, ASPERITY_TABLE_FRICTION, &table);
 *     double force = asperity_eval_friction_force(&table, load, NULL);
 *
 * It needs the declaration of asperity_table and nothing else: C99, C++, CUDA, HIP, without libm. It branches on data only
 * for rows in parts, loads outside the table and the upper bound of the coefficient. For a kernel, copy table.total_count * 8 doubles from table.rows to
 * the device and point a copy of the struct there.
 *
 * Where the library answers from the table, these functions give the same bits, provided that the compiler does not
 * contract a*b + c into a fused multiply-add: GCC does so with -march of a processor that has it, unless -std=c99 or
 * -ffp-contract=off is given; with contraction the last bit or two may differ. Clang, CUDA and HIP are told below.
 *
 * -ffast-math, -Ofast and -ffinite-math-only are allowed, and the last bits may differ. Such a compiler assumes that no number
 * is NaN or infinite: do not pass loads that are, and expect any number where these functions give NaN or infinity. nvcc's
 * --use_fast_math changes no double; of floats it changes the last bits, and takes those below 1.2e-38 for 0.
 *
 * A kernel cannot call the library, so that every load has its rule:
 *
 *   below pull-off             as the library: force and coefficient 0; slope table.separated_slope, 0
 *   zero                       as the library
 *   pulling, pull-off to zero  from the table; the coefficient is the cap
 *   lighter than the table     a straight line from the force at pull-off to the table's lightest load, with the slope of
 *                              that line. Where the table reaches pull-off, such loads lie within 1e-9 of the pull-off
 *                              load above it and the force is right to 2e-4; elsewhere they are below 1e-15 of the load
 *                              at which half the summits touch, and the coefficient is about that of the lightest load
 *   heavier than the table     the force of the heaviest load, slope 0: a bound, 1e3 and more times beyond the load at
 *                              which half the summits touch. The library goes on with a power of the load
 *   not finite                 NaN
 *
 * For processors that are slow at doubles there is a second table, of floats, made from the first: see
 * asperity_float_table below.
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
#define ASPERITY_EVAL_ADDF(a, b) __fadd_rn((a), (b))
#define ASPERITY_EVAL_MULF(a, b) __fmul_rn((a), (b))
#define ASPERITY_EVAL_ROUNDED
#elif defined(__GNUC__) && !defined(__clang__) && !defined(__EDG__) && !defined(__CUDACC__) && __GNUC__ >= 12
/* Not to be summed in another order, as -ffast-math would. Clang is told by a pragma. */
#define ASPERITY_EVAL_ADD(a, b) __builtin_assoc_barrier((a) + (b))
#define ASPERITY_EVAL_MUL(a, b) __builtin_assoc_barrier((a) * (b))
#define ASPERITY_EVAL_ADDF(a, b) __builtin_assoc_barrier((a) + (b))
#define ASPERITY_EVAL_MULF(a, b) __builtin_assoc_barrier((a) * (b))
#define ASPERITY_EVAL_ROUNDED
#else
#define ASPERITY_EVAL_ADD(a, b) ((a) + (b))
#define ASPERITY_EVAL_MUL(a, b) ((a) * (b))
#define ASPERITY_EVAL_ADDF(a, b) ((a) + (b))
#define ASPERITY_EVAL_MULF(a, b) ((a) * (b))
/* What others must round under -ffast-math, MSVC's /fp:fast, goes by the memory. */
#if (defined(__FAST_MATH__) || defined(_M_FP_FAST)) && !(defined(__clang__) && __clang_major__ > 12)
#define ASPERITY_EVAL_ROUNDED volatile
#else
#define ASPERITY_EVAL_ROUNDED
#endif
#endif

#if defined(__clang__) && !defined(__CUDA_ARCH__) && __clang_major__ > 12
#define ASPERITY_EVAL_NO_CONTRACTION _Pragma("clang fp contract(off) reassociate(off)")
#elif defined(__clang__) && !defined(__CUDA_ARCH__)
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

/* Whether a number is NaN. A comparison with itself would not tell under -ffast-math. */
ASPERITY_EVAL_FUNCTION int asperity_eval_is_nan(const double *x)
{
    uint64_t bits;
    ASPERITY_EVAL_COPY(&bits, x, sizeof bits);
    return bits << 1 > ASPERITY_EVAL_EXPONENT << 1;
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

    while (asperity_eval_is_nan(row)) {
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

/* Friction force at loads outside the rows, and its slope. */
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

/* Friction force at a finite load that is x >= 0 above pull-off; the load itself only tells whether it is 0. */
ASPERITY_EVAL_FUNCTION double asperity_eval_at_excess(const asperity_table *table, double load, double x,
                                                      double *dforce_dload)
{
    ASPERITY_EVAL_NO_CONTRACTION
    const double nan = asperity_eval_double(UINT64_C(0x7ff8000000000000));
    double t, t2, t4, force, slope;
    uint64_t bits, index;
    const double *c;

    if (dforce_dload)
        *dforce_dload = nan;
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

/* Friction force at a load [force], and dF/d(load) unless NULL is given for it. */
ASPERITY_EVAL_FUNCTION double asperity_eval_friction_force(const asperity_table *table, double load,
                                                           double *dforce_dload)
{
    ASPERITY_EVAL_NO_CONTRACTION
    const double nan = asperity_eval_double(UINT64_C(0x7ff8000000000000));

    if ((asperity_eval_bits(load) & ASPERITY_EVAL_EXPONENT) == ASPERITY_EVAL_EXPONENT) {
        if (dforce_dload)
            *dforce_dload = nan;
        return nan;
    }
    if (load < table->pull_off_load) {
        if (dforce_dload)
            *dforce_dload = table->separated_slope;
        return 0.0;
    }
    return asperity_eval_at_excess(table, load, ASPERITY_EVAL_ADD(load, -table->pull_off_load), dforce_dload);
}

/* Friction coefficient at a load, capped as the library caps it, and d(mu)/d(load) [1/force] unless NULL is given
 * for it. Below pull-off both are 0. */
ASPERITY_EVAL_FUNCTION double asperity_eval_friction(const asperity_table *table, double load, double *dmu_dload)
{
    ASPERITY_EVAL_NO_CONTRACTION
    double slope = 0.0, mu, difference, size, divisor;
    double force = asperity_eval_friction_force(table, load, dmu_dload ? &slope : NULL);
    if (asperity_eval_is_nan(&force) || load < table->pull_off_load) {
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

/* ---- Single precision ---- */

/* The law in floats. A row is a polynomial for an eighth of a binade of x = load - pull-off load, found from the bits of x
 * as a float, (bits >> 20) - base. Rows have 8 floats: the coefficients of t^0 to t^5, t as for doubles, and what the first
 * two of them lose by rounding. A row whose first float is NaN is a link to its eight parts, which the next three bits of x
 * choose; the last 22 bits of that NaN are the index of the first part, and t begins where the part does. Without an
 * index the row is left out, as it is among the doubles.
 *
 *     float *rows = malloc(asperity_eval_make_float(&table, NULL, NULL) * 8 * sizeof *rows);
 *     asperity_float_table single;
 *     asperity_eval_make_float(&table, rows, &single);
 *     float force = asperity_eval_friction_force_float(&single, load, NULL);
 *
 * Force and slope are within 2e-7 of those of the library for the same load, a float, where that answers from its table and
 * the load is above pull-off by 2^-100 to 2^100 (8e-31 to 1e30; choose units in which it is) and by more than 1e-6 of the
 * pull-off load. Where all contacts meet a kink of the law together, the slope is rounded off within 1/2048 of that load; next
 * to rows that the doubles leave out as much is left out. Beside that range the rules are those for doubles. To use the
 * table elsewhere, copy total_count * 8 floats and change the pointer. */
typedef struct asperity_float_table {
    const float *rows;
    uint32_t row_count; /* found from x; parts follow them */
    uint32_t base;
    uint32_t total_count;
    float pull_off_load, pull_off_rest; /* the pull-off load is their sum */
    float max_friction_coefficient, inverse_cap;
    float pull_off_force, light_slope;
    float zero_force, zero_slope;
    float separated_slope, heavy_force;
} asperity_float_table;

#define ASPERITY_EVAL_FLOAT_SHIFT 20
#define ASPERITY_EVAL_FLOAT_ONE (UINT32_C(127) << 23)
#define ASPERITY_EVAL_FLOAT_EXPONENT (UINT32_C(255) << 23)
#define ASPERITY_EVAL_FLOAT_LINK (UINT32_C(0x1ff) << 22)
#define ASPERITY_EVAL_FLOAT_LEAST_SHIFT (ASPERITY_EVAL_FLOAT_SHIFT - 9)

ASPERITY_EVAL_FUNCTION uint32_t asperity_eval_float_bits(float x)
{
    uint32_t bits;
    ASPERITY_EVAL_COPY(&bits, &x, sizeof bits);
    return bits;
}

ASPERITY_EVAL_FUNCTION float asperity_eval_float(uint32_t bits)
{
    float x;
    ASPERITY_EVAL_COPY(&x, &bits, sizeof x);
    return x;
}

ASPERITY_EVAL_FUNCTION int asperity_eval_is_nan_float(const float *x)
{
    uint32_t bits;
    ASPERITY_EVAL_COPY(&bits, x, sizeof bits);
    return bits << 1 > ASPERITY_EVAL_FLOAT_EXPONENT << 1;
}

/* Where the rows of floats begin and end, as the shifted bits of x: within the table, and from 2^-100 to 2^100. */
static inline void asperity_eval_float_range(const asperity_table *table, uint32_t *begin, uint32_t *end)
{
    /* Eighths of a binade, counted as the exponents of floats are. */
    const uint64_t bias = (UINT64_C(1023) - 127) << 3, least = (127 - 100) << 3, most = (127 + 100) << 3;
    uint64_t first = ((table->base << table->shift) + ((UINT64_C(1) << 49) - 1)) >> 49;
    uint64_t last = ((table->base + table->row_count) << table->shift) >> 49;
    if (first < bias + least)
        first = bias + least;
    if (last > bias + most)
        last = bias + most;
    *begin = (uint32_t)(first - bias);
    *end = last > first ? (uint32_t)(last - bias) : *begin;
}

/* The nearest float that is finite; NaN of NaN. */
static inline float asperity_eval_rounded(double x)
{
    ASPERITY_EVAL_NO_CONTRACTION
    const double largest = 3.4028234663852886e38;
    if (asperity_eval_is_nan(&x))
        return asperity_eval_float(UINT32_C(0x7fc00000));
    return (float)(x > largest ? largest : x < -largest ? -largest : x);
}

/* The polynomial of degree 5 through the force at six places of a row, those at which Chebyshev's polynomial is 0. The row
 * begins at the float of these bits and is 1/2^(23 - shift) of a binade long. */
static inline void asperity_eval_fit_float(const asperity_table *table, uint32_t bits, uint32_t shift, float *row)
{
    ASPERITY_EVAL_NO_CONTRACTION
    static const double part[6] = {0.017037086855465844, 0.14644660940672622, 0.3705904774487396,
                                   0.6294095225512604,   0.8535533905932737,  0.9829629131445341};
    const double length = (double)(UINT32_C(1) << shift) / 8388608.0;
    const double binade = (double)asperity_eval_float(bits & ASPERITY_EVAL_FLOAT_EXPONENT);
    const double begin = (double)asperity_eval_float(bits) / binade;
    double c[6] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, value[6];
    int i, k;

    for (i = 0; i < 6; ++i) {
        value[i] = asperity_eval_at_excess(table, 1.0, (begin + part[i] * length) * binade, NULL);
        if (asperity_eval_is_nan(&value[i])) {
            for (k = 0; k < 8; ++k)
                row[k] = asperity_eval_float(UINT32_C(0x7fc00000));
            return;
        }
    }
    /* Newton's divided differences, then powers. */
    for (k = 1; k < 6; ++k)
        for (i = 5; i >= k; --i)
            value[i] = (value[i] - value[i - 1]) / (part[i] - part[i - k]);
    for (k = 5; k >= 0; --k) {
        for (i = 5; i > 0; --i)
            c[i] = c[i - 1] - part[k] * c[i];
        c[0] = value[k] - part[k] * c[0];
    }
    for (i = 1; i < 6; ++i)
        for (k = i; k < 6; ++k)
            c[k] /= length;
    for (i = 0; i < 6; ++i)
        row[i] = asperity_eval_rounded(c[i]);
    for (i = 0; i < 2; ++i)
        row[6 + i] = asperity_eval_rounded(c[i] - (double)row[i]);
}

/* Whether force and slope of a row are good between the places that made it, or the doubles have none at all of them. */
static inline int asperity_eval_float_is_good(const asperity_table *table, uint32_t bits, uint32_t shift,
                                              const float *row)
{
    ASPERITY_EVAL_NO_CONTRACTION
    const double length = (double)(UINT32_C(1) << shift) / 8388608.0;
    const double binade = (double)asperity_eval_float(bits & ASPERITY_EVAL_FLOAT_EXPONENT);
    int i, missing = 0;

    for (i = 0; i < 8; ++i) {
        const double t = (0.0625 + 0.125 * i) * length;
        double slope, force, value = 0.0, rate = 0.0;
        int k;

        force = asperity_eval_at_excess(table, 1.0, (double)asperity_eval_float(bits) + t * binade, &slope);
        if (asperity_eval_is_nan_float(row) || asperity_eval_is_nan(&force)) {
            ++missing;
            continue;
        }
        for (k = 5; k >= 0; --k) {
            rate = rate * t + value;
            value = value * t + (double)row[k] + (k < 2 ? (double)row[6 + k] : 0.0);
        }
        value -= force;
        rate -= slope * binade;
        /* Half the rounding of a float for the force, and 1e-7 for the slope: with the roundings of evaluating the row,
         * within the 2e-7 that are told above. */
        if (value * value > 1e-15 * force * force || rate * rate > 1e-14 * (slope * binade) * (slope * binade))
            return 0;
    }
    return missing == 0 || missing == 8;
}

/* Fills row `index`, and from row `count` on the parts that it needs; without `rows` it only counts. Returns the number of
 * rows and parts afterwards. */
static inline uint32_t asperity_eval_fill_float(const asperity_table *table, uint32_t bits, uint32_t shift, float *rows,
                                                uint32_t index, uint32_t count)
{
    const uint32_t link = ASPERITY_EVAL_FLOAT_LINK | count;
    float row[8];
    uint32_t i;

    asperity_eval_fit_float(table, bits, shift, row);
    if (shift > ASPERITY_EVAL_FLOAT_LEAST_SHIFT && !asperity_eval_float_is_good(table, bits, shift, row)) {
        const uint32_t first = count;
        count += 8;
        ASPERITY_EVAL_COPY(row, &link, sizeof link);
        for (i = 0; i < 8; ++i)
            count = asperity_eval_fill_float(table, bits + (i << (shift - 3)), shift - 3, rows, first + i, count);
    }
    if (rows)
        for (i = 0; i < 8; ++i)
            ASPERITY_EVAL_COPY(rows + 8 * (size_t)index + i, row + i, sizeof *row);
    return count;
}

/* Makes the table of floats, on the host, of one that the library has filled, into `rows`, to which `single` points
 * afterwards. Returns the number of its rows and parts, each 8 floats; with NULL for `rows` it does only that. */
static inline uint32_t asperity_eval_make_float(const asperity_table *table, float *rows, asperity_float_table *single)
{
    ASPERITY_EVAL_NO_CONTRACTION
    uint32_t begin, end, i, count;
    double lightest, heaviest;

    asperity_eval_float_range(table, &begin, &end);
    count = end - begin;
    for (i = begin; i < end; ++i)
        count = asperity_eval_fill_float(table, i << ASPERITY_EVAL_FLOAT_SHIFT, ASPERITY_EVAL_FLOAT_SHIFT, rows,
                                         i - begin, count);
    if (!rows || !single)
        return count;
    lightest = (double)asperity_eval_float(begin << ASPERITY_EVAL_FLOAT_SHIFT);
    heaviest = (double)asperity_eval_float(end << ASPERITY_EVAL_FLOAT_SHIFT);
    single->rows = rows;
    single->row_count = end - begin;
    single->base = begin;
    single->total_count = count;
    single->pull_off_load = asperity_eval_rounded(table->pull_off_load);
    single->pull_off_rest = (float)(table->pull_off_load - (double)single->pull_off_load);
    /* A greater cap is none: its inverse would not be a normal float. */
    single->max_friction_coefficient = table->max_friction_coefficient > 8e37
                                           ? asperity_eval_float(ASPERITY_EVAL_FLOAT_EXPONENT) /* infinite */
                                           : (float)table->max_friction_coefficient;
    single->inverse_cap = (float)(table->inverse_cap > 1.25e-38 ? table->inverse_cap : 1.25e-38);
    single->pull_off_force = asperity_eval_rounded(table->pull_off_force);
    single->light_slope = asperity_eval_rounded(
        (asperity_eval_at_excess(table, 1.0, lightest, NULL) - table->pull_off_force) / lightest);
    single->zero_force = asperity_eval_rounded(table->zero_force);
    single->zero_slope = asperity_eval_rounded(table->zero_slope);
    single->separated_slope = asperity_eval_rounded(table->separated_slope);
    single->heavy_force = asperity_eval_rounded(asperity_eval_at_excess(table, 1.0, heaviest, NULL));
    return count;
}

/* a + b t */
ASPERITY_EVAL_FUNCTION float asperity_eval_line_float(float a, float b, float t)
{
    ASPERITY_EVAL_NO_CONTRACTION
    return ASPERITY_EVAL_ADDF(a, ASPERITY_EVAL_MULF(b, t));
}

/* x = load - pull-off load, and what it loses by rounding. */
ASPERITY_EVAL_FUNCTION float asperity_eval_excess_float(const asperity_float_table *table, float load, float *lost)
{
    ASPERITY_EVAL_NO_CONTRACTION
    const float minus = -table->pull_off_load;
    const ASPERITY_EVAL_ROUNDED float sum = ASPERITY_EVAL_ADDF(load, minus);
    const ASPERITY_EVAL_ROUNDED float added = ASPERITY_EVAL_ADDF(sum, -load);
    const ASPERITY_EVAL_ROUNDED float of_load = ASPERITY_EVAL_ADDF(load, -ASPERITY_EVAL_ADDF(sum, -added));
    const ASPERITY_EVAL_ROUNDED float rest = ASPERITY_EVAL_ADDF(ASPERITY_EVAL_ADDF(of_load, ASPERITY_EVAL_ADDF(minus, -added)),
                                          -table->pull_off_rest);
    const ASPERITY_EVAL_ROUNDED float x = ASPERITY_EVAL_ADDF(sum, rest);
    *lost = ASPERITY_EVAL_ADDF(rest, -ASPERITY_EVAL_ADDF(x, -sum));
    return x;
}

/* Friction force in the rows at x, of these bits, and its slope. */
ASPERITY_EVAL_FUNCTION float asperity_eval_in_row_float(const asperity_float_table *table, uint32_t bits, float lost,
                                                        float *slope)
{
    ASPERITY_EVAL_NO_CONTRACTION
    uint32_t index = (bits >> ASPERITY_EVAL_FLOAT_SHIFT) - table->base, shift = ASPERITY_EVAL_FLOAT_SHIFT;
    const float *c = table->rows + 8 * (size_t)index;
    float t, inverse_binade, force, rate;

    while (asperity_eval_is_nan_float(c) && (index = asperity_eval_float_bits(c[0]) & ~ASPERITY_EVAL_FLOAT_LINK) != 0) {
        shift -= 3;
        c = table->rows + 8 * (size_t)(index + ((bits >> shift) & 7));
    }
    inverse_binade = asperity_eval_float(2 * ASPERITY_EVAL_FLOAT_ONE - (bits & ASPERITY_EVAL_FLOAT_EXPONENT));
    t = asperity_eval_float((bits & ((UINT32_C(1) << shift) - 1)) | ASPERITY_EVAL_FLOAT_ONE) - 1.0f;
    t = asperity_eval_line_float(t, lost, inverse_binade);
    force = asperity_eval_line_float(c[3], asperity_eval_line_float(c[4], c[5], t), t);
    force = asperity_eval_line_float(c[1], asperity_eval_line_float(c[2], force, t), t);
    rate = asperity_eval_line_float(3.0f * c[3], asperity_eval_line_float(4.0f * c[4], 5.0f * c[5], t), t);
    rate = asperity_eval_line_float(c[7], asperity_eval_line_float(2.0f * c[2], rate, t), t);
    *slope = ASPERITY_EVAL_MULF(ASPERITY_EVAL_ADDF(c[1], rate), inverse_binade);
    return ASPERITY_EVAL_ADDF(c[0], asperity_eval_line_float(c[6], force, t));
}

/* Friction force at loads outside the rows, and its slope. */
ASPERITY_EVAL_FUNCTION float asperity_eval_beside_float(const asperity_float_table *table, float load, float x,
                                                        float *slope)
{
    ASPERITY_EVAL_NO_CONTRACTION
    *slope = 0.0f;
    if (x < 0.0f) {
        *slope = table->separated_slope;
        return 0.0f;
    }
    if (load == 0.0f) {
        *slope = table->zero_slope;
        return table->zero_force;
    }
    if ((asperity_eval_float_bits(x) >> ASPERITY_EVAL_FLOAT_SHIFT) > table->base)
        return table->heavy_force;
    *slope = table->light_slope;
    return asperity_eval_line_float(table->pull_off_force, table->light_slope, x);
}

/* Friction force at a load [force], and dF/d(load) unless NULL is given for it. */
ASPERITY_EVAL_FUNCTION float asperity_eval_friction_force_float(const asperity_float_table *table, float load,
                                                                float *dforce_dload)
{
    float x, lost, force, slope;
    uint32_t bits;

    if ((asperity_eval_float_bits(load) & ASPERITY_EVAL_FLOAT_EXPONENT) == ASPERITY_EVAL_FLOAT_EXPONENT) {
        force = slope = asperity_eval_float(UINT32_C(0x7fc00000));
    } else {
        x = asperity_eval_excess_float(table, load, &lost);
        bits = asperity_eval_float_bits(x);
        if ((bits >> ASPERITY_EVAL_FLOAT_SHIFT) - table->base < table->row_count)
            force = asperity_eval_in_row_float(table, bits, lost, &slope);
        else
            force = asperity_eval_beside_float(table, load, x, &slope);
    }
    if (dforce_dload)
        *dforce_dload = slope;
    return force;
}

/* Friction coefficient at a load, capped as the library caps it, and d(mu)/d(load) [1/force] unless NULL is given
 * for it. Below pull-off both are 0. */
ASPERITY_EVAL_FUNCTION float asperity_eval_friction_float(const asperity_float_table *table, float load,
                                                          float *dmu_dload)
{
    ASPERITY_EVAL_NO_CONTRACTION
    float lost, slope = 0.0f, mu, difference, size, divisor;
    const float force = asperity_eval_friction_force_float(table, load, dmu_dload ? &slope : NULL);
    if (asperity_eval_is_nan_float(&force) || asperity_eval_excess_float(table, load, &lost) < 0.0f) {
        if (dmu_dload)
            *dmu_dload = force;
        return force;
    }
    if (load <= ASPERITY_EVAL_MULF(force, table->inverse_cap)) {
        if (dmu_dload)
            *dmu_dload = 0.0f;
        return table->max_friction_coefficient;
    }
    mu = force / load;
    if (dmu_dload) {
        /* As for doubles. */
        difference = ASPERITY_EVAL_ADDF(slope, -mu);
        size = difference < 0.0f ? -difference : difference;
        divisor = load < 1.0f ? load : 1.0f;
        *dmu_dload = size >= ASPERITY_EVAL_MULF(1e37f, divisor) ? (difference < 0.0f ? -1e37f : 1e37f)
                                                                 : difference / load;
    }
    return mu;
}

#endif
