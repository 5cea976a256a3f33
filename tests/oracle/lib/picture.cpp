#include "tests/oracle/lib/picture.h"

#include <OpenImageIO/imageio.h>
#include <algorithm> // swap_ranges
#include <cmath>     // isfinite
#include <fstream>   // ofstream

#include "tests/oracle/lib/verdict.h"

static void turn_rows(Picture &picture)
{
    size_t row = size_t(picture.width) * size_t(picture.channels);
    for (int y = 0; y < picture.height / 2; y++) {
        auto low = picture.values.begin() + long(size_t(y) * row);
        auto high = picture.values.end() - long(size_t(y + 1) * row);
        std::swap_ranges(low, low + long(row), high);
    }
}

Picture load_picture(const std::string &path)
{
    auto file = OIIO::ImageInput::open(path);
    if (!file)
        throw BadInput(path + ": cannot be read: " + OIIO::geterror());
    const OIIO::ImageSpec &spec = file->spec();
    Picture picture;
    picture.width = spec.width;
    picture.height = spec.height;
    picture.channels = spec.nchannels;
    picture.values.resize(size_t(spec.width) * size_t(spec.height) *
                          size_t(spec.nchannels));
    if (!file->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT,
                          picture.values.data()))
        throw BadInput(path + ": cannot be read: " + file->geterror());
    turn_rows(picture);
    return picture;
}

static void save(const Picture &picture, const std::string &path,
                 OIIO::TypeDesc type)
{
    Picture turned = picture;
    turn_rows(turned);
    auto file = OIIO::ImageOutput::create(path);
    OIIO::ImageSpec spec(turned.width, turned.height, turned.channels, type);
    if (!file || !file->open(path, spec) ||
        !file->write_image(OIIO::TypeDesc::FLOAT, turned.values.data()) ||
        !file->close())
        throw BadInput(path + ": cannot be written: " + OIIO::geterror());
}

void save_picture(const Picture &picture, const std::string &path)
{
    save(picture, path, OIIO::TypeDesc::FLOAT);
}

void save_bytes(const Picture &picture, const std::string &path)
{
    save(picture, path, OIIO::TypeDesc::UINT8);
}

void save_bare(const Picture &picture, const std::string &path)
{
    Picture turned = picture;
    turn_rows(turned);
    std::ofstream file(path, std::ios::binary);
    file.write(reinterpret_cast<const char *>(turned.values.data()),
               std::streamsize(turned.values.size() * sizeof(float)));
    file.close();
    if (!file)
        throw BadInput(path + ": cannot be written");
}

size_t count_non_finite(const Picture &picture)
{
    size_t count = 0;
    for (float value : picture.values)
        count += std::isfinite(value) ? 0 : 1;
    return count;
}
