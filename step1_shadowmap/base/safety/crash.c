#define _GNU_SOURCE // environ, program_invocation_short_name

#include "step1_shadowmap/base/safety/crash.h"

#include <errno.h>  // program_invocation_short_name
#include <signal.h> // signal
#include <stdbool.h>
#include <string.h> // strcspn, strlen, strncmp
#include <unistd.h> // _exit, environ, write

// How the names begin that Mesa looks for.
static const char *const names[] = {"GALLIUM_",  "GALLIVM_", "LIBGL_",
                                    "LP_",       "MESA_",    "OSMESA_",
                                    "SOFTPIPE_", "DRAW_",    "ST_"};

static bool steers(const char *variable)
{
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        if (strncmp(variable, names[i], strlen(names[i])) == 0) {
            return true;
        }
    }
    return false;
}

// Nothing but what is allowed while the program is in an unknown state.
static void say(const char *text, size_t length)
{
    if (write(STDERR_FILENO, text, length) < 0) {
        _exit(1);
    }
}

static void on_crash(int number)
{
    static const char before[] = ": the OpenGL driver has crashed; unset";
    (void)number;
    say(program_invocation_short_name, strlen(program_invocation_short_name));
    say(before, sizeof before - 1);
    for (char **variable = environ; *variable != NULL; variable++) {
        if (steers(*variable)) {
            say(" ", 1);
            say(*variable, strcspn(*variable, "="));
        }
    }
    say("\n", 1);
    _exit(1);
}

void crash_explain(void)
{
    static const int crashes[] = {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL};
    bool steered = false;
    for (char **variable = environ; *variable != NULL; variable++) {
        steered = steered || steers(*variable);
    }
    for (size_t i = 0; steered && i < sizeof crashes / sizeof *crashes; i++) {
        signal(crashes[i], on_crash);
    }
}
