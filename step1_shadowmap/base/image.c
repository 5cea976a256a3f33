#include "step1_shadowmap/base/image.h"

#include <dlfcn.h>  // dlopen
#include <stdlib.h> // free
#include <string.h> // strrchr

#include "step1_shadowmap/base/die.h"          // die
#include "step1_shadowmap/base/file.h"         // file_write
#include "step1_shadowmap/base/image_encode.h" // ImageBytes
#include "step1_shadowmap/base/image_png.h"    // image_encode_png
#include "step1_shadowmap/base/memory.h"       // memory_check

bool image_name_is_known(const char *path)
{
    const char *ending = strrchr(path, '.');
    return ending != NULL && ending != path &&
           (strcmp(ending, ".png") == 0 || strcmp(ending, ".exr") == 0);
}

typedef ImageBytes ImageEncode(const char *path, const float *pixels, int width,
                               int height, int channels);

// OpenImageIO stands on some 250 other libraries. Loading them takes longer
// than a frame, so they are loaded with the first file that needs them: not for
// --help, a wrong option, a window or a PNG.
static ImageEncode *load_encoder(void)
{
    void *library = dlopen("image.so", RTLD_LAZY); // beside, see base.mk
    void *symbol = library != NULL ? dlsym(library, "image_encode") : NULL;
    if (symbol == NULL) {
        die("cannot load the image library: %s", dlerror());
    }
    // ISO C has no cast from an object's to a function's address.
    ImageEncode *encode;
    memcpy(&encode, &symbol, sizeof encode);
    return encode;
}

void image_write(const char *path, const float *pixels, int width, int height,
                 int channels)
{
    size_t values = (size_t)width * (size_t)height * (size_t)channels;
    memory_check(values * (sizeof *pixels + 1), "the encoding of %s", path);
    ImageBytes file =
        strcmp(strrchr(path, '.'), ".png") == 0
            ? image_encode_png(pixels, width, height, channels)
            : load_encoder()(path, pixels, width, height, channels);
    if (file.bytes == NULL) {
        die("cannot write %s: %s", path, file.reason);
    }
    file_write(path, file.bytes, file.count);
    free(file.bytes);
}
