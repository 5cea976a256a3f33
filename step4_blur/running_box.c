#include "step4_blur/running_box.h"

// Lines that one work group blurs, as the shader says.
enum { GROUP = 64 };

Program *running_box_program(Shaders *shaders, const char *constants,
                             const MomentsSettings *moments)
{
    const char *const files[] = {moments_merge_shader(moments),
                                 "step4_blur/shaders/running_box.comp", NULL};
    return gl_compute_program(shaders, constants, files);
}

// The first block around which a box has its middle at `low` or behind. The
// middles of one block's boxes are as many texels as it is long, and the first
// of the map is the first one's: so no block is for boxes outside, and the same
// boxes are added up in the same order wherever `low` is.
static int first_start(int low, const int sides[2])
{
    int width = sides[0] + 1 + sides[1];
    return low / width * width + sides[1];
}

void running_box_apply(GLuint program, GLuint source, Target *target, int axis,
                       const int sides[2])
{
    glBindImageTexture(0, source, 0, GL_TRUE, 0, GL_READ_ONLY, GL_RG32F);
    glBindImageTexture(1, target_texture(target), 0, GL_TRUE, 0, GL_WRITE_ONLY,
                       GL_RG32F);
    glUniform1i(glGetUniformLocation(program, "map"), 0);
    glUniform1i(glGetUniformLocation(program, "blurred"), 1);
    for (int layer = 0; layer < target->layers; layer++) {
        const Rect *rect = target_wanted(target, layer);
        if (rect == NULL) {
            continue;
        }
        int first = rect->low[1 - axis], end = rect->high[1 - axis];
        glUniform1i(glGetUniformLocation(program, "layer"), layer);
        glUniform2i(glGetUniformLocation(program, "lines"), first, end);
        glUniform2i(glGetUniformLocation(program, "middles"),
                    first_start(rect->low[axis], sides), rect->high[axis]);
        glDispatchCompute((GLuint)((end - first + GROUP - 1) / GROUP), 1, 1);
    }
    // Next it is blurred again, or looked up, or read through a framebuffer.
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT |
                    GL_TEXTURE_FETCH_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT);
}
