#include "step3_moments/moments.h"

const ShowMode moments_shows[] = {
    {"mean", "step3_moments/shaders/show_mean.glsl",
     "step1_shadowmap/base/picture/shaders/scale_grey.glsl",
     "0 near     mean depth in the map    1 far", true},
    {"variance", "step3_moments/shaders/show_variance.glsl",
     "step3_moments/shaders/scale_fire.glsl",
     "1e-9      variance  log scale        1e-1", true},
    {NULL, NULL, NULL, NULL, false},
};

const char *const moments_shaders[] = {
    "step1_shadowmap/shaders/map.vert",
    "step1_shadowmap/shaders/light_depth.glsl",
    "step1_shadowmap/shaders/linear_depth.glsl",
    "step3_moments/shaders/moments.frag", NULL};

void moments_create(Moments *moments, Frame *frame, int looked_up)
{
    static const Sampling bilinear = {GL_LINEAR, {1, 1, 1, 1}};
    moments->program = gl_program(&frame->shaders, NULL, moments_shaders);
    moments->target = frame_map(frame, "moments", GL_RG32F, bilinear);
    moments->target.file = "moments";
    moments->target.depth = true;
    moments->target.looked_up = looked_up;
    target_add(&frame->targets, &moments->target);
}

void moments_draw(Moments *moments, const Frame *frame)
{
    for (int layer = 0; layer < moments->target.layers; layer++) {
        shadow_map_draw_layer(&moments->target, moments->program, frame, layer);
    }
}
