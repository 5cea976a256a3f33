// The only C++ file of the programs: OpenImageIO has no C interface.
#include "step1_shadowmap/base/image.h"

#include <OpenImageIO/color.h>      // linear_to_sRGB
#include <OpenImageIO/filesystem.h> // IOVecOutput
#include <OpenImageIO/imageio.h>    // ImageOutput, ImageSpec
#include <algorithm>                // clamp
#include <cstddef>                  // ptrdiff_t
#include <exception>
#include <string>
#include <vector>

#include "step1_shadowmap/base/die.h"  // die
#include "step1_shadowmap/base/file.h" // file_write

static bool ends_with(const std::string &text, const std::string &ending)
{
    return text.size() > ending.size() &&
           text.compare(text.size() - ending.size(), ending.size(), ending) ==
               0;
}

bool image_name_is_known(const char *path)
{
    return ends_with(path, ".png") || ends_with(path, ".exr");
}

// Rows as they are stored: OpenGL's first row is the bottom one.
static bool write_rows(OIIO::ImageOutput &output, const float *pixels,
                       const OIIO::ImageSpec &spec)
{
    std::ptrdiff_t row = spec.width * spec.nchannels *
                         static_cast<std::ptrdiff_t>(sizeof(float));
    const float *top =
        pixels + std::ptrdiff_t(spec.height - 1) * spec.width * spec.nchannels;
    return output.write_image(OIIO::TypeDesc::FLOAT, top, OIIO::AutoStride,
                              -row);
}

static std::vector<float> encode_srgb(const float *pixels, std::size_t count)
{
    std::vector<float> encoded(count);
    for (std::size_t i = 0; i < count; i++) {
        encoded[i] = OIIO::linear_to_sRGB(std::clamp(pixels[i], 0.0f, 1.0f));
    }
    return encoded;
}

// The file's bytes, or nothing and the reason. Encoded in memory: the writers
// of some formats do not say when the disk is full.
static std::vector<unsigned char> encode(const char *path, const float *pixels,
                                         const OIIO::ImageSpec &spec,
                                         std::string &reason)
{
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    auto output = OIIO::ImageOutput::create(path);
    if (!output) {
        reason = OIIO::geterror();
    } else if (!output->set_ioproxy(&memory) || !output->open(path, spec) ||
               !write_rows(*output, pixels, spec) || !output->close()) {
        reason = output->geterror();
        bytes.clear();
    }
    return bytes;
}

static void write(const char *path, const float *pixels, int width, int height,
                  int channels)
{
    bool png = ends_with(path, ".png");
    OIIO::ImageSpec spec(width, height, channels,
                         png ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::FLOAT);
    // Else the writer puts the time there, and no two files are the same.
    spec.attribute("DateTime", "1970:01:01 00:00:00");
    std::vector<float> encoded;
    if (png) {
        spec.attribute("oiio:ColorSpace", "sRGB");
        encoded = encode_srgb(pixels, std::size_t(width) * height * channels);
        pixels = encoded.data();
    }
    std::string reason;
    std::vector<unsigned char> bytes = encode(path, pixels, spec, reason);
    if (bytes.empty()) {
        die("cannot write %s: %s", path, reason.c_str());
    }
    file_write(path, bytes.data(), bytes.size());
}

void image_write(const char *path, const float *pixels, int width, int height,
                 int channels)
{
    try {
        write(path, pixels, width, height, channels);
    } catch (const std::exception &error) { // out of memory, most likely
        die("cannot write %s: %s", path, error.what());
    }
}
