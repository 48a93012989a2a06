/* What a mock-up unit is, behind the functions of FMI 2.0 and 3.0. It has no continuous states and no events. Friction follows
 * from the load and the parameters alone; with microslip (asperity_unit_microslip.h) a unit remembers its path too.
 * surface.h is written for each unit: its parameters, and whether it has microslip.
 *
 * The model is made on entering initialization mode, and made anew where outputs are read after a parameter was set. */

#include <asperity.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifdef _WIN32
#include "asperity_dll.h"
#endif
#include <asperity_loads.h>

#include "surface.h"

#ifdef _WIN32
#define EXPORT __declspec(dllexport)
#else
#define EXPORT __attribute__((visibility("default")))
#endif
/* A static unit has its name before those of the functions. */
#ifdef FMI_PREFIX
#define JOINED(a, b) a##b
#define JOIN(a, b) JOINED(a, b)
#define FMI(name) JOIN(FMI_PREFIX, name)
#else
#define FMI(name) name
#endif

typedef enum { fmiOK, fmiWarning, fmiDiscard, fmiError, fmiFatal, fmiPending } fmiStatus;

/* Value references: of parameters PARAMETERS + their place in PARAMETER_NAMES. */
#if MICROSLIP
enum { LOAD, FORCE, COEFFICIENT, SLOPE, DISPLACEMENT, TANGENTIAL_FORCE, TANGENTIAL_STIFFNESS, PARAMETERS };
#else
enum { LOAD, FORCE, COEFFICIENT, SLOPE, PARAMETERS };
#endif

enum { INSTANTIATED = 1, INITIALIZATION = 2, EVENT = 4, CONTINUOUS_TIME = 8, STEP = 16, TERMINATED = 32 };

/* What a unit is saved by. */
typedef struct {
    asperity_params params;
    int mode;
    double time, load;
#if MICROSLIP
    double displacement, accepted; /* now, and when the last step was accepted, */
    double summits[64];            /* by which they carried this */
#endif
} unit_state;

typedef struct {
    unit_state state;
    asperity_model *model; /* NULL until it is made */
    int stale;             /* a parameter was set since */
    int exchange;          /* model exchange, not co-simulation */
    asperity_told told; /* warnings, in the log */
    void (*log)(void *environment, fmiStatus, const char *category, const char *message); /* may be NULL */
    void *environment;
} unit;

static fmiStatus failed(const unit *u, fmiStatus status, const char *message)
{
    if (u->log)
        u->log(u->environment, status, status == fmiError ? "logStatusError" : "logStatusDiscard", message);
    return status;
}

static fmiStatus refused(const unit *u, fmiStatus status)
{
    char message[512];
    asperity_last_error(message, sizeof message);
    return failed(u, status, message);
}

/* fmiOK in one of the modes: elsewhere the function must not be called. */
static fmiStatus called_in(const unit *u, int modes, const char *function)
{
    const int mode = u->state.mode;
    const char *name = mode == INSTANTIATED      ? "before initialization mode"
                       : mode == INITIALIZATION  ? "in initialization mode"
                       : mode == EVENT           ? "in event mode"
                       : mode == CONTINUOUS_TIME ? "in continuous-time mode"
                       : mode == STEP            ? "in co-simulation"
                                                 : "after the end";
    char message[128];
    if (mode & modes)
        return fmiOK;
    snprintf(message, sizeof message, "%s must not be called %s", function, name);
    return failed(u, fmiError, message);
}

static fmiStatus move(unit *u, int from, int to, const char *function)
{
    const fmiStatus status = called_in(u, from, function);
    if (status == fmiOK)
        u->state.mode = to;
    return status;
}

/* The parameters that the unit was exported with, and their load. */
static fmiStatus set_start(unit *u)
{
    asperity_free(u->model);
    u->model = NULL;
    u->stale = 1;
    memset(&u->state, 0, sizeof u->state);
    u->state.mode = INSTANTIATED;
    u->state.load = START_LOAD;
    memset(&u->told, 0, sizeof u->told);
    if (asperity_params_init(&u->state.params, sizeof u->state.params) != ASPERITY_OK ||
        asperity_params_set_text(&u->state.params, SURFACE, sizeof SURFACE - 1) != ASPERITY_OK)
        return refused(u, fmiError);
    return fmiOK;
}

