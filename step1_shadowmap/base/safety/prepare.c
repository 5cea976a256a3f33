#define _POSIX_C_SOURCE 200809L // open, sigaction

#include <fcntl.h>  // fcntl, open
#include <signal.h> // signal
#include <unistd.h> // STDERR_FILENO, STDIN_FILENO
#ifdef __GLIBC__
#include <malloc.h> // mallopt
#endif

#include "step1_shadowmap/base/safety/crash.h" // crash_explain
#include "step1_shadowmap/base/system/die.h"   // safety_prepare

// Where the program was started with stdin, stdout or stderr closed, the next
// file that it opens would take that place, and be printed into: something that
// cannot be printed to is put there.
static void fill_places(void)
{
    for (int place = STDIN_FILENO; place <= STDERR_FILENO; place++) {
        if (fcntl(place, F_GETFD) == -1) {
            // The lowest free place, for reading only.
            open("/dev/null", O_RDONLY);
        }
    }
}

// A software driver takes memory for a frame and frees it at the end. glibc
// would give it back to the system, which has to clear each page again in the
// next frame: that can take longer than to draw it (measured).
static void keep_memory(void)
{
#ifdef __GLIBC__
    mallopt(M_TRIM_THRESHOLD, 256 << 20); // bytes
#endif
}

void safety_prepare(void)
{
    fill_places();
    // To print to a program that no longer listens is an error as any other.
    signal(SIGPIPE, SIG_IGN);
    keep_memory();
    crash_explain();
}
