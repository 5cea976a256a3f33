// A picture as the bytes of a file: see image_write. By the libraries of the
// two formats themselves: OpenImageIO, which stands on them, stands on some 250
// others, and loading those takes longer than a frame.
#ifndef BASE_IMAGE_ENCODE_H
#define BASE_IMAGE_ENCODE_H

#include <stddef.h> // size_t

#ifdef __cplusplus
extern "C" {
#endif

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
