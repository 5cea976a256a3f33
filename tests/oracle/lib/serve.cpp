#include "tests/oracle/lib/serve.h"

#include <cstdio>
#include <iostream>
#include <sstream>
#include <sys/wait.h> // waitpid
#include <unistd.h>   // _exit, alarm, dup2, fork

int serve(const std::string &seconds,
          int (*answer)(const std::vector<std::string> &words))
{
    for (std::string line, word; std::getline(std::cin, line);) {
        std::vector<std::string> words;
        for (std::istringstream text(line); std::getline(text, word, '\t');)
            words.push_back(word);
        pid_t child = fork();
        if (child < 0 || words.size() < 2)
            return 2;
        if (child == 0) {
            alarm(unsigned(std::stoul(seconds)));
            dup2(STDOUT_FILENO, STDERR_FILENO);
            int status = answer(words);
            std::fflush(stdout);
            // Not exit(): some library's destructor waits for threads, and
            // those are the parent's.
            _exit(status);
        }
        int status = 0;
        waitpid(child, &status, 0);
        std::printf("END %d %d\n", WEXITSTATUS(status), status & 127);
        std::fflush(stdout);
    }
    return 0;
}
