// Step 1: shadow mapping. The scene is drawn twice: as the light sees it, into
// a map of depths; then as the camera sees it, where each point asks the map
// whether something is nearer to the light.

#include "step1_shadowmap/base/run/run.h" // run_next
#include "step1_shadowmap/shadow_map.h"   // shadow_map_draw

// A comparison reads one texel; one to each side is for the rounding of u, v.
enum { REACH = 1 };

static struct {
    Run run;
    BiasSettings bias;
    ShadowMap map;
    Picture picture;
} state;

static void read_options(int argc, char **argv)
{
    state.bias = bias_settings();
    const OptionTable tables[] = {options_table(bias_options, &state.bias),
                                  {0}};
    run_options(&state.run, argc, argv, 1, "step1_shadowmap", NULL, tables);
}

static void create(Frame *frame)
{
    static const char *const visibility[] = {
        "step1_shadowmap/shaders/depth_slope.glsl",
        "step1_shadowmap/shaders/bias.glsl",
        "step1_shadowmap/shaders/hard.glsl", NULL};
    run_begin(&state.run);
    // The reach sets the map's border. The rest is for base/leave_out and
    // --plan, and changes no pixel.
    frame->lookups = bias_lookups(&state.bias, REACH, 1);
    frame->lookups.compares = true;
    run_look(&state.run);
    shadow_map_create(&state.map, frame, REACH);
    picture_create(&state.picture, frame, &state.map.target, NULL, visibility);
}

static void draw(Frame *frame)
{
    shadow_map_draw(&state.map, frame);
    frame_lap(frame, "depth");
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
    while (run_next(&state.run, &state.picture, "step 1, map %dx%d",
                    frame->views.width, frame->views.height)) {
        draw(frame);
    }
    run_end(&state.run);
    return 0;
}
