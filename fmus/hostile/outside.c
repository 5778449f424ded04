/* The deeds that touch the machine: files, sockets, processes, threads; and the messages that no importer expects. */
#define _GNU_SOURCE
#include "hostile.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <pthread.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/types.h>
#include <time.h>
#include <unistd.h>

static int write_file(const char *path, const char *text)
{
    int file = open(path, O_WRONLY | O_CREAT | O_TRUNC, 0644);
    if (file < 0)
        return 0;
    ssize_t written = write(file, text, strlen(text));
    close(file);
    return written == (ssize_t)strlen(text);
}

static int write_resources(const char *name)
{
    char path[sizeof fmu_root + 600];
    snprintf(path, sizeof path, "%s/resources/%s", fmu_root, name);
    return write_file(path, "written by the FMU\n");
}

static int read_file(const char *path)
{
    char byte;
    int file = open(path, O_RDONLY);
    if (file < 0)
        return 0;
    ssize_t length = read(file, &byte, 1);
    close(file);
    return length == 1;
}

/* Connects to a port of this machine, or offers one. */
static int use_socket(bool offer, long port)
{
    struct sockaddr_in address = {.sin_family = AF_INET, .sin_port = htons((uint16_t)port)};
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    int file = socket(AF_INET, SOCK_STREAM, 0);
    if (file < 0)
        return 0;
    const struct sockaddr *where = (const struct sockaddr *)&address;
    int result = offer ? bind(file, where, sizeof address) : connect(file, where, sizeof address);
    if (offer && result == 0)
        result = listen(file, 1);
    close(file);
    return result == 0;
}

/* A child that sleeps for `size` seconds; its number goes to `path`. */
static int leave_child(const struct deed *deed, bool detached)
{
    pid_t child = fork();
    if (child == 0) {
        if (detached)
            setsid();
        sleep(deed->size ? (unsigned)deed->size : 60);
        _exit(0);
    }
    if (child > 0 && deed->path[0]) {
        char text[32];
        snprintf(text, sizeof text, "%ld\n", (long)child);
        write_file(deed->path, text);
    }
    return child > 0;
}

static int shell(const char *path)
{
    char command[600];
    snprintf(command, sizeof command, "touch '%s'", path);
    return system(command) == 0;
}

static void *live_on(void *unused)
{
    for (;;) {
        struct timespec time = {0, 10000000};
        nanosleep(&time, NULL);
    }
    return unused;
}

static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
static pthread_cond_t changed = PTHREAD_COND_INITIALIZER;
static long asked, answered;
static bool answering;

static void *answer(void *unused)
{
    pthread_mutex_lock(&lock);
    for (;;) {
        while (answered == asked)
            pthread_cond_wait(&changed, &lock);
        answered = asked;
        pthread_cond_broadcast(&changed);
    }
    return unused;
}

void ask_thread(void)
{
    pthread_t thread;
    pthread_mutex_lock(&lock);
    if (!answering)
        answering = pthread_create(&thread, NULL, answer, NULL) == 0;
    asked++;
    pthread_cond_broadcast(&changed);
    while (answered != asked)
        pthread_cond_wait(&changed, &lock);
    pthread_mutex_unlock(&lock);
}

int outside(const struct deed *deed)
{
    const char *what = deed->what, *path = deed->path;
    pthread_t thread;
    if (strcmp(what, "write-file") == 0)
        return write_file(path, "written by the FMU\n");
    if (strcmp(what, "write-cwd") == 0)
        return write_file(path[0] ? path : "hostile.txt", "written by the FMU\n");
    if (strcmp(what, "write-resources") == 0)
        return write_resources(path[0] ? path : "hostile.txt");
    if (strcmp(what, "read-file") == 0)
        return read_file(path);
    if (strcmp(what, "socket-connect") == 0)
        return use_socket(false, deed->port);
    if (strcmp(what, "socket-bind") == 0)
        return use_socket(true, deed->port);
    if (strcmp(what, "exec") == 0)
        return shell(path);
    if (strcmp(what, "child") == 0)
        return leave_child(deed, false);
    if (strcmp(what, "child-detached") == 0)
        return leave_child(deed, true);
    if (strcmp(what, "kill-parent") == 0)
        return kill(getppid(), SIGTERM) == 0;
    if (strcmp(what, "chdir") == 0)
        return chdir(path[0] ? path : "/") == 0;
    if (strcmp(what, "thread") == 0)
        return pthread_create(&thread, NULL, live_on, NULL) == 0;
    return -1;
}

void say(struct instance *instance, int status, const char *category, const char *message)
{
    if (instance->log2)
        instance->log2(instance->environment, "hostile", status, category, "%s", message);
    else if (instance->log3)
        instance->log3(instance->environment, status, category, message);
}

static void *chat(void *argument)
{
    struct instance *instance = argument;
    while (!instance->silent) {
        struct timespec time = {0, 1000000};
        say(instance, WARNING, "logStatusError", "a word from another thread");
        nanosleep(&time, NULL);
    }
    return NULL;
}

void stop_chatter(struct instance *instance)
{
    pthread_t *thread = instance->chatter;
    if (!thread)
        return;
    instance->silent = true;
    pthread_join(*thread, NULL);
    free(thread);
    instance->chatter = NULL;
}

void wild_messages(struct instance *instance, const struct deed *deed)
{
    static const char raw[] = "red \x1b[31m bell \a back \r\n no text \xff\xfe end";
    if (!instance)
        return;
    if (strcmp(deed->what, "log-from-thread") == 0 && !instance->chatter) {
        pthread_t *thread = malloc(sizeof *thread);
        instance->chatter = thread;
        if (pthread_create(thread, NULL, chat, instance) != 0)
            abort();
    }
    if (strcmp(deed->what, "log-format") == 0 && instance->log2)
        instance->log2(instance->environment, "hostile", ERROR, "logStatusError", "%s%s%s%s%s%s%s%s%n%n");
    if (strcmp(deed->what, "null-log") != 0)
        return;
    size_t length = deed->size ? (size_t)deed->size : 1 << 20;
    char *text = malloc(length + 1);
    memset(text, 'x', length);
    text[length] = '\0';
    say(instance, WARNING, "logStatusError", text);
    free(text);
    say(instance, 77, "no such category", "a status that does not exist");
    say(instance, ERROR, NULL, raw);
    if (instance->log2) {
        instance->log2(instance->environment, NULL, ERROR, NULL, NULL);
        instance->log2(instance->environment, "hostile", ERROR, "logStatusError", "NULL: %s", (char *)NULL);
        instance->log2(instance->environment, "hostile", ERROR, "logStatusError", "100 %% and a lonely %");
    } else if (instance->log3) {
        instance->log3(instance->environment, ERROR, NULL, NULL);
        instance->log3(instance->environment, ERROR, "logStatusError", "100 %s and a lonely %");
    }
}
