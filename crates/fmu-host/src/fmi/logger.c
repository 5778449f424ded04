/* FMI 2.0's logger is C-variadic, and Rust cannot define such functions yet: format here, hand the text to Rust. */
#include <stdarg.h>
#include <stdio.h>

extern void fmi_hazard_log(void *environment, int status, const char *category, const char *message);

void fmi_hazard_logger(void *environment, const char *instance, int status, const char *category, const char *message,
                       ...)
{
    char text[4096];
    va_list arguments;
    (void)instance;
    text[0] = '\0';
    if (message) {
        va_start(arguments, message);
        vsnprintf(text, sizeof text, message, arguments);
        va_end(arguments);
    }
    fmi_hazard_log(environment, status, category ? category : "", text);
}
