// The key=value words after the folder on the oracle's command line.
#ifndef ORACLE_ARGUMENTS_H
#define ORACLE_ARGUMENTS_H

#include <map>
#include <string>
#include <vector>

#include "tests/oracle/lib/verdict.h"

class Arguments
{
  public:
    // Throws BadInput for a word that is not key=value or whose key is not
    // among `allowed`.
    Arguments(const std::vector<std::string> &words,
              const std::vector<std::string> &allowed);

    bool given(const std::string &key) const
    {
        return values_.count(key) > 0;
    }

    // The number given for `key`, or `fallback` when it was not given. Throws
    // BadInput when it is no number.
    double number(const std::string &key, double fallback) const;

    // The same for words.
    std::string text(const std::string &key, const std::string &fallback) const;

  private:
    std::map<std::string, std::string> values_;
};

#endif
