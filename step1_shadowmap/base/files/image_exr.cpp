// The only C++ file of the programs: it is OpenEXR's language.
#include "step1_shadowmap/base/files/image.h"

#include <ImfChannelList.h> // Channel
#include <ImfFrameBuffer.h> // FrameBuffer, Slice
#include <ImfHeader.h>      // Header
#include <ImfOutputFile.h>  // OutputFile
#include <ImfStdIO.h>       // StdOSStream
#include <cstdio>           // snprintf
#include <cstdlib>          // malloc
#include <cstring>          // memcpy
#include <exception>
#include <new> // bad_alloc
#include <string>

static void write_exr(Imf::OStream &memory, const float *pixels, int width,
                      int height, int channels)
{
    static const char *const grey[] = {"Y"};
    static const char *const color[] = {"R", "G", "B", "A"};
    const char *const *names = channels == 1 ? grey : color;
    std::size_t row = std::size_t(width) * std::size_t(channels);
    Imf::Header header(width, height);
    for (int c = 0; c < channels; c++) {
        header.channels().insert(names[c], Imf::Channel(Imf::FLOAT));
    }
    Imf::OutputFile file(memory, header, 0); // no threads: a picture is small
    // Its first row is the top one, OpenGL's the bottom one.
    for (int y = height - 1; y >= 0; y--) {
        const float *values = pixels + row * std::size_t(y);
        Imf::FrameBuffer buffer;
        for (int c = 0; c < channels; c++) {
            char *first =
                const_cast<char *>(reinterpret_cast<const char *>(values + c));
            // A stride of 0: whatever row it is, it is here.
            buffer.insert(names[c],
                          Imf::Slice(Imf::FLOAT, first,
                                     std::size_t(channels) * sizeof(float), 0));
        }
        file.setFrameBuffer(buffer);
        file.writePixels(1);
    }
}

ImageBytes image_encode_exr(const float *pixels, int width, int height,
                            int channels)
{
    ImageBytes result = {};
    try {
        Imf::StdOSStream memory;
        write_exr(memory, pixels, width, height, channels);
        const std::string bytes = memory.str();
        result.count = bytes.size();
        result.bytes = std::malloc(bytes.size()); // C frees it
        if (result.bytes == nullptr) {
            throw std::bad_alloc();
        }
        std::memcpy(result.bytes, bytes.data(), bytes.size());
    } catch (const std::exception &error) { // out of memory, most likely
        std::snprintf(result.reason, sizeof result.reason, "%s", error.what());
    }
    return result;
}
