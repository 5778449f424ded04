/* Reads which deeds are asked for, counts the calls, and does what is due; those that end or change this process. */
#define _GNU_SOURCE
#include "hostile.h"

#include <dlfcn.h>
#include <fenv.h>
#include <limits.h>
#include <locale.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>
#ifdef __x86_64__
#include <xmmintrin.h>
#endif

static const char *const PLACE_NAMES[PLACES] = {
    "load", "instantiate", "setup", "enter-init", "exit-init", "set", "get", "step", "save", "restore", "free-state",
    "serialize", "deserialize", "reset", "terminate", "free-instance", "unload",
};

/* Every behaviour, so that a slip of a test's pen does not pass for honesty. */
static const char *const KNOWN[] = {
    "segfault", "abort", "exit0", "exit3", "stack-overflow", "hang", "sleep-forever", "fpe", "slow", "print", "chdir",
    "locale", "fpu", "signal-handlers", "thread", "thread-needed", "child", "child-detached", "leak",
    "allocate-without-end", "write-file", "write-cwd", "write-resources", "read-file", "socket-connect", "socket-bind",
    "exec", "kill-parent", "status-warning", "status-discard", "status-error", "status-fatal", "status-pending",
    "bad-status", "nan", "infinity", "state-noop", "state-null", "state-shared", "state-forgets-clock", "state-freeze",
    "state-pointer", "state-size", "shared-instances", "global-state", "forgets-rng", "clock-time", "reset-refused",
    "reset-noop", "single-instance", "once-per-process", "big-state", "null-log", "log-format", "log-from-thread",
};

static struct deed deeds[8];
static size_t deed_count;
static long calls[PLACES];
int64_t shown_early;
char fmu_root[4096];

const struct deed *asked_for(const char *what)
{
    for (size_t k = 0; k < deed_count; k++)
        if (strcmp(deeds[k].what, what) == 0)
            return &deeds[k];
    return NULL;
}

/* Steps of 20 ms in a row with stop, begun ones too: in half steps it is not more of them. */
static long stopped_steps(const struct state *now)
{
    return (long)((now->stopped_ms + 19) / 20);
}

bool has_begun(const struct deed *deed, const struct state *now)
{
    return deed->when_stopped ? stopped_steps(now) >= deed->at : now->steps > deed->at;
}

bool refuses(int status)
{
    return status == DISCARD || status == ERROR || status == FATAL;
}

static bool is_known(const char *what)
{
    for (size_t k = 0; k < sizeof KNOWN / sizeof *KNOWN; k++)
        if (strcmp(what, KNOWN[k]) == 0)
            return true;
    return false;
}

/* One key of the last deed. */
static void read_line(const char *key, const char *value)
{
    struct deed *deed = deed_count ? &deeds[deed_count - 1] : NULL;
    if (strcmp(key, "what") == 0 && is_known(value) && deed_count < sizeof deeds / sizeof *deeds) {
        deed = &deeds[deed_count++];
        deed->place = STEP;
        snprintf(deed->what, sizeof deed->what, "%.31s", value);
        return;
    }
    if (deed && strcmp(key, "where") == 0) {
        for (int place = 0; place < PLACES; place++) {
            if (strcmp(value, PLACE_NAMES[place]) == 0) {
                deed->place = (enum place)place;
                return;
            }
        }
    } else if (deed && strcmp(key, "when") == 0 && strcmp(value, "stop") == 0) {
        deed->when_stopped = true;
        return;
    } else if (deed && strcmp(key, "at") == 0) {
        deed->at = atol(value);
        deed->has_at = true;
        return;
    } else if (deed && strcmp(key, "size") == 0) {
        deed->size = atol(value);
        return;
    } else if (deed && strcmp(key, "port") == 0) {
        deed->port = atol(value);
        return;
    } else if (deed && strcmp(key, "path") == 0) {
        snprintf(deed->path, sizeof deed->path, "%s", value);
        return;
    }
    fprintf(stderr, "resources/behaviour: `%s = %s` has no meaning\n", key, value);
    abort();
}

/* The FMU's folder: the library is in binaries/<platform>/. */
static void find_root(void)
{
    Dl_info info;
    char path[PATH_MAX];
    if (!dladdr((void *)find_root, &info) || !info.dli_fname || !realpath(info.dli_fname, path))
        return;
    for (int level = 0; level < 3; level++) {
        char *slash = strrchr(path, '/');
        if (!slash)
            return;
        *slash = '\0';
    }
    snprintf(fmu_root, sizeof fmu_root, "%s", path);
}

__attribute__((constructor)) static void load(void)
{
    char path[sizeof fmu_root + 32], line[1024], key[64], value[512];
    find_root();
    snprintf(path, sizeof path, "%s/resources/behaviour", fmu_root);
    FILE *file = fopen(path, "r");
    if (!file)
        return;
    while (fgets(line, sizeof line, file)) {
        /* The value may have blanks within. */
        if (sscanf(line, " %63[^= ] = %511[^\n]", key, value) == 2)
            read_line(key, value);
    }
    fclose(file);
    strike(NULL, LOAD);
}

