// Whether there is memory for something large.
#define _POSIX_C_SOURCE 200809L // sysconf

#include <stdarg.h>       // va_list
#include <stdint.h>       // SIZE_MAX
#include <stdio.h>        // fopen, sscanf, vsnprintf
#include <sys/resource.h> // getrlimit
#include <unistd.h>       // sysconf

#include "step1_shadowmap/base/system/die.h" // die, memory_check

// What is smaller is not looked at: it is given, or it is not.
enum { LARGE = 1 << 24 };

static size_t page_bytes(void)
{
    long bytes = sysconf(_SC_PAGESIZE);
    return bytes > 0 ? (size_t)bytes : 4096;
}

// All there is, where the system does not say how much of it is left.
static size_t physical(void)
{
    long pages = sysconf(_SC_PHYS_PAGES);
    return pages > 0 ? (size_t)pages * page_bytes() : SIZE_MAX;
}

static size_t left_in_system(void)
{
    FILE *file = fopen("/proc/meminfo", "r");
    char line[128];
    size_t kilobytes = 0;
    while (file != NULL && kilobytes == 0 && fgets(line, sizeof line, file)) {
        if (sscanf(line, "MemAvailable: %zu kB", &kilobytes) != 1) {
            kilobytes = 0;
        }
    }
    if (file != NULL) {
        fclose(file);
    }
    return kilobytes > 0 ? kilobytes * 1024 : physical();
}

// Of the addresses that the process may use.
static size_t left_of_limit(void)
{
    struct rlimit limit;
    size_t pages = 0;
    if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) {
        return SIZE_MAX;
    }
    FILE *file = fopen("/proc/self/statm", "r");
    if (file != NULL) {
        if (fscanf(file, "%zu", &pages) != 1) {
            pages = 0;
        }
        fclose(file);
    }
    size_t used = pages * page_bytes();
    return limit.rlim_cur > used ? (size_t)limit.rlim_cur - used : 0;
}

// Bytes that this process can still get: what the system has left, and at most
// what a limit on the process (ulimit -v) leaves it.
static size_t memory_left(void)
{
    size_t system = left_in_system();
    size_t limit = left_of_limit();
    return system < limit ? system : limit;
}

static double mebibytes(size_t bytes)
{
    return (double)bytes / (1 << 20);
}

void memory_check(size_t bytes, const char *format, ...)
{
    size_t left = bytes < LARGE ? SIZE_MAX : memory_left();
    if (bytes <= left) {
        return;
    }
    char what[256];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(what, sizeof what, format, arguments);
    va_end(arguments);
    die("no memory for %s: %.0f MiB asked for, %.0f MiB are left", what,
        mebibytes(bytes), mebibytes(left));
}
