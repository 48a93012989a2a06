/* Loads the library, uses it from two threads, unloads it, again and again: the address space and memory stay as they are.
 *
 * usage: reload LIBRARY COUNT */

#define _GNU_SOURCE
#include <asperity.h>

#include <dlfcn.h>
#include <pthread.h>
#include <stdlib.h>
#include <unistd.h>

#include "../c/check.h"

typedef struct functions {
    asperity_status (*init)(asperity_params *, size_t);
    asperity_status (*set_dimensionless)(asperity_params *, double, double, double, double, double);
    asperity_status (*create)(const asperity_params *, asperity_model **);
    double (*force)(const asperity_model *, double);
    size_t (*last_error)(char *, size_t);
    void (*free)(asperity_model *);
} functions;

static double use(const functions *f)
{
    asperity_params p;
    asperity_model *model = NULL;
    double force;

    if (f->init(&p, sizeof p) != ASPERITY_OK || f->set_dimensionless(&p, 0.01, 1000, 0.001, 1, 0.3) != ASPERITY_OK ||
        f->create(&p, &model) != ASPERITY_OK)
        return -1;
    force = f->force(model, 1.0);
    f->free(model);
    p.burgers_vector = -1;
    return f->create(&p, &model) == ASPERITY_INVALID_PARAMETER && f->last_error(NULL, 0) > 0 ? force : -1;
}

static void *use_in_thread(void *argument)
{
    const functions *f = argument;
    double *force = malloc(sizeof *force);

    *force = use(f);
    return force;
}

static long mappings(void)
{
    char line[4096];
    long count = 0;
    FILE *file = fopen("/proc/self/maps", "r");

    while (file != NULL && fgets(line, sizeof line, file) != NULL)
        count++;
    if (file != NULL)
        fclose(file);
    return count;
}

int main(int argc, char **argv)
{
    const long count = argc > 2 ? strtol(argv[2], NULL, 10) : 0;
    long before = 0;
    double first = 0;

    CHECK(count > 0, "usage: reload LIBRARY COUNT");
    for (long i = 0; i < count; i++) {
        void *library = dlopen(argv[1], RTLD_NOW | RTLD_LOCAL);
        functions f;
        pthread_t thread;
        void *in_thread = NULL;
        double here;

        if (library == NULL) {
            fprintf(stderr, "reload: %s\n", dlerror());
            return 1;
        }
        *(void **)&f.init = dlsym(library, "asperity_params_init");
        *(void **)&f.set_dimensionless = dlsym(library, "asperity_params_set_dimensionless");
        *(void **)&f.create = dlsym(library, "asperity_create");
        *(void **)&f.force = dlsym(library, "asperity_friction_force_at_load");
        *(void **)&f.last_error = dlsym(library, "asperity_last_error");
        *(void **)&f.free = dlsym(library, "asperity_free");
        pthread_create(&thread, NULL, use_in_thread, &f);
        here = use(&f);
        pthread_join(thread, &in_thread);
        CHECK(here > 0 && (i == 0 || here == first) && *(double *)in_thread == here, "load %ld: %g", i, here);
        first = here;
        free(in_thread);
        dlclose(library);
        CHECK(dlopen(argv[1], RTLD_NOW | RTLD_NOLOAD) == NULL, "load %ld: the library stays", i);
        if (i == count / 10)
            before = mappings();
    }
    CHECK(mappings() <= before + 2, "%ld mappings after a tenth, %ld at the end", before, mappings());
    printf("reload: loaded, used by two threads and unloaded %ld times, %ld mappings\n", count, mappings());
    return checks_report("reload");
}
