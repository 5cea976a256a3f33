// Step 4: blur. The moments are averaged; comparing with their mean is wrong.

#include "step1_shadowmap/base/run/run.h" // run_next
#include "step3_moments/moments.h"        // moments_draw
#include "step4_blur/blur.h"              // blur_apply

static struct {
    Run run;
    BiasSettings bias;
    BlurSettings filter;
    Moments moments;
    Blur blur;
    Picture picture;
} state;

static void read_options(int argc, char **argv)
{
    state.bias = bias_settings();
    state.filter = blur_settings();
    const OptionTable tables[] = {options_table(bias_options, &state.bias),
                                  options_table(blur_options, &state.filter),
                                  {0}};
    run_options(&state.run, argc, argv, 4, "step4_blur", moments_shows, tables);
    blur_check(&state.filter, &state.run.frame.settings);
}

static void create(Frame *frame)
{
    static const char *const visibility[] = {
        "step1_shadowmap/shaders/depth_slope.glsl",
        "step1_shadowmap/shaders/bias.glsl",
        "step3_moments/shaders/lookup_bilinear.glsl",
        "step3_moments/shaders/mean.glsl", NULL};
    int reach = blur_reach(&state.filter);
    run_begin(&state.run);
    // The reach sets the map's border. The rest is for base/leave_out and
    // --plan, and changes no pixel: the mean is one of so wide a square.
    frame->lookups = bias_lookups(&state.bias, reach, 2 * reach + 1);
    run_look(&state.run);
    moments_create(&state.moments, frame, 0);
    blur_create(&state.blur, frame, &state.filter, &state.moments.target);
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
    picture_draw(&state.picture, frame);
    frame_lap(frame, "shading");
}

int main(int argc, char **argv)
{
    Frame *frame = &state.run.frame;
    read_options(argc, argv);
    create(frame);
    while (run_next(&state.run, &state.picture, "step 4, radius %d",
                    state.filter.radius)) {
        draw(frame);
    }
    run_end(&state.run);
    return 0;
}
