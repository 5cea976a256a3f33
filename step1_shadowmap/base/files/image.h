// Pictures and maps on disk.
#ifndef BASE_IMAGE_H
#define BASE_IMAGE_H

#include <stdbool.h>

// Whether the name ends in .png or .exr.
bool image_name_is_known(const char *path);

// Writes width x height x channels floats, rows from the bottom up (as OpenGL
// has them), top row first into the file. The ending decides: .png encodes
// linear values in [0, 1] as 8-bit sRGB; .exr keeps every float as it is. The
// file appears whole or not at all; dies if it cannot be written.
void image_write(const char *path, const float *pixels, int width, int height,
                 int channels);

#endif
