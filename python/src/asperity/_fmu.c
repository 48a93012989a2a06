/* A friction law as a functional mock-up unit: FMI 2.0 for model exchange and co-simulation. The law has no state and no
 * event; outputs follow from the load and the parameters alone. surface.h is written for each unit: its parameters.
 *
 * The model is made on entering initialization mode, and made anew where outputs are read after a parameter was set. */

#include <asperity.h>
#include <stdlib.h>
#include <string.h>

#ifdef _WIN32
#include "asperity_dll.h"
#endif
#include "surface.h"

/* What fmi2TypesPlatform.h and fmi2FunctionTypes.h of the standard (version 2.0.4) declare, as far as it is used here. */
typedef void *fmi2Component, *fmi2ComponentEnvironment, *fmi2FMUstate;
typedef unsigned int fmi2ValueReference;
typedef double fmi2Real;
typedef int fmi2Integer, fmi2Boolean;
typedef const char *fmi2String;
typedef char fmi2Byte;
typedef enum { fmi2OK, fmi2Warning, fmi2Discard, fmi2Error, fmi2Fatal, fmi2Pending } fmi2Status;
typedef enum { fmi2ModelExchange, fmi2CoSimulation } fmi2Type;
typedef struct {
    void (*logger)(fmi2ComponentEnvironment, fmi2String, fmi2Status, fmi2String, fmi2String, ...);
    void *(*allocateMemory)(size_t, size_t);
    void (*freeMemory)(void *);
    void (*stepFinished)(fmi2ComponentEnvironment, fmi2Status);
    fmi2ComponentEnvironment componentEnvironment;
} fmi2CallbackFunctions;
typedef struct {
    fmi2Boolean newDiscreteStatesNeeded, terminateSimulation, nominalsOfContinuousStatesChanged;
    fmi2Boolean valuesOfContinuousStatesChanged, nextEventTimeDefined;
    fmi2Real nextEventTime;
} fmi2EventInfo;

#ifdef _WIN32
#define EXPORT __declspec(dllexport)
#else
#define EXPORT __attribute__((visibility("default")))
#endif
#ifdef FMI2_FUNCTION_PREFIX
#define JOINED(a, b) a##b
#define JOIN(a, b) JOINED(a, b)
#define FMI(name) JOIN(FMI2_FUNCTION_PREFIX, name)
#else
#define FMI(name) name
#endif

/* Value references: of parameters PARAMETERS + their place in PARAMETER_NAMES. */
enum { LOAD, FORCE, COEFFICIENT, SLOPE, PARAMETERS };

typedef struct {
    asperity_params params;
    asperity_model *model; /* NULL until it is made */
    int stale;             /* a parameter was set since */
    double load;
    char *name;
    const fmi2CallbackFunctions *callbacks;
} unit;

static fmi2Status failed(const unit *u, fmi2Status status, const char *message)
{
    if (u->callbacks->logger)
        u->callbacks->logger(u->callbacks->componentEnvironment, u->name, status,
                             status == fmi2Error ? "logStatusError" : "logStatusDiscard", "%s", message);
    return status;
}

static fmi2Status refused(const unit *u, fmi2Status status)
{
    char message[512];
    asperity_last_error(message, sizeof message);
    return failed(u, status, message);
}

/* The parameters that the unit was exported with, and their load. */
static int set_start(unit *u)
{
    asperity_free(u->model);
    u->model = NULL;
    u->stale = 1;
    u->load = START_LOAD;
    return surface(&u->params) == ASPERITY_OK;
}

static fmi2Status make_model(unit *u)
{
    asperity_status status = ASPERITY_OK;
    if (u->model == NULL)
        status = asperity_create(&u->params, &u->model);
    else if (u->stale)
        status = asperity_set_params(u->model, &u->params);
    if (status != ASPERITY_OK)
        return refused(u, fmi2Error);
    u->stale = 0;
    return fmi2OK;
}

/* An open contact has no friction: no error. A load that cannot be evaluated may be one that a solver only tries. */
static fmi2Status evaluate(unit *u, int coefficient, double load, double *value, double *slope)
{
    asperity_status status;
    if (make_model(u) != fmi2OK)
        return fmi2Error;
    status = coefficient ? asperity_friction_at_loads(u->model, 1, &load, value, slope)
                         : asperity_friction_force_at_loads(u->model, 1, &load, value, slope);
    return status == ASPERITY_OK || status == ASPERITY_SEPARATED ? fmi2OK : refused(u, fmi2Discard);
}

static fmi2Status get_one(unit *u, fmi2ValueReference reference, double *value)
{
    double other;
    switch (reference) {
    case LOAD: *value = u->load; return fmi2OK;
    case FORCE: return evaluate(u, 0, u->load, value, NULL);
    case COEFFICIENT: return evaluate(u, 1, u->load, value, NULL);
    case SLOPE: return evaluate(u, 0, u->load, &other, value);
    default: break;
    }
    if (reference - PARAMETERS >= PARAMETER_COUNT)
        return failed(u, fmi2Error, "a value reference that no variable has");
    if (asperity_params_get_value(&u->params, PARAMETER_NAMES[reference - PARAMETERS], value) != ASPERITY_OK)
        return refused(u, fmi2Error);
    return fmi2OK;
}

