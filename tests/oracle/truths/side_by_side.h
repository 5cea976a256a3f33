// Two pictures of visibility beside each other, and how they are written.
#ifndef ORACLE_SIDE_BY_SIDE_H
#define ORACLE_SIDE_BY_SIDE_H

#include <string>
#include <vector>

#include "tests/oracle/lib/picture.h"

// Why a pixel is counted, or is not.
enum class Kind : char { NOT_COUNTED, APART, NON_FINITE, COUNTED };

// The two, and their difference, pixel by pixel.
struct Comparison {
    std::string name;
    Picture truth, result; // what it should be, and what it is
    Picture error;         // 0 where a pixel is not counted
    std::vector<Kind> kinds;

    Comparison(const std::string &the_name, int width, int height)
        : name(the_name), truth(blank(width, height)), result(truth),
          error(truth), kinds(truth.values.size(), Kind::NOT_COUNTED)
    {
    }

  private:
    static Picture blank(int width, int height)
    {
        Picture picture{width, height, 1, {}};
        picture.values.resize(size_t(width) * size_t(height));
        return picture;
    }
};

// Writes truth.NAME.exr, error.NAME.exr and error.NAME.bin into a folder.
// Throws BadInput.
void write_comparison(const std::string &folder, const Comparison &comparison);

// Writes truth.png, result.png and difference.png. Throws BadInput.
void write_pictures(const std::string &folder, const Comparison &comparison);

#endif
