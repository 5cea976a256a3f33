#define _POSIX_C_SOURCE 200809L // open, sigaction

#include "step1_shadowmap/base/system/printed.h"

#include <errno.h>
#include <fcntl.h>  // fcntl, open
#include <signal.h> // signal
#include <stdio.h>  // ferror, fflush
#include <string.h> // strerror
#include <unistd.h> // STDERR_FILENO, STDIN_FILENO

#include "step1_shadowmap/base/system/die.h" // die

void printed_prepare(void)
{
    for (int place = STDIN_FILENO; place <= STDERR_FILENO; place++) {
        if (fcntl(place, F_GETFD) == -1) {
            // The lowest free place, for reading only.
            open("/dev/null", O_RDONLY);
        }
    }
    signal(SIGPIPE, SIG_IGN);
}

void printed_check(void)
{
    errno = 0;
    if (fflush(stdout) != 0 || ferror(stdout)) {
        die("cannot write to stdout: %s",
            errno == 0 ? "a part is lost" : strerror(errno));
    }
}
