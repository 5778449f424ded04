/* What both versions of FMI have in common: the life of an instance and its calls, each with its deeds first. */
#include "hostile.h"

#include <stdlib.h>
#include <string.h>

/* Behaviours shared-instances and global-state: the one state of all instances. */
static struct state global;
static bool global_is_set;
/* Behaviours single-instance and once-per-process. */
static int made, living;

struct instance *new_instance(void *environment, void *log2, void *log3)
{
    if ((asked_for("single-instance") && living > 0) || (asked_for("once-per-process") && made > 0))
        return NULL;
    struct instance *instance = calloc(1, sizeof *instance);
    if (!instance)
        return NULL;
    instance->environment = environment;
    instance->log2 = (void (*)(void *, const char *, int, const char *, const char *, ...))log2;
    instance->log3 = (void (*)(void *, int, const char *, const char *))log3;
    bool keeps = asked_for("global-state");
    instance->now = keeps || asked_for("shared-instances") ? &global : &instance->own;
    const struct deed *big = asked_for("big-state");
    if (big) {
        instance->history_length = (size_t)(big->size > 1024 ? big->size : 10 << 20) / sizeof(double);
        instance->history = malloc(instance->history_length * sizeof(double));
    }
    if (!keeps || !global_is_set)
        start_values(instance);
    global_is_set |= keeps;
    if (refuses(strike(instance, INSTANTIATE))) {
        free(instance->history);
        free(instance);
        return NULL;
    }
    made++;
    living++;
    return instance;
}

void free_instance(struct instance *instance)
{
    if (!instance)
        return;
    strike(instance, FREE_INSTANCE);
    stop_chatter(instance);
    if (instance->block) {
        /* Whoever still points here shall see that it is over. */
        memset(instance->block, 0x41, sizeof *instance->block);
        free(instance->block);
    }
    free(instance->history);
    free(instance);
    living--;
}

int plain_call(struct instance *instance, enum place place)
{
    return strike(instance, place);
}

int setup(struct instance *instance, double start)
{
    int status = strike(instance, SETUP);
    if (!refuses(status))
        instance->now->time = start;
    return status;
}

int make_step(struct instance *instance, double time, double step)
{
    instance->now->stopped_ms = instance->now->stop ? instance->now->stopped_ms + (int64_t)(step * 1000 + 0.5) : 0;
    int status = strike(instance, STEP);
    if (refuses(status))
        return status;
    if (asked_for("thread-needed"))
        ask_thread();
    int made_it = advance(instance, time, step);
    return made_it == OK ? status : made_it;
}

int get_reals(struct instance *instance, const unsigned *references, size_t count, double *values)
{
    int status = strike(instance, GET);
    for (size_t k = 0; k < count && !refuses(status); k++)
        if (!get_real(instance, references[k], &values[k]))
            return ERROR;
    return status;
}

int set_reals(struct instance *instance, const unsigned *references, size_t count, const double *values)
{
    int status = strike(instance, SET);
    for (size_t k = 0; k < count && !refuses(status); k++)
        if (!set_real(instance, references[k], values[k]))
            return ERROR;
    return status;
}

int reset(struct instance *instance)
{
    int status = strike(instance, RESET);
    if (refuses(status))
        return status;
    if (asked_for("reset-refused"))
        return ERROR;
    if (!asked_for("reset-noop"))
        start_values(instance);
    return status;
}

int save_call(struct instance *instance, void **state)
{
    int status = strike(instance, SAVE);
    if (refuses(status))
        return status;
    int result = save(instance, state);
    return result == OK ? status : result;
}

int restore_call(struct instance *instance, void *state)
{
    int status = strike(instance, RESTORE);
    if (refuses(status))
        return status;
    int result = restore(instance, state);
    return result == OK ? status : result;
}

int free_state_call(struct instance *instance, void **state)
{
    int status = strike(instance, FREE_STATE);
    if (state && !refuses(status))
        free_saved(state);
    return status;
}

int size_call(struct instance *instance, void *state, size_t *size)
{
    (void)state;
    const struct deed *lie = asked_for("state-size");
    *size = lie ? (size_t)lie->size : saved_size(instance);
    return OK;
}

int serialize_call(struct instance *instance, void *state, unsigned char *bytes, size_t size)
{
    int status = strike(instance, SERIALIZE);
    if (refuses(status))
        return status;
    if (!state || size < saved_size(instance))
        return ERROR;
    serialize(instance, state, bytes);
    return status;
}

int deserialize_call(struct instance *instance, const unsigned char *bytes, size_t size, void **state)
{
    int status = strike(instance, DESERIALIZE);
    if (refuses(status))
        return status;
    if (size < saved_size(instance))
        return ERROR;
    int result = deserialize(instance, bytes, state);
    return result == OK ? status : result;
}
