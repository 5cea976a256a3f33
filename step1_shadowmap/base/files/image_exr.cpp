// The only C++ file of the programs: it is OpenEXR's language.
#include "step1_shadowmap/base/files/image_encode.h"

#include <ImfChannelList.h> // Channel
#include <ImfFrameBuffer.h> // FrameBuffer, Slice
#include <ImfHeader.h>      // Header
#include <ImfIO.h>          // OStream
#include <ImfOutputFile.h>  // OutputFile
#include <algorithm>        // copy_n, max
#include <cstdint>          // uint64_t
#include <cstdio>           // snprintf
#include <cstdlib>          // free, realloc
#include <exception>
#include <new>     // bad_alloc
#include <utility> // exchange

// The file: whether the disk has room for it is image.c's to find out. Its
// bytes come from malloc: C frees them.
class Memory : public Imf::OStream
{
  public:
    Memory() : Imf::OStream("memory")
    {
    }
    ~Memory() override
    {
        std::free(bytes);
    }

    void write(const char data[], int size) override
    {
        std::size_t end = place + std::size_t(size);
        if (end > room) {
            grow(std::max(end, 2 * room));
        }
        std::copy_n(data, size, bytes + place);
        place = end;
        count = std::max(count, end);
    }

    std::uint64_t tellp() override
    {
        return place;
    }
    void seekp(std::uint64_t to) override
    {
        place = to;
    }

    // Whose they are then.
    char *release()
    {
        return std::exchange(bytes, nullptr);
    }

    std::size_t count = 0;

  private:
    void grow(std::size_t size)
    {
        void *larger = std::realloc(bytes, size);
        if (larger == nullptr) {
            throw std::bad_alloc();
        }
        bytes = static_cast<char *>(larger);
        room = size;
    }

    char *bytes = nullptr;
    std::size_t place = 0, room = 0;
};

static void write_exr(Memory &memory, const float *pixels, int width,
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
        Memory memory;
        write_exr(memory, pixels, width, height, channels);
        result.count = memory.count;
        result.bytes = memory.release();
    } catch (const std::exception &error) { // out of memory, most likely
        std::snprintf(result.reason, sizeof result.reason, "%s", error.what());
    }
    return result;
}
