/* How a host's program in C or C++ fails: with one line that says so, and with status 1; and calls whose failure is a verdict.
 * The program defines HOST, the host's name, and _GNU_SOURCE. */
#ifndef HOSTS_VERDICT_H
#define HOSTS_VERDICT_H

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "surface.h"

__attribute__((noreturn)) static inline void fail(const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    printf(HOST "  FAIL  ");
    vprintf(format, arguments);
    printf("\n");
    va_end(arguments);
    exit(1);
}

/* Processor time, in which other programs have no part. */
static inline double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* The law of a contact of 1 cm2. */
static inline asperity_model *law_of_contact(void) {
    asperity_params params;
    asperity_model *model = NULL;
    char message[400];
    if (set_surface(&params, 1e-4) == ASPERITY_OK && asperity_create(&params, &model) == ASPERITY_OK) return model;
    asperity_last_error(message, sizeof message);
    fail("%s", message);
}

static inline double exact_mu(const asperity_model *model, double load) {
    asperity_state state;
    state.struct_size = sizeof state;
    if (asperity_state_at_load(model, load, &state) != ASPERITY_OK) fail("no exact state at %g N", load);
    return state.friction_coefficient;
}

#endif
