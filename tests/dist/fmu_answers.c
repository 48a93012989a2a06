/* Runs a mock-up unit through the calls of FMI 2.0 and prints the bits of what it answers, to be compared between systems.
 *
 * usage: fmu_answers UNIT-LIBRARY GUID HEIGHT_STD-REFERENCE
 * Exit status: 0 where each call ends with the status that it must. */

#include <inttypes.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifdef _WIN32
#include <windows.h>
#else
#include <dlfcn.h>
#endif

enum { OK, WARNING, DISCARD, ERROR_STATUS };
enum { MODEL_EXCHANGE, LOAD = 0, FORCE, COEFFICIENT, SLOPE };

typedef struct {
    void (*logger)(void *, const char *, int, const char *, const char *, ...);
    void *(*allocate)(size_t, size_t);
    void (*release)(void *);
    void (*step_finished)(void *, int);
    void *environment;
} callbacks;

static void fail(const char *what)
{
    fprintf(stderr, "fmu_answers: %s\n", what);
    exit(1);
}

/* A function of the unit. C has no cast from object to function pointer: the bytes are copied. */
static void find(const char *file, const char *name, void *function)
{
#ifdef _WIN32
    FARPROC found = GetProcAddress(GetModuleHandleA(file), name);
#else
    void *found = dlsym(dlopen(file, RTLD_NOW), name);
#endif
    if (found == NULL)
        fail(name);
    memcpy(function, &found, sizeof found);
}

static void print_bits(const char *name, double value)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    printf("%s %08" PRIx32 "%08" PRIx32 "\n", name, (uint32_t)(bits >> 32), (uint32_t)bits);
}

static void log_message(void *environment, const char *name, int status, const char *category, const char *format, ...)
{
    va_list arguments;
    (void)environment;
    va_start(arguments, format);
    printf("log of %s: %d %s %s\n", name, status, category, va_arg(arguments, const char *));
    va_end(arguments);
}

static void *(*instantiate)(const char *, int, const char *, const char *, const callbacks *, int, int);
static int (*setup)(void *, int, double, double, int, double), (*enter)(void *), (*leave)(void *), (*reset)(void *);
static int (*get)(void *, const unsigned *, size_t, double *), (*set)(void *, const unsigned *, size_t, const double *);
static int (*derivative)(void *, const unsigned *, size_t, const unsigned *, size_t, const double *, double *);
static void (*release)(void *);

static void demand(const char *what, int status, int wanted)
{
    if (status != wanted) {
        fprintf(stderr, "fmu_answers: %s ended with status %d, not %d\n", what, status, wanted);
        exit(1);
    }
}

/* Outputs and derivatives from nearly nothing to loads beyond what the surface bears, in steps of a fifth. */
static void print_answers(void *unit)
{
    static const unsigned load = LOAD, outputs[] = {FORCE, COEFFICIENT, SLOPE};
    const double one = 1;
    double value[3];
    for (double p = 1e-9; p < 1e3; p *= 1.2) {
        demand("fmi2SetReal", set(unit, &load, 1, &p), OK);
        demand("fmi2GetReal", get(unit, outputs, 3, value), OK);
        print_bits("force", value[0]);
        print_bits("coefficient", value[1]);
        print_bits("slope", value[2]);
        demand("fmi2GetDirectionalDerivative", derivative(unit, outputs, 3, &load, 1, &one, value), OK);
        for (int i = 0; i < 3; i++)
            print_bits("derivative", value[i]);
    }
}

int main(int count, char **arguments)
{
    static const callbacks calls = {log_message, calloc, free, NULL, NULL};
    static const unsigned load = LOAD, force = FORCE;
    double value, number;
    if (count != 4)
        fail("usage: fmu_answers UNIT-LIBRARY GUID HEIGHT_STD-REFERENCE");
    const char *file = arguments[1], *guid = arguments[2];
    const unsigned height_std = (unsigned)strtoul(arguments[3], NULL, 10);
#ifdef _WIN32
    if (LoadLibraryA(file) == NULL)
#else
    if (dlopen(file, RTLD_NOW | RTLD_LOCAL) == NULL)
#endif
        fail("the unit cannot be loaded");
    find(file, "fmi2Instantiate", &instantiate);
    find(file, "fmi2SetupExperiment", &setup);
    find(file, "fmi2EnterInitializationMode", &enter);
    find(file, "fmi2ExitInitializationMode", &leave);
    find(file, "fmi2Reset", &reset);
    find(file, "fmi2GetReal", &get);
    find(file, "fmi2SetReal", &set);
    find(file, "fmi2GetDirectionalDerivative", &derivative);
    find(file, "fmi2FreeInstance", &release);

    if (instantiate("stranger", MODEL_EXCHANGE, "{no}", NULL, &calls, 0, 0) != NULL)
        fail("a GUID of another unit is taken");
    void *unit = instantiate("pad", MODEL_EXCHANGE, guid, NULL, &calls, 0, 0);
    if (unit == NULL)
        fail("fmi2Instantiate gives nothing");
    demand("fmi2SetupExperiment", setup(unit, 0, 0, 0, 0, 0), OK);
    demand("fmi2EnterInitializationMode", enter(unit), OK);
    demand("fmi2ExitInitializationMode", leave(unit), OK);
    print_answers(unit);

    demand("fmi2GetReal", get(unit, &height_std, 1, &number), OK);
    print_bits("height_std", number);
    value = -1;
    demand("fmi2SetReal", set(unit, &height_std, 1, &value), OK);
    demand("fmi2GetReal of a surface that is refused", get(unit, &force, 1, &value), ERROR_STATUS);
    value = 0.8 * number;
    demand("fmi2SetReal", set(unit, &height_std, 1, &value), OK);
    print_answers(unit);
    value = -1e3;
    demand("fmi2SetReal", set(unit, &load, 1, &value), OK);
    demand("fmi2GetReal of surfaces apart", get(unit, &force, 1, &value), OK);
    print_bits("apart", value);
    demand("fmi2Reset", reset(unit), OK);
    demand("fmi2GetReal", get(unit, &height_std, 1, &value), OK);
    print_bits("height_std", value);
    release(unit);
    return 0;
}
