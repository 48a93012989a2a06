/* Runs a mock-up unit through the calls of FMI 2.0 or 3.0 and prints the bits of what it answers, to be compared between systems.
 *
 * usage: fmu_answers VERSION UNIT-LIBRARY GUID HEIGHT_STD-REFERENCE       VERSION is 2 or 3
 * Exit status: 0 where each call ends with the status that it must. */

#include <inttypes.h>
#include <stdarg.h>
#include <stdbool.h>
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
    (void)environment, (void)name;
    va_start(arguments, format);
    printf("log: %d %s %s\n", status, category, va_arg(arguments, const char *));
    va_end(arguments);
}

typedef void log_3(void *, int, const char *, const char *);
static void log_message_3(void *environment, int status, const char *category, const char *message)
{
    (void)environment;
    printf("log: %d %s %s\n", status, category, message);
}

static int version;
static const char *unit_file;
static int (*leave)(void *), (*reset)(void *);
static void (*release)(void *);
static union {
    int (*two)(void *, const unsigned *, size_t, double *);
    int (*three)(void *, const unsigned *, size_t, double *, size_t);
} getter;
static union {
    int (*two)(void *, const unsigned *, size_t, const double *);
    int (*three)(void *, const unsigned *, size_t, const double *, size_t);
} setter;
static union {
    int (*two)(void *, const unsigned *, size_t, const unsigned *, size_t, const double *, double *);
    int (*three)(void *, const unsigned *, size_t, const unsigned *, size_t, const double *, size_t, double *, size_t);
} differentiate;

static int get(void *unit, const unsigned *references, size_t n, double *values)
{
    return version == 2 ? getter.two(unit, references, n, values) : getter.three(unit, references, n, values, n);
}

static int set(void *unit, const unsigned *reference, size_t n, const double *values)
{
    return version == 2 ? setter.two(unit, reference, n, values) : setter.three(unit, reference, n, values, n);
}

static int derivative(void *unit, const unsigned *unknown, size_t n, const unsigned *known, const double *seed, double *values)
{
    return version == 2 ? differentiate.two(unit, unknown, n, known, 1, seed, values)
                        : differentiate.three(unit, unknown, n, known, 1, seed, 1, values, n);
}

static void *instantiate(const char *name, const char *guid)
{
    static const callbacks calls = {log_message, calloc, free, NULL, NULL};
    void *(*two)(const char *, int, const char *, const char *, const callbacks *, int, int);
    void *(*three)(const char *, const char *, const char *, bool, bool, void *, log_3 *);
    if (version == 2) {
        find(unit_file, "fmi2Instantiate", &two);
        return two(name, MODEL_EXCHANGE, guid, NULL, &calls, 0, 0);
    }
    find(unit_file, "fmi3InstantiateModelExchange", &three);
    return three(name, guid, NULL, false, false, NULL, log_message_3);
}

static int enter(void *unit)
{
    int (*two)(void *);
    int (*three)(void *, bool, double, double, bool, double);
    if (version == 2) {
        find(unit_file, "fmi2EnterInitializationMode", &two);
        return two(unit);
    }
    find(unit_file, "fmi3EnterInitializationMode", &three);
    return three(unit, false, 0, 0, false, 0);
}

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
        demand("setting the load", set(unit, &load, 1, &p), OK);
        demand("getting outputs", get(unit, outputs, 3, value), OK);
        print_bits("force", value[0]);
        print_bits("coefficient", value[1]);
        print_bits("slope", value[2]);
        demand("differentiating", derivative(unit, outputs, 3, &load, &one, value), OK);
        for (int i = 0; i < 3; i++)
            print_bits("derivative", value[i]);
    }
}

int main(int count, char **arguments)
{
    static const unsigned load = LOAD, force = FORCE;
    double value, number;
    if (count != 5)
        fail("usage: fmu_answers VERSION UNIT-LIBRARY GUID HEIGHT_STD-REFERENCE");
    version = atoi(arguments[1]);
    unit_file = arguments[2];
    const char *guid = arguments[3];
    const unsigned height_std = (unsigned)strtoul(arguments[4], NULL, 10);
#ifdef _WIN32
    if (LoadLibraryA(unit_file) == NULL)
#else
    if (dlopen(unit_file, RTLD_NOW | RTLD_LOCAL) == NULL)
#endif
        fail("the unit cannot be loaded");
    const bool two = version == 2;
    find(unit_file, two ? "fmi2ExitInitializationMode" : "fmi3ExitInitializationMode", &leave);
    find(unit_file, two ? "fmi2Reset" : "fmi3Reset", &reset);
    find(unit_file, two ? "fmi2GetReal" : "fmi3GetFloat64", &getter);
    find(unit_file, two ? "fmi2SetReal" : "fmi3SetFloat64", &setter);
    find(unit_file, two ? "fmi2GetDirectionalDerivative" : "fmi3GetDirectionalDerivative", &differentiate);
    find(unit_file, two ? "fmi2FreeInstance" : "fmi3FreeInstance", &release);

    if (instantiate("stranger", "{no}") != NULL)
        fail("a GUID of another unit is taken");
    void *unit = instantiate("pad", guid);
    if (unit == NULL)
        fail("no unit is made");
    demand("leaving initialization mode before entering it", leave(unit), ERROR_STATUS);
    demand("entering initialization mode", enter(unit), OK);
    demand("leaving initialization mode", leave(unit), OK);
    print_answers(unit);

    demand("getting", get(unit, &height_std, 1, &number), OK);
    print_bits("height_std", number);
    value = -1;
    demand("setting", set(unit, &height_std, 1, &value), OK);
    demand("getting the force of a surface that is refused", get(unit, &force, 1, &value), ERROR_STATUS);
    value = 0.8 * number;
    demand("setting", set(unit, &height_std, 1, &value), OK);
    print_answers(unit);
    value = -1e3;
    demand("setting", set(unit, &load, 1, &value), OK);
    demand("getting the force of surfaces apart", get(unit, &force, 1, &value), OK);
    print_bits("apart", value);
    demand("resetting", reset(unit), OK);
    demand("getting", get(unit, &height_std, 1, &value), OK);
    print_bits("height_std", value);
    release(unit);
    return 0;
}
