#include "tests/oracle/picture.h"

#include <OpenImageIO/imageio.h>
#include <algorithm> // swap_ranges
#include <cmath>     // isfinite

#include "tests/oracle/report.h"

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

size_t count_non_finite(const Picture &picture)
{
    size_t count = 0;
    for (float value : picture.values)
        count += std::isfinite(value) ? 0 : 1;
    return count;
}
