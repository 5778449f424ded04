/* FMI 2.0, co-simulation: every function of the interface; those that the model has no use for return Error. */
#include "hostile.h"

/* fmi2CallbackFunctions. */
struct callbacks {
    void (*logger)(void *, const char *, int, const char *, const char *, ...);
    void *(*allocate)(size_t, size_t);
    void (*release)(void *);
    void (*step_finished)(void *, int);
    void *environment;
};

EXPORT const char *fmi2GetTypesPlatform(void)
{
    return "default";
}

EXPORT const char *fmi2GetVersion(void)
{
    return "2.0";
}

EXPORT int fmi2SetDebugLogging(struct instance *c, int on, size_t count, const char *const categories[])
{
    (void)c, (void)on, (void)count, (void)categories;
    return OK;
}

EXPORT void *fmi2Instantiate(const char *name, int type, const char *guid, const char *resources,
                             const struct callbacks *callbacks, int visible, int logging)
{
    (void)name, (void)type, (void)guid, (void)resources, (void)visible, (void)logging;
    return new_instance(callbacks ? callbacks->environment : NULL, callbacks ? (void *)callbacks->logger : NULL, NULL);
}

EXPORT void fmi2FreeInstance(struct instance *c)
{
    free_instance(c);
}

EXPORT int fmi2SetupExperiment(struct instance *c, int with_tolerance, double tolerance, double start, int with_stop,
                               double stop)
{
    (void)with_tolerance, (void)tolerance, (void)with_stop, (void)stop;
    return setup(c, start);
}

EXPORT int fmi2EnterInitializationMode(struct instance *c)
{
    return plain_call(c, ENTER_INIT);
}

EXPORT int fmi2ExitInitializationMode(struct instance *c)
{
    return plain_call(c, EXIT_INIT);
}

EXPORT int fmi2Terminate(struct instance *c)
{
    return plain_call(c, TERMINATE);
}

EXPORT int fmi2Reset(struct instance *c)
{
    return reset(c);
}

EXPORT int fmi2GetReal(struct instance *c, const unsigned vr[], size_t count, double values[])
{
    return get_reals(c, vr, count, values);
}

EXPORT int fmi2SetReal(struct instance *c, const unsigned vr[], size_t count, const double values[])
{
    return set_reals(c, vr, count, values);
}

EXPORT int fmi2GetBoolean(struct instance *c, const unsigned vr[], size_t count, int values[])
{
    int status = plain_call(c, GET);
    for (size_t k = 0; k < count && !refuses(status); k++) {
        if (vr[k] != STOP)
            return ERROR;
        values[k] = c->now->stop != 0;
    }
    return status;
}

EXPORT int fmi2SetBoolean(struct instance *c, const unsigned vr[], size_t count, const int values[])
{
    int status = plain_call(c, SET);
    for (size_t k = 0; k < count && !refuses(status); k++) {
        if (vr[k] != STOP)
            return ERROR;
        c->now->stop = values[k] != 0;
    }
    return status;
}

EXPORT int fmi2GetFMUstate(struct instance *c, void **state)
{
    return save_call(c, state);
}

EXPORT int fmi2SetFMUstate(struct instance *c, void *state)
{
    return restore_call(c, state);
}

EXPORT int fmi2FreeFMUstate(struct instance *c, void **state)
{
    return free_state_call(c, state);
}

EXPORT int fmi2SerializedFMUstateSize(struct instance *c, void *state, size_t *size)
{
    return size_call(c, state, size);
}

EXPORT int fmi2SerializeFMUstate(struct instance *c, void *state, unsigned char bytes[], size_t size)
{
    return serialize_call(c, state, bytes, size);
}

EXPORT int fmi2DeSerializeFMUstate(struct instance *c, const unsigned char bytes[], size_t size, void **state)
{
    return deserialize_call(c, bytes, size, state);
}

EXPORT int fmi2DoStep(struct instance *c, double time, double step, int no_set_state_before)
{
    (void)no_set_state_before;
    return make_step(c, time, step);
}

/* fmi2LastSuccessfulTime is 2. */
EXPORT int fmi2GetRealStatus(struct instance *c, int kind, double *value)
{
    if (kind != 2)
        return DISCARD;
    *value = c->now->time;
    return OK;
}

#define NOT_HERE(name)                                                                                                 \
    EXPORT int name(struct instance *c)                                                                                \
    {                                                                                                                  \
        (void)c;                                                                                                       \
        return ERROR;                                                                                                  \
    }

NOT_HERE(fmi2GetInteger)
NOT_HERE(fmi2SetInteger)
NOT_HERE(fmi2GetString)
NOT_HERE(fmi2SetString)
NOT_HERE(fmi2GetDirectionalDerivative)
NOT_HERE(fmi2SetRealInputDerivatives)
NOT_HERE(fmi2GetRealOutputDerivatives)
NOT_HERE(fmi2CancelStep)
NOT_HERE(fmi2GetStatus)
NOT_HERE(fmi2GetIntegerStatus)
NOT_HERE(fmi2GetBooleanStatus)
NOT_HERE(fmi2GetStringStatus)