__attribute__((destructor)) static void unload(void)
{
    strike(NULL, UNLOAD);
}

static __attribute__((noinline)) int overflow(volatile int depth)
{
    volatile char room[4096];
    room[0] = (char)depth;
    return depth < INT_MAX ? overflow(depth + 1) + room[0] : 0;
}

static void swallow(int signal)
{
    (void)signal;
}

static void divide_by_zero(void)
{
#ifdef __x86_64__
    volatile int zero = 0;
    zero = 1 / zero;
#endif
    raise(SIGFPE);
}

static void round_otherwise(void)
{
    fesetround(FE_TOWARDZERO);
#ifdef __x86_64__
    /* Flush to zero, and take denormals for zero. */
    _mm_setcsr(_mm_getcsr() | 0x8040);
#endif
}

static void change_locale(void)
{
    static const char *const names[] = {"de_DE.UTF-8", "de_DE", "fr_FR.UTF-8", "C.UTF-8", "C.utf8"};
    for (size_t k = 0; k < sizeof names / sizeof *names; k++)
        if (setlocale(LC_ALL, names[k]))
            return;
}

static void write_all(int file, const char *text, size_t length)
{
    ssize_t done = write(file, text, length);
    (void)done;
}

/* Lines on both outputs, bytes that are no text, and a line that never ends. */
static void flood(long size)
{
    static const char text[] = "the FMU has something to say \xff\xfe\x1b[2J\n{\"not\": \"ours\"}\n";
    for (long done = 0; done < size; done += (long)sizeof text) {
        write_all(STDOUT_FILENO, text, sizeof text - 1);
        write_all(STDERR_FILENO, text, sizeof text - 1);
    }
    write_all(STDERR_FILENO, "no end of line", 14);
    printf("kept back until the end");
}

/* Kept where the compiler cannot know that nobody looks: it leaves out memory that is not used. */
static char *volatile taken;

static void take_memory(long size)
{
    /* Not checked, as in so many programs. */
    taken = malloc((size_t)size);
    memset(taken, 0x5a, (size_t)size);
}

static int status_named(const char *what)
{
    static const char *const names[] = {"status-warning", "status-discard", "status-error", "status-fatal",
                                        "status-pending"};
    for (int k = 0; k < 5; k++)
        if (strcmp(what, names[k]) == 0)
            return k + 1;
    return strcmp(what, "bad-status") == 0 ? NO_STATUS : OK;
}

static void pause_for(long milliseconds)
{
    struct timespec time = {milliseconds / 1000, milliseconds % 1000 * 1000000};
    nanosleep(&time, NULL);
}

/* Does one deed; the status that it gives the call. */
static int act(struct instance *instance, const struct deed *deed)
{
    const char *what = deed->what;
#define IS(name) (strcmp(what, name) == 0)
    if (IS("segfault"))
        *(volatile int *volatile)8 = 1;
    else if (IS("abort"))
        abort();
    else if (IS("exit0"))
        exit(0);
    else if (IS("exit3"))
        exit(3);
    else if (IS("stack-overflow"))
        overflow(0);
    else if (IS("hang"))
        for (volatile int k = 0;; k++) {}
    else if (IS("sleep-forever"))
        for (;;)
            pause();
    else if (IS("fpe"))
        divide_by_zero();
    else if (IS("print"))
        flood(deed->size ? deed->size : 1 << 20);
    else if (IS("locale"))
        change_locale();
    else if (IS("fpu"))
        round_otherwise();
    else if (IS("signal-handlers")) {
        signal(SIGINT, swallow);
        signal(SIGTERM, swallow);
        signal(SIGSEGV, swallow);
    } else if (IS("allocate-without-end"))
        for (;;)
            take_memory(16 << 20);
    else if (IS("leak"))
        take_memory(deed->size ? deed->size : 1 << 20);
    else if (IS("slow"))
        pause_for(deed->size ? deed->size : 100);
    else {
        int done = outside(deed);
        if (done >= 0 && instance)
            instance->now->shown = 1 + done;
        else if (done >= 0)
            shown_early = 1 + done;
        wild_messages(instance, deed);
    }
#undef IS
    return status_named(what);
}

int strike(struct instance *instance, enum place place)
{
    long call = ++calls[place];
    int status = OK;
    for (size_t k = 0; k < deed_count; k++) {
        const struct deed *deed = &deeds[k];
        if (deed->place != place)
            continue;
        /* Steps are counted in the state, from 0, or from 1 while it is stopped; all other calls in this process, from 1. */
        long step = place != STEP ? 0 : deed->when_stopped ? stopped_steps(instance->now) : (long)instance->now->steps;
        long count = place == STEP ? step : call;
        long at = deed->has_at || place == STEP ? deed->at : 1;
        bool again = strcmp(deed->what, "leak") == 0 || strcmp(deed->what, "slow") == 0;
        if (count == at || (again && count > at)) {
            int given = act(instance, deed);
            status = given == OK ? status : given;
        }
    }
    return status;
}
