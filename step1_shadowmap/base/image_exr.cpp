// The only C++ file of the programs: it is OpenEXR's language.
#include "step1_shadowmap/base/image_encode.h"

#include <ImfChannelList.h> // Channel
#include <ImfFrameBuffer.h> // FrameBuffer, Slice
#include <ImfHeader.h>      // Header
#include <ImfIO.h>          // OStream
#include <ImfOutputFile.h>  // OutputFile
#include <algorithm>        // copy, copy_n, max
#include <cstdint>          // uint64_t
#include <cstdio>           // snprintf
#include <cstdlib>          // malloc
#include <exception>
#include <new> // bad_alloc
#include <vector>

// The file: whether the disk has room for it is image.c's to find out.
class Memory : public Imf::OStream
{
  public:
    Memory() : Imf::OStream("memory")
    {
    }

    void write(const char data[], int count) override
    {
        bytes.resize(std::max(bytes.size(), place + std::size_t(count)));
        std::copy_n(data, count, bytes.begin() + std::ptrdiff_t(place));
        place += std::size_t(count);
    }

    std::uint64_t tellp() override
    {
        return place;
    }
    void seekp(std::uint64_t to) override
    {
        place = to;
    }

    std::vector<char> bytes;

  private:
    std::size_t place = 0;
};

// Rows as they are stored: OpenGL's first row is the bottom one.
static std::vector<float> top_row_first(const float *pixels, std::size_t row,
                                        int height)
{
    std::vector<float> rows;
    rows.reserve(row * std::size_t(height));
    for (int y = height - 1; y >= 0; y--) {
        const float *first = pixels + row * std::size_t(y);
        rows.insert(rows.end(), first, first + row);
    }
    return rows;
}

static void write_exr(Memory &memory, const float *pixels, int width,
                      int height, int channels)
{
    static const char *const grey[] = {"Y"};
    static const char *const color[] = {"R", "G", "B", "A"};
    const char *const *names = channels == 1 ? grey : color;
    std::size_t row = std::size_t(width) * std::size_t(channels);
    std::vector<float> rows = top_row_first(pixels, row, height);
    Imf::Header header(width, height);
    Imf::FrameBuffer buffer;
    for (int c = 0; c < channels; c++) {
        char *first = reinterpret_cast<char *>(rows.data() + c);
        header.channels().insert(names[c], Imf::Channel(Imf::FLOAT));
        buffer.insert(names[c],
                      Imf::Slice(Imf::FLOAT, first,
                                 std::size_t(channels) * sizeof(float),
                                 row * sizeof(float)));
    }
    Imf::OutputFile file(memory, header, 0); // no threads: a picture is small
    file.setFrameBuffer(buffer);
    file.writePixels(height);
}

ImageBytes image_encode_exr(const float *pixels, int width, int height,
                            int channels)
{
    ImageBytes result = {};
    try {
        Memory memory;
        write_exr(memory, pixels, width, height, channels);
        result.count = memory.bytes.size();
        result.bytes = std::malloc(result.count);
        if (result.bytes == nullptr) {
            throw std::bad_alloc();
        }
        std::copy(memory.bytes.begin(), memory.bytes.end(),
                  static_cast<char *>(result.bytes));
    } catch (const std::exception &error) { // out of memory, most likely
        std::snprintf(result.reason, sizeof result.reason, "%s", error.what());
    }
    return result;
}