static fmi2Status set_one(unit *u, fmi2ValueReference reference, double value)
{
    if (reference == LOAD) {
        u->load = value;
        return fmi2OK;
    }
    if (reference < PARAMETERS || reference - PARAMETERS >= PARAMETER_COUNT)
        return failed(u, fmi2Error, "a value reference of no input and no parameter is set");
    if (asperity_params_set_value(&u->params, PARAMETER_NAMES[reference - PARAMETERS], value) != ASPERITY_OK)
        return refused(u, fmi2Error);
    u->stale = 1;
    return fmi2OK;
}

/* d(output)/d(load). The slope's own is a central difference: the law tells no second derivative. */
static fmi2Status derivative(unit *u, fmi2ValueReference output, double *value)
{
    double other, below, above, step = 1e-5 * (u->load < 0 ? -u->load : u->load);
    fmi2Status status;
    switch (output) {
    case FORCE: return evaluate(u, 0, u->load, &other, value);
    case COEFFICIENT: return evaluate(u, 1, u->load, &other, value);
    case SLOPE:
        *value = 0;
        if (!(step > 0))
            return fmi2OK;
        if ((status = evaluate(u, 0, u->load - step, &other, &below)) != fmi2OK ||
            (status = evaluate(u, 0, u->load + step, &other, &above)) != fmi2OK)
            return status;
        *value = (above - below) / (2 * step);
        return fmi2OK;
    default: return failed(u, fmi2Error, "only outputs have directional derivatives");
    }
}

EXPORT const char *FMI(fmi2GetTypesPlatform)(void)
{
    return "default";
}

EXPORT const char *FMI(fmi2GetVersion)(void)
{
    return "2.0";
}

EXPORT fmi2Component FMI(fmi2Instantiate)(fmi2String name, fmi2Type type, fmi2String guid, fmi2String resources,
                                          const fmi2CallbackFunctions *callbacks, fmi2Boolean visible, fmi2Boolean log)
{
    unit *u = callbacks && name ? calloc(1, sizeof *u) : NULL;
    (void)type, (void)resources, (void)visible, (void)log;
    if (u == NULL)
        return NULL;
    u->callbacks = callbacks;
    u->name = malloc(strlen(name) + 1);
    if (u->name != NULL) {
        strcpy(u->name, name);
        if (guid == NULL || strcmp(guid, GUID) != 0)
            failed(u, fmi2Error, "the GUID is not that of this unit");
#ifdef _WIN32
        else if (!load_asperity())
            failed(u, fmi2Error, "asperity.dll beside the unit's DLL is missing, of another version, or lacks a DLL of its own");
#endif
        else if (set_start(u))
            return u;
    }
    free(u->name);
    free(u);
    return NULL;
}

EXPORT void FMI(fmi2FreeInstance)(fmi2Component c)
{
    unit *u = c;
    if (u == NULL)
        return;
    asperity_free(u->model);
    free(u->name);
    free(u);
}

EXPORT fmi2Status FMI(fmi2EnterInitializationMode)(fmi2Component c)
{
    return make_model(c);
}

EXPORT fmi2Status FMI(fmi2Reset)(fmi2Component c)
{
    return set_start(c) ? fmi2OK : refused(c, fmi2Error);
}

EXPORT fmi2Status FMI(fmi2GetReal)(fmi2Component c, const fmi2ValueReference reference[], size_t n, fmi2Real value[])
{
    fmi2Status status = fmi2OK;
    for (size_t i = 0; i < n && status == fmi2OK; i++)
        status = get_one(c, reference[i], &value[i]);
    return status;
}

EXPORT fmi2Status FMI(fmi2SetReal)(fmi2Component c, const fmi2ValueReference reference[], size_t n,
                                   const fmi2Real value[])
{
    fmi2Status status = fmi2OK;
    for (size_t i = 0; i < n && status == fmi2OK; i++)
        status = set_one(c, reference[i], value[i]);
    return status;
}

EXPORT fmi2Status FMI(fmi2GetDirectionalDerivative)(fmi2Component c, const fmi2ValueReference unknown[],
                                                    size_t unknowns, const fmi2ValueReference known[], size_t knowns,
                                                    const fmi2Real seed[], fmi2Real value[])
{
    double along = 0;
    for (size_t i = 0; i < knowns; i++) {
        if (known[i] != LOAD)
            return failed(c, fmi2Error, "directional derivatives are those with respect to the load");
        along += seed[i];
    }
    for (size_t i = 0; i < unknowns; i++) {
        double slope;
        fmi2Status status = derivative(c, unknown[i], &slope);
        if (status != fmi2OK)
            return status;
        value[i] = slope * along;
    }
    return fmi2OK;
}

EXPORT fmi2Status FMI(fmi2NewDiscreteStates)(fmi2Component c, fmi2EventInfo *info)
{
    (void)c;
    memset(info, 0, sizeof *info);
    return fmi2OK;
}

