// Step 2: percentage-closer filtering. The map is step 1's; each point of the
// picture compares itself with n x n of its texels and averages the answers.

#include "step1_shadowmap/base/run/run.h" // run_next
#include "step1_shadowmap/shadow_map.h"   // shadow_map_draw
#include "step2_pcf/pcf.h"                // pcf_shaders

static struct {
    Run run;
    BiasSettings bias;
    PcfSettings pcf;
    ShadowMap map;
    Picture picture;
} state;

static void read_options(int argc, char **argv)
{
    state.bias = bias_settings();
    state.pcf = pcf_settings();
    const OptionTable tables[] = {options_table(bias_options, &state.bias),
                                  options_table(pcf_options, &state.pcf),
                                  {0}};
    run_options(&state.run, argc, argv, 2, "step2_pcf", NULL, tables);
}

static void create(Frame *frame)
{
    char constants[PCF_CONSTANTS_BYTES];
    run_begin(&state.run);
    // The reach sets the map's border. The rest is for base/leave_out and
    // --plan, and changes no pixel.
    frame->lookups = pcf_lookups(&state.pcf, &state.bias);
    run_look(&state.run);
    shadow_map_create(&state.map, frame, frame->lookups.reach);
    pcf_constants(&state.pcf, constants);
    picture_create(&state.picture, frame, &state.map.target, constants,
                   pcf_shaders);
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
    while (run_next(&state.run, &state.picture, "step 2, kernel %d",
                    state.pcf.kernel)) {
        draw(frame);
    }
    run_end(&state.run);
    return 0;
}
