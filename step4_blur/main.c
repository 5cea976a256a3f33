// Step 4: blur. The moments are averaged; comparing with their mean is wrong.

#include "step1_shadowmap/base/run/run.h" // run_next
#include "step3_moments/moments.h"        // moments_draw
#include "step4_blur/blur.h"              // blur_apply

static struct {
    Run run;
    BiasSettings bias;
    MomentsSettings moments_settings;
    BlurSettings blur_settings;
    Moments moments;
    Blur blur;
    Picture picture;
} state;

static void read_options(int argc, char **argv)
{
    Frame *frame = &state.run.frame;
    state.bias = bias_settings();
    state.moments_settings = moments_settings();
    state.blur_settings = blur_settings();
    const OptionTable tables[] = {
        options_table(bias_options, &state.bias),
        options_table(moments_options, &state.moments_settings),
        options_table(blur_options, &state.blur_settings),
        {0}};
    run_options(&state.run, argc, argv, 4, "step4_blur", moments_shows, tables);
    moments_settings_check(&state.moments_settings, &frame->settings,
                           frame->options);
    blur_check(&state.blur_settings, &state.moments_settings, &frame->settings,
               frame->options);
}

static void create(Frame *frame)
{
    const char *visibility[BLUR_MAX_SHADERS + 2] = {
        "step1_shadowmap/shaders/depth_slope.glsl",
        "step1_shadowmap/shaders/bias.glsl"};
    blur_picture_shaders(&state.blur_settings, &state.moments_settings,
                         "step3_moments/shaders/mean.glsl", &visibility[2]);
    run_begin(&state.run);
    frame->lookups = blur_lookups(&state.blur_settings, &state.moments_settings,
                                  &state.bias);
    run_look(&state.run);
    moments_create(&state.moments, frame, &state.moments_settings, 0);
    blur_create(&state.blur, frame, &state.blur_settings, &state.moments);
    picture_create(&state.picture, frame, &state.blur.result, NULL, visibility);
}

static void draw(Frame *frame)
{
    moments_draw(&state.moments, frame);
    frame_lap(frame, "moments");
    blur_apply(&state.blur, frame);
    frame_lap(frame, "blur");
    GLuint program = picture_begin(&state.picture, frame);
    bias_apply(&state.bias, program);
    blur_set_lookup(&state.blur, frame, program);
    picture_draw(&state.picture, frame);
    frame_lap(frame, "shading");
}

int main(int argc, char **argv)
{
    Frame *frame = &state.run.frame;
    read_options(argc, argv);
    create(frame);
    while (run_next(&state.run, &state.picture, "step 4, radius %d",
                    state.blur_settings.radius)) {
        draw(frame);
    }
    run_end(&state.run);
    return 0;
}
