#include "step4_blur/mips.h"

#include "step1_shadowmap/base/system/die.h" // die_usage

const char mips_pass[] = "mip-map levels";

int mips_count(const int size[2])
{
    int count = 1;
    while ((size[0] >> (count - 1)) % 2 == 0 &&
           (size[1] >> (count - 1)) % 2 == 0 && count < MIPS_MAX_LEVELS) {
        count++;
    }
    return count;
}

// Makes only these levels readable. While one level is drawn, none but the
// level before it may be: reading what is being drawn has no defined result.
static void limit_levels(int first, int last)
{
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BASE_LEVEL, first);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, last);
}

void mips_create(Mips *mips, Frame *frame, Program *program, Target *owner,
                 Target *map, int last, int looked_up)
{
    const int size[2] = {map->width, map->height};
    mips->program = program;
    mips->map = map;
    mips->levels = owner->levels = mips_count(size);
    for (int level = 1; level < mips->levels; level++) {
        Target *target = &mips->targets[level];
        *target = (Target){.pass = mips_pass,
                           .why = "--mips",
                           .file = "blurred",
                           .kind = TARGET_LAYERS,
                           .width = size[0] >> level,
                           .height = size[1] >> level,
                           .layers = map->layers,
                           .formats = {map->formats[0]},
                           .sampling = map->sampling,
                           .shares = owner,
                           .level = level,
                           .reads = level == 1 ? map : target - 1,
                           .scale = 2,
                           .reach = {1, 1},
                           .looked_up = level <= last ? looked_up : 0};
        target_add(&frame->targets, target);
    }
}

void mips_check_sampler(int layers, int anisotropy)
{
    // A driver may take the pixel's length from the coordinates of the pixel
    // beside it (llvmpipe does), and those may be in another layer.
    if (anisotropy > 1 && layers > 1) {
        die_usage("--sampler hardware takes --anisotropy with a map of one "
                  "layer only, not with this one of %d: drop one of them",
                  layers);
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
}

// Of the texture that is bound. The shader blends the levels itself, unless the
// texture unit is to do so.
static void set_filter(const Mips *mips)
{
    GLenum target = GL_TEXTURE_2D_ARRAY;
    GLint filter = mips->anisotropy > 0 ? GL_LINEAR_MIPMAP_LINEAR
                   : mips->map->sampling.filter == GL_LINEAR
                       ? GL_LINEAR_MIPMAP_NEAREST
                       : GL_NEAREST_MIPMAP_NEAREST;
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, filter);
    if (mips->anisotropy > 1) {
        glTexParameterf(target, GL_TEXTURE_MAX_ANISOTROPY_EXT,
                        (GLfloat)mips->anisotropy);
    }
}

void mips_limit_sampler(const Mips *mips, int last)
{
    glBindTexture(GL_TEXTURE_2D_ARRAY, target_texture(mips->map));
    glTexParameterf(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LOD, (GLfloat)last);
}

void mips_apply(Mips *mips, const Frame *frame)
{
    GLuint texture = target_texture(mips->map);
    GLuint program = gl_use(mips->program);
    glBindTexture(GL_TEXTURE_2D_ARRAY, texture);
    set_filter(mips);
    for (int level = 1; level < mips->levels; level++) {
        limit_levels(level - 1, level - 1);
        frame_filter(frame, program, texture, &mips->targets[level]);
    }
    limit_levels(0, mips->levels - 1);
}
