// The check `compare`: two pictures, pixel by pixel.
#ifndef ORACLE_COMPARE_H
#define ORACLE_COMPARE_H

#include <string>

#include "tests/oracle/lib/verdict.h"

// Passes when both are finite everywhere, no value differs by more than
// `most`, and no more than `share` of the pixels by more than 1/255.
void compare_pictures(const std::string &first, const std::string &second,
                      double most, double share, Report &report);

#endif
