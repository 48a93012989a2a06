/* What a host may do to the library: cycles of create and free, fork, signals during a batch. What it may do to the
 * floating-point environment: tests/c/environments.c.
 *
 * usage: faults CYCLES */

#define _GNU_SOURCE
#include "answers.h"
#include "resident.h"

#include <pthread.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

static asperity_model *create(int which)
{
    const asperity_params p = surface(which);
    asperity_model *model = NULL;

    CHECK(asperity_create(&p, &model) == ASPERITY_OK, "surface %s", SURFACE_NAMES[which]);
    return model;
}

static void cycles(long count)
{
    /* Surfaces whose models are made fast, and one that is refused each time. */
    const int cheap[] = { 1, 0, 4, 8 };
    asperity_params refused = surface(0);
    long before = 0, after;

    refused.summit_radius = -1;
    for (long i = 0; i < count; i++) {
        const asperity_params p = surface(cheap[i % 4]), other = surface(cheap[(i + 1) % 4]);
        asperity_model *model = NULL, *none = NULL;

        if (i == count / 2) /* the heap has found its size by then */
            before = resident();
        if (asperity_create(&p, &model) != ASPERITY_OK || asperity_create(&refused, &none) != ASPERITY_INVALID_PARAMETER)
            CHECK(0, "cycle %ld", i);
        if (i % 64 == 0 && asperity_set_params(model, &other) != ASPERITY_OK)
            CHECK(0, "cycle %ld", i);
        asperity_free(model);
    }
    after = resident();
    CHECK(before > 0 && after - before <= 64, "%ld pages after half of the cycles, %ld at the end", before, after);
    printf("%ld cycles of create and free: %ld kB resident after half, %ld kB at the end\n", count,
        before * sysconf(_SC_PAGESIZE) / 1024, after * sysconf(_SC_PAGESIZE) / 1024);
}

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
            const int kept = same(&before, &in_child) && asperity_set_params(model, &other) == ASPERITY_OK;
            asperity_free(model);
            _exit(kept ? 0 : 1);
        }
        CHECK(child > 0 && waitpid(child, &status, 0) == child, "no child");
        CHECK(WIFEXITED(status) && WEXITSTATUS(status) == 0, "child %d ended with %d", i, status);
    }
    pthread_join(thread, &done);
    answer(model, &in_child);
    CHECK(done == model && same(&before, &in_child), "the parent answers otherwise after forking");
    asperity_free(model);
    printf("fork: 10 children of a parent with two threads answer the same bits\n");
}

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

int main(int argc, char **argv)
{
    const long count = argc > 1 ? strtol(argv[1], NULL, 10) : 1000;

    cycles(count);
    fork_after_create();
    signal_during_batch();
    return checks_report("faults");
}
