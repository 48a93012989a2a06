/* The functions of FMI 2.0, for model exchange and co-simulation. asperity_unit.h has what they do. */

#ifdef FMI2_FUNCTION_PREFIX
#define FMI_PREFIX FMI2_FUNCTION_PREFIX
#endif
#include "asperity_unit.h"
#include "asperity_unit_saved.h"

/* What fmi2TypesPlatform.h and fmi2FunctionTypes.h of the standard (version 2.0.4) declare, as far as it is used here. */
typedef void *fmi2Component, *fmi2ComponentEnvironment, *fmi2FMUstate;
typedef unsigned int fmi2ValueReference;
typedef double fmi2Real;
typedef int fmi2Integer, fmi2Boolean;
typedef const char *fmi2String;
typedef char fmi2Byte;
typedef enum { fmi2ModelExchange, fmi2CoSimulation } fmi2Type;
typedef struct {
    void (*logger)(fmi2ComponentEnvironment, fmi2String, fmiStatus, fmi2String, fmi2String, ...);
    void *(*allocateMemory)(size_t, size_t);
    void (*freeMemory)(void *);
    void (*stepFinished)(fmi2ComponentEnvironment, fmiStatus);
    fmi2ComponentEnvironment componentEnvironment;
} fmi2CallbackFunctions;
typedef struct {
    fmi2Boolean newDiscreteStatesNeeded, terminateSimulation, nominalsOfContinuousStatesChanged;
    fmi2Boolean valuesOfContinuousStatesChanged, nextEventTimeDefined;
    fmi2Real nextEventTime;
} fmi2EventInfo;

/* The argument lists are the standard's: time, steps and tolerances do not matter. */
#pragma GCC diagnostic ignored "-Wunused-parameter"

typedef struct {
    unit unit;
    const fmi2CallbackFunctions *callbacks;
    char name[];
} instance;

static void log_message(void *environment, fmiStatus status, const char *category, const char *message)
{
    const instance *i = environment;
    if (i->callbacks->logger)
        i->callbacks->logger(i->callbacks->componentEnvironment, i->name, status, category, "%s", message);
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
    instance *i = callbacks && name ? calloc(1, sizeof *i + strlen(name) + 1) : NULL;
    if (i == NULL)
        return NULL;
    i->callbacks = callbacks;
    strcpy(i->name, name);
    i->unit.exchange = type == fmi2ModelExchange;
    i->unit.log = log_message;
    i->unit.environment = i;
    return instantiated(&i->unit, guid);
}

EXPORT void FMI(fmi2FreeInstance)(fmi2Component c)
{
    release(c);
}

EXPORT fmiStatus FMI(fmi2EnterInitializationMode)(fmi2Component c)
{
    return enter_initialization(c, "fmi2EnterInitializationMode");
}

EXPORT fmiStatus FMI(fmi2ExitInitializationMode)(fmi2Component c)
{
    return exit_initialization(c, "fmi2ExitInitializationMode");
}

