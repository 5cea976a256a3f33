#include "step1_shadowmap/base/picture/frame.h"

Target frame_map(const Frame *frame, const char *pass, GLenum format,
                 Sampling sampling)
{
    return (Target){.pass = pass,
                    .kind = TARGET_LAYERS,
                    .width = frame->views.width,
                    .height = frame->views.height,
                    .layers = frame->views.layers,
                    .formats = {format},
                    .sampling = sampling};
}

// On unit 0, by single texels. Returns the sampler.
static GLuint bind_source(Target *source)
{
    Sampling single = source->sampling;
    single.filter = GL_NEAREST;
    GLuint texture = target_texture(source);
    GLuint sampler = gl_sampler(single);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D_ARRAY, texture);
    glBindSampler(0, sampler);
    return sampler;
}

void frame_filter(const Frame *frame, Program *program, Target *target)
{
    GLuint name = 0, sampler = 0;
    glDisable(GL_DEPTH_TEST);
    for (int layer = 0; layer < target->layers; layer++) {
        if (!target_begin(target, layer)) {
            continue;
        }
        if (name == 0) {
            name = gl_use(program);
            sampler = bind_source(target->reads);
            glUniform1i(glGetUniformLocation(name, "map"), 0);
        }
        glUniform1i(glGetUniformLocation(name, "layer"), layer);
        gl_draw_fullscreen(frame->empty_vao);
    }
    glBindSampler(0, 0);
    glDeleteSamplers(1, &sampler);
}

__attribute__((weak)) void frame_lap(Frame *frame, const char *name)
{
    (void)frame, (void)name;
    if (target_limit != NULL) {
        target_limit(NULL);
    }
}
