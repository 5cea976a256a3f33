// The options that every step has.
#ifndef BASE_SETTINGS_H
#define BASE_SETTINGS_H

#include <stdbool.h>

#include "step1_shadowmap/base/system/options.h" // Option
#include "step1_shadowmap/base/light/view.h"     // ViewsSize

// One choice of --show.
typedef struct ShowMode {
    const char *name;
    const char *shader; // file that defines vec3 show(...)
    const char *scale;  // file that defines vec3 scale_color(float) for values
                        // from 0 to 1, which the legend shows; or NULL
    const char *legend; // what the scale means: "low .. what .. high"
    bool reads_map;     // every pixel looks the map up, lit or not
} ShowMode;

enum { SHOWS_MAX = 6 };

enum { OPTION_TABLES = 32 }; // that a program joins, and the empty one

typedef struct BaseSettings {
    const char *program; // stepN_what
    int step;            // N
    const char *scene;
    const char *light; // a kind, or NULL: the scene's own
    bool list_scenes;
    int size[2];             // of the picture, pixels
    int map_size[2];         // of the shadow map, texels
    const char *output;      // file, or NULL
    char default_output[32]; // that file if no option says otherwise
    const char *show;
    const ShowMode *shows[SHOWS_MAX]; // lists of its choices, then NULL
    const char *dump;                 // directory, or NULL
    const char *shaders;              // directory, or NULL
    bool print_shader; // the picture's program, in place of drawing
    bool window;
    const char *context;
    ViewsFit *fit; // of a light that is not parallel, or has many views
    bool prints; // the run is for what it prints on stdout: it writes a picture
                 // only where --output names one
} BaseSettings;

extern const Option base_options[];

// The defaults of a program, the step's number and its name (stepN_what), which
// writes out/stepN_what.png if no option says otherwise. `more_shows` are
// choices of --show besides the three that every step has, or NULL; the list
// ends with a NULL name.
void base_settings(BaseSettings *settings, int step, const char *program,
                   const ShowMode *more_shows);

// More choices of --show; the list ends with a NULL name.
void base_add_shows(BaseSettings *settings, const ShowMode more[]);

// The choice that --show names; refuses (status 2) any other name.
const ShowMode *base_show_mode(const BaseSettings *settings);

// Answers --list-scenes (and exits with 0), refuses an output name with an
// unknown ending and what a window cannot do (status 2). To be called after
// options_parse.
void base_settings_check(const BaseSettings *settings);

// Makes the directories of the default output and of --dump, once everything
// that could be wrong with the options has been looked at. --dump asks for
// something else than a picture, as what `prints` does: then there is an output
// only where --output names it, else it is NULL from here on.
void base_prepare_files(BaseSettings *settings, const OptionTable tables[]);

// Says that this file was written, or directory (`ending` "/"): on stdout, or
// on stderr where stdout is for what the run prints.
void base_say_written(const BaseSettings *settings, const char *path,
                      const char *ending);

// What the views are fitted to.
ViewsSize base_views_size(const BaseSettings *settings);

#endif
