/* The functions of FMI 3.0, for model exchange and co-simulation. asperity_unit.h has what they do. */

#include <stdbool.h>
#include <stdint.h>

#ifdef FMI3_FUNCTION_PREFIX
#define FMI_PREFIX FMI3_FUNCTION_PREFIX
#endif
#include "asperity_unit.h"
#include "asperity_unit_saved.h"

/* The argument lists are the standard's: steps and tolerances do not matter. */
#pragma GCC diagnostic ignored "-Wunused-parameter"

/* Of fmi3PlatformTypes.h and fmi3FunctionTypes.h of the standard (version 3.0), as far as it is used here. */
typedef void *fmi3Instance;
typedef uint32_t reference;

/* Beside the unit, FMI 3.0 wants the time as a variable. */
enum { TIME = PARAMETERS + PARAMETER_COUNT };

typedef void log_message(void *environment, fmiStatus, const char *category, const char *message);

static unit *new_instance(int exchange, const char *token, void *environment, log_message *log)
{
    unit *u = calloc(1, sizeof *u);
    if (u == NULL)
        return NULL;
    u->exchange = exchange;
    u->log = log;
    u->environment = environment;
    return instantiated(u, token);
}

EXPORT const char *FMI(fmi3GetVersion)(void)
{
    return "3.0";
}

EXPORT fmi3Instance FMI(fmi3InstantiateModelExchange)(const char *name, const char *token, const char *resources,
                                                      bool visible, bool logging, void *environment, log_message *log)
{
    return new_instance(1, token, environment, log);
}

EXPORT fmi3Instance FMI(fmi3InstantiateCoSimulation)(const char *name, const char *token, const char *resources,
                                                     bool visible, bool logging, bool event_mode, bool early_return,
                                                     const reference intermediate[], size_t intermediates,
                                                     void *environment, log_message *log, void (*update)(void))
{
    if (!event_mode && intermediates == 0)
        return new_instance(0, token, environment, log);
    if (log)
        log(environment, fmiError, "logStatusError", "the unit has no event mode and no intermediate variables");
    return NULL;
}

EXPORT fmi3Instance FMI(fmi3InstantiateScheduledExecution)(const char *name, const char *token, const char *resources,
                                                           bool visible, bool logging, void *environment,
                                                           log_message *log, void (*update)(void *),
                                                           void (*lock)(void), void (*unlock)(void))
{
    if (log)
        log(environment, fmiError, "logStatusError", "the unit is for model exchange and co-simulation");
    return NULL;
}

EXPORT void FMI(fmi3FreeInstance)(fmi3Instance c)
{
    release(c);
}

EXPORT fmiStatus FMI(fmi3EnterInitializationMode)(fmi3Instance c, bool tolerance_defined, double tolerance,
                                                  double start, bool stop_defined, double stop)
{
    ((unit *)c)->state.time = start;
    return enter_initialization(c, "fmi3EnterInitializationMode");
}

EXPORT fmiStatus FMI(fmi3ExitInitializationMode)(fmi3Instance c)
{
    return exit_initialization(c, "fmi3ExitInitializationMode");
}

