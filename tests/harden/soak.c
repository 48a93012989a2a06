/* Two threads evaluate while a third rebuilds other models: answers stay bit for bit, memory stays as it is.
 *
 * usage: soak SCALAR_CALLS BATCH_ELEMENTS */

#define _GNU_SOURCE
#include "answers.h"
#include "resident.h"

#include <pthread.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>

enum { POINTS = 4096, THREADS = 2 };

typedef struct task {
    const asperity_model *model;
    const double *loads;
    double *expected_force, *expected_slope;
    long scalar, batch;
    long wrong;
    double scalar_seconds, batch_seconds;
} task;

static atomic_int done;
static long rebuilt, refused;

static double now(void)
{
    struct timespec t;

    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void *evaluate(void *argument)
{
    task *t = argument;
    double force[POINTS], slope[POINTS], start = now();

    for (long i = 0; i < t->scalar; i++)
        t->wrong += asperity_friction_force_at_load(t->model, t->loads[i % POINTS]) != t->expected_force[i % POINTS];
    t->scalar_seconds = now() - start;
    start = now();
    for (long i = 0; i < t->batch; i += POINTS) {
        asperity_friction_force_at_loads(t->model, POINTS, t->loads, force, slope);
        t->wrong += memcmp(force, t->expected_force, sizeof force) != 0;
        t->wrong += memcmp(slope, t->expected_slope, sizeof slope) != 0;
    }
    t->batch_seconds = now() - start;
    return NULL;
}

static void *rebuild(void *argument)
{
    asperity_model *model = NULL;
    asperity_params p = surface(0);

    (void)argument;
    if (asperity_create(&p, &model) != ASPERITY_OK)
        return NULL;
    for (long i = 0; !atomic_load(&done); i++) {
        p = surface((int)(i % SURFACES));
        rebuilt += asperity_set_params(model, &p) == ASPERITY_OK;
        p.height_std = -1;
        refused += asperity_set_params(model, &p) == ASPERITY_INVALID_PARAMETER;
    }
    asperity_free(model);
    return NULL;
}

int main(int argc, char **argv)
{
    static double loads[POINTS], force[POINTS], slope[POINTS];
    static answers before, after;
    const long scalar = argc > 2 ? strtol(argv[1], NULL, 10) : 0, batch = argc > 2 ? strtol(argv[2], NULL, 10) : 0;
    const long page = sysconf(_SC_PAGESIZE) / 1024; /* kB */
    const asperity_params p = surface(8);
    asperity_model *model = NULL;
    task tasks[THREADS];
    pthread_t threads[THREADS], rebuilder;
    double start, took, scalar_seconds = 0, batch_seconds = 0;
    long first, last = 0;

    CHECK(scalar > 0 && batch > 0, "usage: soak SCALAR_CALLS BATCH_ELEMENTS");
    if (asperity_create(&p, &model) != ASPERITY_OK)
        return 1;
    answer(model, &before);
    for (int i = 0; i < POINTS; i++) {
        /* A few below pull-off, the rest on the branch. */
        const double x = before.summary.max_table_load * pow(10, -12 + 11.9 * i / POINTS);
        loads[i] = before.summary.pull_off_load + (i % 97 == 0 ? -x : x);
    }
    asperity_friction_force_at_loads(model, POINTS, loads, force, slope);
    pthread_create(&rebuilder, NULL, rebuild, NULL);
    start = now();
    for (int i = 0; i < THREADS; i++) {
        const task t = { model, loads, force, slope, scalar / THREADS, batch / THREADS, 0, 0, 0 };
        tasks[i] = t;
        pthread_create(&threads[i], NULL, evaluate, &tasks[i]);
    }
    nanosleep(&(struct timespec){ 1, 0 }, NULL);
    first = resident() * page;
    for (int i = 0; i < THREADS; i++) {
        pthread_join(threads[i], NULL);
        CHECK(tasks[i].wrong == 0, "thread %d: %ld answers differ", i, tasks[i].wrong);
        scalar_seconds += tasks[i].scalar_seconds;
        batch_seconds += tasks[i].batch_seconds;
    }
    took = now() - start;
    last = resident() * page;
    atomic_store(&done, 1);
    pthread_join(rebuilder, NULL);
    answer(model, &after);
    CHECK(same(&before, &after), "the model answers otherwise than at the start");
    CHECK(rebuilt > 0 && refused > 0, "nothing was rebuilt");
    /* At either moment a model may be in the making, with its tables: up to some 700 kB. */
    CHECK(last <= first + 1024, "memory grows from %ld kB to %ld kB", first, last);
    printf("soak: %ld scalar calls (%.1f ns each in its thread), %ld batch elements (%.2f ns), %ld models rebuilt, "
           "in %.1f s; %ld kB resident after a second, %ld kB at the end\n",
        scalar, 1e9 * scalar_seconds / (double)scalar, batch, 1e9 * batch_seconds / (double)batch, rebuilt, took, first,
        last);
    asperity_free(model);
    return checks_report("soak");
}
