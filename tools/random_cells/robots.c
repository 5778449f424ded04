/* Two robots of one axis each that swing, and stop while a sensor says so: an FMU for FMI 2.0 and 3.0, written for the random cells.
 *
 * It shares nothing with the example FMUs. Time goes in whole milliseconds, progress along the programme in thousandths of
 * them and the override in thousandths, so that equal states are equal bytes and steps may be cut as one likes.
 *
 *   q = middle + swing sin(2 pi (progress / period) + begin)      for each axis, rad or m as the cell file reads it
 *
 * A robot heeds the inputs of its mask (1: s1, 2: s2, 4: s3). Where one of them is false a stop is wanted: for ever if it is latched, else until
 * all have been true for restart_ms. After reaction_ms of that the override goes to nothing in ramp_ms, and back in the same time.
 * While an input of the mask mutes is false, s1 is not heeded, for mute_ms at most. For deaf_ms from a restart no input is heeded,
 * and for ever after so many stops as hears says, unless it is 0. */
#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#ifdef SLEEP_US
#include <unistd.h>
#endif

#define EXPORT __attribute__((visibility("default")))
#define OK 0
#define ERROR 3
#define ROBOTS 2
#define SENSORS 3
#define TWO_PI 6.283185307179586
#define FULL 1000

/* Value references. Reals: 10 R + 0 middle, 1 swing, 2 begin; outputs 10 R + 5 q, 6 qd. Integers: 100 + 10 R + 0 period_ms,
 * 1 reaction_ms, 2 ramp_ms, 3 restart_ms, 4 heeds, 5 mutes, 6 mute_ms, 7 deaf_ms, 8 hears. Booleans: 200 + S sensor,
 * 210 + R latched. 999 is the time. */
struct parameters {
    double middle[ROBOTS], swing[ROBOTS], begin[ROBOTS];
    int period_ms[ROBOTS], reaction_ms[ROBOTS], ramp_ms[ROBOTS], restart_ms[ROBOTS], heeds[ROBOTS], latched[ROBOTS];
    int mutes[ROBOTS], mute_ms[ROBOTS], deaf_ms[ROBOTS], hears[ROBOTS];
};

/* All that changes. */
struct state {
    int ms, clear[SENSORS];
    int progress[ROBOTS], override[ROBOTS], wanted_ms[ROBOTS], free_ms[ROBOTS], tripped[ROBOTS];
    int muted_ms[ROBOTS], deaf_ms[ROBOTS], stops[ROBOTS];
};

struct instance {
    struct parameters is;
    struct state now;
};

static struct instance *fresh(void)
{
    struct instance *c = calloc(1, sizeof *c);
    if (!c)
        return NULL;
    for (int r = 0; r < ROBOTS; r++) {
        c->is.period_ms[r] = 1000;
        c->is.reaction_ms[r] = 100;
        c->is.ramp_ms[r] = 100;
        c->now.override[r] = FULL;
    }
    for (int s = 0; s < SENSORS; s++)
        c->now.clear[s] = 1;
    return c;
}

/* One millisecond of one robot. */
static void tick(struct instance *c, int r)
{
    const struct parameters *is = &c->is;
    struct state *now = &c->now;
    bool seen = false, mutes = false;
    for (int s = 0; s < SENSORS; s++)
        mutes |= (is->mutes[r] >> s & 1) && !now->clear[s];
    now->muted_ms[r] = !mutes ? 0 : now->muted_ms[r] < is->mute_ms[r] ? now->muted_ms[r] + 1 : is->mute_ms[r];
    mutes = mutes && now->muted_ms[r] < is->mute_ms[r];
    for (int s = 0; s < SENSORS; s++)
        seen |= (is->heeds[r] >> s & 1) && !now->clear[s] && !(s == 0 && mutes);
    if (now->deaf_ms[r] > 0) {
        now->deaf_ms[r]--;
        seen = false;
    }
    if (is->hears[r] > 0 && seen && !now->tripped[r]) {
        seen = now->stops[r] < is->hears[r];
        now->stops[r] += seen;
    }
    now->free_ms[r] = seen ? 0 : now->free_ms[r] < is->restart_ms[r] ? now->free_ms[r] + 1 : is->restart_ms[r];
    if (seen)
        now->tripped[r] = 1;
    else if (now->tripped[r] && !is->latched[r] && now->free_ms[r] >= is->restart_ms[r]) {
        now->tripped[r] = 0;
        now->deaf_ms[r] = is->deaf_ms[r];
    }
    if (!now->tripped[r])
        now->wanted_ms[r] = 0;
    else if (now->wanted_ms[r] < is->reaction_ms[r])
        now->wanted_ms[r]++;
    bool stops = now->tripped[r] && now->wanted_ms[r] >= is->reaction_ms[r];
    int by = is->ramp_ms[r] > 0 ? (FULL + is->ramp_ms[r] - 1) / is->ramp_ms[r] : FULL;
    int override = now->override[r] + (stops ? -by : by);
    now->override[r] = override < 0 ? 0 : override > FULL ? FULL : override;
    now->progress[r] = (now->progress[r] + now->override[r]) % (is->period_ms[r] * FULL);
}

