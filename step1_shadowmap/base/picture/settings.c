#include "step1_shadowmap/base/picture/settings.h"

#include <stdio.h>  // snprintf, stdout
#include <stdlib.h> // exit
#include <string.h> // strcmp, strrchr

#include "step1_shadowmap/base/system/die.h" // die_usage
#include "step1_shadowmap/base/files/file.h" // file_is_directory, file_make_directory
#include "step1_shadowmap/base/files/image.h" // image_name_is_known
#include "step1_shadowmap/base/scene/scene.h" // scene_list

enum { MAX_SIDE = 32768 };

const Option base_options[] = {
    {"scene", OPTION_TEXT, offsetof(BaseSettings, scene), 0, 0, NULL,
     "NAME[:key=value,...]", "the scene to draw"},
    {"list-scenes", OPTION_FLAG, offsetof(BaseSettings, list_scenes), 0, 0,
     NULL, NULL, "print every scene with its keys, ranges and defaults"},
    {"size", OPTION_EXTENT, offsetof(BaseSettings, size), 1, MAX_SIDE, NULL,
     "WxH", "the picture, in pixels"},
    {"map-size", OPTION_SIDE, offsetof(BaseSettings, map_size), 1, MAX_SIDE,
     NULL, "N or WxH", "the shadow map, in texels"},
    {"output", OPTION_TEXT, offsetof(BaseSettings, output), 0, 0, NULL, "FILE",
     "the picture: .png (8-bit sRGB) or .exr (linear float); where something "
     "else is asked for, none unless this names one"},
    {"show", OPTION_TEXT, offsetof(BaseSettings, show), 0, 0, NULL, "WHAT",
     "shaded, visibility (1 lit, 0 in shadow), depth, or what the step and its "
     "techniques add: any other word lists them"},
    {"dump", OPTION_TEXT, offsetof(BaseSettings, dump), 0, 0, NULL, "DIR",
     "write every intermediate map there, as float EXR"},
    {"shaders", OPTION_TEXT, offsetof(BaseSettings, shaders), 0, 0, NULL, "DIR",
     "look for shader files there first (laid out as in the tree)"},
    {"window", OPTION_FLAG, offsetof(BaseSettings, window), 0, 0, NULL, NULL,
     "show the scene in a window; there, h prints the keys"},
    {"context", OPTION_CHOICE, offsetof(BaseSettings, context), 0, 0, "osmesa",
     NULL, "where OpenGL draws without a window"},
    {0},
};

static const ShowMode shows[] = {
    {"shaded", "step1_shadowmap/base/picture/shaders/show_shaded.glsl", NULL,
     NULL, false},
    {"visibility", "step1_shadowmap/base/picture/shaders/show_visibility.glsl",
     NULL, NULL, false},
    {"depth", "step1_shadowmap/base/picture/shaders/show_depth.glsl",
     "step1_shadowmap/base/picture/shaders/scale_grey.glsl",
     "0 near     depth from the light    1 far", false},
    {NULL, NULL, NULL, NULL, false},
};

void base_add_shows(BaseSettings *settings, const ShowMode more[])
{
    for (int i = 0; i < SHOWS_MAX; i++) {
        if (settings->shows[i] == NULL) {
            settings->shows[i] = more;
            return;
        }
    }
    die("more than %d lists of --show", SHOWS_MAX);
}

const ShowMode *base_show_mode(const BaseSettings *settings)
{
    char names[128] = "";
    for (int i = 0; i < SHOWS_MAX && settings->shows[i] != NULL; i++) {
        const ShowMode *mode = settings->shows[i];
        for (; mode->name != NULL; mode++) {
            size_t length = strlen(names);
            if (strcmp(mode->name, settings->show) == 0) {
                return mode;
            }
            snprintf(names + length, sizeof names - length, ", %s", mode->name);
        }
    }
    die_usage("--show '%s': allowed are %s", settings->show, names + 2);
}

void base_settings(BaseSettings *settings, int step, const char *program,
                   const ShowMode *more_shows)
{
    *settings = (BaseSettings){.program = program,
                               .step = step,
                               .shows = {shows, more_shows},
                               .scene = "teapot",
                               .size = {1280, 720},
                               .map_size = {512, 512},
                               .output = settings->default_output,
                               .show = "shaded",
                               .context = "osmesa"};
    snprintf(settings->default_output, sizeof settings->default_output,
             "out/%s.png", program);
}

void base_settings_check(const BaseSettings *settings)
{
    if (settings->list_scenes) {
        scene_list(stdout);
        printed_check();
        exit(0);
    }
    base_show_mode(settings); // refuses a wrong one
    file_check_shaders(settings->shaders);
    if (!image_name_is_known(settings->output)) {
        die_usage("--output '%s': the name has to end in .png or .exr",
                  settings->output);
    }
    if (settings->window && settings->dump != NULL) {
        die_usage("--dump keeps one frame, --window draws many: drop --dump "
                  "or --window");
    }
}

// Of the default output, which is in one.
static void make_output_directory(const char *output)
{
    char directory[FILE_NAME_BYTES];
    snprintf(directory, sizeof directory, "%.*s",
             (int)(strrchr(output, '/') - output), output);
    file_make_directory(directory);
}

void base_prepare_files(BaseSettings *settings, const OptionTable tables[])
{
    bool other = settings->dump != NULL || settings->prints;
    if (settings->dump != NULL) {
        file_make_directory(settings->dump);
    }
    if (options_given(tables, "output")) {
        return;
    }
    if (other && !settings->window) {
        settings->output = NULL;
    } else {
        make_output_directory(settings->output);
    }
}

void base_say_written(const BaseSettings *settings, const char *path,
                      const char *ending)
{
    fprintf(settings->prints ? stderr : stdout, "wrote %s%s\n", path, ending);
    printed_check();
}

ViewsSize base_views_size(const BaseSettings *settings)
{
    return (ViewsSize){{settings->size[0], settings->size[1]},
                       {settings->map_size[0], settings->map_size[1]},
                       settings->fit};
}
