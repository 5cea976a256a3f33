#include "step1_shadowmap/shadow_map.h"

const Option bias_options[] = {
    {"bias", OPTION_NUMBER, offsetof(BiasSettings, constant), -1, 1, NULL, "X",
     "constant depth bias, in units of the depth range"},
    {"slope-bias", OPTION_NUMBER, offsetof(BiasSettings, slope), -100, 100,
     NULL, "X", "bias by X times the depth change across half the kernel"},
    {0},
};

BiasSettings bias_settings(void)
{
    return (BiasSettings){.constant = 5e-4, .slope = 1};
}

void bias_apply(const BiasSettings *settings, GLuint program)
{
    glUniform1f(glGetUniformLocation(program, "bias"),
                (float)settings->constant);
    glUniform1f(glGetUniformLocation(program, "slope_bias"),
                (float)settings->slope);
}

Lookups bias_lookups(const BiasSettings *settings, int reach, int kernel)
{
    return (Lookups){.reach = reach,
                     .bias = settings->constant,
                     .slope_bias = settings->slope,
                     .kernel = kernel,
                     .rounding = 0x1p-12};
}

void shadow_map_create(ShadowMap *map, Frame *frame, int reach)
{
    static const char *const files[] = {
        "step1_shadowmap/shaders/map.vert",
        "step1_shadowmap/shaders/light_depth.glsl",
        "step1_shadowmap/shaders/linear_depth.glsl",
        "step1_shadowmap/shaders/depth.frag", NULL};
    static const Sampling depths = {GL_NEAREST, {1, 1, 1, 1}}; // far outside
    map->program = gl_program(&frame->shaders, NULL, files);
    map->target = frame_map(frame, "depth", GL_R32F, depths);
    map->target.file = "depth";
    map->target.depth = true;
    map->target.looked_up = reach;
    target_add(&frame->targets, &map->target);
}

void shadow_map_draw_layer(Target *target, Program *map_program,
                           const Frame *frame, int layer)
{
    static const float far_depth = 1;
    const Views *views = &frame->views;
    if (!target_begin(target, layer)) {
        return;
    }
    GLuint program = gl_use(map_program);
    glEnable(GL_DEPTH_TEST);
    // What is before the near plane of a split still casts into it.
    glEnable(GL_DEPTH_CLAMP);
    view_set_light(program, views);
    glUniform1i(glGetUniformLocation(program, "layer"), layer);
    glClearBufferfv(GL_COLOR, 0, target->sampling.far);
    glClearBufferfv(GL_DEPTH, 0, &far_depth);
    geometry_draw_shapes(&frame->geometry, &frame->scene,
                         &views->light[layer].seen, views->origin);
    glDisable(GL_DEPTH_CLAMP);
}

void shadow_map_draw(ShadowMap *map, const Frame *frame)
{
    for (int layer = 0; layer < map->target.layers; layer++) {
        shadow_map_draw_layer(&map->target, map->program, frame, layer);
    }
}
