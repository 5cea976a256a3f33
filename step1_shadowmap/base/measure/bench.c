// --bench: the times of many frames. --move: what moves from one to the next.
#include <stdio.h>  // printf
#include <stdlib.h> // free, qsort
#include <string.h> // memcpy, strcmp

#include "step1_shadowmap/base/measure/stopwatch.h" // measure_clock
#include "step1_shadowmap/base/run/extras.h"        // bench_options, ...
#include "step1_shadowmap/base/system/die.h" // allocate, complain, die_usage

enum {
    MAX_FRAMES = 1024, // the warm-up included
    WARM_UP = 3        // frames: a program's code is made at its first draw
};

static struct Bench {
    int bench; // frames to time, or 0
    bool print_shader;
    const char *move; // objects that move between frames, or NULL
    Stopwatch last;   // of the last frame
    double milliseconds[STOPWATCH_MAX_PASSES][MAX_FRAMES];
} state;

static const Option options[] = {
    {.name = "bench",
     .kind = OPTION_INTEGER,
     .offset = offsetof(struct Bench, bench),
     .minimum = 0,
     .maximum = MAX_FRAMES - WARM_UP,
     .argument = "N",
     .help = "time N frames after a warm-up; prints each pass's times, and the "
             "texels and bytes that it touches, as CSV"},
    {.name = "print-shader",
     .kind = OPTION_FLAG,
     .offset = offsetof(struct Bench, print_shader),
     .help = "print the picture's shader program, with the names of its files, "
             "and exit"},
    {.name = "move",
     .kind = OPTION_TEXT,
     .offset = offsetof(struct Bench, move),
     .argument = "NAME",
     .help = "with --bench: from frame to frame the scene's objects of this "
             "name rise by a hundredth of their height"},
    {0},
};

OptionTable bench_options(void)
{
    return options_table(options, &state);
}

void bench_check(Frame *frame)
{
    if (frame->settings.window && state.bench > 0) {
        die_usage("--bench times frames that are all the same, in --window "
                  "they change: drop --bench or --window");
    }
    if (state.move != NULL && state.bench == 0) {
        die_usage("--move %s is from frame to frame: add --bench, or drop "
                  "--move",
                  state.move);
    }
    frame->settings.prints = frame->settings.prints || state.bench > 0;
    frame->settings.print_shader = state.print_shader;
    frame->changes = frame->changes || state.move != NULL;
}

static void rise(Object *object)
{
    double *row = object->transform[1];
    row[3] +=
        0.01 * row[1] * (double)(object->mesh->high[1] - object->mesh->low[1]);
}

// Of the name that --move says; at the first frame they only have to be there.
static void move_objects(Scene *scene, bool first)
{
    int count = 0;
    for (int i = 0; i < scene->object_count; i++) {
        if (strcmp(scene->objects[i].name, state.move) == 0) {
            count++;
            if (!first) {
                rise(&scene->objects[i]);
            }
        }
    }
    if (count == 0) {
        die_usage("--move '%s': no object of scene %s has that name; one is "
                  "'%s'",
                  state.move, scene->name,
                  scene->objects[scene->object_count - 1].name);
    }
}

static void keep_times(const Stopwatch *clock, int frame)
{
    state.last = *clock;
    for (int pass = 0; pass < clock->passes; pass++) {
        state.milliseconds[pass][frame] = clock->milliseconds[pass];
    }
}

bool bench_next(Frame *frame, int drawn)
{
    bool another = drawn < (state.bench > 0 ? state.bench + WARM_UP : 1);
    if (drawn > 0 && state.bench > 0) {
        keep_times(measure_clock(), drawn - 1);
    }
    if (state.move != NULL && another) {
        move_objects(&frame->scene, drawn == 0);
    }
    return another;
}

static int compare(const void *a, const void *b)
{
    double x = *(const double *)a;
    double y = *(const double *)b;
    return (x > y) - (x < y);
}

// The value below which `part` of the sorted samples lie, interpolated.
static double quantile(const double *sorted, int count, double part)
{
    double place = part * (count - 1);
    int index = (int)place;
    int next = index + 1 < count ? index + 1 : index;
    return sorted[index] + (place - index) * (sorted[next] - sorted[index]);
}

static void print_line(const char *name, const double *samples,
                       const Touched *touched)
{
    int count = state.bench;
    size_t bytes = (size_t)count * sizeof *samples;
    double *sorted = allocate(1, bytes);
    memcpy(sorted, samples, bytes);
    qsort(sorted, (size_t)count, sizeof *sorted, compare);
    printf("%s,%.4f,%.4f,%.4f,%d,glFinish+CLOCK_MONOTONIC,%zu,%zu,", name,
           quantile(sorted, count, 0.5), quantile(sorted, count, 0.25),
           quantile(sorted, count, 0.75), count, touched->texels,
           touched->bytes);
    for (int i = 0; i < count; i++) {
        printf("%s%.4f", i ? " " : "", samples[i]);
    }
    putchar('\n');
    free(sorted);
}

// As CSV: a header, and for each pass and for their total the name, median,
// first and third quartile over the frames after the warm-up (milliseconds),
// the number of these frames, the clock, texels and bytes touched by the last
// frame, and each frame's time, so that several runs can be pooled.
static void print_times(void)
{
    double *total = allocate((size_t)state.bench, sizeof *total);
    Touched touched = {0, 0};
    puts("pass,median_ms,quartile1_ms,quartile3_ms,frames,clock,texels,bytes,"
         "samples_ms");
    for (int pass = 0; pass < state.last.passes; pass++) {
        const double *samples = state.milliseconds[pass] + WARM_UP;
        for (int i = 0; i < state.bench; i++) {
            total[i] += samples[i];
        }
        touched.texels += state.last.touched[pass].texels;
        touched.bytes += state.last.touched[pass].bytes;
        print_line(state.last.name[pass], samples, &state.last.touched[pass]);
    }
    print_line("total", total, &touched);
    free(total);
    printed_check();
}

void bench_print(void)
{
    if (state.bench == 0) {
        return;
    }
    print_times();
    if (state.last.passes > 1 && state.last.touched[0].texels == 0) {
        complain("nothing changed after the first frame, so the map was kept: "
                 "its passes drew nothing; --redraw times them");
    }
}
