// Puts pictures of one size side by side, at half their size, with black lines
// between them: out/steps.png.
// usage: strip OUTPUT.png INPUT.png...
#include <png.h>    // png_image
#include <stdint.h> // uint8_t
#include <stdio.h>  // fprintf
#include <stdlib.h> // calloc, exit, free
#include <string.h> // memset, strerror

enum { CHANNELS = 3, GAP = 16 }; // pixels before halving

static void fail(const char *name, const char *why)
{
    fprintf(stderr, "strip: %s: %s\n", name, why);
    exit(1);
}

static png_image opened(const char *name)
{
    png_image image;
    memset(&image, 0, sizeof image);
    image.version = PNG_IMAGE_VERSION;
    if (!png_image_begin_read_from_file(&image, name))
        fail(name, image.message);
    image.format = PNG_FORMAT_RGB;
    return image;
}

// Makes each pixel the mean of four, in place. An odd row or column is dropped.
static void halve(uint8_t *pixels, png_image *image)
{
    size_t row = (size_t)image->width * CHANNELS;
    image->width /= 2;
    image->height /= 2;
    uint8_t *mean = pixels;
    for (size_t y = 0; y < image->height; y++)
        for (size_t i = 0; i < (size_t)image->width * CHANNELS; i++) {
            size_t x = i / CHANNELS * 2 * CHANNELS + i % CHANNELS;
            const uint8_t *p = pixels + 2 * y * row + x;
            unsigned above = (unsigned)p[0] + p[CHANNELS];
            unsigned below = (unsigned)p[row] + p[row + CHANNELS];
            *mean++ = (uint8_t)((above + below + 2) / 4);
        }
}

int main(int argc, char **argv)
{
    if (argc < 3)
        fail("usage", "strip OUTPUT.png INPUT.png...");
    png_image strip = opened(argv[2]);
    unsigned width = strip.width, height = strip.height;
    unsigned count = (unsigned)argc - 2;
    strip.width = count * width + (count - 1) * GAP;
    uint8_t *pixels =
        calloc((size_t)strip.width * height, CHANNELS * sizeof *pixels);
    if (!pixels)
        fail(argv[1], "no memory");
    png_image_free(&strip);
    for (unsigned i = 0; i < count; i++) {
        png_image image = opened(argv[i + 2]);
        if (image.width != width || image.height != height)
            fail(argv[i + 2], "not of the first picture's size");
        uint8_t *place = pixels + (size_t)i * (width + GAP) * CHANNELS;
        int stride = (int)(strip.width * CHANNELS);
        if (!png_image_finish_read(&image, NULL, place, stride, NULL))
            fail(argv[i + 2], image.message);
    }
    halve(pixels, &strip);
    if (!png_image_write_to_file(&strip, argv[1], 0, pixels, 0, NULL))
        fail(argv[1], strip.message);
    free(pixels);
}
