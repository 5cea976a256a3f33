// Step 3: moments. The map keeps two numbers per texel, the depth and its
// square. The picture still compares with one of them, the mean.

#include "step1_shadowmap/base/run/run.h" // run_next
#include "step3_moments/moments.h"        // moments_draw

enum { REACH = 1 }; // texels that a bilinear lookup reads to each side

static struct {
    Run run;
    BiasSettings bias;
    Moments moments;
    Picture picture;
} state;

static void read_options(int argc, char **argv)
{
    state.bias = bias_settings();
    const OptionTable tables[] = {options_table(bias_options, &state.bias),
                                  {0}};
    run_options(&state.run, argc, argv, 3, "step3_moments", moments_shows,
                tables);
}

static void create(Frame *frame)
{
    static const char *const visibility[] = {
        "step1_shadowmap/shaders/depth_slope.glsl",
        "step1_shadowmap/shaders/bias.glsl",
        "step3_moments/shaders/lookup_bilinear.glsl",
        "step3_moments/shaders/mean.glsl", NULL};
    run_begin(&state.run);
    // The reach sets the map's border. The rest is for base/leave_out and
    // --plan, and changes no pixel.
    frame->lookups = bias_lookups(&state.bias, REACH, 1);
    run_look(&state.run);
    moments_create(&state.moments, frame, REACH);
    picture_create(&state.picture, frame, &state.moments.target, NULL,
                   visibility);
}

static void draw(Frame *frame)
{
    moments_draw(&state.moments, frame);
    frame_lap(frame, "moments");
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
    while (run_next(&state.run, &state.picture, "step 3, map %dx%d",
                    frame->views.width, frame->views.height)) {
        draw(frame);
    }
    run_end(&state.run);
    return 0;
}