EXPORT fmi2Status FMI(fmi2CompletedIntegratorStep)(fmi2Component c, fmi2Boolean last, fmi2Boolean *event,
                                                   fmi2Boolean *terminate)
{
    (void)c, (void)last;
    *event = *terminate = 0;
    return fmi2OK;
}

/* ---- Nothing to do: there is no state, no event, and time does not matter. ---- */

#define NOTHING(name)                                                                                                  \
    EXPORT fmi2Status FMI(name)(fmi2Component c)                                                        \
    {                                                                                                                  \
        (void)c;                                                                                                       \
        return fmi2OK;                                                                                                 \
    }
#define NONE(name, ...)                                                                                                \
    EXPORT fmi2Status FMI(name)(fmi2Component c, __VA_ARGS__)                                                          \
    {                                                                                                                  \
        return failed(c, fmi2Error, #name ": the unit has nothing of this kind");                                      \
    }
/* Arrays of a kind that the unit has none of: fine if empty. */
#define EMPTY(name, type)                                                                                              \
    EXPORT fmi2Status FMI(name)(fmi2Component c, const fmi2ValueReference r[], size_t n, type v[])                     \
    {                                                                                                                  \
        (void)r, (void)v;                                                                                              \
        return n == 0 ? fmi2OK : failed(c, fmi2Error, #name ": the unit has reals alone");                             \
    }
#define STATES(name, type)                                                                                             \
    EXPORT fmi2Status FMI(name)(fmi2Component c, type x[], size_t n)                                                   \
    {                                                                                                                  \
        (void)x;                                                                                                       \
        return n == 0 ? fmi2OK : failed(c, fmi2Error, #name ": the unit has no states and no event indicators");       \
    }

EXPORT fmi2Status FMI(fmi2SetDebugLogging)(fmi2Component c, fmi2Boolean on, size_t n, const fmi2String categories[])
{
    (void)c, (void)on, (void)n, (void)categories;
    return fmi2OK;
}

EXPORT fmi2Status FMI(fmi2SetupExperiment)(fmi2Component c, fmi2Boolean tolerance_defined, fmi2Real tolerance,
                                           fmi2Real start, fmi2Boolean stop_defined, fmi2Real stop)
{
    (void)c, (void)tolerance_defined, (void)tolerance, (void)start, (void)stop_defined, (void)stop;
    return fmi2OK;
}

EXPORT fmi2Status FMI(fmi2SetTime)(fmi2Component c, fmi2Real time)
{
    (void)c, (void)time;
    return fmi2OK;
}

EXPORT fmi2Status FMI(fmi2DoStep)(fmi2Component c, fmi2Real time, fmi2Real step, fmi2Boolean no_set_prior)
{
    (void)time, (void)step, (void)no_set_prior;
    return make_model(c);
}

NOTHING(fmi2ExitInitializationMode)
NOTHING(fmi2Terminate)
NOTHING(fmi2EnterEventMode)
NOTHING(fmi2EnterContinuousTimeMode)
NOTHING(fmi2CancelStep)
EMPTY(fmi2GetInteger, fmi2Integer)
EMPTY(fmi2GetBoolean, fmi2Boolean)
EMPTY(fmi2GetString, fmi2String)
EMPTY(fmi2SetInteger, const fmi2Integer)
EMPTY(fmi2SetBoolean, const fmi2Boolean)
EMPTY(fmi2SetString, const fmi2String)
STATES(fmi2SetContinuousStates, const fmi2Real)
STATES(fmi2GetDerivatives, fmi2Real)
STATES(fmi2GetEventIndicators, fmi2Real)
STATES(fmi2GetContinuousStates, fmi2Real)
STATES(fmi2GetNominalsOfContinuousStates, fmi2Real)

#pragma GCC diagnostic ignored "-Wunused-parameter"
NONE(fmi2GetFMUstate, fmi2FMUstate *state)
NONE(fmi2SetFMUstate, fmi2FMUstate state)
NONE(fmi2FreeFMUstate, fmi2FMUstate *state)
NONE(fmi2SerializedFMUstateSize, fmi2FMUstate state, size_t *size)
NONE(fmi2SerializeFMUstate, fmi2FMUstate state, fmi2Byte bytes[], size_t size)
NONE(fmi2DeSerializeFMUstate, const fmi2Byte bytes[], size_t size, fmi2FMUstate *state)
NONE(fmi2SetRealInputDerivatives, const fmi2ValueReference r[], size_t n, const fmi2Integer order[],
     const fmi2Real value[])
NONE(fmi2GetRealOutputDerivatives, const fmi2ValueReference r[], size_t n, const fmi2Integer order[], fmi2Real value[])
NONE(fmi2GetStatus, int kind, fmi2Status *value)
NONE(fmi2GetRealStatus, int kind, fmi2Real *value)
NONE(fmi2GetIntegerStatus, int kind, fmi2Integer *value)
NONE(fmi2GetBooleanStatus, int kind, fmi2Boolean *value)
NONE(fmi2GetStringStatus, int kind, fmi2String *value)
