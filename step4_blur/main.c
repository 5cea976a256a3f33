// Step 4: blur. The moments are averaged; comparing with their mean is wrong.

#include "step1_shadowmap/base/gl/context.h"         // context_create
#include "step1_shadowmap/base/picture/dump.h"       // dump_run
#include "step1_shadowmap/base/picture/scene_draw.h" // scene_draw
#include "step1_shadowmap/base/run/settings.h"       // base_settings
#include "step1_shadowmap/base/system/stopwatch.h"   // stopwatch_lap
#include "step1_shadowmap/base/run/window.h"         // window_next, window_show
#include "step3_moments/moments.h"                   // moments_draw
#include "step4_blur/blur.h"                         // blur_apply

static struct {
    BaseSettings base;
    BiasSettings bias;
    MomentsSettings moments;
    BlurSettings blur;
    OptionTable options[5];
    Context context;
    Scene scene;
    Views views;
    Facts facts;
    BlurPlan plan;
    Geometry geometry;
    MomentsMap map;
    Blur filter;
    SceneDraw picture;
    Stopwatch stopwatch;
    Window window;
} state;

static void read_settings(int argc, char **argv)
{
    base_settings(&state.base, "step4_blur", moments_shows);
    state.bias = bias_settings();
    state.moments = moments_settings();
    state.blur = blur_settings();
    state.options[0] = options_table(base_options, &state.base);
    state.options[1] = options_table(bias_options, &state.bias);
    state.options[2] = options_table(moments_options, &state.moments);
    state.options[3] = options_table(blur_options, &state.blur);
    options_parse(argc, argv, state.options);
    moments_settings_check(&state.moments, &state.base, state.options);
    blur_check(&state.blur, &state.moments, &state.base, state.options);
    base_settings_check(&state.base);
}

static void look(void)
{
    if (facts_collect(&state.facts, &state.scene, &state.views, &state.base,
                      blur_reach(&state.blur))) {
        blur_plan_bias(&state.bias, &state.facts, &state.blur, &state.moments);
        blur_plan_decide(&state.plan, &state.facts, &state.blur,
                         &state.moments);
    }
}

static void create(void)
{
    ShaderFiles files = base_shader_files(&state.base);
    const char *visibility[BLUR_MAX_SHADERS + 2] = {
        "step1_shadowmap/shaders/depth_slope.glsl",
        "step1_shadowmap/shaders/bias.glsl"};
    blur_picture_shaders(&state.blur, &state.moments,
                         "step3_moments/shaders/mean.glsl", &visibility[2]);
    base_create_scene(&state.base, &state.scene);
    state.context = context_create(state.base.window, state.base.size);
    look();
    state.geometry = geometry_create(&state.scene);
    if (facts_make_maps(&state.facts)) {
        state.map = moments_create(files, &state.views, &state.moments);
        state.filter = blur_create(files, &state.blur, &state.map);
    }
    state.picture = scene_draw_create(&state.base, &state.facts, visibility);
    plan_print(&state.facts.plan, state.base.plan);
}

static void draw_frame(void)
{
    stopwatch_start(&state.stopwatch);
    look();
    if (map_plan_begin(&state.plan.map)) {
        moments_draw(&state.map, &state.geometry, &state.plan.map);
        stopwatch_lap(&state.stopwatch, "moments", state.map.touched);
        blur_apply(&state.filter, &state.map, &state.plan);
        stopwatch_lap(&state.stopwatch, "blur", state.filter.touched);
    }
    bias_apply(&state.bias, state.picture.program.id);
    blur_set_lookup(&state.filter, &state.views, state.picture.program.id);
    scene_draw(&state.picture, &state.scene, &state.geometry, &state.views,
               state.filter.result);
    stopwatch_lap(&state.stopwatch, "shading", state.picture.touched);
}

static void write_files(void)
{
    if (state.base.dump != NULL) {
        scene_draw_dump(&state.picture, state.base.dump);
        dump_run(&(Run){state.options, &state.facts, &state.stopwatch,
                        state.map.bytes + state.filter.bytes});
        moments_dump(&state.map, &state.geometry, &state.plan.map,
                     state.base.dump);
        blur_dump(&state.filter, &state.map, &state.plan, state.base.dump);
    }
    scene_draw_write(&state.picture, &state.base);
    stopwatch_print(&state.stopwatch, state.base.bench);
}

static void run_window(void)
{
    state.window = window_create(&state.context, &state.base,
                                 "step 4, radius %d", state.blur.radius);
    while (window_next(&state.window, &state.scene.camera)) {
        if (state.window.reload) {
            bool compiled = moments_reload(&state.map, &state.plan.map) &&
                            blur_reload(&state.filter) &&
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
    blur_destroy(&state.filter);
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
