#include "step1_shadowmap/base/files/image_encode.h"

#include <math.h>   // powf
#include <png.h>    // png_image_write_to_memory
#include <stdio.h>  // snprintf
#include <stdlib.h> // free, malloc

#include "step1_shadowmap/base/system/die.h" // allocate

// IEC 61966-2-1.
static png_byte srgb(float linear)
{
    float value = linear > 1 ? 1 : linear > 0 ? linear : 0; // of NaN: 0
    float encoded = value <= 0.0031308f
                        ? 12.92f * value
                        : 1.055f * powf(value, 1 / 2.4f) - 0.055f;
    return (png_byte)(255 * encoded + 0.5f);
}

ImageBytes image_encode_png(const float *pixels, int width, int height,
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
