/* Allocations fail in turn, alone and with all later ones: a call does without, or fails with a status and a message,
 * changes nothing and keeps no memory. The calls of a solver's loop make none.
 *
 * usage: LD_PRELOAD=failing_malloc.so out_of_memory */

#include "answers.h"

#include <dlfcn.h>
#include <limits.h>
#include <stdlib.h>

static void (*arm)(long, int);
static long (*disarm)(long *);

enum call { CREATE, SET_PARAMS, STATE, CALLS };

static const char *const NAMES[CALLS] = { "asperity_create", "asperity_set_params", "asperity_state_at_load" };

typedef struct outcome {
    asperity_status status;
    long allocations, left;
    asperity_model *made;
    asperity_state state;
} outcome;

/* As many heights as a table may have; of fewer, creation is quick. */
enum { MOST_HEIGHTS = 256, FEW_HEIGHTS = 8 };

static asperity_params measured_heights(int n)
{
    static double height[MOST_HEIGHTS], density[MOST_HEIGHTS];
    asperity_params p = surface(0);

    for (int i = 0; i < n; i++) {
        height[i] = i;
        density[i] = i < n / 2 ? i + 1 : n - i;
    }
    p.height_distribution = ASPERITY_HEIGHTS_TABULATED;
    p.table_height = height;
    p.table_density = density;
    p.table_length = (uint64_t)n;
    return p;
}

static asperity_params johnson_heights(void)
{
    asperity_params p = surface(0);

    p.height_distribution = ASPERITY_HEIGHTS_JOHNSON;
    p.skew = 1.5;
    p.kurtosis = 7;
    return p;
}

/* The call with the k-th allocation failing; with none for k = -1. */
static outcome with_failure(enum call call, const asperity_params *p, long k, int all, asperity_model *model)
{
    outcome o;

    memset(&o, 0, sizeof o);
    o.state.struct_size = sizeof o.state;
    arm(k, all);
    switch (call) {
    case CREATE: o.status = asperity_create(p, &o.made); break;
    case SET_PARAMS: o.status = asperity_set_params(model, p); break;
    default: o.status = asperity_state_at_load(model, 1e-3, &o.state); break;
    }
    o.allocations = disarm(&o.left);
    return o;
}

/* Whether the call failed. */
static int fails_well(enum call call, const asperity_params *p, long k, int all, asperity_model *model)
{
    const outcome o = with_failure(call, p, k, all, model);
    /* After it, which is to be the first of its model. */
    const outcome sound = call == STATE ? with_failure(call, p, -1, 0, model) : (outcome){ 0 };
    char message[128] = "";

    if (o.status == ASPERITY_OK) {
        CHECK(call != CREATE || o.made != NULL, "allocation %ld: success without a model", k);
        CHECK(call != STATE || SAME(o.state, sound.state), "allocation %ld: another state", k);
        asperity_free(o.made);
        return 0;
    }
    asperity_last_error(message, sizeof message);
    CHECK(o.status == ASPERITY_OUT_OF_MEMORY, "%s, allocation %ld: status %d", NAMES[call], k, o.status);
    CHECK(strncmp(message, "out of memory: ", 15) == 0, "%s, allocation %ld: '%s'", NAMES[call], k, message);
    CHECK(o.made == NULL, "allocation %ld: a model all the same", k);
    CHECK(o.state.load == 0, "allocation %ld: a state all the same", k);
    CHECK(o.left == 0, "%s, allocation %ld: %ld blocks are kept", NAMES[call], k, o.left);
    return 1;
}

