/* The answers of models made on this processor, as a list: for each surface a hash of its table, of each kind of call, of
 * exact states and of the summary. Two processors with the same list give the same bits. */

#include "answers.h"

#include <inttypes.h>

enum { FAMILIES = 5 };

static const char *const FAMILY_NAMES[FAMILIES] = {
    "Weibull heights, skew 1.5", "Johnson heights, bounded", "Johnson heights, unbounded", "measured heights",
    "spectral moments",
};

/* A surface of each kind of heights that surfaces.h leaves out. */
static asperity_params of_family(int which)
{
    static const double height[] = {-3, -2, -1, -0.25, 0.5, 1.25, 2, 3};
    static const double density[] = {0, 0.05, 0.2, 0.4, 0.37, 0.21, 0.06, 0.0};
    asperity_params p;

    asperity_params_init(&p);
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
    default:
        p = surface(8);
        CHECK(asperity_params_set_spectral_moments(&p, 2.5e-17, 1.5e-3, 4.4e11, 1e-8) == ASPERITY_OK, "moments");
        break;
    }
    return p;
}

/* FNV-1a. */
static uint64_t hash(const void *bytes, size_t size)
{
    const unsigned char *byte = bytes;
    uint64_t h = 0xcbf29ce484222325;

    for (size_t i = 0; i < size; i++)
        h = (h ^ byte[i]) * 0x100000001b3;
    return h;
}

static void list(const char *name, asperity_params p)
{
    static answers of;
    asperity_model *model = NULL;
    asperity_table table = {.struct_size = sizeof table};

    CHECK(asperity_create(&p, &model) == ASPERITY_OK, "surface %s", name);
    if (model == NULL)
        return;
    answer(model, &of);
    CHECK(asperity_table_of(model, &table) == ASPERITY_OK, "surface %s", name);
    /* The vectors of this processor against its scalar call. */
    CHECK(memcmp(of.batch, of.force, sizeof of.batch) == 0, "%s: a batch has other bits than its calls", name);
    printf("%-32s", name);
    printf(" table %016" PRIx64, hash(table.rows, table.total_count * 8 * sizeof *table.rows));
    /* The view without the address of its rows. */
    table.rows = NULL;
    printf(" ends %016" PRIx64, hash(&table, sizeof table));
    printf(" loads %016" PRIx64, hash(of.load, sizeof of.load));
    printf(" mu %016" PRIx64, hash(of.mu, sizeof of.mu));
    printf(" force %016" PRIx64, hash(of.batch, sizeof of.batch));
    printf(" slope %016" PRIx64, hash(of.slope, sizeof of.slope));
    printf(" exact %016" PRIx64, hash(of.exact, sizeof of.exact));
    printf(" summary %016" PRIx64 "\n", hash(&of.summary, sizeof of.summary));
    asperity_free(model);
}

int main(void)
{
    for (int s = 0; s < SURFACES; s++)
        list(SURFACE_NAMES[s], surface(s));
    for (int f = 0; f < FAMILIES; f++)
        list(FAMILY_NAMES[f], of_family(f));
    return checks_report("processors");
}
