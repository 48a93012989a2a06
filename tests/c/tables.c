/* Tables of heights live as long as they should: a model copies the caller's, and lends its own. Every table lies at the
 * ends of heap blocks, so that valgrind sees what is read after it was freed, or beyond. */

#include <asperity.h>

#include <stdlib.h>

#include "check.h"
#include "surfaces.h"

enum { LENGTH = 33 };

/* A raised cosine about 5, in a unit and from an origin of its own. */
static asperity_params with_table(asperity_params p, size_t length)
{
    double *height = malloc(length * sizeof *height), *density = malloc(length * sizeof *density);

    if (height == NULL || density == NULL)
        exit(1);
    for (size_t i = 0; i < length; i++) {
        const double part = (double)i / (double)(length - 1);
        height[i] = 2 + 6 * part;
        density[i] = 1 - cos(2 * 3.14159265358979324 * part);
    }
    p.height_distribution = ASPERITY_HEIGHTS_TABULATED;
    p.table_height = height;
    p.table_density = density;
    p.table_length = length;
    return p;
}

static void free_table(asperity_params *p)
{
    free((void *)p->table_height);
    free((void *)p->table_density);
    p->table_height = p->table_density = NULL;
}

static const char *last_message(void)
{
    static char message[512];
    asperity_last_error(message, sizeof message);
    return message;
}

static void a_table_is_copied_and_lent(void)
{
    asperity_params p = with_table(surface(0), LENGTH), back = { .struct_size = sizeof back };
    asperity_model *model = NULL;
    asperity_summary s;
    double mu;

    CHECK(asperity_create(&p, &model) == ASPERITY_OK, "%s", last_message());
    mu = asperity_friction_at_load(model, 100);
    free_table(&p);
    CHECK(asperity_friction_at_load(model, 100) == mu && mu > 0, "mu = %g", mu);
    s.struct_size = sizeof s;
    CHECK(asperity_summary_of(model, &s) == ASPERITY_OK && fabs(s.skew) < 1e-12, "skew %g", s.skew);
    /* The kurtosis of the raised cosine is 6/5 (90 - pi^4)/(pi^2 - 6)^2 + 3; the table nears it. */
    CHECK(fabs(s.kurtosis - 2.4062) < 0.01, "kurtosis %g", s.kurtosis);

    CHECK(asperity_get_params(model, &back) == ASPERITY_OK && back.table_length == LENGTH, "%s", last_message());
    CHECK(back.table_height != NULL && back.table_height[0] == 2 && back.table_height[LENGTH - 1] == 8, "heights");
    CHECK(back.table_density != NULL && back.table_density[LENGTH / 2] == 2, "densities");

    /* The model's own pointers come back into it, with another parameter. */
    back.asperity_count = 2;
    CHECK(asperity_set_params(model, &back) == ASPERITY_OK, "%s", last_message());
    CHECK(fabs(asperity_friction_at_load(model, 200) / mu - 1) < 1e-8, "twice the summits carry twice the load");
    CHECK(asperity_get_params(model, &back) == ASPERITY_OK && back.asperity_count == 2, "%s", last_message());

    /* On failure its table is where it was. */
    back.summit_radius = -1;
    CHECK(asperity_set_params(model, &back) == ASPERITY_INVALID_PARAMETER, "a negative radius");
    CHECK(back.table_height[0] == 2, "the table moved");
    asperity_free(model);

    /* The caller's was freed above: there is none. */
    CHECK(asperity_create(&p, &model) == ASPERITY_NULL_POINTER && strstr(last_message(), "table_height is NULL"), "%s", last_message());
    p.table_height = &mu;
    CHECK(asperity_create(&p, &model) == ASPERITY_NULL_POINTER && strstr(last_message(), "table_density is NULL"), "%s", last_message());
}

int main(void)
{
    a_table_is_copied_and_lent();
    return checks_report("tables");
}
