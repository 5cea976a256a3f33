#define _GNU_SOURCE // program_invocation_short_name

#include "step1_shadowmap/base/system/die.h"

#include <errno.h> // errno, program_invocation_short_name
#include <stdarg.h>
#include <stdio.h>
#include <stdint.h> // SIZE_MAX
#include <stdlib.h>
#include <string.h> // strerror

static void print(const char *format, va_list arguments)
{
    char message[2048];
    vsnprintf(message, sizeof message, format, arguments);
    // One line, whatever the user's own words hold.
    for (char *letter = message; *letter != '\0'; letter++) {
        if ((unsigned char)*letter < ' ') {
            *letter = '?';
        }
    }
    fprintf(stderr, "%s: %s\n", program_invocation_short_name, message);
}

void die(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    print(format, arguments);
    exit(1);
}

void die_usage(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    print(format, arguments);
    exit(2);
}

void complain(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    print(format, arguments);
    va_end(arguments);
}

void *allocate(size_t count, size_t size)
{
    size_t bytes =
        size > 0 && count > SIZE_MAX / size ? SIZE_MAX : count * size;
    memory_check(bytes, "%zu x %zu bytes", count, size);
    void *memory = calloc(count, size);
    if (memory == NULL) {
        die("no memory for %zu x %zu bytes", count, size);
    }
    return memory;
}

void printed_check(void)
{
    errno = 0;
    if (fflush(stdout) != 0 || ferror(stdout)) {
        die("cannot write to stdout: %s",
            errno == 0 ? "a part is lost" : strerror(errno));
    }
}

__attribute__((weak)) void memory_check(size_t bytes, const char *format, ...)
{
    (void)bytes, (void)format;
}
