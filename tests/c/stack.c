/* Calls run on threads with small stacks, as fibres, embedded systems and some solvers have them: every function of the header
 * stays within what docs/c.md says of its kind. A thread's stack is filled with a pattern; what is overwritten was used. */

#define _GNU_SOURCE
#include <asperity.h>

#include <pthread.h>
#include <stdint.h>
#include <stdlib.h>

#include "check.h"
#include "surfaces.h"

enum { N = 200, FEW = 3, SIZE = 1 << 20, KIB = 1024 };
/* What docs/c.md promises [KiB]: of one answer and of parameters, of batches and exact states, of models, of estimates. */
enum { ANSWERS = 8, EXACT = 32, MAKES = 64, ESTIMATES = 96 };

static const char SURFACE[] = "pair = \"steel/steel\"\nnominal_area = 1e-4\nmeasured = [[100, 0.17], [1000, 0.16]]\n"
                              "[roughness]\nRa = 0.8e-6\nprocess = \"ground\"\n";
static asperity_params params, changed;
static asperity_model *model, *other;
static const asperity_model *models[1];
static double in[N], rate[N], out[4 * N], more[4 * N], states[N * 64];
static uint32_t which[N];
static uint64_t warnings;
static char text[1 << 16];
static asperity_state state = { .struct_size = sizeof state };
static asperity_summary summary = { .struct_size = sizeof summary };
static asperity_microslip slip = { .struct_size = sizeof slip };
static asperity_table table = { .struct_size = sizeof table };
static asperity_specimens specimens = { .struct_size = sizeof specimens };
static asperity_estimate estimates[FEW];

#define CALLS(X)                                                                               \
    X(ESTIMATES, estimate_at_loads, (SURFACE, sizeof SURFACE - 1, FEW, in, estimates))         \
    X(ESTIMATES, estimate_text, (SURFACE, sizeof SURFACE - 1, FEW, in, text, sizeof text))     \
    X(ANSWERS, name, (ASPERITY_NAMES_PAIRS, 3))                                                \
    X(ANSWERS, describe, (ASPERITY_NAMES_PARAMETERS, "skeww", text, sizeof text))              \
    X(ANSWERS, params_init, (&changed, sizeof changed))                                        \
    X(ANSWERS, params_set_dimensionless, (&changed, 0.01, 1000, 0.001, 1, 0.3))                \
    X(ANSWERS, params_set_materials, (&changed, 200e9, 0.3, 70e9, 0.34))                       \
    X(ANSWERS, params_set_spectral_moments, (&changed, 3, 0.5, 0.7, 11))                       \
    X(ANSWERS, params_set_values, (&changed, 1, (const char *[]){"skew"}, (double[]){0.1}))    \
    X(ANSWERS, params_get_value, (&changed, "skew", out))                                      \
    X(ANSWERS, params_set_pair, (&changed, "steel/steel"))                                     \
    X(MAKES, params_calibrate, (&changed, in[0], 0.2))                                         \
    X(MAKES, params_calibrate_force, (&changed, in[0], 0.2 * in[0]))                           \
    X(ESTIMATES, params_set_estimate, (&changed, SURFACE, sizeof SURFACE - 1))                 \
    X(MAKES, params_set_text, (&changed, SURFACE, sizeof SURFACE - 1))                         \
    X(EXACT, params_text, (&params, text, sizeof text))                                        \
    X(ANSWERS, params_set_units, (&changed, 1e-3, 1.0))                                        \
    X(MAKES, params_read, (&changed, "tests/examples/ground.toml"))                        \
    X(MAKES, create, (&params, &other))                                                        \
    X(MAKES, set_params, (other, &params))                                                     \
    X(ANSWERS, get_params, (model, &changed))                                                  \
    X(ANSWERS, free, (other))                                                                  \
    X(ANSWERS, friction_at_load, (model, in[0]))                                               \
    X(ANSWERS, friction_force_at_load, (model, 1e300))                                         \
    X(EXACT, friction_at_loads, (model, N, in, out, more))                                     \
    X(EXACT, friction_force_at_loads, (model, N, in, out, more))                               \
    X(ANSWERS, friction_and_slope_at_load, (model, in[1], out))                                \
    X(ANSWERS, friction_force_and_slope_at_load, (model, in[1], out))                          \
    X(MAKES, friction_force_at_loads_of, (models, 1, N, which, in, out, more))                 \
    X(ANSWERS, tangential_stiffness_at_load, (model, in[0]))                                   \
    X(EXACT, tangential_stiffness_at_loads, (model, N, in, out))                               \
    X(EXACT, tangential_at_load, (model, in[0], 1e-9, out, more))                              \
    X(ANSWERS, microslip_length, (model))                                                      \
    X(EXACT, microslip_step, (model, in[0], rate, states, states, &slip))                      \
    X(EXACT, microslip_steps, (model, N / 2, in, rate, states, states, out, more))             \
    X(ANSWERS, microslip_turn, (states, 0.8, 0.6))                                             \
    X(ANSWERS, load_and_slope_at_gap, (model, 0.0, out))                                       \
    X(EXACT, loads_at_gaps, (model, N, rate, out, more))                                       \
    X(EXACT, specimens_at_loads, (model, 2, 1, 1, in, &specimens))                             \
    X(EXACT, each_specimen_at_loads, (model, 0, 2, 1, 1, in, states))                          \
    X(EXACT, state_at_load, (model, in[0], &state))                                            \
    X(EXACT, state_at_gap, (model, 0.0, &state))                                               \
    X(ANSWERS, summary_of, (model, &summary))                                                  \
    X(EXACT, check_loads, (model, in[0], in[N - 1], &warnings))                                \
    X(ANSWERS, warnings_text, (UINT64_MAX, text, sizeof text))                                 \
    X(ANSWERS, last_error, (text, sizeof text))                                                \
    X(ANSWERS, status_string, (3))                                                             \
    X(ANSWERS, abi_version, ())                                                                \
    X(ANSWERS, version, ())                                                                    \
    X(ANSWERS, table_of, (model, ASPERITY_TABLE_LOAD_AT_GAP, &table))

