#include "step1_shadowmap/base/picture/dump.h"

#include <stdio.h>  // snprintf
#include <stdlib.h> // free

#include "step1_shadowmap/base/files/file.h"  // FILE_NAME_BYTES
#include "step1_shadowmap/base/gl/gl.h"       // gl_read_layer
#include "step1_shadowmap/base/files/image.h" // image_write

void dump_image(const char *directory, const char *name, const float *pixels,
                int width, int height, int channels)
{
    char path[FILE_NAME_BYTES];
    snprintf(path, sizeof path, "%s/%s.exr", directory, name);
    image_write(path, pixels, width, height, channels);
}

void dump_target(Target *target, const char *directory)
{
    GLuint texture = target_texture(target);
    int channels = target->formats[0] == GL_R32F ? 1 : 2;
    for (int layer = 0; layer < target->layers; layer++) {
        char name[64];
        int length = snprintf(name, sizeof name, "%s.%d", target->file, layer);
        if (target->level > 0) {
            snprintf(name + length, sizeof name - (size_t)length, ".m%d",
                     target->level);
        }
        float *texels = gl_read_layer(texture, target->level, layer,
                                      target->width, target->height, channels);
        dump_image(directory, name, texels, target->width, target->height,
                   channels);
        free(texels);
    }
}
