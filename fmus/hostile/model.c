/* The honest model, a slowly turning joint whose speed also depends on a hidden clock, and its saved states; and the
 * faults that lie in the numbers and in the states. */
#define _GNU_SOURCE
#include "hostile.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

/* Speed at full pace, rad/s; change of it, rad/s^2; period of the clock, ms: up to 20 % faster in its middle. */
static const double SPEED = 0.5, ACCELERATION = 1.0;
static const int64_t PERIOD = 700;
/* Places of the history that are in use, far apart. */
static const size_t SLOTS = 16;

/* Behaviour forgets-rng: belongs to the process, not to a state. */
static uint64_t random_state = 88172645463325252ULL;
/* Behaviour state-shared: the one buffer. */
static struct saved *shared_buffer;

void start_values(struct instance *instance)
{
    *instance->now = (struct state){.qd = SPEED, .drive = SPEED, .shown = shown_early};
    instance->frozen_until = -1;
    for (size_t k = 0; k < instance->history_length; k++)
        instance->history[k] = 1e-9 * (double)k;
}

static void millisecond(struct state *now)
{
    double target = now->stop ? 0 : SPEED, change = ACCELERATION * 1e-3, difference = target - now->drive;
    now->drive += difference > change ? change : difference < -change ? -change : difference;
    int64_t phase = now->clock % PERIOD;
    int64_t triangle = phase < PERIOD - phase ? phase : PERIOD - phase;
    double swell = 1 + 0.2 * (double)triangle / ((double)PERIOD / 2);
    now->qd = now->drive * swell + now->push;
    now->q += now->qd * 1e-3;
    now->clock++;
}

int advance(struct instance *instance, double time, double step)
{
    struct state *now = instance->now;
    long ticks = lround(step * 1e3);
    if (ticks < 1 || fabs(step * 1e3 - (double)ticks) > 1e-6)
        return DISCARD;
    if (time + step / 2 < instance->frozen_until) {
        now->time = time + step;
        return OK;
    }
    for (long k = 0; k < ticks; k++)
        millisecond(now);
    if (asked_for("forgets-rng")) {
        random_state ^= random_state << 13;
        random_state ^= random_state >> 7;
        random_state ^= random_state << 17;
        now->q += 1e-6 * (double)(random_state % 1000);
    }
    if (instance->history_length) {
        /* What was written here some steps ago moves the joint a little. */
        double *slot = &instance->history[(size_t)now->steps % SLOTS * (instance->history_length / SLOTS)];
        now->q += 1e-6 * *slot;
        *slot = now->q;
    }
    now->steps++;
    now->time = time + step;
    return OK;
}

bool get_real(const struct instance *instance, unsigned reference, double *value)
{
    const struct state *now = instance->now;
    const struct deed *deed;
    switch (reference) {
    case TIME:
        *value = now->time;
        return true;
    case PUSH:
        *value = now->push;
        return true;
    case Q:
        *value = now->q;
        if ((deed = asked_for("nan")) && has_begun(deed, now))
            *value = NAN;
        if ((deed = asked_for("infinity")) && has_begun(deed, now))
            *value = INFINITY;
        if (asked_for("clock-time")) {
            struct timespec clock;
            clock_gettime(CLOCK_REALTIME, &clock);
            *value += 1e-12 * (double)clock.tv_nsec;
        }
        return true;
    case QD:
        *value = now->shown ? (double)(now->shown - 1) : now->qd;
        return true;
    default:
        return false;
    }
}

bool set_real(struct instance *instance, unsigned reference, double value)
{
    if (reference == PUSH)
        instance->now->push = value;
    return reference == PUSH;
}

size_t saved_size(const struct instance *instance)
{
    return sizeof(struct saved) + instance->history_length * sizeof(double);
}

int save(struct instance *instance, void **state)
{
    if (asked_for("state-null")) {
        *state = NULL;
        return OK;
    }
    struct saved *saved = *state;
    if (asked_for("state-shared")) {
        if (!shared_buffer)
            shared_buffer = malloc(saved_size(instance));
        saved = shared_buffer;
    }
    if (!saved)
        saved = malloc(saved_size(instance));
    if (!saved)
        return ERROR;
    saved->state = *instance->now;
    if (instance->history_length)
        memcpy(saved->history, instance->history, instance->history_length * sizeof(double));
    *state = saved;
    return OK;
}

int restore(struct instance *instance, const struct saved *state)
{
    if (asked_for("state-noop"))
        return OK;
    if (!state)
        return ERROR;
    int64_t clock = instance->now->clock;
    double time = instance->now->time;
    *instance->now = state->state;
    if (instance->history_length)
        memcpy(instance->history, state->history, instance->history_length * sizeof(double));
    if (asked_for("state-forgets-clock"))
        instance->now->clock = clock;
    if (asked_for("state-freeze"))
        instance->frozen_until = time;
    return OK;
}

void free_saved(void **state)
{
    if (*state != shared_buffer)
        free(*state);
    *state = NULL;
}

void serialize(struct instance *instance, const struct saved *state, unsigned char *bytes)
{
    if (asked_for("state-pointer")) {
        if (!instance->block)
            instance->block = malloc(sizeof *instance->block);
        *instance->block = state->state;
        memset(bytes, 0, saved_size(instance));
        memcpy(bytes, &instance->block, sizeof instance->block);
        return;
    }
    memcpy(bytes, state, saved_size(instance));
}

int deserialize(struct instance *instance, const unsigned char *bytes, void **state)
{
    struct saved *saved = malloc(saved_size(instance));
    if (!saved)
        return ERROR;
    memcpy(saved, bytes, saved_size(instance));
    if (asked_for("state-pointer")) {
        const struct state *block;
        memcpy(&block, bytes, sizeof block);
        saved->state = *block;
    }
    *state = saved;
    return OK;
}
