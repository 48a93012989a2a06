/* Programs compiled from abi-1.h alone, as one that was compiled when ABI 1 was young: each field of a struct is compared with
 * what the library says by another route, and each byte of the struct must have been. */

#ifndef FIELDS_H
#define FIELDS_H

#include "../c/check.h"
#include "abi-1.h"

#include <math.h>
#include <stdlib.h>

static char message[512];

static void needs(asperity_status status)
{
    if (status == ASPERITY_OK)
        return;
    asperity_last_error(message, sizeof message);
    fprintf(stderr, "the library refuses: %s\n", message);
    exit(1);
}

static inline int says(const char *text)
{
    asperity_last_error(message, sizeof message);
    return strstr(message, text) != NULL;
}

static inline asperity_model *model_of(const asperity_params *params)
{
    asperity_model *model = NULL;

    needs(asperity_create(params, &model));
    return model;
}

/* The case of the paper, but for the number of summits. */
static inline asperity_params paper(double count)
{
    asperity_params params;

    needs(asperity_params_init(&params, sizeof params));
    needs(asperity_params_set_dimensionless(&params, 0.01, 1000, 0.001, 1, 0.3));
    params.asperity_count = count;
    return params;
}

static void near_to(const char *field, double value, double expected, double tolerance)
{
    CHECK(islessequal(fabs(value - expected), tolerance * fabs(expected)), "%s is %.12g, must be %.12g", field, value, expected);
}

/* Which bytes of a struct were compared. */
#define SEEN_BYTES(type) static unsigned char seen_##type[sizeof(asperity_##type)]
#define SEEN(type, field) \
    memset(seen_##type + offsetof(asperity_##type, field), 1, sizeof ((asperity_##type *)NULL)->field)

#define NEAR(type, object, field, expected, tolerance)                                                                 \
    do {                                                                                                               \
        SEEN(type, field);                                                                                             \
        near_to(#type "." #field, (object).field, expected, tolerance);                                                \
    } while (0)

#define HOLDS(type, object, field, claim)                                                                              \
    do {                                                                                                               \
        SEEN(type, field);                                                                                             \
        CHECK(claim, "%s", #type "." #field);                                                                          \
    } while (0)

#define ALL_SEEN(type)                                                                                                 \
    do {                                                                                                               \
        const unsigned char *missed = memchr(seen_##type, 0, sizeof seen_##type);                                      \
        CHECK(missed == NULL, "asperity_" #type ": nothing compares byte %d", missed ? (int)(missed - seen_##type) : 0); \
    } while (0)

#endif
