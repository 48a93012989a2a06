/* Loads and unloads the library 200 times, each time with threads that called it, failed in it, and outlive it.
 *
 * usage: consumer LIBRARY
 * A library that leaves something behind in a thread (a destructor of a thread-local) stays mapped or crashes here.
 * Exit status: 0 where the library goes each time and comes back as good as new. */

#define _GNU_SOURCE

#include <asperity.h>

#include <dlfcn.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { TIMES = 200, THREADS = 3 };

typedef struct library {
    void *handle;
    asperity_status (*params_init)(asperity_params *, size_t);
    asperity_status (*set_dimensionless)(asperity_params *, double, double, double, double, double);
    asperity_status (*create)(const asperity_params *, asperity_model **);
    double (*friction_at_load)(const asperity_model *, double);
    size_t (*last_error)(char *, size_t);
    void (*free)(asperity_model *);
} library;

typedef struct work {
    const library *lib;
    const asperity_model *model;
    pthread_barrier_t called, unloaded;
} work;

static void fail(const char *what, const char *why)
{
    fprintf(stderr, "%s: %s\n", what, why);
    exit(1);
}

/* C has no cast from object to function pointer; POSIX has the pointer's bytes copied. */
static void find(const library *lib, const char *name, void *function)
{
    void *symbol = dlsym(lib->handle, name);

    if (symbol == NULL)
        fail(name, "not found");
    memcpy(function, &symbol, sizeof symbol);
}

static library load(const char *path)
{
    library lib;

    lib.handle = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    if (lib.handle == NULL)
        fail(path, dlerror());
    find(&lib, "asperity_params_init", &lib.params_init);
    find(&lib, "asperity_params_set_dimensionless", &lib.set_dimensionless);
    find(&lib, "asperity_create", &lib.create);
    find(&lib, "asperity_friction_at_load", &lib.friction_at_load);
    find(&lib, "asperity_last_error", &lib.last_error);
    find(&lib, "asperity_free", &lib.free);
    return lib;
}

static void unload(const library *lib, const char *path)
{
    if (dlclose(lib->handle) != 0)
        fail(path, dlerror());
    if (dlopen(path, RTLD_NOW | RTLD_NOLOAD) != NULL)
        fail(path, "still loaded after dlclose");
}

/* The case of the paper, by functions that were found by name. */
static asperity_params paper(const library *lib)
{
    asperity_params params;

    if (lib->params_init(&params, sizeof params) != ASPERITY_OK || params.calibration_error != 0.05)
        fail("asperity_params_init", "the struct is not whole");
    lib->set_dimensionless(&params, 0.01, 1000, 0.001, 1, 0.3);
    return params;
}

static void *call(void *argument)
{
    work *w = argument;
    asperity_params params;
    asperity_model *none = NULL;
    char message[256];

    if (!(w->lib->friction_at_load(w->model, 1.0) > 0))
        fail("asperity_friction_at_load", "no friction");
    params = paper(w->lib);
    params.height_std = -1;
    if (w->lib->create(&params, &none) != ASPERITY_INVALID_PARAMETER)
        fail("asperity_create", "took height_std = -1");
    w->lib->last_error(message, sizeof message);
    if (strncmp(message, "height_std = -1: ", 17) != 0)
        fail("asperity_last_error", message);
    pthread_barrier_wait(&w->called);
    pthread_barrier_wait(&w->unloaded);
    return NULL;
}

static void once(const char *path)
{
    const library lib = load(path);
    const asperity_params params = paper(&lib);
    asperity_model *model = NULL;
    pthread_t threads[THREADS];
    work w;

    if (lib.create(&params, &model) != ASPERITY_OK)
        fail("asperity_create", "failed");
    w.lib = &lib;
    w.model = model;
    pthread_barrier_init(&w.called, NULL, THREADS + 1);
    pthread_barrier_init(&w.unloaded, NULL, THREADS + 1);
    for (int i = 0; i < THREADS; i++)
        if (pthread_create(&threads[i], NULL, call, &w) != 0)
            fail("pthread_create", "failed");
    pthread_barrier_wait(&w.called);
    lib.free(model);
    unload(&lib, path);
    pthread_barrier_wait(&w.unloaded);
    for (int i = 0; i < THREADS; i++)
        pthread_join(threads[i], NULL);
    pthread_barrier_destroy(&w.called);
    pthread_barrier_destroy(&w.unloaded);
}

int main(int argc, char **argv)
{
    if (argc != 2)
        fail("usage", "consumer LIBRARY");
    for (int i = 0; i < TIMES; i++)
        once(argv[1]);
    return 0;
}
