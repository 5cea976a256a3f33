#include "step4_blur/running_box.h"

// Lines that one work group blurs, as the shader says.
enum { GROUP = 64 };

Program running_box_program(ShaderFiles files, const MomentsSettings *moments)
{
    const char *const shaders[] = {moments_merge_shader(moments),
                                   "step4_blur/shaders/map_texel.glsl",
                                   "step4_blur/shaders/running_box.comp", NULL};
    return gl_compute_program(files, shaders);
}

// The first block of which some box's middle is at `low` or behind: its boxes
// have theirs from so many texels before its start to so many after it.
static int first_start(int low, const int sides[2])
{
    int width = sides[0] + 1 + sides[1];
    int start = low - sides[0];
    return start <= 0 ? 0 : (start + width - 1) / width * width;
}

void running_box_apply(GLuint program, GLuint source, GLuint target,
                       const Rect texels[], const MapPlan *plan, int axis,
                       const int sides[2])
{
    glUseProgram(program);
    glBindImageTexture(0, target, 0, GL_TRUE, 0, GL_WRITE_ONLY, GL_RG32F);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D_ARRAY, source);
    glUniform1i(glGetUniformLocation(program, "map"), 0);
    glUniform2i(glGetUniformLocation(program, "axis"), 1 - axis, axis);
    for (int layer = 0; layer < plan->layer_count; layer++) {
        const Rect *rect = &texels[layer];
        int lines = rect->high[1 - axis] - rect->low[1 - axis];
        if (!plan->layers[layer].draw || rect_is_empty(rect)) {
            continue;
        }
        glUniform1i(glGetUniformLocation(program, "layer"), layer);
        glUniform2i(glGetUniformLocation(program, "lines"), rect->low[1 - axis],
                    rect->high[1 - axis]);
        glUniform2i(glGetUniformLocation(program, "middles"),
                    first_start(rect->low[axis], sides), rect->high[axis]);
        glDispatchCompute((GLuint)((lines + GROUP - 1) / GROUP), 1, 1);
    }
    // Next it is looked up, or read through a framebuffer.
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT);
}
