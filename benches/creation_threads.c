/* Models made a second by threads of one process: asperity_create takes no lock, so that threads do not wait for each other.
 * usage: creation_threads THREADS MODELS; prints models a second, and milliseconds of processor time for each. */
#include <asperity.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

static long models_each;

static void *make_models(void *failed)
{
    asperity_params params;

    asperity_params_init(&params, sizeof params);
    if (asperity_params_set_dimensionless(&params, 0.01, 1000.0, 0.001, 1.0, 0.3) != ASPERITY_OK)
        *(int *)failed = 1;
    for (long i = 0; i < models_each; i++) {
        asperity_model *model = NULL;
        params.work_of_adhesion *= 1.0 + 1e-6;
        if (asperity_create(&params, &model) != ASPERITY_OK)
            *(int *)failed = 1;
        asperity_free(model);
    }
    return NULL;
}

static double seconds(clockid_t clock)
{
    struct timespec now;

    clock_gettime(clock, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

int main(int argc, char **argv)
{
    const int threads = argc == 3 ? atoi(argv[1]) : 0;
    const long models = argc == 3 ? atol(argv[2]) : 0;
    pthread_t thread[64];
    int failed[64] = {0}, any = 0;

    if (threads < 1 || threads > 64 || models < threads) {
        fprintf(stderr, "usage: creation_threads THREADS MODELS, 1 to 64 threads\n");
        return 2;
    }
    models_each = models / threads;
    const double start = seconds(CLOCK_MONOTONIC), processor = seconds(CLOCK_PROCESS_CPUTIME_ID);
    for (int i = 0; i < threads; i++)
        if (pthread_create(&thread[i], NULL, make_models, &failed[i]) != 0)
            return 1;
    for (int i = 0; i < threads; i++) {
        pthread_join(thread[i], NULL);
        any |= failed[i];
    }
    const double made = (double)(models_each * threads);
    printf("%.0f %.3f\n", made / (seconds(CLOCK_MONOTONIC) - start), 1e3 * (seconds(CLOCK_PROCESS_CPUTIME_ID) - processor) / made);
    return any;
}