/* Up to the k-th. */
static void each_allocation(enum call call, asperity_params p, const char *name, long most)
{
    const asperity_params first = surface(8);
    static answers before, after;
    asperity_model *model = NULL;
    long count, failed = 0, done = 0;
    outcome o;

    CHECK(asperity_create(&first, &model) == ASPERITY_OK, "no model");
    o = with_failure(call, &p, -1, 0, model);
    CHECK(o.status == ASPERITY_OK && o.allocations > 0, "%s on %s", NAMES[call], name);
    asperity_free(o.made);
    count = o.allocations;
    for (long k = 1; k <= count && k <= most; k += 1 + k / 8)
        for (int all = 0; all < 2; all++) {
            CHECK(asperity_set_params(model, &first) == ASPERITY_OK, "no model");
            answer(model, &before);
            /* The first state of a model takes memory that stays. */
            CHECK(call != STATE || asperity_set_params(model, &first) == ASPERITY_OK, "no model");
            if (fails_well(call, &p, k, all, model)) {
                answer(model, &after);
                CHECK(same(&before, &after), "%s on %s, allocation %ld: the model changed", NAMES[call], name, k);
                failed++;
            }
            done++;
        }
    CHECK(failed > 0, "%s on %s never fails", NAMES[call], name);
    printf("%s, %s: %ld allocations; of %ld calls in want of some %ld fail with a status, the others do without\n",
           NAMES[call], name, count, done, failed);
    asperity_free(model);
}

/* A text with a table that no text before had, which stays, and a measurement, for which a model is made. */
static size_t new_text(char *text, size_t size)
{
    static int highest = 3;

    return (size_t)snprintf(text, size,
                            "pair = \"Si/Si\"\nnominal_area = 1e-8\nheight_std = 5e-9\nsummit_radius = 1e-6\n"
                            "asperity_count = 1e5\ntable_height = [0, 1, 2, %d]\ntable_density = [0, 1, 1, 0]\n"
                            "calibration_load = 1e-3\ncalibration_friction_coefficient = 0.4\n",
                            highest++);
}

/* Texts are set, or refused with nothing changed; of what is written nothing stays. */
static void each_allocation_of_a_text(void)
{
    asperity_params before, p;
    char text[512], message[128];
    long count, left, failed = 0, done = 0;

    asperity_params_init(&before, sizeof before);
    p = before;
    arm(-1, 0);
    CHECK(asperity_params_set_text(&p, text, new_text(text, sizeof text)) == ASPERITY_OK, "%s", text);
    count = disarm(&left);
    for (long k = 1; k <= count; k += 1 + k / 8)
        for (int all = 0; all < 2; all++) {
            const size_t length = new_text(text, sizeof text);
            asperity_status status;
            p = before;
            arm(k, all);
            status = asperity_params_set_text(&p, text, length);
            disarm(&left);
            done++;
            if (status == ASPERITY_OK) {
                CHECK(p.calibration_load == 1e-3 && p.table_length == 4, "allocation %ld: not set", k);
                continue;
            }
            failed++;
            asperity_last_error(message, sizeof message);
            CHECK(status == ASPERITY_OUT_OF_MEMORY && strncmp(message, "out of memory: ", 15) == 0, "%ld: %s", k, message);
            CHECK(SAME(p, before) && left == 0, "a text, allocation %ld: %ld blocks are kept", k, left);
        }
    CHECK(failed > 0, "a text never fails");
    p = before;
    arm(-1, 0);
    CHECK(asperity_params_set_text(&p, text, new_text(text, sizeof text)) == ASPERITY_OK, "%s", text);
    disarm(&left);
    arm(-1, 0);
    CHECK(asperity_params_text(&p, text, sizeof text) > 0, "no text");
    disarm(&left);
    CHECK(left == 0, "a text that is written: %ld blocks are kept", left);
    printf("texts: %ld allocations; of %ld calls in want of some %ld fail with a status, the others do without\n", count,
           done, failed);
}

