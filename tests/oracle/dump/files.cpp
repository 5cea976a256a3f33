#include "tests/oracle/dump/files.h"

#include <algorithm> // min, max
#include <cmath>     // sqrt, abs

#include "tests/oracle/filters/chebyshev_bound.h" // blur_share
#include "tests/oracle/lib/rounding.h"
#include "tests/oracle/stages/stage.h" // check_moments

static void check_finite(const Picture &picture, const std::string &name,
                         Report &report)
{
    size_t bad = count_non_finite(picture);
    report.line(bad == 0, name, "%d x %d x %d, %zu values not finite",
                picture.width, picture.height, picture.channels, bad);
}

static void check_range(const Picture &picture, const std::string &name,
                        double low, double high, Report &report)
{
    size_t outside = 0;
    double least = INFINITY, most = -INFINITY;
    for (float value : picture.values) {
        outside += value >= low && value <= high ? 0 : 1;
        least = std::min(least, double(value));
        most = std::max(most, double(value));
    }
    report.line(outside == 0, name + ": range",
                "%zu values outside [%.3g, %.3g]; from %.3g to %.3g", outside,
                low, high, least, most);
}

static Picture check_picture(const Run &run, const std::string &name,
                             int channels, Report &report)
{
    Picture picture = load_file(run, name, run.width, run.height, channels);
    check_finite(picture, name, report);
    return picture;
}

static void check_maps(const Run &run, int layer, Report &report)
{
    std::string number = "." + std::to_string(layer) + ".exr";
    std::string name = (run.step >= 3 ? "moments" : "depth") + number;
    Picture map = load_map(run, layer);
    check_finite(map, name, report);
    check_range(map, name, 0, 1, report);
    if (run.settings.msaa > 1)
        for (const Picture &sample : load_samples(run, layer)) {
            check_finite(sample, "samples" + number, report);
            check_range(sample, "samples" + number, 0, 1, report);
        }
    if (run.step >= 3)
        check_moments(run, layer, report);
    if (run.step < 4)
        return;
    Picture blurred = load_filtered(run, layer);
    check_finite(blurred, "blurred" + number, report);
    // n times the rounded 1/n can be a little over 1.
    check_range(blurred, "blurred" + number, 0, 1 + blur_share(run.settings),
                report);
}

// Where an object is shown its normal has length 1, elsewhere everything is 0.
static void check_normals(const Run &run, const Picture &normal,
                          const Picture &receiver, Report &report)
{
    size_t wrong = 0, shown = 0;
    double worst = 0;
    for (int y = 0; y < run.height; y++)
        for (int x = 0; x < run.width; x++) {
            double square = 0;
            for (int c = 0; c < 3; c++)
                square += double(normal.at(x, y, c)) * normal.at(x, y, c);
            bool object = receiver.at(x, y, 3) >= 0;
            double error = std::abs(std::sqrt(square) - (object ? 1 : 0));
            shown += object ? 1 : 0;
            worst = std::max(worst, error);
            // Square sum, root, quotient; an inverse root of 2 ulp.
            wrong += error <= rounding_share(8) ? 0 : 1;
        }
    report.line(wrong == 0, "normal.exr: unit length",
                "%zu of %zu pixels are not, worst by %.3g", wrong, shown,
                worst);
}

void check_files(const Run &run, Report &report)
{
    size_t maps = run.settings.shadows ? run.views.size() : 0;
    for (size_t layer = 0; layer < maps; layer++)
        check_maps(run, int(layer), report);
    Picture receiver = check_picture(run, "receiver.exr", 4, report);
    Picture normal = check_picture(run, "normal.exr", 3, report);
    check_picture(run, "position.exr", 3, report);
    check_picture(run, "image.exr", 3, report);
    if (run.views.at(0).split())
        check_picture(run, "handover.exr", 4, report);
    Picture visibility = check_picture(run, "visibility.exr", 1, report);
    check_range(visibility, "visibility.exr", 0, 1, report);
    check_normals(run, normal, receiver, report);
}