static double angle(const struct instance *c, int r)
{
    return TWO_PI * c->now.progress[r] / ((double)c->is.period_ms[r] * FULL) + c->is.begin[r];
}

static int step(struct instance *c, double length)
{
    double whole = floor(length * 1000 + 0.5);
    if (fabs(whole - length * 1000) > 1e-6 || whole < 1)
        return ERROR;
#ifdef SLEEP_US
    usleep(SLEEP_US);
#endif
    for (int ms = 0; ms < (int)whole; ms++) {
        for (int r = 0; r < ROBOTS; r++)
            tick(c, r);
        c->now.ms++;
    }
    return OK;
}

static int get_real(const struct instance *c, unsigned vr, double *value)
{
    int r = (int)(vr / 10);
    if (vr == 999) {
        *value = c->now.ms / 1000.0;
        return OK;
    }
    if (r >= ROBOTS)
        return ERROR;
    double rate = TWO_PI * c->now.override[r] / FULL / (c->is.period_ms[r] / 1000.0);
    switch (vr % 10) {
    case 0: *value = c->is.middle[r]; return OK;
    case 1: *value = c->is.swing[r]; return OK;
    case 2: *value = c->is.begin[r]; return OK;
    case 5: *value = c->is.middle[r] + c->is.swing[r] * sin(angle(c, r)); return OK;
    case 6: *value = c->is.swing[r] * cos(angle(c, r)) * rate; return OK;
    }
    return ERROR;
}

static int set_real(struct instance *c, unsigned vr, double value)
{
    if (vr / 10 >= ROBOTS)
        return ERROR;
    double *of[] = {c->is.middle, c->is.swing, c->is.begin};
    if (vr % 10 > 2)
        return ERROR;
    of[vr % 10][vr / 10] = value;
    return OK;
}

static int *integer(struct instance *c, unsigned vr)
{
    int *of[] = {c->is.period_ms, c->is.reaction_ms, c->is.ramp_ms, c->is.restart_ms, c->is.heeds, c->is.mutes, c->is.mute_ms, c->is.deaf_ms, c->is.hears};
    unsigned r = (vr - 100) / 10, k = (vr - 100) % 10;
    return vr >= 100 && r < ROBOTS && k < 9 ? of[k] + r : NULL;
}

static int *boolean(struct instance *c, unsigned vr)
{
    if (vr >= 200 && vr < 200 + SENSORS)
        return c->now.clear + (vr - 200);
    return vr >= 210 && vr < 210 + ROBOTS ? c->is.latched + (vr - 210) : NULL;
}

static void *saved(const struct instance *c, void *room)
{
    struct instance *copy = room ? room : malloc(sizeof *copy);
    if (copy)
        *copy = *c;
    return copy;
}

#define REALS(set_or_get, pointer)                                      \
    for (size_t k = 0; k < n; k++)                                      \
        if (set_or_get(c, vr[k], pointer v[k]) != OK)                   \
            return ERROR;                                               \
    return OK
#define OTHERS(of, assignment)                                          \
    for (size_t k = 0; k < n; k++) {                                    \
        int *p = of(c, vr[k]);                                          \
        if (!p)                                                         \
            return ERROR;                                               \
        assignment;                                                     \
    }                                                                   \
    return OK

