#include "step1_shadowmap/base/run/run.h"

#include <stdarg.h> // va_start
#include <stdio.h>  // vsnprintf

#include "step1_shadowmap/base/picture/dump.h" // dump_target
#include "step1_shadowmap/base/run/extras.h"   // leave_out_look, bench_next

void run_options(Run *run, int argc, char **argv, int step, const char *program,
                 const ShowMode *more_shows, const OptionTable tables[])
{
    Frame *frame = &run->frame;
    int count = 0;
    base_settings(&frame->settings, step, program, more_shows);
    frame->options[count++] = options_table(base_options, &frame->settings);
    if (bench_options != NULL) {
        frame->options[count++] = bench_options();
    }
    if (leave_out_options != NULL) {
        frame->options[count++] = leave_out_options(&frame->settings);
    }
    for (; tables->options != NULL; tables++) {
        frame->options[count++] = *tables;
    }
    if (techniques_join != NULL) {
        techniques_join(frame->options, count);
    }
    options_parse(argc, argv, frame->options);
    if (bench_check != NULL) {
        bench_check(frame);
    }
    if (techniques_check != NULL) {
        techniques_check(frame);
    }
}

void run_begin(Run *run)
{
    Frame *frame = &run->frame;
    const BaseSettings *settings = &frame->settings;
    base_settings_check(settings);
    scene_create(&frame->scene, settings->scene, settings->light);
    frame->changes = settings->window || frame->changes;
    run->context = context_create(settings->window, settings->size);
    frame->shaders.directory = settings->shaders;
    frame->geometry = geometry_create(&frame->scene);
    glGenVertexArrays(1, &frame->empty_vao);
}

// Without leave_out everything is drawn.
static void look(Frame *frame)
{
    const ViewsSize size = base_views_size(&frame->settings);
    if (leave_out_look != NULL) {
        leave_out_look(frame);
    } else {
        views_fit(&frame->views, &frame->scene, &size, frame->lookups.reach);
        frame->looks_up = true;
    }
}

void run_look(Run *run)
{
    if (techniques_prepare != NULL) {
        techniques_prepare(&run->frame);
    }
    look(&run->frame);
}

// Every map is drawn once more, all of it: the picture may have needed less.
static bool next_dump(Run *run)
{
    Frame *frame = &run->frame;
    const BaseSettings *settings = &frame->settings;
    if (settings->dump == NULL || frame->dump != NULL ||
        (leave_out_nothing != NULL && !leave_out_nothing(frame))) {
        return false;
    }
    frame->dump = settings->dump;
    base_prepare_files(&frame->settings, frame->options);
    if (techniques_before != NULL) {
        techniques_before(frame);
    }
    return true;
}

static bool next_in_window(Run *run)
{
    Frame *frame = &run->frame;
    Window *window = &run->window;
    if (run->drawn > 0) {
        window_show(window, frame, run->picture);
    }
    if (!window_next(window, &frame->settings, &frame->scene.camera)) {
        return false;
    }
    if (window->reload) {
        window->shader_error = !gl_reload(&frame->shaders);
    }
    return true;
}

static void begin_first(Run *run, Picture *picture, const char *subject)
{
    Frame *frame = &run->frame;
    run->picture = picture;
    if (measure_print_shader != NULL) {
        measure_print_shader(frame, picture->program);
    }
    if (frame->settings.window) {
        base_prepare_files(&frame->settings, frame->options);
        run->window = window_create(&run->context, &frame->shaders, subject);
        gl_compile(&frame->shaders);
    }
}

bool run_next(Run *run, Picture *picture, const char *subject, ...)
{
    Frame *frame = &run->frame;
    if (run->drawn == 0) {
        char text[80];
        va_list arguments;
        va_start(arguments, subject);
        vsnprintf(text, sizeof text, subject, arguments);
        va_end(arguments);
        begin_first(run, picture, text);
    }
    bool another = frame->settings.window ? next_in_window(run)
                   : bench_next != NULL   ? bench_next(frame, run->drawn)
                                          : run->drawn == 0;
    if (!another) {
        return next_dump(run);
    }
    run->drawn++;
    if (frame_start != NULL) {
        frame_start();
    }
    look(frame);
    if (leave_out_begin != NULL) {
        leave_out_begin(frame, run->window.reload);
    }
    if (techniques_before != NULL) {
        techniques_before(frame);
    }
    return true;
}

static void write_dump(Run *run, const char *directory)
{
    Frame *frame = &run->frame;
    picture_dump(run->picture, directory);
    for (int i = 0; i < frame->targets.count; i++) {
        if (frame->targets.list[i]->file != NULL && frame->dump != NULL) {
            dump_target(frame->targets.list[i], directory);
        }
    }
    if (measure_dump != NULL) {
        measure_dump(frame);
    }
}

static void write_files(Run *run)
{
    BaseSettings *settings = &run->frame.settings;
    base_prepare_files(settings, run->frame.options);
    if (settings->dump != NULL) {
        write_dump(run, settings->dump);
    }
    if (settings->output != NULL) {
        picture_write(run->picture, settings->output);
        base_say_written(settings, settings->output, "");
    }
    if (settings->dump != NULL) {
        base_say_written(settings, settings->dump, "/");
    }
    if (bench_print != NULL) {
        bench_print();
    }
}

void run_end(Run *run)
{
    Frame *frame = &run->frame;
    if (!frame->settings.window) {
        write_files(run);
    }
    targets_destroy(&frame->targets);
    gl_destroy_programs(&frame->shaders);
    glDeleteVertexArrays(1, &frame->empty_vao);
    geometry_destroy(&frame->geometry);
    context_destroy(&run->context);
    scene_destroy(&frame->scene);
}
