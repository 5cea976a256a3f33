#include "tests/oracle/errors.h"

#include <algorithm> // nth_element, max, min
#include <cmath>     // isfinite, sqrt
#include <cstdio>    // printf
#include <filesystem>
#include <set>

#include "tests/oracle/axis_kernel.h"
#include "tests/oracle/parallel.h"
#include "tests/oracle/report.h" // BadInput
#include "tests/oracle/seam.h"
#include "tests/oracle/truth.h"

namespace
{

enum class Kind : char { NOT_COUNTED, APART, NON_FINITE, COUNTED };

// One truth against the program, pixel by pixel.
struct Comparison {
    Picture truth, error;
    std::vector<Kind> kinds;

    Comparison(int width, int height)
        : truth{width, height, 1, {}}, error{width, height, 1, {}}
    {
        size_t count = size_t(width) * size_t(height);
        truth.values.resize(count);
        error.values.resize(count);
        kinds.resize(count, Kind::NOT_COUNTED);
    }
};

} // namespace

static void compare_pixel(const Pixel &pixel, const Truth &truth,
                          Comparison &comparison)
{
    // The background is 1, what faces away is 0: in every program and truth.
    TruthValue value{pixel.receiver.shown ? 0.0 : 1.0};
    Kind kind = Kind::NOT_COUNTED;
    double error = 0;
    if (pixel.counts) {
        value = truth.at(pixel);
        kind = pixel.grazing || value.apart ? Kind::APART : Kind::COUNTED;
        if (!std::isfinite(pixel.receiver.visibility))
            kind = Kind::NON_FINITE;
        if (kind == Kind::COUNTED)
            error = value.error(pixel.receiver.visibility);
    }
    comparison.truth.at(pixel.x, pixel.y) = float(value.value);
    comparison.error.at(pixel.x, pixel.y) = float(error);
    size_t index =
        size_t(pixel.y) * size_t(comparison.truth.width) + size_t(pixel.x);
    comparison.kinds[index] = kind;
}

// Of the pixels for which `of` holds.
static void print(const std::string &name, const Comparison &comparison,
                  const std::function<bool(size_t)> &of)
{
    std::vector<double> errors;
    size_t apart = 0, non_finite = 0, over = 0;
    double squares = 0, largest = 0;
    for (size_t i = 0; i < comparison.kinds.size(); i++) {
        if (!of(i))
            continue;
        apart += comparison.kinds[i] == Kind::APART ? 1 : 0;
        non_finite += comparison.kinds[i] == Kind::NON_FINITE ? 1 : 0;
        if (comparison.kinds[i] != Kind::COUNTED)
            continue;
        double error = std::abs(double(comparison.error.values[i]));
        errors.push_back(error);
        squares += error * error;
        largest = std::max(largest, error);
        over += error > 1.0 / 255 ? 1 : 0;
    }
    double count = std::max<double>(double(errors.size()), 1), p99 = 0;
    if (!errors.empty()) { // at least 99 % are not larger
        auto place = errors.begin() + long(std::ceil(0.99 * count)) - 1;
        std::nth_element(errors.begin(), place, errors.end());
        p99 = *place;
    }
    std::printf("%s,%zu,%zu,%zu,%.6g,%.6g,%.6g,%.6g\n", name.c_str(),
                errors.size(), apart, non_finite, std::sqrt(squares / count),
                p99, largest, double(over) / count);
}

static void write(const std::string &folder, const std::string &name,
                  const Comparison &comparison)
{
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    if (failure)
        throw BadInput(folder + ": cannot be made: " + failure.message());
    save_picture(comparison.truth, folder + "/truth." + name + ".exr");
    save_picture(comparison.error, folder + "/error." + name + ".exr");
    save_bare(comparison.error, folder + "/error." + name + ".bin");
}

static std::vector<Truth> truths_of(const TruthScene &scene,
                                    const ErrorOptions &options)
{
    std::vector<Truth> truths;
    const Run &run = scene.run;
    if (run.step == 5 && !run.settings.reduces())
        truths.push_back(lower_truth(scene));
    truths.push_back(pcf_truth(scene));
    truths.push_back(footprint_truth(scene, options.rays));
    truths.push_back(hard_truth(scene));
    if (options.light_size > 0)
        truths.push_back(area_truth(scene, options.rays, options.light_size));
    return truths;
}

// Of every pixel, which edge of the cube its filter reaches over: the two faces
// as digits; empty: none.
static std::vector<std::string> seams_of(const TruthScene &scene)
{
    const Run &run = scene.run;
    double reach = AxisKernel(run.step, run.settings).half_width();
    std::vector<std::string> seams;
    for (int y = 0; y < run.height; y++)
        for (int x = 0; x < run.width; x++) {
            Receiver r = scene.receivers.at(x, y);
            seams.emplace_back();
            if (!r.shown)
                continue;
            Seam seam = nearest_seam(r, scene.view(r));
            if (seam.texels < reach)
                seams.back() = std::to_string(std::min(r.layer, seam.face)) +
                               std::to_string(std::max(r.layer, seam.face));
        }
    return seams;
}

static void print_seams(const std::string &truth, const Comparison &comparison,
                        const std::vector<std::string> &seams)
{
    std::set<std::string> names(seams.begin(), seams.end());
    for (const std::string &name : names)
        print(truth + (name.empty() ? ".rest" : ".seam" + name), comparison,
              [&](size_t i) { return seams[i] == name; });
}

void print_errors(const Run &run, const ErrorOptions &options)
{
    TruthScene scene(run);
    std::vector<Truth> truths = truths_of(scene, options);
    std::vector<Comparison> comparisons(truths.size(),
                                        Comparison(run.width, run.height));
    parallel_rows(run.height, [&](int y) {
        for (int x = 0; x < run.width; x++) {
            Pixel pixel = scene.pixel(x, y);
            for (size_t i = 0; i < truths.size(); i++)
                compare_pixel(pixel, truths[i], comparisons[i]);
        }
    });
    std::printf("truth,pixels,apart,nonfinite,rmse,p99,max,share\n");
    std::vector<std::string> seams;
    if (options.seams)
        seams = seams_of(scene);
    for (size_t i = 0; i < truths.size(); i++) {
        print(truths[i].name, comparisons[i], [](size_t) { return true; });
        if (options.seams)
            print_seams(truths[i].name, comparisons[i], seams);
        if (!options.write_into.empty())
            write(options.write_into, truths[i].name, comparisons[i]);
    }
}
