#include "step1_shadowmap/base/system/options.h"

#include <errno.h>  // errno, for strtol and strtod
#include <getopt.h> // getopt_long
#include <limits.h> // INT_MAX
#include <math.h>   // isfinite
#include <stdlib.h> // strtod, strtol
#include <string.h> // strcmp, strncmp

#include "step1_shadowmap/base/system/die.h" // die, die_usage

static void *value_of(const OptionTable *table, const Option *option)
{
    return (char *)table->settings + option->offset;
}

void options_write_value(FILE *file, const OptionTable *table,
                         const Option *option,
                         void write_text(FILE *, const char *))
{
    char extent_text[32];
    const void *value = value_of(table, option);
    const int *extent = value;
    const char *text = NULL;
    switch (option->kind) {
    case OPTION_FLAG:
        fputs(*(const bool *)value ? "true" : "false", file);
        break;
    case OPTION_TEXT:
    case OPTION_CHOICE:
        text = *(const char *const *)value;
        write_text(file, text == NULL ? "" : text);
        break;
    case OPTION_INTEGER:
    case OPTION_ODD:
        fprintf(file, "%d", *extent);
        break;
    case OPTION_NUMBER:
        if (*(const double *)value == OPTION_AUTO) {
            write_text(file, option->choices);
        } else {
            fprintf(file, "%.12g", *(const double *)value);
        }
        break;
    case OPTION_EXTENT:
    case OPTION_SIDE:
        snprintf(extent_text, sizeof extent_text, "%dx%d", extent[0],
                 extent[1]);
        write_text(file, extent_text);
        break;
    }
}

static void write_plain(FILE *file, const char *text)
{
    fputs(text, file);
}

static void print_help(const char *program, const OptionTable tables[])
{
    printf("usage: %s [options]\n", program);
    for (const OptionTable *table = tables; table->options; table++) {
        for (const Option *option = table->options; option->name; option++) {
            const char *argument = option->argument  ? option->argument
                                   : option->choices ? option->choices
                                                     : "";
            printf("  --%s %s\n      %s", option->name, argument, option->help);
            const char *const *text = value_of(table, option);
            bool no_default = option->kind == OPTION_FLAG ||
                              ((option->kind == OPTION_TEXT ||
                                option->kind == OPTION_CHOICE) &&
                               *text == NULL);
            if (!no_default) {
                fputs(" (default ", stdout);
                options_write_value(stdout, table, option, write_plain);
                fputs(")", stdout);
            }
            putchar('\n');
        }
    }
    puts("  --help\n      print this and exit");
}

static _Noreturn void refuse(const Option *option, const char *text)
{
    const char *name = option->name;
    switch (option->kind) {
    case OPTION_CHOICE:
        die_usage("--%s '%s': allowed are %s", name, text, option->choices);
    case OPTION_INTEGER:
        die_usage("--%s '%s': allowed are whole numbers from %.0f to %.0f",
                  name, text, option->minimum, option->maximum);
    case OPTION_ODD:
        die_usage("--%s '%s': allowed are odd numbers from %.0f to %.0f", name,
                  text, option->minimum, option->maximum);
    case OPTION_NUMBER:
        die_usage("--%s '%s': allowed are numbers from %g to %g%s%s", name,
                  text, option->minimum, option->maximum,
                  option->choices ? ", or " : "",
                  option->choices ? option->choices : "");
    case OPTION_TEXT:
        die_usage("--%s '%s': wants %s: %s", name, text, option->argument,
                  option->help);
    default:
        die_usage("--%s '%s': allowed is %s, each from %.0f to %.0f", name,
                  text, option->argument, option->minimum, option->maximum);
    }
}

static bool in_range(const Option *option, double value)
{
    return value >= option->minimum && value <= option->maximum;
}

// A whole number in the option's range at the start of *text, which moves
// behind it.
static bool read_integer(const Option *option, const char **text, int *value)
{
    char *end = NULL;
    if (**text < '0' || **text > '9') {
        return false; // strtol would skip blanks and take a sign
    }
    errno = 0;
    long number = strtol(*text, &end, 10);
    if (errno != 0 || number > INT_MAX || !in_range(option, (double)number)) {
        return false;
    }
    *text = end;
    *value = (int)number;
    return true;
}

static bool read_extent(const Option *option, const char *text, int extent[2])
{
    if (!read_integer(option, &text, &extent[0])) {
        return false;
    }
    if (option->kind == OPTION_SIDE && *text == '\0') {
        extent[1] = extent[0];
        return true;
    }
    return *text++ == 'x' && read_integer(option, &text, &extent[1]) &&
           *text == '\0';
}

