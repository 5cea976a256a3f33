// A picture in memory, float, with row 0 at the BOTTOM as OpenGL has it. Files
// are top row first; load_picture turns them.
#ifndef ORACLE_PICTURE_H
#define ORACLE_PICTURE_H

#include <string>
#include <vector>

struct Picture {
    int width = 0, height = 0, channels = 0;
    std::vector<float> values;

    float at(int x, int y, int channel = 0) const
    {
        return values[index(x, y, channel)];
    }
    float &at(int x, int y, int channel = 0)
    {
        return values[index(x, y, channel)];
    }
    bool holds(int x, int y) const
    {
        return x >= 0 && y >= 0 && x < width && y < height;
    }

  private:
    size_t index(int x, int y, int channel) const
    {
        return (size_t(y) * size_t(width) + size_t(x)) * size_t(channels) +
               size_t(channel);
    }
};

// Reads any file that OpenImageIO knows; 8-bit values become 0 to 1.
// Throws BadInput when it cannot.
Picture load_picture(const std::string &path);

// Writes a picture of 32-bit floats, top row first. Throws BadInput.
void save_picture(const Picture &picture, const std::string &path);

// Writes a picture of values from 0 to 1 in 8 bits each. Throws BadInput.
void save_bytes(const Picture &picture, const std::string &path);

// The same as save_picture, as bare floats, for gnuplot.
void save_bare(const Picture &picture, const std::string &path);

// NaN and infinite values. Count them first: comparisons call NaN equal.
size_t count_non_finite(const Picture &picture);

#endif
