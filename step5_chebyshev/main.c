// Step 5: variance shadow mapping. The filtered moments bound how much light
// can arrive; the bound is the shadow.

#include "step1_shadowmap/base/gl/context.h"         // context_create
#include "step1_shadowmap/base/picture/dump.h"       // dump_run
#include "step1_shadowmap/base/picture/scene_draw.h" // scene_draw_dump
#include "step1_shadowmap/base/run/settings.h"       // base_settings
#include "step1_shadowmap/base/system/stopwatch.h"   // stopwatch_lap
#include "step1_shadowmap/base/run/window.h"         // window_next, window_show
#include "step3_moments/moments.h"                   // moments_draw
#include "step4_blur/blur.h"                         // blur_apply
#include "step5_chebyshev/chebyshev.h"               // chebyshev_settings
#include "step5_chebyshev/deferred.h"                // deferred_draw
#include "step5_chebyshev/shading.h"                 // shading_picture

static struct {
    BaseSettings base;
    ShadingSettings shading;
    OptionTable options[6];
    Context context;
    Scene scene;
    Views views;
    Facts facts;
    BlurPlan plan;
    Geometry geometry;
    MomentsMap map;
    Blur filter;
    SceneDraw picture;
    Deferred deferred;
    Stopwatch stopwatch;
    Window window;
} state;

static void read_settings(int argc, char **argv)
{
    base_settings(&state.base, "step5_chebyshev", moments_shows);
    state.shading = shading_settings();
    state.options[0] = options_table(base_options, &state.base);
    state.options[1] = options_table(moments_options, &state.shading.moments);
    state.options[2] = options_table(blur_options, &state.shading.blur);
    state.options[3] =
        options_table(chebyshev_options, &state.shading.chebyshev);
    state.options[4] = options_table(shading_options, &state.shading);
    options_parse(argc, argv, state.options);
    shading_check(&state.shading, &state.base, state.options);
    base_settings_check(&state.base);
}

// Where the light sees the scene from, and what the picture needs of that.
static void look(void)
{
    shading_look(&state.shading, &state.plan, &state.facts, &state.views,
                 &state.scene, &state.base);
}

static void create(void)
{
    ShaderFiles files = base_shader_files(&state.base);
    base_create_scene(&state.base, &state.scene);
    state.context = context_create(state.base.window, state.base.size);
    look();
    state.geometry = geometry_create(&state.scene);
    if (facts_make_maps(&state.facts)) {
        state.map = moments_create(files, &state.views, &state.shading.moments);
        state.filter = blur_create(files, &state.shading.blur, &state.map);
    }
    state.base.constants = shading_constants(&state.shading, &state.filter);
    state.picture = shading_picture(&state.shading, &state.base, &state.facts);
    state.deferred =
        deferred_create(state.shading.deferred, &state.base, &state.picture);
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
    blur_set_lookup(&state.filter, &state.views, state.picture.program.id);
    shading_apply(&state.shading, &state.views, state.picture.program.id);
    deferred_draw(&state.deferred, &state.picture, &state.scene,
                  &state.geometry, &state.views, state.filter.result);
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
    state.window =
        window_create(&state.context, &state.base, "step 5, radius %d",
                      state.shading.blur.radius);
    while (window_next(&state.window, &state.scene.camera)) {
        if (state.window.reload) {
            bool compiled = moments_reload(&state.map, &state.plan.map) &&
                            blur_reload(&state.filter) &&
                            scene_draw_reload(&state.picture) &&
                            deferred_reload(&state.deferred);
            window_reload(&state.window, compiled);
        }
        draw_frame();
        window_show(&state.window, &state.picture, &state.stopwatch);
    }
    window_destroy(&state.window);
}

static void destroy(void)
{
    deferred_destroy(&state.deferred);
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
