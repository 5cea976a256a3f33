#define _POSIX_C_SOURCE 200809L // clock_gettime

#include "step1_shadowmap/base/system/stopwatch.h"

#include <glad/gl.h> // glFinish
#include <stdio.h>   // printf
#include <stdlib.h>  // free, qsort
#include <string.h>  // memcpy, strcmp
#include <time.h>    // clock_gettime

#include "step1_shadowmap/base/system/die.h"     // allocate, complain, die
#include "step1_shadowmap/base/system/printed.h" // printed_check

static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec * 1e3 + (double)time.tv_nsec * 1e-6;
}

void touch(Touched *touched, size_t texels, size_t bytes_for_each)
{
    touched->texels += texels;
    touched->bytes += texels * bytes_for_each;
}

void stopwatch_start(Stopwatch *stopwatch)
{
    glFinish();
    stopwatch->pass = 0;
    if (stopwatch->frames < STOPWATCH_MAX_FRAMES) {
        stopwatch->frames++;
    }
    stopwatch->started = now();
}

void stopwatch_lap(Stopwatch *stopwatch, const char *name, Touched touched)
{
    glFinish();
    int pass = 0;
    while (pass < stopwatch->pass && strcmp(stopwatch->name[pass], name) != 0) {
        pass++;
    }
    if (pass == STOPWATCH_MAX_PASSES) {
        die("more than %d passes to time", STOPWATCH_MAX_PASSES);
    }
    double time = now();
    double *lap = &stopwatch->milliseconds[pass][stopwatch->frames - 1];
    if (pass == stopwatch->pass) {
        stopwatch->passes = ++stopwatch->pass;
        stopwatch->name[pass] = name;
        stopwatch->touched[pass] = (Touched){0, 0};
        *lap = 0;
    }
    stopwatch->touched[pass].texels += touched.texels;
    stopwatch->touched[pass].bytes += touched.bytes;
    *lap += time - stopwatch->started;
    stopwatch->started = time;
}

double stopwatch_last(const Stopwatch *stopwatch, int pass)
{
    return stopwatch->milliseconds[pass][stopwatch->frames - 1];
}

double stopwatch_total(const Stopwatch *stopwatch)
{
    double total = 0;
    for (int pass = 0; pass < stopwatch->passes; pass++) {
        total += stopwatch_last(stopwatch, pass);
    }
    return total;
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

static void print_line(const char *name, const double *samples, int count,
                       const Touched *touched)
{
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

void stopwatch_print(const Stopwatch *stopwatch, int bench)
{
    if (bench == 0) {
        return;
    }
    int count = stopwatch->frames - STOPWATCH_WARM_UP;
    double *total = allocate((size_t)count, sizeof *total);
    Touched touched = {0, 0};
    puts("pass,median_ms,quartile1_ms,quartile3_ms,frames,clock,texels,bytes,"
         "samples_ms");
    for (int pass = 0; pass < stopwatch->passes; pass++) {
        const double *samples =
            stopwatch->milliseconds[pass] + STOPWATCH_WARM_UP;
        for (int i = 0; i < count; i++) {
            total[i] += samples[i];
        }
        touched.texels += stopwatch->touched[pass].texels;
        touched.bytes += stopwatch->touched[pass].bytes;
        print_line(stopwatch->name[pass], samples, count,
                   &stopwatch->touched[pass]);
    }
    print_line("total", total, count, &touched);
    free(total);
    printed_check();
    if (stopwatch->passes > 1 && stopwatch->touched[0].texels == 0) {
        complain("nothing changed after the first frame, so the map was kept: "
                 "its passes drew nothing; --redraw times them");
    }
}
