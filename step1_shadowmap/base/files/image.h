// Pictures and maps on disk. By the libraries of the two formats themselves:
// OpenImageIO, which stands on them, stands on some 250 others, and loading
// those takes longer than a frame.
#ifndef BASE_IMAGE_H
#define BASE_IMAGE_H

#include <stdbool.h>
#include <stddef.h> // size_t

#ifdef __cplusplus
extern "C" {
#endif

// Whether the name ends in .png or .exr.
bool image_name_is_known(const char *path);

// Writes width x height x channels floats, rows from the bottom up (as OpenGL
// has them), top row first into the file. The ending decides: .png encodes
// linear values in [0, 1] as 8-bit sRGB; .exr keeps every float as it is. The
// file appears whole or not at all; dies if it cannot be written.
void image_write(const char *path, const float *pixels, int width, int height,
                 int channels);

// A picture as the bytes of a file.
typedef struct ImageBytes {
    void *bytes; // to be freed; NULL if it failed
    size_t count;
    char reason[256]; // why it failed
} ImageBytes;

// 1 to 4 channels.
ImageBytes image_encode_exr(const float *pixels, int width, int height,
                            int channels);

#ifdef __cplusplus
}
#endif

#endif