/* FMI 2.0 */
EXPORT const char *fmi2GetVersion(void) { return "2.0"; }
EXPORT const char *fmi2GetTypesPlatform(void) { return "default"; }
EXPORT int fmi2SetDebugLogging(void *c, int on, size_t n, const char *const names[]) { (void)c, (void)on, (void)n, (void)names; return OK; }
EXPORT void *fmi2Instantiate(const char *name, int kind, const char *guid, const char *resources, const void *calls, int visible, int logging)
{
    (void)name, (void)kind, (void)guid, (void)resources, (void)calls, (void)visible, (void)logging;
    return fresh();
}
EXPORT void fmi2FreeInstance(void *c) { free(c); }
EXPORT int fmi2SetupExperiment(void *c, int t, double tolerance, double start, int s, double stop)
{
    (void)c, (void)t, (void)tolerance, (void)start, (void)s, (void)stop;
    return OK;
}
EXPORT int fmi2EnterInitializationMode(void *c) { (void)c; return OK; }
EXPORT int fmi2ExitInitializationMode(void *c) { (void)c; return OK; }
EXPORT int fmi2Terminate(void *c) { (void)c; return OK; }
EXPORT int fmi2Reset(struct instance *c)
{
    struct instance *other = fresh();
    if (!other)
        return ERROR;
    *c = *other;
    free(other);
    return OK;
}
EXPORT int fmi2GetReal(struct instance *c, const unsigned vr[], size_t n, double v[]) { REALS(get_real, &); }
EXPORT int fmi2SetReal(struct instance *c, const unsigned vr[], size_t n, const double v[]) { REALS(set_real, ); }
EXPORT int fmi2GetInteger(struct instance *c, const unsigned vr[], size_t n, int v[]) { OTHERS(integer, v[k] = *p); }
EXPORT int fmi2SetInteger(struct instance *c, const unsigned vr[], size_t n, const int v[]) { OTHERS(integer, *p = v[k]); }
EXPORT int fmi2GetBoolean(struct instance *c, const unsigned vr[], size_t n, int v[]) { OTHERS(boolean, v[k] = *p); }
EXPORT int fmi2SetBoolean(struct instance *c, const unsigned vr[], size_t n, const int v[]) { OTHERS(boolean, *p = v[k] != 0); }
EXPORT int fmi2DoStep(struct instance *c, double t, double length, int keep) { (void)t, (void)keep; return step(c, length); }
EXPORT int fmi2GetFMUstate(struct instance *c, void **state) { *state = saved(c, *state); return *state ? OK : ERROR; }
EXPORT int fmi2SetFMUstate(struct instance *c, void *state) { *c = *(struct instance *)state; return OK; }
EXPORT int fmi2FreeFMUstate(void *c, void **state) { (void)c; free(*state); *state = NULL; return OK; }
EXPORT int fmi2SerializedFMUstateSize(void *c, void *state, size_t *size) { (void)c, (void)state; *size = sizeof(struct instance); return OK; }
EXPORT int fmi2SerializeFMUstate(void *c, void *state, char bytes[], size_t n)
{
    (void)c;
    if (n < sizeof(struct instance))
        return ERROR;
    memcpy(bytes, state, sizeof(struct instance));
    return OK;
}
EXPORT int fmi2DeSerializeFMUstate(void *c, const char bytes[], size_t n, void **state)
{
    (void)c, (void)n;
    *state = saved((const struct instance *)bytes, *state);
    return *state ? OK : ERROR;
}

