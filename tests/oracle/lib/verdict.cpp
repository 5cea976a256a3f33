#include "tests/oracle/lib/verdict.h"

#include <cstdarg> // va_list
#include <cstdio>

void Report::line(bool passed, const std::string &what, const char *format, ...)
{
    std::printf("%s %s: ", passed ? "PASS" : "FAIL", what.c_str());
    va_list arguments;
    va_start(arguments, format);
    std::vprintf(format, arguments);
    va_end(arguments);
    std::printf("\n");
    printed_++;
    failed_ += passed ? 0 : 1;
}
