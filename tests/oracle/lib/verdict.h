// What a check found: one line each, PASS or FAIL, and whether any failed.
#ifndef ORACLE_VERDICT_H
#define ORACLE_VERDICT_H

#include <stdexcept> // runtime_error
#include <string>

// A file that is missing, unreadable or of the wrong size, or a bad argument:
// main prints it as one line on stderr and exits with status 2.
struct BadInput : std::runtime_error {
    using std::runtime_error::runtime_error;
};

class Report
{
  public:
    // Prints "PASS what: numbers" or "FAIL what: numbers".
    void line(bool passed, const std::string &what, const char *format, ...)
        __attribute__((format(printf, 4, 5)));

    bool all_passed() const
    {
        return failed_ == 0 && printed_ > 0;
    }

  private:
    int printed_ = 0;
    int failed_ = 0;
};

#endif