#define RUN(kind, name, arguments) static void *run_##name(void *unused) { (void)asperity_##name arguments; return unused; }
CALLS(RUN)

static const struct {
    const char *name;
    void *(*run)(void *);
    size_t allowed;
} calls[] = {
#define ROW(kind, name, arguments) {"asperity_" #name, run_##name, (size_t)kind * KIB},
    CALLS(ROW)
};
enum { COUNT = sizeof calls / sizeof *calls };

static void *nothing(void *unused)
{
    return unused;
}

/* Bytes of a thread's stack that are used, with what the thread itself takes. */
static size_t used(void *(*run)(void *))
{
    static unsigned char *stack;
    pthread_attr_t attributes;
    pthread_t thread;
    size_t untouched = 0;

    if (stack == NULL && posix_memalign((void **)&stack, 4096, SIZE) != 0)
        abort();
    memset(stack, 0xa5, SIZE);
    if (pthread_attr_init(&attributes) != 0 || pthread_attr_setstack(&attributes, stack, SIZE) != 0 ||
        pthread_create(&thread, &attributes, run, NULL) != 0 || pthread_join(thread, NULL) != 0)
        abort();
    pthread_attr_destroy(&attributes);
    while (stack[untouched] == 0xa5) untouched++;
    return SIZE - untouched;
}

static void prepare(asperity_params p)
{
    asperity_summary made = { .struct_size = sizeof made };

    params = changed = p;
    if (asperity_create(&params, &model) != ASPERITY_OK || asperity_summary_of(model, &made) != ASPERITY_OK)
        abort();
    models[0] = model;
    /* All decades of the table, and beyond both ends. */
    for (int i = 0; i < N; i++) {
        in[i] = made.pull_off_load + 1e-3 * made.max_table_load * pow(1e-24, (double)(N - i) / N);
        rate[i] = (i % 3 - 1) * 0.3 * params.height_std;
    }
    memset(states, 0, sizeof states);
    for (int i = 0; i < FEW; i++) estimates[i].struct_size = sizeof estimates[i];
}

int main(int count, char **arguments)
{
    static size_t most[COUNT];
    const size_t of_thread = used(nothing);
    (void)arguments;

    for (int kind = 0; kind < SURFACES; kind++) {
        prepare(surface(kind));
        for (int i = 0; i < COUNT; i++) {
            /* Estimates have a surface of their own. */
            if (kind > 0 && calls[i].allowed == (size_t)ESTIMATES * KIB) continue;
            changed = params;
            const size_t bytes = used(calls[i].run) - of_thread;
            most[i] = bytes > most[i] ? bytes : most[i];
        }
        asperity_free(model);
    }
    for (int i = 0; i < COUNT; i++) {
        if (count > 1) printf("%6zu %s\n", most[i], calls[i].name);
        CHECK(most[i] <= calls[i].allowed, "%s takes %zu bytes of stack, not %zu", calls[i].name, most[i], calls[i].allowed);
    }
    return checks_report("stack");
}
