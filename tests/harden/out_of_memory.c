/* Every allocation of create and set_params fails in turn, each in a child of its own: it dies by Rust's rule, an abort
 * that says so, or goes on. The calls of a solver's loop allocate nothing.
 *
 * usage: LD_PRELOAD=failing_malloc.so out_of_memory */

#include "answers.h"

#include <dlfcn.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

static void (*arm)(long);
static long (*disarm)(void);

enum call { CREATE, SET_PARAMS, CALLS };

static const char *const NAMES[CALLS] = { "asperity_create", "asperity_set_params" };

/* Does the call with the k-th allocation failing; returns how many it made. */
static long with_failure(enum call call, long k, asperity_model *model)
{
    const asperity_params p = surface(4);
    asperity_model *made = NULL;
    int status;

    arm(k);
    status = call == CREATE ? asperity_create(&p, &made) : asperity_set_params(model, &p);
    k = disarm();
    if (status != ASPERITY_OK)
        _exit(3);
    return k;
}

/* How a child ends whose k-th allocation fails; what it says on standard error. */
static int end_of_child(enum call call, long k, asperity_model *model, char *said, size_t size)
{
    int ends[2], status = -1;
    size_t length = 0;
    ssize_t got;
    pid_t child;

    CHECK(pipe(ends) == 0, "no pipe");
    child = fork();
    if (child == 0) {
        dup2(ends[1], STDERR_FILENO);
        close(ends[0]);
        alarm(20);
        with_failure(call, k, model);
        _exit(0);
    }
    close(ends[1]);
    while ((got = read(ends[0], said + length, size - 1 - length)) > 0)
        length += (size_t)got;
    said[length] = '\0';
    close(ends[0]);
    waitpid(child, &status, 0);
    return status;
}

static void each_allocation(enum call call, asperity_model *model)
{
    const long count = with_failure(call, -1, model);
    long aborted = 0, survived = 0;
    char said[4096];

    CHECK(count > 0, "%s makes no allocation", NAMES[call]);
    for (long k = 1; k <= count; k++) {
        const int status = end_of_child(call, k, model, said, sizeof said);
        if (WIFSIGNALED(status) && WTERMSIG(status) == SIGABRT && strstr(said, "memory allocation of") != NULL)
            aborted++;
        else if (WIFEXITED(status) && WEXITSTATUS(status) == 0)
            survived++;
        else
            CHECK(0, "%s, allocation %ld of %ld: status %x, '%s'", NAMES[call], k, count, (unsigned)status, said);
    }
    CHECK(aborted + survived == count, "of %ld allocations", count);
    printf("%s: of %ld allocations that fail %ld abort, saying so, %ld are done without\n", NAMES[call], count, aborted,
        survived);
}

/* The calls that the header says to allocate nothing, within the table and beyond it, where they integrate. */
static void loops_allocate_nothing(void)
{
    static answers out;
    double loads[LOADS], force[LOADS], slope[LOADS];

    for (int which = 0; which < SURFACES; which++) {
        const asperity_params p = surface(which);
        asperity_model *model = NULL;
        long count;

        CHECK(asperity_create(&p, &model) == ASPERITY_OK, "surface %s", SURFACE_NAMES[which]);
        answer(model, &out);
        for (int i = 0; i < LOADS; i++)
            loads[i] = i == 0 ? NAN : out.summary.pull_off_load + out.summary.max_table_load * pow(10, -20 + 0.25 * i);
        arm(-1);
        for (int i = 0; i < LOADS; i++) {
            force[i] = asperity_friction_force_at_load(model, loads[i]);
            slope[i] = asperity_friction_at_load(model, loads[i]);
        }
        asperity_friction_force_at_loads(model, LOADS, loads, force, slope);
        asperity_friction_at_loads(model, LOADS, loads, force, slope);
        asperity_state_at_load(model, -1e300, &out.exact[0]); /* refused, with a message */
        count = disarm();
        CHECK(count == 0, "the calls of a loop on %s make %ld allocations", SURFACE_NAMES[which], count);
        asperity_free(model);
    }
    printf("the calls of a solver's loop make no allocation, within the table or beyond it, nor does a refusal\n");
}

int main(void)
{
    const asperity_params p = surface(0);
    asperity_model *model = NULL;

    *(void **)&arm = dlsym(RTLD_DEFAULT, "failing_malloc_arm");
    *(void **)&disarm = dlsym(RTLD_DEFAULT, "failing_malloc_disarm");
    if (arm == NULL || disarm == NULL || asperity_create(&p, &model) != ASPERITY_OK) {
        fprintf(stderr, "out_of_memory: failing_malloc.so is not preloaded\n");
        return 1;
    }
    each_allocation(CREATE, model);
    each_allocation(SET_PARAMS, model);
    loops_allocate_nothing();
    asperity_free(model);
    return checks_report("out_of_memory");
}
