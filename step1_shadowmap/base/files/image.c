#include "step1_shadowmap/base/files/image.h"

#include <math.h>   // powf
#include <png.h>    // png_image_write_to_memory
#include <stdio.h>  // snprintf
#include <stdlib.h> // free
#include <string.h> // strrchr

#include "step1_shadowmap/base/system/die.h" // allocate, die
#include "step1_shadowmap/base/files/file.h" // file_write

bool image_name_is_known(const char *path)
{
    const char *ending = strrchr(path, '.');
    return ending != NULL && ending != path &&
           (strcmp(ending, ".png") == 0 || strcmp(ending, ".exr") == 0);
}

// IEC 61966-2-1.
static png_byte srgb(float linear)
{
    float value = linear > 1 ? 1 : linear > 0 ? linear : 0; // of NaN: 0
    float encoded = value <= 0.0031308f
                        ? 12.92f * value
                        : 1.055f * powf(value, 1 / 2.4f) - 0.055f;
    return (png_byte)(255 * encoded + 0.5f);
}

static ImageBytes encode_png(const float *pixels, int width, int height,
                             int channels)
{
    size_t count = (size_t)width * (size_t)height * (size_t)channels;
    png_byte *values = allocate(count, 1);
    for (size_t i = 0; i < count; i++) {
        values[i] = srgb(pixels[i]);
    }
    png_image image = {.version = PNG_IMAGE_VERSION,
                       .width = (png_uint_32)width,
                       .height = (png_uint_32)height,
                       .format =
                           channels == 1 ? PNG_FORMAT_GRAY : PNG_FORMAT_RGB};
    ImageBytes file = {.count = PNG_IMAGE_PNG_SIZE_MAX(image)};
    file.bytes = allocate(file.count, 1);
    // OpenGL's first row is the bottom one: so the stride is negative.
    if (!png_image_write_to_memory(&image, file.bytes, &file.count, 0, values,
                                   -width * channels, NULL)) {
        snprintf(file.reason, sizeof file.reason, "%s", image.message);
        free(file.bytes);
        file.bytes = NULL;
    }
    free(values);
    return file;
}

void image_write(const char *path, const float *pixels, int width, int height,
                 int channels)
{
    size_t values = (size_t)width * (size_t)height * (size_t)channels;
    memory_check(values * (sizeof *pixels + 1), "the encoding of %s", path);
    ImageBytes file = strcmp(strrchr(path, '.'), ".png") == 0
                          ? encode_png(pixels, width, height, channels)
                          : image_encode_exr(pixels, width, height, channels);
    if (file.bytes == NULL) {
        die("cannot write %s: %s", path, file.reason);
    }
    file_write(path, file.bytes, file.count);
    free(file.bytes);
}
