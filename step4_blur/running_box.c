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

void running_box_apply(GLuint program, GLuint source, GLuint target,
                       const int size[2], int layers, int axis,
                       const int sides[2])
{
    int lines = size[1 - axis];
    glUseProgram(program);
    glBindImageTexture(0, target, 0, GL_TRUE, 0, GL_READ_WRITE, GL_RG32F);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D_ARRAY, source);
    glUniform1i(glGetUniformLocation(program, "map"), 0);
    glUniform2i(glGetUniformLocation(program, "sides"), sides[0], sides[1]);
    glUniform2i(glGetUniformLocation(program, "axis"), 1 - axis, axis);
    for (int layer = 0; layer < layers; layer++) {
        glUniform1i(glGetUniformLocation(program, "layer"), layer);
        glDispatchCompute((GLuint)((lines + GROUP - 1) / GROUP), 1, 1);
    }
    // Next it is looked up, or read through a framebuffer.
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT);
}