/* FMI 3.0 */
EXPORT const char *fmi3GetVersion(void) { return "3.0"; }
EXPORT int fmi3SetDebugLogging(void *c, bool on, size_t n, const char *const names[]) { (void)c, (void)on, (void)n, (void)names; return OK; }
EXPORT void *fmi3InstantiateCoSimulation(const char *name, const char *token, const char *resources, bool visible, bool logging, bool event_mode,
                                         bool early, const unsigned needed[], size_t n, void *environment, void *log, void *intermediate)
{
    (void)name, (void)token, (void)resources, (void)visible, (void)logging, (void)event_mode, (void)early, (void)needed, (void)n;
    (void)environment, (void)log, (void)intermediate;
    return fresh();
}
EXPORT void fmi3FreeInstance(void *c) { free(c); }
EXPORT int fmi3EnterInitializationMode(void *c, bool t, double tolerance, double start, bool s, double stop)
{
    (void)c, (void)t, (void)tolerance, (void)start, (void)s, (void)stop;
    return OK;
}
EXPORT int fmi3ExitInitializationMode(void *c) { (void)c; return OK; }
EXPORT int fmi3Terminate(void *c) { (void)c; return OK; }
EXPORT int fmi3Reset(struct instance *c) { return fmi2Reset(c); }
EXPORT int fmi3GetFloat64(struct instance *c, const unsigned vr[], size_t n, double v[], size_t m) { (void)m; REALS(get_real, &); }
EXPORT int fmi3SetFloat64(struct instance *c, const unsigned vr[], size_t n, const double v[], size_t m) { (void)m; REALS(set_real, ); }
EXPORT int fmi3GetInt32(struct instance *c, const unsigned vr[], size_t n, int v[], size_t m) { (void)m; OTHERS(integer, v[k] = *p); }
EXPORT int fmi3SetInt32(struct instance *c, const unsigned vr[], size_t n, const int v[], size_t m) { (void)m; OTHERS(integer, *p = v[k]); }
EXPORT int fmi3GetBoolean(struct instance *c, const unsigned vr[], size_t n, bool v[], size_t m) { (void)m; OTHERS(boolean, v[k] = *p != 0); }
EXPORT int fmi3SetBoolean(struct instance *c, const unsigned vr[], size_t n, const bool v[], size_t m) { (void)m; OTHERS(boolean, *p = v[k]); }
EXPORT int fmi3DoStep(struct instance *c, double t, double length, bool keep, bool *event, bool *ends, bool *early, double *last)
{
    (void)keep;
    *event = *ends = *early = false;
    *last = t + length;
    return step(c, length);
}
EXPORT int fmi3GetFMUState(struct instance *c, void **state) { return fmi2GetFMUstate(c, state); }
EXPORT int fmi3SetFMUState(struct instance *c, void *state) { return fmi2SetFMUstate(c, state); }
EXPORT int fmi3FreeFMUState(void *c, void **state) { return fmi2FreeFMUstate(c, state); }
EXPORT int fmi3SerializedFMUStateSize(void *c, void *state, size_t *size) { return fmi2SerializedFMUstateSize(c, state, size); }
EXPORT int fmi3SerializeFMUState(void *c, void *state, unsigned char bytes[], size_t n) { return fmi2SerializeFMUstate(c, state, (char *)bytes, n); }
EXPORT int fmi3DeserializeFMUState(void *c, const unsigned char bytes[], size_t n, void **state)
{
    return fmi2DeSerializeFMUstate(c, (const char *)bytes, n, state);
}

/* What the standards want to be there and nothing here has a use for. */
#define ABSENT(name) EXPORT int name(void) { return ERROR; }
ABSENT(fmi2GetString) ABSENT(fmi2SetString) ABSENT(fmi2GetDirectionalDerivative) ABSENT(fmi2SetRealInputDerivatives)
ABSENT(fmi2GetRealOutputDerivatives) ABSENT(fmi2CancelStep) ABSENT(fmi2GetStatus) ABSENT(fmi2GetRealStatus) ABSENT(fmi2GetIntegerStatus)
ABSENT(fmi2GetBooleanStatus) ABSENT(fmi2GetStringStatus)
#define ABSENT_PAIR(type) ABSENT(fmi3Get##type) ABSENT(fmi3Set##type)
ABSENT_PAIR(Float32) ABSENT_PAIR(Int8) ABSENT_PAIR(UInt8) ABSENT_PAIR(Int16) ABSENT_PAIR(UInt16) ABSENT_PAIR(UInt32) ABSENT_PAIR(Int64)
ABSENT_PAIR(UInt64) ABSENT_PAIR(String) ABSENT_PAIR(Binary) ABSENT_PAIR(Clock) ABSENT_PAIR(IntervalDecimal) ABSENT_PAIR(IntervalFraction)
ABSENT_PAIR(ShiftDecimal) ABSENT_PAIR(ShiftFraction)
ABSENT(fmi3InstantiateModelExchange) ABSENT(fmi3InstantiateScheduledExecution) ABSENT(fmi3EnterEventMode) ABSENT(fmi3GetNumberOfVariableDependencies)
ABSENT(fmi3GetVariableDependencies) ABSENT(fmi3GetDirectionalDerivative) ABSENT(fmi3GetAdjointDerivative) ABSENT(fmi3EnterConfigurationMode)
ABSENT(fmi3ExitConfigurationMode) ABSENT(fmi3EvaluateDiscreteStates) ABSENT(fmi3UpdateDiscreteStates) ABSENT(fmi3EnterContinuousTimeMode)
ABSENT(fmi3CompletedIntegratorStep) ABSENT(fmi3SetTime) ABSENT(fmi3SetContinuousStates) ABSENT(fmi3GetContinuousStateDerivatives)
ABSENT(fmi3GetEventIndicators) ABSENT(fmi3GetContinuousStates) ABSENT(fmi3GetNominalsOfContinuousStates) ABSENT(fmi3GetNumberOfEventIndicators)
ABSENT(fmi3GetNumberOfContinuousStates) ABSENT(fmi3EnterStepMode) ABSENT(fmi3GetOutputDerivatives) ABSENT(fmi3ActivateModelPartition)
