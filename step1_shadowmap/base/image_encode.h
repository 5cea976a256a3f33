// A picture as the bytes of a file; in the library image.so.
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

// See image_write.
ImageBytes image_encode(const char *path, const float *pixels, int width,
                        int height, int channels);

#ifdef __cplusplus
}
#endif

#endif
