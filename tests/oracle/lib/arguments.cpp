#include "tests/oracle/lib/arguments.h"

#include <algorithm> // find
#include <cstdlib>   // strtod

Arguments::Arguments(const std::vector<std::string> &words,
                     const std::vector<std::string> &allowed)
{
    for (const std::string &word : words) {
        size_t equals = word.find('=');
        std::string key = word.substr(0, equals);
        if (equals == std::string::npos ||
            std::find(allowed.begin(), allowed.end(), key) == allowed.end())
            throw BadInput("this check takes no argument '" + word + "'");
        values_[key] = word.substr(equals + 1);
    }
}

double Arguments::number(const std::string &key, double fallback) const
{
    auto found = values_.find(key);
    if (found == values_.end())
        return fallback;
    char *end = nullptr;
    double value = std::strtod(found->second.c_str(), &end);
    if (found->second.empty() || *end != '\0')
        throw BadInput("'" + key + "=" + found->second +
                       "': a number is needed");
    return value;
}

std::string Arguments::text(const std::string &key,
                            const std::string &fallback) const
{
    auto found = values_.find(key);
    return found == values_.end() ? fallback : found->second;
}
