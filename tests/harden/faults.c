/* What a host may do to the library: fork, interrupt a batch by signals, and ask in a loop that may not allocate. */

#define _GNU_SOURCE
#include <asperity.h>

#include <pthread.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include "../c/check.h"
#include "../c/surfaces.h"

enum { LOADS = 96 };

typedef struct answers {
    double load[LOADS], mu[LOADS], force[LOADS], batch[LOADS], slope[LOADS];
    asperity_state exact;
} answers;

/* ---- Allocations: the program's own functions stand before those of the C library ---- */

extern void *__libc_malloc(size_t);
extern void *__libc_calloc(size_t, size_t);
extern void *__libc_realloc(void *, size_t);
extern void *__libc_memalign(size_t, size_t);

static atomic_long allocations;

void *malloc(size_t size)
{
    allocations++;
    return __libc_malloc(size);
}

void *calloc(size_t count, size_t size)
{
    allocations++;
    return __libc_calloc(count, size);
}

void *realloc(void *block, size_t size)
{
    allocations++;
    return __libc_realloc(block, size);
}

int posix_memalign(void **block, size_t alignment, size_t size)
{
    allocations++;
    *block = __libc_memalign(alignment, size);
    return *block == NULL;
}

static asperity_model *create(int which)
{
    const asperity_params p = surface(which);
    asperity_model *model = NULL;

    CHECK(asperity_create(&p, &model) == ASPERITY_OK, "surface %s", SURFACE_NAMES[which]);
    return model;
}

/* The calls of a loop, at loads from the pull-off to far beyond the table, one of them none. */
static void loop(const asperity_model *model, answers *out)
{
    double stiffness[LOADS];

    for (int i = 0; i < LOADS; i++) {
        out->mu[i] = asperity_friction_at_load(model, out->load[i]);
        out->force[i] = asperity_friction_force_at_load(model, out->load[i]);
        asperity_load_and_slope_at_gap(model, out->load[i], &out->slope[i]);
    }
    asperity_friction_at_loads(model, LOADS, out->load, out->batch, out->slope);
    asperity_tangential_stiffness_at_loads(model, LOADS, out->load, stiffness);
    asperity_friction_force_at_loads(model, LOADS, out->load, out->batch, out->slope);
}

static void answer(const asperity_model *model, answers *out)
{
    asperity_summary s = { .struct_size = sizeof s };

    memset(out, 0, sizeof *out);
    asperity_summary_of(model, &s);
    for (int i = 0; i < LOADS; i++)
        out->load[i] = i == 0 ? NAN : s.pull_off_load + s.max_table_load * pow(10, -20 + 0.25 * i);
    loop(model, out);
    out->exact.struct_size = sizeof out->exact;
    asperity_state_at_load(model, 0.1 * s.max_table_load, &out->exact);
}

static void loops_allocate_nothing(void)
{
    static answers out;

    for (int which = 0; which < SURFACES; which++) {
        const long before = allocations;
        asperity_model *model = create(which);
        asperity_params p, copy = { .struct_size = sizeof copy };
        char message[128];
        long made;

        CHECK(allocations > before, "allocations are not counted");
        answer(model, &out);
        made = allocations;
        loop(model, &out);
        asperity_get_params(model, &copy);
        asperity_params_init(&p, sizeof p);
        asperity_params_set_materials(&p, 1, 0.3, 2, 0.4);
        asperity_params_set_materials(&p, -1, 0.3, 2, 0.4); /* refused, with a message */
        asperity_last_error(message, sizeof message);
        made = allocations - made;
        CHECK(made == 0, "calls on %s make %ld allocations", SURFACE_NAMES[which], made);
        asperity_free(model);
    }
    printf("the calls of a solver's loop make no allocation, within the table or beyond it\n");
}

/* ---- Children ---- */

static void *evaluate(void *argument)
{
    const asperity_model *model = argument;
    double sum = 0;

    for (int i = 0; i < 3000000; i++)
        sum += asperity_friction_force_at_load(model, 1.0 + i % 1000);
    return sum > 0 ? argument : NULL;
}

/* A child has the models of its parent, also when another thread was evaluating. */
static void fork_after_create(void)
{
    static answers before, in_child;
    asperity_model *model = create(0);
    const asperity_params other = surface(1);
    pthread_t thread;
    void *done = NULL;

    answer(model, &before);
    pthread_create(&thread, NULL, evaluate, model);
    for (int i = 0; i < 10; i++) {
        int status = -1;
        const pid_t child = fork();

        if (child == 0) {
            answer(model, &in_child);
            const int kept = SAME(before, in_child) && asperity_set_params(model, &other) == ASPERITY_OK;
            asperity_free(model);
            _exit(kept ? 0 : 1);
        }
        CHECK(child > 0 && waitpid(child, &status, 0) == child, "no child");
        CHECK(WIFEXITED(status) && WEXITSTATUS(status) == 0, "child %d ended with %d", i, status);
    }
    pthread_join(thread, &done);
    answer(model, &in_child);
    CHECK(done == model && SAME(before, in_child), "the parent answers otherwise after forking");
    asperity_free(model);
    printf("fork: 10 children of a parent with two threads answer the same bits\n");
}

/* ---- Signals ---- */

static asperity_model *interrupted;
static volatile sig_atomic_t signals;
static double at_signal;

static void on_signal(int number)
{
    double loads[8] = { 1, 2, 3, 4, 5, 6, 7, 8 }, forces[8];

    (void)number;
    signals++;
    asperity_friction_force_at_loads(interrupted, 8, loads, forces, NULL);
    at_signal = forces[7];
}

/* A batch that is interrupted has the bits of one that is not; the handler may call the library too. */
static void signal_during_batch(void)
{
    enum { N = 20000 };
    static double loads[N], expected[N], slopes[N], force[N], slope[N];
    struct sigaction action = { .sa_handler = on_signal, .sa_flags = SA_RESTART }, old;
    const struct itimerval often = { { 0, 200 }, { 0, 200 } }, never = { { 0, 0 }, { 0, 0 } };
    int kept = 1, batches = 0;

    interrupted = create(0);
    for (int i = 0; i < N; i++)
        loads[i] = pow(10, -4 + 10.0 * i / N);
    asperity_friction_force_at_loads(interrupted, N, loads, expected, slopes);
    sigaction(SIGALRM, &action, &old);
    setitimer(ITIMER_REAL, &often, NULL);
    while (signals < 1000 && batches < 1000000) {
        asperity_friction_force_at_loads(interrupted, N, loads, force, slope);
        kept = kept && SAME(force, expected) && SAME(slope, slopes);
        batches++;
    }
    setitimer(ITIMER_REAL, &never, NULL);
    sigaction(SIGALRM, &old, NULL);
    CHECK(signals >= 1000 && kept, "%d signals", (int)signals);
    CHECK(at_signal == asperity_friction_force_at_load(interrupted, 8), "the handler got %g", at_signal);
    asperity_free(interrupted);
    printf("signals: %d during %d batches of %d loads, which have the same bits\n", (int)signals, batches, (int)N);
}

int main(void)
{
    loops_allocate_nothing();
    fork_after_create();
    signal_during_batch();
    return checks_report("faults");
}
