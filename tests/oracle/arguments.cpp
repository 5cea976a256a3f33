#include "tests/oracle/arguments.h"

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
        std::string text = word.substr(equals + 1);
        char *end = nullptr;
        values_[key] = std::strtod(text.c_str(), &end);
        if (text.empty() || *end != '\0')
            throw BadInput("'" + word + "': a number is needed");
    }
}

double Arguments::number(const std::string &key, double fallback) const
{
    auto found = values_.find(key);
    return found == values_.end() ? fallback : found->second;
}
