#include "step1_shadowmap/shadow_map.h"

#include "step1_shadowmap/base/picture/dump.h"   // dump_layers
#include "step1_shadowmap/base/leave_out/flat.h" // flat_everywhere

const Option bias_options[] = {
    {.name = "bias",
     .kind = OPTION_NUMBER,
     .offset = offsetof(BiasSettings, constant),
     .minimum = -1,
     .maximum = 1,
     .argument = "X",
     .help = "constant depth bias, in units of the depth range"},
    {.name = "slope-bias",
     .kind = OPTION_NUMBER,
     .offset = offsetof(BiasSettings, slope),
     .minimum = -100,
     .maximum = 100,
     .argument = "X",
     .help = "bias by X times the receiver's depth change across half the "
             "comparison kernel"},
    {0},
};

BiasSettings bias_settings(void)
{
    return (BiasSettings){.constant = 5e-4, .slope = 1};
}

void bias_apply(const BiasSettings *settings, GLuint program)
{
    glUseProgram(program);
    glUniform1f(glGetUniformLocation(program, "bias"),
                (float)settings->constant);
    glUniform1f(glGetUniformLocation(program, "slope_bias"),
                (float)settings->slope);
}

// Where the light meets the plane at less than 0.02 the slope's part is held
// (depth_slope.glsl). The constant part is for rounding, of a mean by more than
// of a depth.
void bias_plan(const BiasSettings *settings, Facts *facts, int kernel,
               GLenum format)
{
    static const double least_sine = 0.03;
    double rounding = format == GL_RG16F ? 0x1p-9 : 0x1p-12;
    Flat flat;
    if (flat_everywhere(facts, kernel / 2 + 1, &flat) &&
        flat.sine > least_sine && settings->slope >= 1 &&
        settings->constant > rounding + flat.error) {
        facts_drop_lookups(facts, "one plane alone, which its bias keeps lit");
    }
}

void bias_plan_behind(const BiasSettings *settings, Facts *facts)
{
    facts->compared =
        settings->constant >= 0 && settings->slope >= 0 && !facts->whole;
}

Program shadow_map_program(ShaderFiles files, const char *const shaders[])
{
    const char *const vertex[] = {"step1_shadowmap/shaders/centre_out.glsl",
                                  "step1_shadowmap/shaders/map.vert", NULL};
    const char *fragment[PROGRAM_MAX_FILES + 1] = {
        "step1_shadowmap/shaders/light_depth.glsl"};
    for (int i = 0; shaders[i] != NULL; i++) {
        fragment[i + 1] = shaders[i];
    }
    return gl_program(files, vertex, fragment);
}

const Sampling shadow_map_depths = {GL_NEAREST, {1, 1, 1, 1}};

ShadowMap shadow_map_create(Program program, const Views *views, GLenum format,
                            Sampling sampling)
{
    gl_check_size("map-size", views->width, views->height);
    ShadowMap map = {.program = program,
                     .format = format,
                     .width = views->width,
                     .height = views->height,
                     .layers = views->layers,
                     .channels = format == GL_R32F ? 1 : 2,
                     .sampling = sampling};
    size_t texels = (size_t)map.width * (size_t)map.height;
    map.bytes = texels * ((size_t)map.layers * gl_texel_bytes(format) +
                          gl_texel_bytes(GL_DEPTH_COMPONENT32F));
    map.texture =
        gl_texture_array(format, map.width, map.height, map.layers, sampling);
    map.depth_buffer = gl_depth_buffer(map.width, map.height);
    for (int layer = 0; layer < map.layers; layer++) {
        map.framebuffers[layer] =
            gl_layer_framebuffer(map.texture, layer, map.depth_buffer);
    }
    return map;
}

void shadow_map_draw_layer(const ShadowMap *map, int layer,
                           const Geometry *geometry, const MapPlan *plan)
{
    static const float far_depth = 1;
    const LayerPlan *part = &plan->layers[layer];
    GLuint program = map->program.id;
    glEnable(GL_DEPTH_TEST);
    // What is before the near plane of a split still casts into it.
    glEnable(GL_DEPTH_CLAMP);
    glViewport(0, 0, map->width, map->height);
    gl_limit(&part->rect);
    glUseProgram(program);
    view_set_light(program, plan->views);
    glUniform2f(glGetUniformLocation(program, "map_size"), (float)map->width,
                (float)map->height); // where it is used
    glUniform1i(glGetUniformLocation(program, "layer"), layer);
    glClearBufferfv(GL_COLOR, 0, map->sampling.far);
    glClearBufferfv(GL_DEPTH, 0, &far_depth);
    geometry_draw_shapes(geometry, plan->scene, &part->list,
                         plan->views->origin);
    gl_unlimit();
    glDisable(GL_DEPTH_CLAMP);
}

void shadow_map_draw(ShadowMap *map, const Geometry *geometry,
                     const MapPlan *plan)
{
    map->touched = (Touched){0, 0};
    touch(&map->touched, map_plan_texels(plan),
          gl_texel_bytes(map->format) + gl_texel_bytes(GL_DEPTH_COMPONENT32F));
    for (int layer = 0; layer < map->layers; layer++) {
        if (plan->layers[layer].draw) {
            glBindFramebuffer(GL_FRAMEBUFFER, map->framebuffers[layer]);
            shadow_map_draw_layer(map, layer, geometry, plan);
        }
    }
}

void shadow_map_dump(ShadowMap *map, const Geometry *geometry,
                     const MapPlan *plan, const char *directory)
{
    MapPlan whole = map_plan_whole(plan);
    shadow_map_draw(map, geometry, &whole);
    dump_layers(directory, "depth", map->texture, map->width, map->height,
                map->layers, map->channels);
}

bool shadow_map_reload(ShadowMap *map, MapPlan *plan)
{
    map_plan_forget(plan);
    return gl_program_reload(&map->program);
}

void shadow_map_destroy(ShadowMap *map)
{
    glDeleteFramebuffers(map->layers, map->framebuffers);
    glDeleteRenderbuffers(1, &map->depth_buffer);
    glDeleteTextures(1, &map->texture);
    gl_program_destroy(&map->program);
    *map = (ShadowMap){0};
}
