#include "step4_blur/techniques/sat/sat_compute.h"

// Rows or columns that one work group sums, as the shaders say.
enum { GROUP = 64 };

SatCompute sat_compute_create(Shaders *shaders)
{
    static const char *const rows[] = {
        "step4_blur/shaders/map_texel.glsl",
        "step4_blur/techniques/sat/sat_steps.glsl",
        "step4_blur/techniques/sat/sat_rows.comp", NULL};
    static const char *const columns[] = {
        "step4_blur/techniques/sat/sat_columns.comp", NULL};
    return (SatCompute){.rows = gl_program(shaders, NULL, rows),
                        .columns = gl_program(shaders, NULL, columns)};
}

// Sums the lines along one axis of every layer.
static void sum_lines(GLuint program, int axis, Target *target)
{
    for (int layer = 0; layer < target->layers; layer++) {
        const Rect *rect = target_wanted(target, layer);
        if (rect == NULL) {
            continue;
        }
        int lines = rect->high[1 - axis] - rect->low[1 - axis];
        glUniform1i(glGetUniformLocation(program, "layer"), layer);
        glUniform2iv(glGetUniformLocation(program, "first"), 1, rect->low);
        glUniform2iv(glGetUniformLocation(program, "end"), 1, rect->high);
        glDispatchCompute((GLuint)((lines + GROUP - 1) / GROUP), 1, 1);
    }
}

void sat_compute_apply(const SatCompute *compute, GLuint map, Target *table,
                       Target *sums, GLuint steps)
{
    GLuint rows = gl_use(compute->rows);
    glBindImageTexture(0, target_texture(table), 0, GL_TRUE, 0, GL_READ_WRITE,
                       GL_RG32UI);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D_ARRAY, map);
    glUniform1i(glGetUniformLocation(rows, "map"), 0);
    glUniform1ui(glGetUniformLocation(rows, "steps"), steps);
    sum_lines(rows, 0, table);
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    sum_lines(gl_use(compute->columns), 1, sums);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}
