/* Calls run on threads with small stacks, as fibres, embedded systems and some solvers have them: every function of the header
 * stays within what docs/dev/reliability.md says of its kind. A thread's stack is filled with a pattern; what is overwritten was used. */

#define _GNU_SOURCE
#include <asperity.h>

#include <pthread.h>
#include <stdint.h>
#include <stdlib.h>

#include "check.h"
#include "surfaces.h"

enum { N = 200, FEW = 3, SIZE = 1 << 20, KIB = 1024 };
/* What is promised of each call, STACK_asperity_create [KiB] and the like, is defined before this file is included. */

static const char SURFACE[] = "pair = \"steel/steel\"\nnominal_area = 1e-4\nmeasured = [[100, 0.17], [1000, 0.16]]\n"
                              "[roughness]\nRa = 0.8e-6\nprocess = \"ground\"\n";
static asperity_params params, changed, calibrated;
static char text_of_calibrated[1 << 14];
static asperity_model *model, *other, *after;
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

/* Functions, each in its dearest forms. */
#define CALLS(X) \
    X(estimate_at_loads, , (SURFACE, sizeof SURFACE - 1, FEW, in, estimates)) \
    X(estimate_text, , (SURFACE, sizeof SURFACE - 1, FEW, in, text, sizeof text)) \
    X(name, , (ASPERITY_NAMES_PAIRS, 3)) \
    X(describe, , (ASPERITY_NAMES_PARAMETERS, "skeww", text, sizeof text)) \
    X(describe, _of_an_interface, (ASPERITY_NAMES_INTERFACES, "KCl film on iron in vacuum", text, sizeof text)) \
    X(describe, _of_materials, (ASPERITY_NAMES_MATERIALS, "steeel", text, sizeof text)) \
    X(params_init, , (&changed, sizeof changed)) \
    X(params_set_dimensionless, , (&changed, 0.01, 1000, 0.001, 1, 0.3)) \
    X(params_set_materials, , (&changed, 200e9, 0.3, 70e9, 0.34)) \
    X(params_set_spectral_moments, , (&changed, 3, 0.5, 0.7, 11)) \
    X(params_set_values, , (&changed, 1, (const char *[]){"skew"}, (double[]){0.1})) \
    X(params_set_values, _calibrating, (&changed, 2, (const char *[]){"calibration_load", "calibration_friction_force"}, (double[]){in[N / 2], 0.2 * in[N / 2]})) \
    X(params_set_values, _of_a_coefficient, (&changed, 2, (const char *[]){"calibration_load", "calibration_friction_coefficient"}, (double[]){in[N - 1], 0.2})) \
    X(params_set_values, _of_no_name, (&changed, 1, (const char *[]){"sumit_radiuss"}, in)) \
    X(params_get_value, , (&changed, "skew", out)) \
    X(params_get_value, _of_no_name, (&changed, "sumit_radiuss", out)) \
    X(params_set_pair, , (&changed, "steel/steel")) \
    X(params_set_pair, _of_no_name, (&changed, "stele/alumina")) \
    X(params_calibrate, , (&changed, in[0], 0.2)) \
    X(params_calibrate_force, , (&changed, in[0], 0.2 * in[0])) \
    X(params_set_text, , (&changed, SURFACE, sizeof SURFACE - 1)) \
    X(params_set_text, _calibrated, (&changed, text_of_calibrated, sizeof text_of_calibrated)) \
    X(params_set_text, _of_no_key, (&changed, "hardnes = 1", 11)) \
    X(params_text, , (&params, text, sizeof text)) \
    X(params_text, _calibrated, (&calibrated, text, sizeof text)) \
    X(params_set_units, , (&changed, 1e-3, 1.0)) \
    X(params_read, , (&changed, "tests/examples/ground.toml")) \
    X(params_read, _of_no_file, (&changed, "no such file.toml")) \
    X(create, , (&params, &other)) \
    X(unloaded, , (model, in[N - 1], &after)) \
    X(set_params, , (other, &params)) \
    X(get_params, , (model, &changed)) \
    X(free, , (other)) \
    X(friction_at_load, , (model, in[0])) \
    X(friction_at_load, _of_no_load, (model, NAN)) \
    X(friction_at_load, _beyond, (model, 1e300)) \
    X(friction_force_at_load, , (model, 1e300)) \
    X(friction_force_at_load, _pulled, (model, -1e300)) \
    X(friction_at_loads, , (model, N, in, out, more)) \
    X(friction_force_at_loads, , (model, N, in, out, more)) \
    X(friction_and_slope_at_load, , (model, in[1], out)) \
    X(friction_force_and_slope_at_load, , (model, in[1], out)) \
    X(friction_force_and_slope_at_load, _beyond, (model, 1e30, out)) \
    X(friction_force_at_loads_of, , (models, 1, N, which, in, out, more)) \
    X(tangential_stiffness_at_load, , (model, in[0])) \
    X(tangential_stiffness_at_load, _beyond, (model, 1e30)) \
    X(tangential_stiffness_at_loads, , (model, N, in, out)) \
    X(tangential_at_load, , (model, in[0], 1e-9, out, more)) \
    X(tangential_at_load, _slipping, (model, in[N - 1], 1e30, out, more)) \
    X(microslip_length, , (model)) \
    X(microslip_step, , (model, in[0], rate, states, states, &slip)) \
    X(microslip_steps, , (model, N / 2, in, rate, states, states, out, more)) \
    X(microslip_turn, , (states, 0.8, 0.6)) \
    X(load_and_slope_at_gap, , (model, 0.0, out)) \
    X(load_and_slope_at_gap, _pressed, (model, -1e30, out)) \
    X(load_and_slope_at_gap, _beyond, (model, 1e30, out)) \
    X(loads_at_gaps, , (model, N, rate, out, more)) \
    X(specimens_at_loads, , (model, 2, 1, 1, in, &specimens)) \
    X(each_specimen_at_loads, , (model, 0, 0, 2, 1, 1, in, out, more, out, more, out, more)) \
    X(state_at_load, , (model, in[0], &state)) \
    X(state_at_load, _pulled, (model, -1e30, &state)) \
    X(state_at_load, _of_no_load, (model, NAN, &state)) \
    X(state_at_gap, , (model, 0.0, &state)) \
    X(summary_of, , (model, &summary)) \
    X(check_loads, , (model, in[0], in[N - 1], &warnings)) \
    X(warnings_text, , (UINT64_MAX, text, sizeof text)) \
    X(last_error, , (text, sizeof text)) \
    X(status_string, , (3)) \
    X(abi_version, , ()) \
    X(version, , ()) \
    X(table_of, , (model, ASPERITY_TABLE_LOAD_AT_GAP, &table))

