/* The table as a kernel reads it: by asperity_eval.h with the declarations of ABI 1, and by the rule that the header states. */

#include "fields.h"

#include <asperity_eval.h>

SEEN_BYTES(table);

static double of_bits(uint64_t bits)
{
    double value;

    memcpy(&value, &bits, sizeof value);
    return value;
}

/* F of a row, or of the part of it in which the load lies. */
static double by_rule(const asperity_table *table, double load)
{
    const double x = load - table->pull_off_load, one = 1.0;
    uint64_t bits, unit, row;
    const double *c;
    double t, force = 0;

    memcpy(&bits, &x, sizeof bits);
    memcpy(&unit, &one, sizeof unit);
    row = (bits >> table->shift) - table->base;
    if (row >= table->row_count)
        return -1;
    t = of_bits((bits & ((UINT64_C(1) << table->shift) - 1)) | unit) - 1;
    for (c = table->rows + 8 * row; isnan(c[0]);) {
        int part = 0;
        memcpy(&bits, c, sizeof bits);
        while (part < 6 && t >= c[2 + part])
            part++;
        t -= part > 0 ? c[1 + part] : 0;
        c = table->rows + (bits & ((UINT64_C(1) << 51) - 1)) / sizeof *c + 8 * part;
    }
    for (int k = 7; k >= 0; k--)
        force = force * t + c[k];
    return force;
}

static asperity_table table_of(const asperity_model *model)
{
    asperity_table table = { .struct_size = sizeof table };

    needs(asperity_table_of(model, &table));
    return table;
}

/* By all routes, at loads from the lightest row to the heaviest and beyond both. */
static void loads(const asperity_model *model, const asperity_table *table, const asperity_summary *s)
{
    const double nearest = s->min_table_load - s->pull_off_load;
    int by_rows = 0;

    for (double x = 1e-3 * nearest; x < 1e3 * s->max_table_load; x *= 1.07) {
        const double load = s->pull_off_load + x;
        double slope, expected_slope;
        const double expected = asperity_friction_force_and_slope_at_load(model, load, &expected_slope);
        const double force = asperity_eval_friction_force(table, load, &slope), rule = by_rule(table, load);

        if (rule < 0)
            continue;
        by_rows++;
        CHECK(force == expected && slope == expected_slope, "at %g: F %.17g, slope %g, by the library %.17g, %g", load, force,
              slope, expected, expected_slope);
        CHECK(fabs(rule / expected - 1) < 1e-14, "at %g: F %.17g by the rule, %.17g", load, rule, expected);
        CHECK(asperity_eval_friction(table, load, NULL) == asperity_friction_at_load(model, load), "the coefficient at %g", load);
    }
    CHECK(by_rows > 500, "%d loads in the rows", by_rows);
}

static void fields(void)
{
    asperity_params p = paper(1000);
    asperity_model *model, *hertz;
    asperity_summary s = { .struct_size = sizeof s };
    asperity_table t, copy;
    uint64_t parts = 0;
    double force, slope, *rows;

    p.max_friction_coefficient = 8;
    model = model_of(&p);
    p.work_of_adhesion = 0;
    hertz = model_of(&p);
    needs(asperity_summary_of(model, &s));
    t = table_of(model);
    HOLDS(table, t, struct_size, t.struct_size == sizeof t);
    HOLDS(table, t, layout_version, t.layout_version == ASPERITY_TABLE_LAYOUT);
    HOLDS(table, t, rows, (uintptr_t)t.rows % 64 == 0);
    NEAR(table, t, pull_off_load, s.pull_off_load, 0);
    NEAR(table, t, max_friction_coefficient, 8, 0);
    NEAR(table, t, inverse_cap, 0.125, 0);
    near_to("table.base", s.pull_off_load + of_bits(t.base << t.shift), s.min_table_load, 1e-12);
    near_to("table.row_count", s.pull_off_load + of_bits((t.base + t.row_count) << t.shift), s.max_table_load, 1e-12);
    SEEN(table, base);
    SEEN(table, shift);
    SEEN(table, row_count);
    /* The last part is that of the last link. */
    for (uint64_t row = 0; row < t.total_count; row++) {
        const double *c = t.rows + 8 * row;
        uint64_t bits, end;
        memcpy(&bits, c, sizeof bits);
        end = (bits & ((UINT64_C(1) << 51) - 1)) / 64 + 1;
        for (int k = 2; isnan(c[0]) && k < 8 && c[k] < 1; k++)
            end++;
        parts = isnan(c[0]) && end > parts ? end : parts;
    }
    HOLDS(table, t, total_count, t.total_count == (parts > 0 ? parts : t.row_count));
    NEAR(table, t, pull_off_force, asperity_friction_force_at_load(model, s.pull_off_load), 1e-12);
    force = asperity_eval_friction_force(&t, s.min_table_load, NULL);
    NEAR(table, t, light_slope, (force - t.pull_off_force) / (s.min_table_load - s.pull_off_load), 1e-3);
    NEAR(table, t, zero_force, asperity_friction_force_and_slope_at_load(model, 0, &slope), 1e-12);
    NEAR(table, t, zero_slope, slope, 1e-9);
    NEAR(table, t, heavy_force, asperity_friction_force_at_load(model, s.max_table_load), 1e-9);
    CHECK(t.separated_slope == 0, "with adhesion a contact that came apart has no slope");
    loads(model, &t, &s);

    /* A copy in memory of just its size, as on a device. */
    copy = t;
    rows = malloc((size_t)t.total_count * 8 * sizeof *rows);
    CHECK(rows != NULL, "no memory for %d rows", (int)t.total_count);
    if (rows != NULL)
        copy.rows = memcpy(rows, t.rows, (size_t)t.total_count * 8 * sizeof *rows);
    loads(model, &copy, &s);
    free(rows);

    needs(asperity_summary_of(hertz, &s));
    asperity_friction_force_and_slope_at_load(hertz, s.min_table_load, &slope);
    t = table_of(hertz);
    NEAR(table, t, separated_slope, slope, 1e-6);
    asperity_free(model);
    asperity_free(hertz);
    ALL_SEEN(table);
}

int main(void)
{
    fields();
    return checks_report("table");
}
