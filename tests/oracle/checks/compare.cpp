#include "tests/oracle/checks/compare.h"

#include <algorithm> // max
#include <cmath>     // sqrt, abs

#include "tests/oracle/lib/picture.h"

static bool check_finite(const Picture &picture, const std::string &name,
                         Report &report)
{
    size_t bad = count_non_finite(picture);
    report.line(bad == 0, name, "%zu values not finite", bad);
    return bad == 0;
}

namespace
{

struct Difference {
    double largest = 0, squares = 0;
    size_t values = 0, pixels = 0, over = 0; // over 1/255 in any channel
};

} // namespace

static Difference difference(const Picture &a, const Picture &b)
{
    Difference d;
    for (int y = 0; y < a.height; y++)
        for (int x = 0; x < a.width; x++) {
            double pixel = 0;
            for (int c = 0; c < a.channels; c++) {
                double error = std::abs(double(a.at(x, y, c)) - b.at(x, y, c));
                pixel = std::max(pixel, error);
                d.squares += error * error;
                d.values++;
            }
            d.largest = std::max(d.largest, pixel);
            d.pixels++;
            d.over += pixel > 1.0 / 255 ? 1 : 0;
        }
    return d;
}

void compare_pictures(const std::string &first, const std::string &second,
                      double most, double share, Report &report)
{
    Picture a = load_picture(first), b = load_picture(second);
    if (a.width != b.width || a.height != b.height || a.channels != b.channels)
        throw BadInput(second + ": not of the size and channels of " + first);
    bool finite = check_finite(a, first, report);
    finite = check_finite(b, second, report) && finite;
    if (!finite)
        return;
    Difference d = difference(a, b);
    double over = double(d.over) / double(d.pixels);
    report.line(d.largest <= most && over <= share, "compare",
                "largest %.3g (at most %.3g), RMSE %.3g, share over 1/255 "
                "%.3g (at most %.3g)",
                d.largest, most, std::sqrt(d.squares / double(d.values)), over,
                share);
}
