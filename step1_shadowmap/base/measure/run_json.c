// run.json, which says how the files of --dump were made. The tests recompute
// each stage from these files.
#define _POSIX_C_SOURCE 200809L // open_memstream

#include <stdlib.h> // free

#include "step1_shadowmap/base/files/file.h"        // file_write
#include "step1_shadowmap/base/measure/stopwatch.h" // measure_clock
#include "step1_shadowmap/base/run/extras.h"        // measure_dump
#include "step1_shadowmap/base/system/die.h"        // die

// As a JSON string, quoted and escaped.
static void write_text(FILE *file, const char *text)
{
    fputc('"', file);
    for (; *text != '\0'; text++) {
        unsigned char letter = (unsigned char)*text;
        if (letter == '"' || letter == '\\') {
            fprintf(file, "\\%c", letter);
        } else if (letter < ' ') {
            fprintf(file, "\\u%04x", letter);
        } else {
            fputc(letter, file);
        }
    }
    fputc('"', file);
}

static void write_options(FILE *file, const OptionTable tables[])
{
    const char *separator = "";
    for (const OptionTable *table = tables; table->options; table++) {
        for (const Option *option = table->options; option->name; option++) {
            fprintf(file, "%s\n    \"%s\": ", separator, option->name);
            options_write_value(file, table, option, write_text);
            separator = ",";
        }
    }
}

static void write_matrix(FILE *file, const double matrix[4][4])
{
    for (int row = 0; row < 4; row++) {
        const double *m = matrix[row];
        fprintf(file, "%s[%.17g, %.17g, %.17g, %.17g]", row ? ", " : "[", m[0],
                m[1], m[2], m[3]);
    }
    fputs("]", file);
}

// The light's position and half cone are written where it has them.
static void write_place(FILE *file, const Views *views, const Light *light)
{
    const double *position = views->light_position;
    if (light->kind != LIGHT_DIRECTIONAL) {
        fprintf(file, ", \"position\": [%.17g, %.17g, %.17g]", position[0],
                position[1], position[2]);
    }
    if (light->kind == LIGHT_SPOT) {
        fprintf(file, ", \"cone\": %.17g", light->cone);
    }
}

static void write_looked_up(FILE *file, const Rect *rect)
{
    fprintf(file, ", \"looked_up\": [%d, %d, %d, %d]", rect->low[0],
            rect->low[1], rect->high[0], rect->high[1]);
}

static void write_views(FILE *file, const Views *views, const Light *light)
{
    const double *origin = views->origin;
    fprintf(file, "  \"origin\": [%.17g, %.17g, %.17g],\n", origin[0],
            origin[1], origin[2]);
    fputs("  \"clip_from_relative\": ", file);
    write_matrix(file, views->clip_from_relative);
    fprintf(file, ",\n  \"light\": \"%s\",\n  \"views\": [",
            light_kind_name(light->kind));
    for (int i = 0; i < views->layers; i++) {
        const LightView *view = &views->light[i];
        fprintf(file, "%s\n    {\"map_from_relative\": ", i ? "," : "");
        write_matrix(file, view->map_from_relative);
        fprintf(file,
                ", \"near\": %.17g, \"far\": %.17g, \"width\": %d, "
                "\"height\": %d, \"border\": %d",
                view->near, view->far, views->width, views->height,
                views->border);
        write_place(file, views, light);
        write_looked_up(file, &view->looked_up);
        if (view->end > 0) {
            fprintf(file, ", \"handover\": %.17g, \"end\": %.17g",
                    view->handover, view->end);
        }
        fputs("}", file);
    }
    fputs("],\n", file);
}

static void write_passes(FILE *file, const Stopwatch *stopwatch)
{
    fputs("  \"passes\": [", file);
    for (int i = 0; i < stopwatch->passes; i++) {
        fprintf(file, "%s{\"name\": \"%s\", \"ms\": %.6g}", i ? ", " : "",
                stopwatch->name[i], stopwatch->milliseconds[i]);
    }
    fputs("]\n", file);
}

static void write_run(FILE *file, const Frame *frame)
{
    const BaseSettings *base = &frame->settings;
    fprintf(file, "{\n  \"program\": \"%s\",\n  \"step\": %d,\n", base->program,
            base->step);
    fputs("  \"scene\": ", file);
    write_text(file, base->scene);
    fputs(",\n  \"options\": {", file);
    write_options(file, frame->options);
    fputs("\n  },\n", file);
    write_views(file, &frame->views, &frame->scene.light);
    fprintf(file, "  \"map_bytes\": %zu,\n",
            targets_map_bytes(&frame->targets));
    fprintf(file, "  \"gl_renderer\": \"%s\",\n",
            (const char *)glGetString(GL_RENDERER));
    fprintf(file, "  \"gl_version\": \"%s\",\n",
            (const char *)glGetString(GL_VERSION));
    write_passes(file, measure_clock());
    fputs("}\n", file);
}

void measure_dump(const Frame *frame)
{
    char path[FILE_NAME_BYTES];
    char *text = NULL;
    size_t length = 0;
    snprintf(path, sizeof path, "%s/run.json", frame->settings.dump);
    FILE *memory = open_memstream(&text, &length);
    if (memory == NULL) {
        die("no memory for %s", path);
    }
    write_run(memory, frame);
    if (fclose(memory) != 0) {
        die("no memory for %s", path);
    }
    file_write(path, text, length);
    free(text);
}
