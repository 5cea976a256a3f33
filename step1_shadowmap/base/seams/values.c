#include <string.h> // strcmp

#include "step1_shadowmap/base/seams/technique.h" // options_value

void *options_value(const OptionTable tables[], const char *name)
{
    for (const OptionTable *table = tables; table->options; table++) {
        for (const Option *option = table->options; option->name; option++) {
            if (strcmp(option->name, name) == 0) {
                return (char *)table->settings + option->offset;
            }
        }
    }
    return NULL;
}

bool options_on(const OptionTable tables[], const char *flag)
{
    const bool *value = options_value(tables, flag);
    return value != NULL && *value;
}

bool options_is(const OptionTable tables[], const char *name,
                const char *choice)
{
    const char *const *value = options_value(tables, name);
    return value != NULL && strcmp(*value, choice) == 0;
}

int options_integer(const OptionTable tables[], const char *name)
{
    const int *value = options_value(tables, name);
    return *value;
}
