// The key=value words after the folder on the oracle's command line.
#ifndef ORACLE_ARGUMENTS_H
#define ORACLE_ARGUMENTS_H

#include <map>
#include <string>
#include <vector>

#include "tests/oracle/report.h"

class Arguments
{
  public:
    // Throws BadInput for a word that is not key=value or whose key is not
    // among `allowed`.
    Arguments(const std::vector<std::string> &words,
              const std::vector<std::string> &allowed);

    // The number given for `key`, or `fallback` when it was not given.
    double number(const std::string &key, double fallback) const;

  private:
    std::map<std::string, double> values_;
};

#endif