#define RUN(name, form, arguments) \
    static void *run_##name##form(void *unused) { (void)asperity_##name arguments; return unused; }
CALLS(RUN)

static const struct {
    const char *name;
    void *(*run)(void *);
    size_t allowed;
} calls[] = {
#define ROW(name, form, arguments) {"asperity_" #name #form, run_##name##form, (size_t)STACK_asperity_##name * KIB},
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
    calibrated = params;
    (void)asperity_params_calibrate(&calibrated, in[N / 2], 0.2);
    memset(text_of_calibrated, '\n', sizeof text_of_calibrated);
    text_of_calibrated[asperity_params_text(&calibrated, text_of_calibrated, sizeof text_of_calibrated)] = '\n';
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
            if (kind > 0 && strstr(calls[i].name, "estimate") != NULL) continue;
            changed = params;
            const size_t bytes = used(calls[i].run) - of_thread;
            most[i] = bytes > most[i] ? bytes : most[i];
        }
        asperity_free(model), asperity_free(after);
        after = NULL;
    }
    for (int i = 0; i < COUNT; i++) {
        if (count > 1) printf("%6zu %s\n", most[i], calls[i].name);
        CHECK(most[i] <= calls[i].allowed, "%s takes %zu bytes of stack, not %zu", calls[i].name, most[i], calls[i].allowed);
    }
    return checks_report("stack");
}