/* The unit, ready, or NULL after a message. It is the first member of what was allocated. */
static unit *instantiated(unit *u, const char *guid)
{
    if (guid == NULL || strcmp(guid, GUID) != 0)
        failed(u, fmiError, "the GUID is not that of this unit");
#ifdef _WIN32
    else if (!load_asperity())
        failed(u, fmiError, "asperity.dll beside the unit's DLL is missing, of another version, or lacks a DLL of its own");
#endif
    else if (set_start(u) == fmiOK)
        return u;
    free(u);
    return NULL;
}

static void release(unit *u)
{
    if (u != NULL)
        asperity_free(u->model);
    free(u);
}

static fmiStatus make_model(unit *u)
{
    asperity_status status = ASPERITY_OK;
    if (u->model == NULL)
        status = asperity_create(&u->state.params, &u->model);
    else if (u->stale)
        status = asperity_set_params(u->model, &u->state.params);
    if (status != ASPERITY_OK)
        return refused(u, fmiError);
    if (u->stale) /* of this surface nothing was looked at */
        u->told.lightest = u->told.heaviest = 0;
    u->stale = 0;
    return fmiOK;
}

/* Logs each warning of the model once, at the first load at which it is seen. */
static void tell_warnings(unit *u, double load)
{
    char text[640], message[768];
    uint64_t warnings, bit;
    if (u->log == NULL)
        return;
    warnings = asperity_told_anew(&u->told, u->model, load);
    for (bit = 1; bit <= warnings; bit *= 2)
        if (warnings & bit) {
            asperity_warnings_text(bit, text, sizeof text);
            snprintf(message, sizeof message, "at a load of %g: %s", load, text);
            u->log(u->environment, fmiWarning, "logStatusWarning", message);
        }
}

#include "asperity_unit_microslip.h"

static fmiStatus enter_initialization(unit *u, const char *function)
{
    if (called_in(u, INSTANTIATED, function) != fmiOK || make_model(u) != fmiOK)
        return fmiError;
    u->state.mode = INITIALIZATION;
    return fmiOK;
}

/* An open contact has no friction: no error. A load that cannot be evaluated may be one that a solver only tries. */
static fmiStatus evaluate(unit *u, int coefficient, double load, double *value, double *slope)
{
    asperity_status status;
    if (make_model(u) != fmiOK)
        return fmiError;
    status = coefficient ? asperity_friction_at_loads(u->model, 1, &load, value, slope)
                         : asperity_friction_force_at_loads(u->model, 1, &load, value, slope);
    if (status != ASPERITY_OK && status != ASPERITY_SEPARATED)
        return refused(u, fmiDiscard);
    tell_warnings(u, load);
    return fmiOK;
}

/* Initialization is over: what was set in it is where the unit begins. */
static fmiStatus exit_initialization(unit *u, const char *function)
{
    fmiStatus status = called_in(u, INITIALIZATION, function);
    if (status == fmiOK)
        status = accept_step(u);
    if (status == fmiOK)
        u->state.mode = u->exchange ? EVENT : STEP;
    return status;
}

/* In model exchange the solver has accepted a step; in co-simulation it is the step. */
static fmiStatus completed(unit *u, int mode, const char *function)
{
    fmiStatus status = called_in(u, mode, function);
    if (status == fmiOK)
        status = make_model(u);
    return status == fmiOK ? accept_step(u) : status;
}