#define MOVE(name, from, to)                                                                                           \
    EXPORT fmiStatus FMI(name)(fmi3Instance c)                                                                         \
    {                                                                                                                  \
        return move(c, from, to, #name);                                                                               \
    }
MOVE(fmi3EnterEventMode, CONTINUOUS_TIME, EVENT)
MOVE(fmi3EvaluateDiscreteStates, INITIALIZATION | EVENT, ((unit *)c)->state.mode)
MOVE(fmi3EnterContinuousTimeMode, EVENT, CONTINUOUS_TIME)
MOVE(fmi3Terminate, EVENT | CONTINUOUS_TIME | STEP, TERMINATED)

EXPORT fmiStatus FMI(fmi3Reset)(fmi3Instance c)
{
    return set_start(c);
}

static fmiStatus count_is(const unit *u, size_t count, size_t wanted)
{
    return count == wanted ? fmiOK : failed(u, fmiError, "each variable has one value: the arrays differ in length");
}

EXPORT fmiStatus FMI(fmi3GetFloat64)(fmi3Instance c, const reference r[], size_t n, double value[], size_t values)
{
    fmiStatus status = count_is(c, values, n);
    for (size_t i = 0; i < n && status == fmiOK; i++)
        if (r[i] == TIME)
            value[i] = ((unit *)c)->state.time;
        else
            status = get_one(c, r[i], &value[i]);
    return status;
}

EXPORT fmiStatus FMI(fmi3SetFloat64)(fmi3Instance c, const reference r[], size_t n, const double value[], size_t values)
{
    fmiStatus status = count_is(c, values, n);
    for (size_t i = 0; i < n && status == fmiOK; i++)
        status = set_one(c, r[i], value[i]);
    return status;
}

EXPORT fmiStatus FMI(fmi3GetDirectionalDerivative)(fmi3Instance c, const reference unknown[], size_t unknowns,
                                                   const reference known[], size_t knowns, const double seed[],
                                                   size_t seeds, double value[], size_t values)
{
    if (count_is(c, seeds, knowns) != fmiOK || count_is(c, values, unknowns) != fmiOK)
        return fmiError;
    return directional_derivative(c, unknown, unknowns, known, knowns, seed, value);
}

EXPORT fmiStatus FMI(fmi3UpdateDiscreteStates)(fmi3Instance c, bool *update, bool *terminate, bool *nominals,
                                               bool *states, bool *time_defined, double *time)
{
    *update = *terminate = *nominals = *states = *time_defined = false;
    *time = 0;
    return called_in(c, EVENT, "fmi3UpdateDiscreteStates");
}

EXPORT fmiStatus FMI(fmi3CompletedIntegratorStep)(fmi3Instance c, bool no_set_prior, bool *event, bool *terminate)
{
    *event = *terminate = false;
    return completed(c, CONTINUOUS_TIME, "fmi3CompletedIntegratorStep");
}

EXPORT fmiStatus FMI(fmi3SetTime)(fmi3Instance c, double time)
{
    ((unit *)c)->state.time = time;
    return called_in(c, EVENT | CONTINUOUS_TIME, "fmi3SetTime");
}

EXPORT fmiStatus FMI(fmi3DoStep)(fmi3Instance c, double time, double step, bool no_set_prior, bool *event,
                                 bool *terminate, bool *early, double *reached)
{
    *event = *terminate = *early = false;
    *reached = time;
    const fmiStatus status = completed(c, STEP, "fmi3DoStep");
    if (status == fmiOK)
        ((unit *)c)->state.time = *reached = time + step;
    return status;
}

EXPORT fmiStatus FMI(fmi3GetFMUState)(fmi3Instance c, void **state)
{
    return save(c, state);
}

EXPORT fmiStatus FMI(fmi3SetFMUState)(fmi3Instance c, void *state)
{
    return bring_back(c, state);
}

EXPORT fmiStatus FMI(fmi3FreeFMUState)(fmi3Instance c, void **state)
{
    return free_saved(state);
}

EXPORT fmiStatus FMI(fmi3SerializedFMUStateSize)(fmi3Instance c, void *state, size_t *size)
{
    *size = SAVED_BYTES;
    return fmiOK;
}

EXPORT fmiStatus FMI(fmi3SerializeFMUState)(fmi3Instance c, void *state, uint8_t bytes[], size_t size)
{
    return write_saved(c, state, bytes, size);
}

EXPORT fmiStatus FMI(fmi3DeserializeFMUState)(fmi3Instance c, const uint8_t bytes[], size_t size, void **state)
{
    return read_saved(c, bytes, size, state);
}

/* ---- Nothing to do: there are no continuous states and no events. ---- */

EXPORT fmiStatus FMI(fmi3SetDebugLogging)(fmi3Instance c, bool on, size_t n, const char *const categories[])
{
    return fmiOK;
}

#define ZERO(name)                                                                                                     \
    EXPORT fmiStatus FMI(name)(fmi3Instance c, size_t *n)                                                              \
    {                                                                                                                  \
        *n = 0;                                                                                                        \
        return fmiOK;                                                                                                  \
    }
#define NONE(name, ...)                                                                                                \
    EXPORT fmiStatus FMI(name)(__VA_ARGS__)                                                                            \
    {                                                                                                                  \
        return failed(c, fmiError, #name ": the unit has nothing of this kind");                                       \
    }
/* Arrays of what the unit has none of: fine if empty. */
#define EMPTY(name, ...)                                                                                               \
    EXPORT fmiStatus FMI(name)(fmi3Instance c, __VA_ARGS__)                                                            \
    {                                                                                                                  \
        return n == 0 ? fmiOK : failed(c, fmiError, #name ": the unit has Float64 alone, no continuous states and no events");    \
    }
#define TYPE(name, type)                                                                                               \
    EMPTY(fmi3Get##name, const reference r[], size_t n, type v[], size_t values)                                       \
    EMPTY(fmi3Set##name, const reference r[], size_t n, const type v[], size_t values)

typedef const char *text;
typedef const uint8_t *binary;
TYPE(Float32, float)
TYPE(Int8, int8_t)
TYPE(UInt8, uint8_t)
TYPE(Int16, int16_t)
TYPE(UInt16, uint16_t)
TYPE(Int32, int32_t)
TYPE(UInt32, uint32_t)
TYPE(Int64, int64_t)
TYPE(UInt64, uint64_t)
TYPE(Boolean, bool)
TYPE(String, text)
EMPTY(fmi3GetBinary, const reference r[], size_t n, size_t sizes[], binary v[], size_t values)
EMPTY(fmi3SetBinary, const reference r[], size_t n, const size_t sizes[], const binary v[], size_t values)
EMPTY(fmi3GetClock, const reference r[], size_t n, bool v[])
EMPTY(fmi3SetClock, const reference r[], size_t n, const bool v[])
EMPTY(fmi3GetIntervalDecimal, const reference r[], size_t n, double v[], int qualifiers[])
EMPTY(fmi3GetIntervalFraction, const reference r[], size_t n, uint64_t counters[], uint64_t resolutions[], int qualifiers[])
EMPTY(fmi3GetShiftDecimal, const reference r[], size_t n, double v[])
EMPTY(fmi3GetShiftFraction, const reference r[], size_t n, uint64_t counters[], uint64_t resolutions[])
EMPTY(fmi3SetIntervalDecimal, const reference r[], size_t n, const double v[])
EMPTY(fmi3SetIntervalFraction, const reference r[], size_t n, const uint64_t counters[], const uint64_t resolutions[])
EMPTY(fmi3SetShiftDecimal, const reference r[], size_t n, const double v[])
EMPTY(fmi3SetShiftFraction, const reference r[], size_t n, const uint64_t counters[], const uint64_t resolutions[])
EMPTY(fmi3SetContinuousStates, const double x[], size_t n)
EMPTY(fmi3GetContinuousStateDerivatives, double x[], size_t n)
EMPTY(fmi3GetEventIndicators, double x[], size_t n)
EMPTY(fmi3GetContinuousStates, double x[], size_t n)
EMPTY(fmi3GetNominalsOfContinuousStates, double x[], size_t n)
EMPTY(fmi3GetOutputDerivatives, const reference r[], size_t n, const int32_t orders[], double v[], size_t values)
ZERO(fmi3GetNumberOfEventIndicators)
ZERO(fmi3GetNumberOfContinuousStates)
NONE(fmi3GetNumberOfVariableDependencies, fmi3Instance c, reference r, size_t *n)
NONE(fmi3GetVariableDependencies, fmi3Instance c, reference r, size_t elements[], reference known[],
     size_t known_elements[], int kinds[], size_t n)
NONE(fmi3GetAdjointDerivative, fmi3Instance c, const reference unknown[], size_t unknowns, const reference known[],
     size_t knowns, const double seed[], size_t seeds, double value[], size_t values)
NONE(fmi3EnterConfigurationMode, fmi3Instance c)
NONE(fmi3ExitConfigurationMode, fmi3Instance c)
NONE(fmi3EnterStepMode, fmi3Instance c)
NONE(fmi3ActivateModelPartition, fmi3Instance c, reference clock, double time)
