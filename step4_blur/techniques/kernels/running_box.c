#include "step4_blur/techniques/kernels/running_box.h"

#include <stdio.h> // snprintf

// Lines that one work group blurs, as the shader says.
enum { GROUP = 64 };

Program *running_box_program(Shaders *shaders, const int sides[2])
{
    static const char *const files[] = {
        "step3_moments/techniques/shared/merge_raw.glsl",
        "step4_blur/techniques/kernels/running_box.comp", NULL};
    char constants[64];
    snprintf(constants, sizeof constants, "const ivec2 sides = ivec2(%d, %d);",
             sides[0], sides[1]);
    return gl_program(shaders, constants, files);
}

// The start of the first block that has a box whose middle is at `low` or
// behind. Block k holds the boxes whose middles are k * width ...
// (k + 1) * width - 1, so each box is added up in the same order wherever `low`
// is.
static int first_start(int low, const int sides[2])
{
    int width = sides[0] + 1 + sides[1];
    return low / width * width + sides[1];
}

static void bind_images(Target *target)
{
    GLuint source = target_texture(target->reads);
    glBindImageTexture(0, source, 0, GL_TRUE, 0, GL_READ_ONLY, GL_RG32F);
    glBindImageTexture(1, target_texture(target), 0, GL_TRUE, 0, GL_WRITE_ONLY,
                       GL_RG32F);
}

void running_box_apply(Program *program, Target *target, int axis,
                       const int sides[2])
{
    GLuint name = gl_use(program);
    bind_images(target);
    glUniform2i(glGetUniformLocation(name, "axis"), 1 - axis, axis);
    glUniform1i(glGetUniformLocation(name, "map"), 0);
    glUniform1i(glGetUniformLocation(name, "blurred"), 1);
    for (int layer = 0; layer < target->layers; layer++) {
        const Rect *rect = target_wanted(target, layer);
        if (rect == NULL) {
            continue;
        }
        int first = rect->low[1 - axis], end = rect->high[1 - axis];
        glUniform1i(glGetUniformLocation(name, "layer"), layer);
        glUniform2i(glGetUniformLocation(name, "lines"), first, end);
        glUniform2i(glGetUniformLocation(name, "middles"),
                    first_start(rect->low[axis], sides), rect->high[axis]);
        glDispatchCompute((GLuint)((end - first + GROUP - 1) / GROUP), 1, 1);
    }
    // Next it is blurred again, or looked up, or read through a framebuffer.
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT |
                    GL_TEXTURE_FETCH_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT);
}
