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

void frame_filter(const Frame *frame, GLuint program, GLuint source,
                  Target *target)
{
    glDisable(GL_DEPTH_TEST);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D_ARRAY, source);
    glUniform1i(glGetUniformLocation(program, "map"), 0);
    for (int layer = 0; layer < target->layers; layer++) {
        if (target_begin(target, layer)) {
            glUniform1i(glGetUniformLocation(program, "layer"), layer);
            gl_draw_fullscreen(frame->empty_vao);
        }
    }
}

void frame_lap(Frame *frame, const char *name)
{
    bool picture = false;
    for (int i = 0; i < frame->targets.count; i++) {
        const Target *target = frame->targets.list[i];
        picture = picture || (target->kind == TARGET_PICTURE &&
                              target->touched.texels > 0);
    }
    Touched touched = targets_touched(&frame->targets);
    gl_unlimit();
    if (frame->dump == NULL && (frame->looks_up || picture)) {
        stopwatch_lap(&frame->clock, name, touched);
    }
}