static fmiStatus get_one(unit *u, unsigned reference, double *value)
{
    double other;
    switch (reference) {
    case LOAD: *value = u->state.load; return fmiOK;
    case FORCE: return evaluate(u, 0, u->state.load, value, NULL);
    case COEFFICIENT: return evaluate(u, 1, u->state.load, value, NULL);
    case SLOPE: return evaluate(u, 0, u->state.load, &other, value);
#if MICROSLIP
    case DISPLACEMENT: *value = u->state.displacement; return fmiOK;
    case TANGENTIAL_FORCE:
    case TANGENTIAL_STIFFNESS: return resistance(u, u->state.load, reference, value, NULL, NULL);
#endif
    default: break;
    }
    if (reference - PARAMETERS >= PARAMETER_COUNT)
        return failed(u, fmiError, "a value reference that no variable has");
    if (asperity_params_get_value(&u->state.params, PARAMETER_NAMES[reference - PARAMETERS], value) != ASPERITY_OK)
        return refused(u, fmiError);
    return fmiOK;
}

static fmiStatus set_one(unit *u, unsigned reference, double value)
{
    if (reference == LOAD) {
        u->state.load = value;
        return fmiOK;
    }
#if MICROSLIP
    if (reference == DISPLACEMENT) {
        u->state.displacement = value;
        return fmiOK;
    }
#endif
    if (reference < PARAMETERS || reference - PARAMETERS >= PARAMETER_COUNT)
        return failed(u, fmiError, "a value reference of no input and no parameter is set");
    if (asperity_params_set_values(&u->state.params, 1, &PARAMETER_NAMES[reference - PARAMETERS], &value) != ASPERITY_OK)
        return refused(u, fmiError);
    u->stale = 1;
    return fmiOK;
}

/* d(slope)/d(load), a central difference: the law tells no second derivative. */
static fmiStatus curvature(unit *u, double *value)
{
    double other, below, above, step = 1e-5 * (u->state.load < 0 ? -u->state.load : u->state.load);
    fmiStatus status;
    *value = 0;
    if (!(step > 0))
        return fmiOK;
    if ((status = evaluate(u, 0, u->state.load - step, &other, &below)) != fmiOK ||
        (status = evaluate(u, 0, u->state.load + step, &other, &above)) != fmiOK)
        return status;
    *value = (above - below) / (2 * step);
    return fmiOK;
}

/* d(output)/d(load). */
static fmiStatus derivative(unit *u, unsigned output, double *value)
{
    double other;
    switch (output) {
    case FORCE: return evaluate(u, 0, u->state.load, &other, value);
    case COEFFICIENT: return evaluate(u, 1, u->state.load, &other, value);
    case SLOPE: return curvature(u, value);
#if MICROSLIP
    case TANGENTIAL_FORCE: return resistance(u, u->state.load, output, &other, value, NULL);
    case TANGENTIAL_STIFFNESS: return stiffening(u, value);
#endif
    default: return failed(u, fmiError, "only outputs have directional derivatives");
    }
}

/* d(output)/d(displacement); the stiffness is constant from one slip to the next. */
static fmiStatus derivative_along(unit *u, unsigned output, double *value)
{
    *value = 0;
#if MICROSLIP
    if (output == TANGENTIAL_FORCE) {
        double other;
        return resistance(u, u->state.load, output, &other, NULL, value);
    }
#endif
    (void)u;
    (void)output;
    return fmiOK;
}

static fmiStatus directional_derivative(unit *u, const unsigned unknown[], size_t unknowns, const unsigned known[],
                                        size_t knowns, const double seed[], double value[])
{
    double by_load = 0, by_displacement = 0;
    for (size_t i = 0; i < knowns; i++) {
        if (known[i] == LOAD)
            by_load += seed[i];
#if MICROSLIP
        else if (known[i] == DISPLACEMENT)
            by_displacement += seed[i];
#endif
        else
            return failed(u, fmiError, "directional derivatives are those with respect to inputs");
    }
    for (size_t i = 0; i < unknowns; i++) {
        double slope, along;
        fmiStatus status = derivative(u, unknown[i], &slope);
        if (status == fmiOK)
            status = derivative_along(u, unknown[i], &along);
        if (status != fmiOK)
            return status;
        value[i] = slope * by_load + along * by_displacement;
    }
    return fmiOK;
}
