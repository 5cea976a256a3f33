// The only C++ file of the programs: OpenImageIO has no C interface. It is a
// library of its own, loaded by image.c when there is something to write.
#include "step1_shadowmap/base/image_encode.h"

#include <OpenImageIO/filesystem.h> // IOVecOutput
#include <OpenImageIO/imageio.h>    // ImageOutput, ImageSpec
#include <cstddef>                  // ptrdiff_t
#include <cstdio>                   // snprintf
#include <cstdlib>                  // malloc
#include <cstring>                  // memcpy
#include <exception>
#include <string>
#include <vector>

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

ImageBytes image_encode(const char *path, const float *pixels, int width,
                        int height, int channels)
{
    // A picture is small: handing rows to other threads takes longer.
    OIIO::attribute("threads", 1);
    ImageBytes result = {};
    std::string reason;
    try {
        OIIO::ImageSpec spec(width, height, channels, OIIO::TypeDesc::FLOAT);
        // Else the writer puts the time there, and no two files are the same.
        spec.attribute("DateTime", "1970:01:01 00:00:00");
        std::vector<unsigned char> bytes = encode(path, pixels, spec, reason);
        if (!bytes.empty()) {
            result.bytes = std::malloc(bytes.size());
            result.count = bytes.size();
        }
        if (result.bytes != nullptr) {
            std::memcpy(result.bytes, bytes.data(), bytes.size());
        }
    } catch (const std::exception &error) { // out of memory, most likely
        reason = error.what();
    }
    std::snprintf(result.reason, sizeof result.reason, "%s", reason.c_str());
    return result;
}
