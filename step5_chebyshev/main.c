// Step 5: variance shadow mapping. The filtered moments bound how much light
// can arrive; the bound is the shadow.

#include "step1_shadowmap/base/run/run.h" // run_next
#include "step3_moments/moments.h"        // moments_draw
#include "step4_blur/blur.h"              // blur_apply
#include "step5_chebyshev/deferred.h"     // deferred_draw
#include "step5_chebyshev/shading.h"      // shading_picture

static struct {
    Run run;
    ShadingSettings settings;
    Moments moments;
    Blur blur;
    Picture picture;
    Deferred deferred;
} state;

static void read_options(int argc, char **argv)
{
    Frame *frame = &state.run.frame;
    ShadingSettings *settings = &state.settings;
    *settings = shading_settings();
    const OptionTable tables[] = {
        options_table(moments_options, &settings->moments),
        options_table(blur_options, &settings->blur),
        options_table(chebyshev_options, &settings->chebyshev),
        options_table(shading_options, settings),
        {0}};
    run_options(&state.run, argc, argv, 5, "step5_chebyshev", moments_shows,
                tables);
    shading_check(settings, &frame->settings, frame->options);
}

static void create(Frame *frame)
{
    ShadingSettings *settings = &state.settings;
    run_begin(&state.run);
    frame->lookups = shading_lookups(settings, frame);
    run_look(&state.run);
    moments_create(&state.moments, frame, &settings->moments, 0);
    blur_create(&state.blur, frame, &settings->blur, &state.moments);
    shading_picture(settings, &state.picture, frame, &state.blur);
    deferred_create(&state.deferred, frame, settings->deferred, &state.picture);
}

static void draw(Frame *frame)
{
    moments_draw(&state.moments, frame);
    frame_lap(frame, "moments");
    blur_apply(&state.blur, frame);
    frame_lap(frame, "blur");
    GLuint program = picture_begin(&state.picture, frame);
    blur_set_lookup(&state.blur, frame, program);
    shading_apply(&state.settings, &frame->views, program);
    deferred_draw(&state.deferred, &state.picture, frame);
    frame_lap(frame, "shading");
}

int main(int argc, char **argv)
{
    Frame *frame = &state.run.frame;
    read_options(argc, argv);
    create(frame);
    while (run_next(&state.run, &state.picture, "step 5, radius %d",
                    state.settings.blur.radius)) {
        draw(frame);
    }
    run_end(&state.run);
    return 0;
}
