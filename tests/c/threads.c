/* Threads that share a model get the answers that one thread gets, bit for bit; each has its own last message. */

#include <asperity.h>

#include <stdlib.h>

#include "check.h"
#include "surfaces.h"

#ifdef _WIN32
#include <windows.h>
typedef HANDLE thread;
#define WORK static DWORD WINAPI
#define START(at, function, argument) ((*(at) = CreateThread(NULL, 0, function, argument, 0, NULL)) != NULL)
#define JOIN(thread) WaitForSingleObject(thread, INFINITE)
#else
#include <pthread.h>
typedef pthread_t thread;
#define WORK static void *
#define START(at, function, argument) (pthread_create(at, NULL, function, argument) == 0)
#define JOIN(thread) pthread_join(thread, NULL)
#endif

enum { THREADS = 4, LOADS = 200, EXACT = 10 };

typedef struct answers {
    double mu[LOADS], force[LOADS], batch[LOADS], slope[LOADS];
    asperity_state exact[EXACT];
    asperity_summary summary;
} answers;

typedef struct task {
    const asperity_model *model;
    int index;
    answers found;
    int messages_kept;
} task;

static double load_of(int i)
{
    return pow(10, -6 + 12.0 * i / LOADS);
}

static void answer(const asperity_model *model, answers *out)
{
    double loads[LOADS];

    memset(out, 0, sizeof *out);
    for (int i = 0; i < LOADS; i++) {
        loads[i] = load_of(i);
        out->mu[i] = asperity_friction_at_load(model, loads[i]);
        out->force[i] = asperity_friction_force_at_load(model, loads[i]);
    }
    asperity_friction_force_at_loads(model, LOADS, loads, out->batch, out->slope);
    for (int i = 0; i < EXACT; i++) {
        out->exact[i].struct_size = sizeof out->exact[i];
        asperity_state_at_load(model, loads[i * LOADS / EXACT], &out->exact[i]);
    }
    out->summary.struct_size = sizeof out->summary;
    asperity_summary_of(model, &out->summary);
}

/* Provokes a message of this thread's own; it must still be there after all the others have provoked theirs. */
static void provoke(int index)
{
    asperity_params p = surface(0);
    asperity_model *none = NULL;
    p.burgers_vector = -1 - index;
    asperity_create(&p, &none);
}

static int has_message(int index)
{
    char expected[64], message[128];
    snprintf(expected, sizeof expected, "burgers_vector = %d: ", -1 - index);
    asperity_last_error(message, sizeof message);
    return strncmp(message, expected, strlen(expected)) == 0;
}

WORK work(void *argument)
{
    task *t = argument;
    t->messages_kept = asperity_last_error(NULL, 0) == 0; /* a new thread has no message */
    provoke(t->index);
    answer(t->model, &t->found);
    t->messages_kept = t->messages_kept && has_message(t->index);
    return 0;
}

int main(void)
{
    const asperity_params p = surface(4);
    asperity_model *model = NULL, *other = NULL;
    task *tasks = calloc(THREADS, sizeof *tasks);
    thread threads[THREADS];
    answers *alone = malloc(sizeof *alone);

    if (tasks == NULL || alone == NULL || asperity_create(&p, &model) != ASPERITY_OK ||
        asperity_create(&p, &other) != ASPERITY_OK)
        return 1;
    provoke(THREADS);
    answer(other, alone); /* the threads are the first to ask the model for exact states */
    asperity_free(other);
    for (int i = 0; i < THREADS; i++) {
        tasks[i].model = model;
        tasks[i].index = i;
        CHECK(START(&threads[i], work, &tasks[i]), "no thread %d", i);
    }
    for (int i = 0; i < THREADS; i++) {
        JOIN(threads[i]);
        CHECK(memcmp(alone, &tasks[i].found, sizeof *alone) == 0, "thread %d has other answers", i);
        CHECK(tasks[i].messages_kept, "thread %d lost its message", i);
    }
    CHECK(has_message(THREADS), "the main thread lost its message");
    asperity_free(model);
    free(alone);
    free(tasks);
    return checks_report("threads");
}
