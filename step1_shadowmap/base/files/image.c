#include "step1_shadowmap/base/files/image.h"

#include <stdlib.h> // free
#include <string.h> // strrchr

#include "step1_shadowmap/base/system/die.h"         // die
#include "step1_shadowmap/base/files/file.h"         // file_write
#include "step1_shadowmap/base/files/image_encode.h" // image_encode_png

bool image_name_is_known(const char *path)
{
    const char *ending = strrchr(path, '.');
    return ending != NULL && ending != path &&
           (strcmp(ending, ".png") == 0 || strcmp(ending, ".exr") == 0);
}

void image_write(const char *path, const float *pixels, int width, int height,
                 int channels)
{
    size_t values = (size_t)width * (size_t)height * (size_t)channels;
    memory_check(values * (sizeof *pixels + 1), "the encoding of %s", path);
    ImageBytes file = strcmp(strrchr(path, '.'), ".png") == 0
                          ? image_encode_png(pixels, width, height, channels)
                          : image_encode_exr(pixels, width, height, channels);
    if (file.bytes == NULL) {
        die("cannot write %s: %s", path, file.reason);
    }
    file_write(path, file.bytes, file.count);
    free(file.bytes);
}