/* As many words as a text may have, out of the reserve alone. */
static void the_reserve_suffices_for_the_longest_text(void)
{
    enum { LONGEST = 1 << 20, LINES = 43600 };
    char *text = malloc(LONGEST), message[128] = "";
    asperity_status status;
    asperity_params p;
    long left;

    memset(text, ' ', LONGEST);
    for (int i = 0; i < LINES; i++) /* three words and signs each */
        memcpy(text + 24 * i, " # a\n", 5);
    memcpy(text + LONGEST - 16, "\nhardness = 1e9", 15);
    asperity_params_init(&p, sizeof p);
    arm(2, 1);
    status = asperity_params_set_text(&p, text, LONGEST);
    disarm(&left);
    asperity_last_error(message, sizeof message);
    CHECK(status == ASPERITY_OK && p.hardness == 1e9, "the longest text: %s", message);
    free(text);
}

/* Setters and the calls of a loop, within the table and beyond it, where they integrate; a refusal. */
static void loops_allocate_nothing(void)
{
    static answers out;
    double loads[LOADS], force[LOADS], slope[LOADS];

    for (int which = 0; which < SURFACES; which++) {
        asperity_params p = surface(which), copy = { .struct_size = sizeof copy };
        asperity_model *model = NULL;
        char message[128];
        long count, left;

        CHECK(asperity_create(&p, &model) == ASPERITY_OK, "surface %s", SURFACE_NAMES[which]);
        answer(model, &out);
        for (int i = 0; i < LOADS; i++)
            loads[i] = i == 0 ? NAN : out.summary.pull_off_load + out.summary.max_table_load * pow(10, -20 + 0.25 * i);
        arm(-1, 0);
        for (int i = 0; i < LOADS; i++) {
            force[i] = asperity_friction_force_at_load(model, loads[i]);
            slope[i] = asperity_friction_at_load(model, loads[i]);
        }
        asperity_friction_force_at_loads(model, LOADS, loads, force, slope);
        asperity_friction_at_loads(model, LOADS, loads, force, slope);
        asperity_summary_of(model, &out.summary);
        asperity_get_params(model, &copy);
        asperity_params_set_materials(&p, 1, 0.3, 2, 0.4);
        asperity_params_set_dimensionless(&p, 0.02, 500, 0.003, 0.5, 0.2);
        asperity_params_set_skew(&p, -0.3);
        asperity_params_set_spectral_moments(&p, 1, 0.01, 1e-3, 5);
        asperity_params_set_skew(&p, -3); /* refused, with a message */
        asperity_last_error(message, sizeof message);
        count = disarm(&left);
        CHECK(count == 0, "calls on %s make %ld allocations", SURFACE_NAMES[which], count);
        asperity_free(model);
    }
    printf("setters and the calls of a solver's loop make no allocation, within the table or beyond it\n");
}

int main(void)
{
    *(void **)&arm = dlsym(RTLD_DEFAULT, "failing_malloc_arm");
    *(void **)&disarm = dlsym(RTLD_DEFAULT, "failing_malloc_disarm");
    if (arm == NULL || disarm == NULL) {
        fprintf(stderr, "out_of_memory: failing_malloc.so is not preloaded\n");
        return 1;
    }
    each_allocation_of_a_text();
    the_reserve_suffices_for_the_longest_text();
    each_allocation(CREATE, surface(4), SURFACE_NAMES[4], LONG_MAX);
    each_allocation(CREATE, surface(6), SURFACE_NAMES[6], LONG_MAX);
    each_allocation(CREATE, johnson_heights(), "Johnson's heights", LONG_MAX);
    each_allocation(CREATE, measured_heights(FEW_HEIGHTS), "a table of heights", LONG_MAX);
    /* All from the reserve, which has to suffice for it. */
    each_allocation(CREATE, measured_heights(MOST_HEIGHTS), "the longest table of heights", 2);
    each_allocation(SET_PARAMS, surface(4), SURFACE_NAMES[4], LONG_MAX);
    each_allocation(STATE, surface(4), SURFACE_NAMES[4], LONG_MAX);
    loops_allocate_nothing();
    return checks_report("out_of_memory");
}