#define MOVE(name, from, to)                                                                                           \
    EXPORT fmiStatus FMI(name)(fmi2Component c)                                                                        \
    {                                                                                                                  \
        return move(c, from, to, #name);                                                                               \
    }
MOVE(fmi2EnterEventMode, EVENT | CONTINUOUS_TIME, EVENT)
MOVE(fmi2EnterContinuousTimeMode, EVENT, CONTINUOUS_TIME)
MOVE(fmi2Terminate, EVENT | CONTINUOUS_TIME | STEP, TERMINATED)

EXPORT fmiStatus FMI(fmi2Reset)(fmi2Component c)
{
    return set_start(c);
}

EXPORT fmiStatus FMI(fmi2GetReal)(fmi2Component c, const fmi2ValueReference reference[], size_t n, fmi2Real value[])
{
    fmiStatus status = fmiOK;
    for (size_t i = 0; i < n && status == fmiOK; i++)
        status = get_one(c, reference[i], &value[i]);
    return status;
}

EXPORT fmiStatus FMI(fmi2SetReal)(fmi2Component c, const fmi2ValueReference reference[], size_t n,
                                  const fmi2Real value[])
{
    fmiStatus status = fmiOK;
    for (size_t i = 0; i < n && status == fmiOK; i++)
        status = set_one(c, reference[i], value[i]);
    return status;
}

EXPORT fmiStatus FMI(fmi2GetDirectionalDerivative)(fmi2Component c, const fmi2ValueReference unknown[],
                                                   size_t unknowns, const fmi2ValueReference known[], size_t knowns,
                                                   const fmi2Real seed[], fmi2Real value[])
{
    return directional_derivative(c, unknown, unknowns, known, knowns, seed, value);
}

EXPORT fmiStatus FMI(fmi2NewDiscreteStates)(fmi2Component c, fmi2EventInfo *info)
{
    memset(info, 0, sizeof *info);
    return called_in(c, EVENT, "fmi2NewDiscreteStates");
}

EXPORT fmiStatus FMI(fmi2CompletedIntegratorStep)(fmi2Component c, fmi2Boolean last, fmi2Boolean *event,
                                                  fmi2Boolean *terminate)
{
    *event = *terminate = 0;
    return completed(c, CONTINUOUS_TIME, "fmi2CompletedIntegratorStep");
}

EXPORT fmiStatus FMI(fmi2DoStep)(fmi2Component c, fmi2Real time, fmi2Real step, fmi2Boolean no_set_prior)
{
    return completed(c, STEP, "fmi2DoStep");
}

EXPORT fmiStatus FMI(fmi2GetFMUstate)(fmi2Component c, fmi2FMUstate *state)
{
    return save(c, state);
}

EXPORT fmiStatus FMI(fmi2SetFMUstate)(fmi2Component c, fmi2FMUstate state)
{
    return bring_back(c, state);
}

EXPORT fmiStatus FMI(fmi2FreeFMUstate)(fmi2Component c, fmi2FMUstate *state)
{
    return free_saved(state);
}

EXPORT fmiStatus FMI(fmi2SerializedFMUstateSize)(fmi2Component c, fmi2FMUstate state, size_t *size)
{
    *size = SAVED_BYTES;
    return fmiOK;
}

EXPORT fmiStatus FMI(fmi2SerializeFMUstate)(fmi2Component c, fmi2FMUstate state, fmi2Byte bytes[], size_t size)
{
    return write_saved(c, state, (unsigned char *)bytes, size);
}

EXPORT fmiStatus FMI(fmi2DeSerializeFMUstate)(fmi2Component c, const fmi2Byte bytes[], size_t size, fmi2FMUstate *state)
{
    return read_saved(c, (const unsigned char *)bytes, size, state);
}

/* ---- Nothing to do: there are no continuous states, no events, and time does not matter. ---- */

#define NOTHING(name, ...)                                                                                             \
    EXPORT fmiStatus FMI(name)(fmi2Component c, __VA_ARGS__)                                                           \
    {                                                                                                                  \
        return fmiOK;                                                                                                  \
    }
#define NONE(name, ...)                                                                                                \
    EXPORT fmiStatus FMI(name)(fmi2Component c, __VA_ARGS__)                                                           \
    {                                                                                                                  \
        return failed(c, fmiError, #name ": the unit has nothing of this kind");                                       \
    }
/* Arrays of what the unit has none of: fine if empty. */
#define EMPTY(name, n, ...)                                                                                            \
    EXPORT fmiStatus FMI(name)(fmi2Component c, __VA_ARGS__)                                                           \
    {                                                                                                                  \
        return n == 0 ? fmiOK : failed(c, fmiError, #name ": the unit has reals alone, no continuous states and no events");      \
    }

NOTHING(fmi2SetDebugLogging, fmi2Boolean on, size_t n, const fmi2String categories[])
NOTHING(fmi2SetupExperiment, fmi2Boolean tolerance_defined, fmi2Real tolerance, fmi2Real start,
        fmi2Boolean stop_defined, fmi2Real stop)
NOTHING(fmi2SetTime, fmi2Real time)
EMPTY(fmi2GetInteger, n, const fmi2ValueReference r[], size_t n, fmi2Integer v[])
EMPTY(fmi2GetBoolean, n, const fmi2ValueReference r[], size_t n, fmi2Boolean v[])
EMPTY(fmi2GetString, n, const fmi2ValueReference r[], size_t n, fmi2String v[])
EMPTY(fmi2SetInteger, n, const fmi2ValueReference r[], size_t n, const fmi2Integer v[])
EMPTY(fmi2SetBoolean, n, const fmi2ValueReference r[], size_t n, const fmi2Boolean v[])
EMPTY(fmi2SetString, n, const fmi2ValueReference r[], size_t n, const fmi2String v[])
EMPTY(fmi2SetContinuousStates, n, const fmi2Real x[], size_t n)
EMPTY(fmi2GetDerivatives, n, fmi2Real x[], size_t n)
EMPTY(fmi2GetEventIndicators, n, fmi2Real x[], size_t n)
EMPTY(fmi2GetContinuousStates, n, fmi2Real x[], size_t n)
EMPTY(fmi2GetNominalsOfContinuousStates, n, fmi2Real x[], size_t n)
NONE(fmi2SetRealInputDerivatives, const fmi2ValueReference r[], size_t n, const fmi2Integer order[],
     const fmi2Real value[])
NONE(fmi2GetRealOutputDerivatives, const fmi2ValueReference r[], size_t n, const fmi2Integer order[], fmi2Real value[])
NONE(fmi2GetStatus, int kind, fmiStatus *value)
NONE(fmi2GetRealStatus, int kind, fmi2Real *value)
NONE(fmi2GetIntegerStatus, int kind, fmi2Integer *value)
NONE(fmi2GetBooleanStatus, int kind, fmi2Boolean *value)
NONE(fmi2GetStringStatus, int kind, fmi2String *value)
MOVE(fmi2CancelStep, STEP, STEP)
