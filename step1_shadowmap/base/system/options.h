// Long command-line options. Each stage has one table of the options that it
// adds; main.c joins the tables of the stages that it is made of.
#ifndef BASE_OPTIONS_H
#define BASE_OPTIONS_H

#include <stdbool.h>
#include <stddef.h> // offsetof, for the tables
#include <stdio.h>  // FILE

typedef enum OptionKind {
    OPTION_FLAG,    // bool, no argument
    OPTION_TEXT,    // const char *, any text
    OPTION_CHOICE,  // const char *, one of `choices`
    OPTION_INTEGER, // int in [minimum, maximum]
    OPTION_ODD,     // the same, odd numbers only
    OPTION_NUMBER,  // double in [minimum, maximum], or the word in `choices`,
                    // which is stored as OPTION_AUTO
    OPTION_EXTENT,  // int[2] "WxH", each in [minimum, maximum]
    OPTION_SIDE     // the same, or one number for both
} OptionKind;

#define OPTION_AUTO (-1.0)

typedef struct Option {
    const char *name; // without the dashes
    OptionKind kind;
    size_t offset; // of the value in the stage's settings
    double minimum, maximum;
    const char *choices;  // "shaded,visibility"
    const char *argument; // what --help calls the value; NULL: the choices
    const char *help;     // one line, with the unit
} Option;

enum { OPTIONS_MAX = 32 };

typedef struct OptionTable {
    const Option *options;   // ends with a NULL name
    void *settings;          // holds the defaults before options_parse
    bool given[OPTIONS_MAX]; // which of them the command line named
} OptionTable;

// A stage's options and its settings, for the list that main.c joins.
OptionTable options_table(const Option *options, void *settings);

// Reads the command line into the tables' settings. --help prints every
// option with its default and unit and exits with 0. An unknown option, a bad
// value or a left-over argument exits with 2 and one line on stderr. The last
// table has NULL options.
void options_parse(int argc, char **argv, OptionTable tables[]);

// Whether the command line named this option.
bool options_given(const OptionTable tables[], const char *name);

// An option's value, of which texts are written by `write_text`.
void options_write_value(FILE *file, const OptionTable *table,
                         const Option *option,
                         void write_text(FILE *, const char *));

#endif
