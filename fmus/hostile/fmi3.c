/* FMI 3.0, co-simulation: every function of the interface; those that the model has no use for return Error. */
#include "hostile.h"

EXPORT const char *fmi3GetVersion(void)
{
    return "3.0";
}

EXPORT int fmi3SetDebugLogging(struct instance *c, bool on, size_t count, const char *const categories[])
{
    (void)c, (void)on, (void)count, (void)categories;
    return OK;
}

EXPORT void *fmi3InstantiateCoSimulation(const char *name, const char *token, const char *resources, bool visible,
                                         bool logging, bool event_mode, bool early_return, const unsigned required[],
                                         size_t required_count, void *environment, void *log, void *intermediate)
{
    (void)name, (void)token, (void)resources, (void)visible, (void)logging, (void)event_mode, (void)early_return;
    (void)required, (void)required_count, (void)intermediate;
    return new_instance(environment, NULL, log);
}

EXPORT void fmi3FreeInstance(struct instance *c)
{
    free_instance(c);
}

/* What FMI 2.0 sets up in a call of its own comes with this one. */
EXPORT int fmi3EnterInitializationMode(struct instance *c, bool with_tolerance, double tolerance, double start,
                                       bool with_stop, double stop)
{
    (void)with_tolerance, (void)tolerance, (void)with_stop, (void)stop;
    int status = setup(c, start);
    if (refuses(status))
        return status;
    int entered = plain_call(c, ENTER_INIT);
    return entered == OK ? status : entered;
}

EXPORT int fmi3ExitInitializationMode(struct instance *c)
{
    return plain_call(c, EXIT_INIT);
}

EXPORT int fmi3Terminate(struct instance *c)
{
    return plain_call(c, TERMINATE);
}

EXPORT int fmi3Reset(struct instance *c)
{
    return reset(c);
}

EXPORT int fmi3GetFloat64(struct instance *c, const unsigned vr[], size_t count, double values[], size_t room)
{
    return count == room ? get_reals(c, vr, count, values) : ERROR;
}

EXPORT int fmi3SetFloat64(struct instance *c, const unsigned vr[], size_t count, const double values[], size_t given)
{
    return count == given ? set_reals(c, vr, count, values) : ERROR;
}

EXPORT int fmi3GetBoolean(struct instance *c, const unsigned vr[], size_t count, bool values[], size_t room)
{
    int status = plain_call(c, GET);
    for (size_t k = 0; k < count && !refuses(status); k++) {
        if (vr[k] != STOP || count != room)
            return ERROR;
        values[k] = c->now->stop != 0;
    }
    return status;
}

EXPORT int fmi3SetBoolean(struct instance *c, const unsigned vr[], size_t count, const bool values[], size_t given)
{
    int status = plain_call(c, SET);
    for (size_t k = 0; k < count && !refuses(status); k++) {
        if (vr[k] != STOP || count != given)
            return ERROR;
        c->now->stop = values[k];
    }
    return status;
}

EXPORT int fmi3GetFMUState(struct instance *c, void **state)
{
    return save_call(c, state);
}

EXPORT int fmi3SetFMUState(struct instance *c, void *state)
{
    return restore_call(c, state);
}

EXPORT int fmi3FreeFMUState(struct instance *c, void **state)
{
    return free_state_call(c, state);
}

EXPORT int fmi3SerializedFMUStateSize(struct instance *c, void *state, size_t *size)
{
    return size_call(c, state, size);
}

EXPORT int fmi3SerializeFMUState(struct instance *c, void *state, unsigned char bytes[], size_t size)
{
    return serialize_call(c, state, bytes, size);
}

EXPORT int fmi3DeserializeFMUState(struct instance *c, const unsigned char bytes[], size_t size, void **state)
{
    return deserialize_call(c, bytes, size, state);
}

EXPORT int fmi3DoStep(struct instance *c, double time, double step, bool no_set_state_before, bool *event,
                      bool *terminate, bool *early_return, double *last_time)
{
    (void)no_set_state_before;
    *event = *terminate = *early_return = false;
    *last_time = time;
    int status = make_step(c, time, step);
    if (!refuses(status))
        *last_time = time + step;
    return status;
}

#define NOT_HERE(name)                                                                                                 \
    EXPORT int name(struct instance *c)                                                                                \
    {                                                                                                                  \
        (void)c;                                                                                                       \
        return ERROR;                                                                                                  \
    }

/* Other kinds of instances: there are none. */
EXPORT void *fmi3InstantiateModelExchange(void)
{
    return NULL;
}

EXPORT void *fmi3InstantiateScheduledExecution(void)
{
    return NULL;
}

NOT_HERE(fmi3ActivateModelPartition)
NOT_HERE(fmi3CompletedIntegratorStep)
NOT_HERE(fmi3EnterConfigurationMode)
NOT_HERE(fmi3EnterContinuousTimeMode)
NOT_HERE(fmi3EnterEventMode)
NOT_HERE(fmi3EnterStepMode)
NOT_HERE(fmi3EvaluateDiscreteStates)
NOT_HERE(fmi3ExitConfigurationMode)
NOT_HERE(fmi3GetAdjointDerivative)
NOT_HERE(fmi3GetBinary)
NOT_HERE(fmi3GetClock)
NOT_HERE(fmi3GetContinuousStateDerivatives)
NOT_HERE(fmi3GetContinuousStates)
NOT_HERE(fmi3GetDirectionalDerivative)
NOT_HERE(fmi3GetEventIndicators)
NOT_HERE(fmi3GetFloat32)
NOT_HERE(fmi3GetInt16)
NOT_HERE(fmi3GetInt32)
NOT_HERE(fmi3GetInt64)
NOT_HERE(fmi3GetInt8)
NOT_HERE(fmi3GetIntervalDecimal)
NOT_HERE(fmi3GetIntervalFraction)
NOT_HERE(fmi3GetNominalsOfContinuousStates)
NOT_HERE(fmi3GetNumberOfContinuousStates)
NOT_HERE(fmi3GetNumberOfEventIndicators)
NOT_HERE(fmi3GetNumberOfVariableDependencies)
NOT_HERE(fmi3GetOutputDerivatives)
NOT_HERE(fmi3GetShiftDecimal)
NOT_HERE(fmi3GetShiftFraction)
NOT_HERE(fmi3GetString)
NOT_HERE(fmi3GetUInt16)
NOT_HERE(fmi3GetUInt32)
NOT_HERE(fmi3GetUInt64)
NOT_HERE(fmi3GetUInt8)
NOT_HERE(fmi3GetVariableDependencies)
NOT_HERE(fmi3SetBinary)
NOT_HERE(fmi3SetClock)
NOT_HERE(fmi3SetContinuousStates)
NOT_HERE(fmi3SetFloat32)
NOT_HERE(fmi3SetInt16)
NOT_HERE(fmi3SetInt32)
NOT_HERE(fmi3SetInt64)
NOT_HERE(fmi3SetInt8)
NOT_HERE(fmi3SetIntervalDecimal)
NOT_HERE(fmi3SetIntervalFraction)
NOT_HERE(fmi3SetShiftDecimal)
NOT_HERE(fmi3SetShiftFraction)
NOT_HERE(fmi3SetString)
NOT_HERE(fmi3SetTime)
NOT_HERE(fmi3SetUInt16)
NOT_HERE(fmi3SetUInt32)
NOT_HERE(fmi3SetUInt64)
NOT_HERE(fmi3SetUInt8)
NOT_HERE(fmi3UpdateDiscreteStates)
