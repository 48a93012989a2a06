/* CHECK: says which claim does not hold, and where; the program fails at its end. Floating-point traps are on. */

#ifndef CHECK_H
#define CHECK_H

#include "traps_on.h"

#include <stdio.h>
#include <string.h>

static int checks_done, checks_failed;

#define CHECK(claim, ...)                                                                                              \
    do {                                                                                                               \
        checks_done++;                                                                                                 \
        if (!(claim)) {                                                                                                \
            checks_failed++;                                                                                           \
            fprintf(stderr, "%s:%d: %s: does not hold: ", __FILE__, __LINE__, #claim);                                 \
            fprintf(stderr, __VA_ARGS__);                                                                              \
            fputc('\n', stderr);                                                                                       \
        }                                                                                                              \
    } while (0)

static int checks_report(const char *program)
{
    CHECK(fegetexcept() == traps_at_start, "other exceptions are trapped than at the start");
    printf("%s: %d checks, %d failed\n", program, checks_done, checks_failed);
    return checks_failed == 0 && checks_done > 0 ? 0 : 1;
}

/* Whether two objects are the same, bit for bit. */
#define SAME(a, b) (sizeof(a) == sizeof(b) && memcmp(&(a), &(b), sizeof(a)) == 0)

#endif