static bool read_number(const Option *option, const char *text, double *value)
{
    if (option->choices != NULL && strcmp(text, option->choices) == 0) {
        *value = OPTION_AUTO;
        return true;
    }
    char *end = NULL;
    *value = strtod(text, &end);
    return end != text && *end == '\0' && isfinite(*value) &&
           in_range(option, *value);
}

static bool read_choice(const Option *option, const char *text,
                        const char **value)
{
    size_t length = strlen(text);
    *value = text;
    const char *choice = option->choices;
    while (choice != NULL && length > 0 && strchr(text, ',') == NULL) {
        if (strncmp(choice, text, length) == 0 &&
            (choice[length] == ',' || choice[length] == '\0')) {
            return true;
        }
        choice = strchr(choice, ',');
        choice = choice == NULL ? NULL : choice + 1;
    }
    return false;
}

static bool read_value(const Option *option, const char *text, void *value)
{
    int *integer = value;
    switch (option->kind) {
    case OPTION_FLAG:
        *(bool *)value = true;
        return true;
    case OPTION_TEXT:
        *(const char **)value = text;
        return *text != '\0';
    case OPTION_CHOICE:
        return read_choice(option, text, value);
    case OPTION_INTEGER:
        return read_integer(option, &text, integer) && *text == '\0';
    case OPTION_ODD:
        return read_integer(option, &text, integer) && *text == '\0' &&
               *integer % 2 == 1;
    case OPTION_NUMBER:
        return read_number(option, text, value);
    default:
        return read_extent(option, text, value);
    }
}

// Above every letter that getopt_long returns for itself.
enum { FIRST_VALUE = 256, KNOWN_OPTIONS = 2 * OPTIONS_MAX };

// All tables as one list for getopt_long. Each option's value says its table
// and its place there; if they were equal, getopt would take --s for any of
// those that begin with s.
static void join_tables(const OptionTable tables[],
                        struct option list[KNOWN_OPTIONS])
{
    int count = 0;
    for (int t = 0; tables[t].options; t++) {
        for (int i = 0; tables[t].options[i].name; i++) {
            if (count + 1 == KNOWN_OPTIONS || i == OPTIONS_MAX) {
                die("more than %d options", count);
            }
            bool flag = tables[t].options[i].kind == OPTION_FLAG;
            list[count].name = tables[t].options[i].name;
            list[count].has_arg = flag ? no_argument : required_argument;
            list[count++].val = FIRST_VALUE + OPTIONS_MAX * t + i;
        }
    }
}

static void help_if_asked(int argc, char **argv, const OptionTable tables[])
{
    for (int i = 1; i < argc; i++) {
        if (strcmp(argv[i], "--help") == 0) {
            print_help(argv[0], tables);
            printed_check();
            exit(0);
        }
    }
}

OptionTable options_table(const Option *options, void *settings)
{
    return (OptionTable){.options = options, .settings = settings};
}

void options_parse(int argc, char **argv, OptionTable tables[])
{
    struct option list[KNOWN_OPTIONS] = {{0}};
    if (safety_prepare != NULL) {
        safety_prepare();
    }
    join_tables(tables, list);
    // Before any value is read: the help shows the defaults.
    help_if_asked(argc, argv, tables);
    opterr = 0; // our messages, one line each
    int result;
    while ((result = getopt_long(argc, argv, ":", list, NULL)) >= FIRST_VALUE) {
        OptionTable *table = &tables[(result - FIRST_VALUE) / OPTIONS_MAX];
        int place = (result - FIRST_VALUE) % OPTIONS_MAX;
        const Option *option = &table->options[place];
        const char *text = optarg == NULL ? "" : optarg;
        if (!read_value(option, text, value_of(table, option))) {
            refuse(option, text);
        }
        table->given[place] = true;
    }
    if (result == ':') {
        die_usage("%s wants a value; see --help", argv[optind - 1]);
    }
    if (result == '?') {
        die_usage("unknown option '%s'; see --help", argv[optind - 1]);
    }
    if (optind < argc) {
        die_usage("'%s' is no option; see --help", argv[optind]);
    }
}

bool options_given(const OptionTable tables[], const char *name)
{
    for (const OptionTable *table = tables; table->options; table++) {
        for (int i = 0; table->options[i].name; i++) {
            if (strcmp(table->options[i].name, name) == 0) {
                return table->given[i];
            }
        }
    }
    return false;
}
