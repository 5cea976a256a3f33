#define _GNU_SOURCE // program_invocation_short_name

#include "step1_shadowmap/base/die.h"

#include <errno.h> // program_invocation_short_name
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

static _Noreturn void stop(int status, const char *format, va_list arguments)
{
    fprintf(stderr, "%s: ", program_invocation_short_name);
    vfprintf(stderr, format, arguments);
    fputc('\n', stderr);
    exit(status);
}

void die(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    stop(1, format, arguments);
}

void die_usage(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    stop(2, format, arguments);
}

void *allocate(size_t count, size_t size)
{
    void *memory = calloc(count, size);
    if (memory == NULL) {
        die("no memory for %zu x %zu bytes", count, size);
    }
    return memory;
}
