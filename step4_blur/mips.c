#include "step4_blur/mips.h"

#include <stdio.h>  // snprintf
#include <stdlib.h> // free

#include "step1_shadowmap/base/system/die.h"    // die_usage
#include "step1_shadowmap/base/picture/dump.h"  // dump_image
#include "step1_shadowmap/base/system/memory.h" // memory_check

int mips_count(const int size[2])
{
    int count = 1;
    while ((size[0] >> (count - 1)) % 2 == 0 &&
           (size[1] >> (count - 1)) % 2 == 0 && count < MIPS_MAX_LEVELS) {
        count++;
    }
    return count;
}

static void add_levels(Mips *mips, GLenum format)
{
    const int size[2] = {mips->width, mips->height};
    size_t texel = gl_texel_bytes(format);
    mips->levels = mips_count(size);
    for (int level = 1; level < mips->levels; level++) {
        int width = size[0] >> level, height = size[1] >> level;
        size_t bytes =
            texel * (size_t)width * (size_t)height * (size_t)mips->layers;
        memory_check(bytes, "mip-map level %d of %dx%d texels", level, width,
                     height);
        glTexImage3D(GL_TEXTURE_2D_ARRAY, level, (GLint)format, width, height,
                     mips->layers, 0, GL_RED, GL_FLOAT, NULL);
        mips->bytes += bytes;
    }
}

// Makes only these levels readable. While one level is drawn, none but the
// level before it may be: reading what is being drawn has no defined result.
static void limit_levels(int first, int last)
{
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BASE_LEVEL, first);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, last);
}

Mips mips_create(Program program, GLuint texture, const ShadowMap *map,
                 const int size[2])
{
    Mips mips = {.program = program,
                 .texture = texture,
                 .width = size[0],
                 .height = size[1],
                 .layers = map->layers};
    glBindTexture(GL_TEXTURE_2D_ARRAY, texture);
    add_levels(&mips, map->format);
    // The lookup blends the levels itself.
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER,
                    map->sampling.filter == GL_LINEAR
                        ? GL_LINEAR_MIPMAP_NEAREST
                        : GL_NEAREST_MIPMAP_NEAREST);
    limit_levels(0, mips.levels - 1);
    for (int level = 1; level < mips.levels; level++) {
        for (int layer = 0; layer < map->layers; layer++) {
            mips.framebuffers[level][layer] =
                gl_level_framebuffer(texture, level, layer);
        }
    }
    return mips;
}

void mips_use_sampler(const Mips *mips, int anisotropy)
{
    // A driver may take the pixel's length from the coordinates of the pixel
    // beside it (llvmpipe does), and those may be in another layer.
    if (anisotropy > 1 && mips->layers > 1) {
        die_usage("--sampler hardware takes --anisotropy with a map of one "
                  "layer only, not with this one of %d: drop one of them",
                  mips->layers);
    }
    GLfloat most = 1;
    if (GLAD_GL_EXT_texture_filter_anisotropic) {
        glGetFloatv(GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT, &most);
    }
    if ((GLfloat)anisotropy > most) {
        die_usage("--sampler hardware takes --anisotropy 1 to %g with this "
                  "driver, not %d: drop one of them",
                  (double)most, anisotropy);
    }
    glBindTexture(GL_TEXTURE_2D_ARRAY, mips->texture);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER,
                    GL_LINEAR_MIPMAP_LINEAR);
    if (anisotropy > 1) {
        glTexParameterf(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_ANISOTROPY_EXT,
                        (GLfloat)anisotropy);
    }
}

void mips_limit_sampler(const Mips *mips, int last)
{
    glBindTexture(GL_TEXTURE_2D_ARRAY, mips->texture);
    glTexParameterf(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LOD, (GLfloat)last);
}

void mips_apply(const Mips *mips, GLuint texture, GLuint empty_vao,
                const Rect levels[][VIEW_MAX_LAYERS], const MapPlan *plan)
{
    GLuint program = mips->program.id;
    glUseProgram(program);
    glUniform1i(glGetUniformLocation(program, "map"), 0);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D_ARRAY, texture);
    for (int level = 1; level < mips->levels; level++) {
        limit_levels(level - 1, level - 1);
        glViewport(0, 0, mips->width >> level, mips->height >> level);
        for (int layer = 0; layer < mips->layers; layer++) {
            if (plan->layers[layer].draw) {
                gl_limit(&levels[level][layer]);
                glBindFramebuffer(GL_FRAMEBUFFER,
                                  mips->framebuffers[level][layer]);
                glUniform1i(glGetUniformLocation(program, "layer"), layer);
                gl_draw_fullscreen(empty_vao);
            }
        }
    }
    gl_unlimit();
    limit_levels(0, mips->levels - 1);
}

void mips_dump(const Mips *mips, GLuint texture, const char *directory)
{
    for (int level = 1; level < mips->levels; level++) {
        int width = mips->width >> level, height = mips->height >> level;
        for (int layer = 0; layer < mips->layers; layer++) {
            char name[64];
            snprintf(name, sizeof name, "blurred.%d.m%d", layer, level);
            float *texels =
                gl_read_layer(texture, level, layer, width, height, 2);
            dump_image(directory, name, texels, width, height, 2);
            free(texels);
        }
    }
}

void mips_destroy(Mips *mips)
{
    for (int level = 1; level < mips->levels; level++) {
        glDeleteFramebuffers(mips->layers, mips->framebuffers[level]);
    }
    gl_program_destroy(&mips->program);
    *mips = (Mips){.levels = 0};
}
