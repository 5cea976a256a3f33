// A picture as the bytes of a PNG file.
#ifndef BASE_IMAGE_PNG_H
#define BASE_IMAGE_PNG_H

#include "step1_shadowmap/base/image_encode.h" // ImageBytes

// See image_write; 1 or 3 channels. It takes libpng and not OpenImageIO, which
// stands on it and on some 250 other libraries: loading those takes longer than
// a frame.
ImageBytes image_encode_png(const float *pixels, int width, int height,
                            int channels);

#endif
