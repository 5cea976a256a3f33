// Step 5: variance shadow mapping. The filtered moments bound how much light
// can arrive; the bound is the shadow.

#include "step1_shadowmap/base/run/run.h" // run_next
#include "step3_moments/moments.h"        // moments_draw
#include "step4_blur/blur.h"              // blur_apply
#include "step5_chebyshev/chebyshev.h"    // chebyshev_constants

static struct {
    Run run;
    BlurSettings blur_settings;
    ChebyshevSettings settings;
    Moments moments;
    Blur blur;
    Picture picture;
} state;

static void read_options(int argc, char **argv)
{
    state.blur_settings = blur_settings();
    state.settings = chebyshev_settings();
    const OptionTable tables[] = {
        options_table(blur_options, &state.blur_settings),
        options_table(chebyshev_options, &state.settings),
        {0}};
    run_options(&state.run, argc, argv, 5, "step5_chebyshev", moments_shows,
                tables);
    blur_check(&state.blur_settings, &state.run.frame.settings);
}

static void create(Frame *frame)
{
    static const char *const visibility[] = {
        "step3_moments/shaders/lookup_bilinear.glsl",
        "step5_chebyshev/shaders/chebyshev.glsl",
        "step5_chebyshev/shaders/reduction_linear.glsl",
        "step5_chebyshev/shaders/visibility.glsl", NULL};
    const BlurSettings *filter = &state.blur_settings;
    int radius = filter->radius, factor = filter->downsample;
    char constants[CHEBYSHEV_CONSTANTS_BYTES];
    run_begin(&state.run);
    frame->lookups = (Lookups){
        .reach = blur_reach(filter),
        .spread = chebyshev_spread(&state.settings, radius, factor)};
    run_look(&state.run);
    moments_create(&state.moments, frame, 0);
    blur_create(&state.blur, frame, filter, &state.moments.target);
    chebyshev_constants(&state.settings, radius, factor, constants);
    picture_create(&state.picture, frame, &state.blur.result, constants,
                   visibility);
}

static void draw(Frame *frame)
{
    moments_draw(&state.moments, frame);
    frame_lap(frame, "moments");
    blur_apply(&state.blur, frame);
    frame_lap(frame, "blur");
    picture_begin(&state.picture, frame);
    picture_draw(&state.picture, frame);
    frame_lap(frame, "shading");
}

int main(int argc, char **argv)
{
    Frame *frame = &state.run.frame;
    read_options(argc, argv);
    create(frame);
    while (run_next(&state.run, &state.picture, "step 5, radius %d",
                    state.blur_settings.radius)) {
        draw(frame);
    }
    run_end(&state.run);
    return 0;
}
