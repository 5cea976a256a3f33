// Many checks in one process: loading the libraries takes longer than most.
#ifndef ORACLE_SERVE_H
#define ORACLE_SERVE_H

#include <string>
#include <vector>

// Answers every line of standard input, words separated by tabs, until its end.
// `answer` runs in a process of its own, for at most this many seconds, with
// both of its outputs on standard output; then comes the line
// "END status signal". The exit status, for main.
int serve(const std::string &seconds,
          int (*answer)(const std::vector<std::string> &words));

#endif
