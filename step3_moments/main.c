// Step 3: moments. The map keeps two numbers per texel, the depth and its
// square. The picture still compares with one of them, the mean.

#include "step1_shadowmap/base/gl/context.h"         // context_create
#include "step1_shadowmap/base/picture/dump.h"       // dump_run
#include "step1_shadowmap/base/leave_out/facts.h"    // facts_collect
#include "step1_shadowmap/base/picture/scene_draw.h" // scene_draw
#include "step1_shadowmap/base/run/settings.h"       // base_settings
#include "step1_shadowmap/base/system/stopwatch.h"   // stopwatch_lap
#include "step1_shadowmap/base/run/window.h"         // window_next, window_show
#include "step3_moments/moments.h"                   // moments_draw

enum { REACH = 1 }; // texels that a bilinear lookup reads to each side

static struct {
    BaseSettings base;
    BiasSettings bias;
    MomentsSettings moments;
    OptionTable options[4];
    Context context;
    Scene scene;
    Views views;
    Facts facts;
    MapPlan plan;
    Geometry geometry;
    MomentsMap map;
    SceneDraw picture;
    Stopwatch stopwatch;
    Window window;
} state;

static void read_settings(int argc, char **argv)
{
    base_settings(&state.base, "step3_moments", moments_shows);
    state.bias = bias_settings();
    state.moments = moments_settings();
    state.options[0] = options_table(base_options, &state.base);
    state.options[1] = options_table(bias_options, &state.bias);
    state.options[2] = options_table(moments_options, &state.moments);
    options_parse(argc, argv, state.options);
    moments_settings_check(&state.moments, &state.base, state.options);
    base_settings_check(&state.base);
}

// Where the light sees the scene from, and what the picture needs of that.
static void look(void)
{
    if (facts_collect(&state.facts, &state.scene, &state.views, &state.base,
                      REACH)) {
        bias_plan(&state.bias, &state.facts, 1, moments_format(&state.moments));
        map_plan_decide_within(&state.plan, &state.facts, REACH, "moments",
                               moments_format(&state.moments));
    }
}

static void create(void)
{
    const char *const visibility[] = {
        "step1_shadowmap/shaders/depth_slope.glsl",
        "step1_shadowmap/shaders/bias.glsl",
        moments_merge_shader(&state.moments),
        moments_between_shader(&state.moments),
        "step3_moments/shaders/lookup_bilinear.glsl",
        "step3_moments/shaders/mean.glsl",
        NULL};
    base_create_scene(&state.base, &state.scene);
    state.context = context_create(state.base.window, state.base.size);
    look();
    state.geometry = geometry_create(&state.scene);
    if (facts_make_maps(&state.facts)) {
        state.map = moments_create(base_shader_files(&state.base), &state.views,
                                   &state.moments);
    }
    state.picture = scene_draw_create(&state.base, &state.facts, visibility);
    plan_print(&state.facts.plan, state.base.plan);
}

static void draw_frame(void)
{
    stopwatch_start(&state.stopwatch);
    look();
    if (map_plan_begin(&state.plan)) {
        moments_draw(&state.map, &state.geometry, &state.plan);
        stopwatch_lap(&state.stopwatch, "moments", state.map.touched);
    }
    bias_apply(&state.bias, state.picture.program.id);
    scene_draw(&state.picture, &state.scene, &state.geometry, &state.views,
               state.map.texels.texture);
    stopwatch_lap(&state.stopwatch, "shading", state.picture.touched);
}

static void write_files(void)
{
    if (state.base.dump != NULL) {
        scene_draw_dump(&state.picture, state.base.dump);
        dump_run(&(Run){state.options, &state.facts, &state.stopwatch,
                        state.map.bytes});
        moments_dump(&state.map, &state.geometry, &state.plan, state.base.dump);
    }
    scene_draw_write(&state.picture, &state.base);
    stopwatch_print(&state.stopwatch, state.base.bench);
}

static void run_window(void)
{
    state.window = window_create(&state.context, &state.base,
                                 "step 3, format %s", state.moments.format);
    while (window_next(&state.window, &state.scene.camera)) {
        if (state.window.reload) {
            bool compiled = moments_reload(&state.map, &state.plan) &&
                            scene_draw_reload(&state.picture);
            window_reload(&state.window, compiled);
        }
        draw_frame();
        window_show(&state.window, &state.picture, &state.stopwatch);
    }
    window_destroy(&state.window);
}

static void destroy(void)
{
    scene_draw_destroy(&state.picture);
    moments_destroy(&state.map);
    geometry_destroy(&state.geometry);
    context_destroy(&state.context);
    scene_destroy(&state.scene);
}

int main(int argc, char **argv)
{
    read_settings(argc, argv);
    create();
    for (int i = 0; base_next_frame(&state.base, &state.scene, i); i++) {
        draw_frame();
    }
    base_prepare_files(&state.base, state.options);
    if (state.base.window) {
        run_window();
    } else {
        write_files();
    }
    destroy();
    return 0;
}
