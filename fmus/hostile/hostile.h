/* What the files of the hostile FMU share. Its types are declared here; no header of the FMI standard is used.
 *
 * model.c is an honest turning joint and its saved states, with the faults that lie there; calls.c does what both
 * versions of FMI have in common; fmi2.c and fmi3.c are the two interfaces; deeds.c reads `resources/behaviour` and
 * does what it asks for; outside.c has the deeds that touch the machine rather than the process itself.
 *
 * What the file may hold is in README.md. Without it the FMU is honest. */
#ifndef HOSTILE_H
#define HOSTILE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define EXPORT __attribute__((visibility("default")))

/* Equal in both versions, except for PENDING, which only FMI 2.0 has. */
enum status { OK, WARNING, DISCARD, ERROR, FATAL, PENDING, NO_STATUS = 99 };

/* Calls in which a deed can be done; the names are in deeds.c. */
enum place {
    LOAD, INSTANTIATE, SETUP, ENTER_INIT, EXIT_INIT, SET, GET, STEP, SAVE, RESTORE, FREE_STATE, SERIALIZE, DESERIALIZE,
    RESET, TERMINATE, FREE_INSTANCE, UNLOAD, PLACES
};

/* Value references. */
enum { TIME, STOP, PUSH, Q, QD };

/* Everything that changes; eight bytes each, so that equal states are equal bytes. */
struct state {
    double time, q, qd, drive, push;
    /* Hidden, ms. */
    int64_t clock;
    int64_t steps, stop;
    /* How long stop has been true, ms. */
    int64_t stopped_ms;
    /* 0: nothing to show; else qd is this minus 1: whether something outside could be done. */
    int64_t shown;
};

struct instance {
    struct state *now, own;
    /* Behaviour big-state: values that the motion depends on. */
    double *history;
    size_t history_length;
    /* Behaviour state-freeze. */
    double frozen_until;
    /* Behaviour state-pointer: what serialised bytes point to. */
    struct state *block;
    /* The importer's log callback, of one version or the other. */
    void *environment;
    void (*log2)(void *, const char *, int, const char *, const char *, ...);
    void (*log3)(void *, int, const char *, const char *);
    /* Behaviour log-from-thread. */
    void *chatter;
    volatile bool silent;
};

struct saved {
    struct state state;
    double history[];
};

struct deed {
    char what[32], path[512];
    enum place place;
    bool has_at, when_stopped;
    long at, size, port;
};

/* deeds.c */

/* The deed of this name if it was asked for, wherever and whenever. */
const struct deed *asked_for(const char *what);
/* Does what is due in this call; what the call has to return. */
int strike(struct instance *instance, enum place place);
/* Whether `nan` or `infinity` has begun. */
bool has_begun(const struct deed *deed, const struct state *now);
/* Whether a call with this status does nothing else. */
bool refuses(int status);
/* What `shown` begins with: the answer to a deed that was done before there was an instance. */
extern int64_t shown_early;
/* The folder that the FMU was unpacked to. */
extern char fmu_root[4096];

/* outside.c */

/* Does a deed that concerns the machine: 1 it could be done, 0 it could not, -1 it is none of these. */
int outside(const struct deed *deed);
/* A log message. */
void say(struct instance *instance, int status, const char *category, const char *message);
/* Does a deed that concerns the log, or none. */
void wild_messages(struct instance *instance, const struct deed *deed);
void stop_chatter(struct instance *instance);
/* Behaviour thread-needed: waits until the other thread, which is started first if need be, has answered. */
void ask_thread(void);

/* model.c */

void start_values(struct instance *instance);
int advance(struct instance *instance, double time, double step);
bool get_real(const struct instance *instance, unsigned reference, double *value);
bool set_real(struct instance *instance, unsigned reference, double value);
size_t saved_size(const struct instance *instance);
int save(struct instance *instance, void **state);
int restore(struct instance *instance, const struct saved *state);
void free_saved(void **state);
void serialize(struct instance *instance, const struct saved *state, unsigned char *bytes);
int deserialize(struct instance *instance, const unsigned char *bytes, void **state);

/* calls.c: an instance without its log callback, or nothing; then the calls that are the same in both versions. */

struct instance *new_instance(void *environment, void *log2, void *log3);
void free_instance(struct instance *instance);
int plain_call(struct instance *instance, enum place place);
int setup(struct instance *instance, double start);
int make_step(struct instance *instance, double time, double step);
int get_reals(struct instance *instance, const unsigned *references, size_t count, double *values);
int set_reals(struct instance *instance, const unsigned *references, size_t count, const double *values);
int reset(struct instance *instance);
int save_call(struct instance *instance, void **state);
int restore_call(struct instance *instance, void *state);
int free_state_call(struct instance *instance, void **state);
int size_call(struct instance *instance, void *state, size_t *size);
int serialize_call(struct instance *instance, void *state, unsigned char *bytes, size_t size);
int deserialize_call(struct instance *instance, const unsigned char *bytes, size_t size, void **state);

#endif
