// A step's program that stays: it loads its libraries once, which takes longer
// than a small picture does, and draws as often as it is asked, each time in a
// process of its own. It is linked from the program's objects, with
// this in front of their main.
//
// A request is one line on stdin, with tabs between: the directory to work in,
// the files for stdout and stderr, the seconds that it may take, and the
// arguments. The answer is one line: exit status and signal.
#define _GNU_SOURCE // on_exit, program_invocation_short_name, strsep

#include <errno.h>    // program_invocation_short_name
#include <fcntl.h>    // open
#include <stdio.h>    // getline, printf
#include <stdlib.h>   // atoi, exit, on_exit
#include <string.h>   // strcspn, strrchr, strsep
#include <sys/wait.h> // waitpid
#include <unistd.h>   // alarm, chdir, dup2, fork

enum { MAX_WORDS = 128 };

// The linker's names (--wrap=main) for the program's main and for this one.
int __real_main(int argc, char **argv);
int __wrap_main(int argc, char **argv);

static void redirect(const char *path, int mode, int to)
{
    int file = open(path, mode);
    if (file < 0 || dup2(file, to) < 0) {
        perror(path);
        _exit(126);
    }
    close(file);
}

// Some library's thread did not come along with the fork, and the library's
// exit handler would wait for it. What is registered last is called first.
static void leave(int status, void *unused)
{
    (void)unused;
    fflush(NULL);
    _exit(status);
}

static int answer(char *program, char *line)
{
    char *words[MAX_WORDS] = {program};
    int count = 1;
    on_exit(leave, NULL);
    if (chdir(strsep(&line, "\t")) != 0) {
        _exit(126);
    }
    redirect("/dev/null", O_RDONLY, STDIN_FILENO);
    redirect(strsep(&line, "\t"), O_WRONLY, STDOUT_FILENO);
    redirect(strsep(&line, "\t"), O_WRONLY, STDERR_FILENO);
    alarm((unsigned)atoi(strsep(&line, "\t")));
    while (line != NULL && count < MAX_WORDS - 1) {
        words[count++] = strsep(&line, "\t");
    }
    return __real_main(count, words);
}

int __wrap_main(int argc, char **argv)
{
    char *line = NULL;
    size_t room = 0;
    (void)argc;
    while (getline(&line, &room, stdin) > 0) {
        line[strcspn(line, "\n")] = '\0';
        pid_t child = fork();
        if (child == 0) {
            exit(answer(argv[0], line));
        }
        int status = -1;
        waitpid(child, &status, 0);
        printf("%d %d\n", WEXITSTATUS(status), status & 127);
        fflush(stdout);
    }
    free(line);
    return 0;
}
