#include "tests/oracle/checks/errors.h"

#include <algorithm> // nth_element, max, min
#include <cmath>     // isfinite, sqrt
#include <cstdio>    // printf
#include <set>

#include "tests/oracle/filters/axis_kernel.h"
#include "tests/oracle/truths/chain.h"
#include "tests/oracle/truths/side_by_side.h"
#include "tests/oracle/truths/kept_truth.h"
#include "tests/oracle/lib/parallel.h"
#include "tests/oracle/lib/verdict.h" // BadInput
#include "tests/oracle/truths/seam.h"
#include "tests/oracle/truths/truth.h"

namespace
{

// A truth's name, what it depends on besides the run, and how it is made.
struct Wanted {
    std::string name, details;
    std::function<Truth()> make;
};

// A truth as a picture of TRUTH_CHANNELS.
struct Judge {
    std::string name;
    Picture values;
};

} // namespace

static std::vector<Pixel> pixels_of(const TruthScene &scene)
{
    size_t width = size_t(scene.run.width), height = size_t(scene.run.height);
    std::vector<Pixel> pixels(width * height);
    parallel_rows(int(height), [&](int y) {
        for (int x = 0; x < int(width); x++)
            pixels[size_t(y) * width + size_t(x)] = scene.pixel(x, y);
    });
    return pixels;
}

// The background is 1, what faces away is 0: in every program and truth.
static Picture picture_of(const Run &run, const std::vector<Pixel> &pixels,
                          const Truth &truth)
{
    Picture picture{run.width, run.height, TRUTH_CHANNELS, {}};
    picture.values.resize(pixels.size() * TRUTH_CHANNELS);
    parallel_rows(run.height, [&](int y) {
        for (int x = 0; x < run.width; x++) {
            const Pixel &pixel = pixels[size_t(y * run.width + x)];
            TruthValue value{pixel.receiver.shown ? 0.0 : 1.0};
            if (pixel.counts)
                value = truth.at(pixel);
            picture.at(x, y, 0) = float(value.value);
            picture.at(x, y, 1) = float(value.below);
            picture.at(x, y, 2) = float(value.above);
            picture.at(x, y, 3) = value.apart ? 1 : 0;
        }
    });
    return picture;
}

static TruthValue value_at(const Picture &picture, const Pixel &pixel)
{
    auto channel = [&](int i) {
        return double(picture.at(pixel.x, pixel.y, i));
    };
    return {channel(0), channel(3) != 0, channel(1), channel(2)};
}

static Kind kind_of(const Pixel &pixel, const TruthValue &value)
{
    if (!pixel.counts)
        return Kind::NOT_COUNTED;
    if (!std::isfinite(pixel.receiver.visibility))
        return Kind::NON_FINITE;
    return pixel.grazing || value.apart ? Kind::APART : Kind::COUNTED;
}

static Comparison compare(const Run &run, const std::vector<Pixel> &pixels,
                          const Judge &judge)
{
    Comparison comparison(judge.name, run.width, run.height);
    for (const Pixel &pixel : pixels) {
        TruthValue value = value_at(judge.values, pixel);
        size_t index = size_t(pixel.y * run.width + pixel.x);
        Kind kind = kind_of(pixel, value);
        double error =
            kind == Kind::COUNTED ? value.error(pixel.receiver.visibility) : 0;
        comparison.truth.at(pixel.x, pixel.y) = float(value.value);
        comparison.result.at(pixel.x, pixel.y) =
            float(pixel.receiver.visibility);
        comparison.error.at(pixel.x, pixel.y) = float(error);
        comparison.kinds[index] = kind;
    }
    return comparison;
}

// One link of the chain: what becomes of the visibility when `before` is
// replaced by `after`, on the pixels that every link counts.
static Comparison link(const std::vector<Kind> &kinds, const Picture &before,
                       const Picture &after, const std::string &name)
{
    Comparison comparison("chain." + name, before.width, before.height);
    comparison.kinds = kinds;
    for (int y = 0; y < before.height; y++)
        for (int x = 0; x < before.width; x++) {
            size_t index = size_t(y) * size_t(before.width) + size_t(x);
            comparison.truth.at(x, y) = before.at(x, y);
            comparison.result.at(x, y) = after.at(x, y);
            if (kinds[index] == Kind::COUNTED)
                comparison.error.at(x, y) = after.at(x, y) - before.at(x, y);
        }
    return comparison;
}

// Of the pixels for which `of` holds.
static void print(const std::string &name, const Comparison &comparison,
                  const std::function<bool(size_t)> &of)
{
    std::vector<double> errors;
    size_t apart = 0, non_finite = 0, over = 0;
    double sum = 0, squares = 0, largest = 0;
    for (size_t i = 0; i < comparison.kinds.size(); i++) {
        if (!of(i))
            continue;
        apart += comparison.kinds[i] == Kind::APART ? 1 : 0;
        non_finite += comparison.kinds[i] == Kind::NON_FINITE ? 1 : 0;
        if (comparison.kinds[i] != Kind::COUNTED)
            continue;
        double error = std::abs(double(comparison.error.values[i]));
        errors.push_back(error);
        sum += double(comparison.error.values[i]);
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
    std::printf("%s,%zu,%zu,%zu,%.6g,%.6g,%.6g,%.6g,%.6g\n", name.c_str(),
                errors.size(), apart, non_finite, std::sqrt(squares / count),
                p99, largest, double(over) / count, sum / count);
}

static std::string in_words(const char *format, double a, double b)
{
    char text[80];
    std::snprintf(text, sizeof text, format, a, b);
    return text;
}

static std::vector<Wanted> truths_of(const TruthScene &scene,
                                     const ErrorOptions &options)
{
    std::vector<Wanted> truths;
    const Run &run = scene.run;
    double rays = options.rays, size = options.light_size;
    std::string count = in_words("%g", rays, 0);
    if (run.step == 5 && !run.settings.reduces() && !run.settings.soft &&
        options.lower)
        truths.push_back(
            {"lower", "", [&scene] { return lower_truth(scene); }});
    if (run.settings.has_weights()) {
        truths.push_back({"pcf", "", [&scene] { return pcf_truth(scene); }});
        truths.push_back({"footprint", count, [&scene, rays] {
                              return footprint_truth(scene, rays);
                          }});
    }
    truths.push_back({"hard", "", [&scene] { return hard_truth(scene); }});
    if (size > 0)
        truths.push_back(
            {"area", in_words("%g-%.17g", rays, size),
             [&scene, rays, size] { return area_truth(scene, rays, size); }});
    return truths;
}

static std::vector<Judge> judges_of(const TruthScene &scene,
                                    const std::vector<Pixel> &pixels,
                                    const ErrorOptions &options)
{
    KeptTruths kept(scene, options.keep_in);
    std::vector<Judge> judges;
    for (const Wanted &wanted : truths_of(scene, options)) {
        auto make = [&] {
            return picture_of(scene.run, pixels, wanted.make());
        };
        // The lower bound is made of what the program stored.
        bool keep = wanted.name != "lower";
        judges.push_back(
            {wanted.name,
             keep ? kept.find(wanted.name, wanted.details, make) : make()});
    }
    return judges;
}

// Of a technique that imitates a light with an area, the area's truth, if that
// was asked for.
static const Judge &light_of(const Run &run, const std::vector<Judge> &judges)
{
    const char *name = run.settings.has_weights() ? "hard" : "area";
    for (const Judge &judge : judges)
        if (judge.name == name)
            return judge;
    return judges.back();
}

// Light truth, footprint truth, same-weights PCF, the models of the technique,
// the program: a comparison for each step from one to the next.
static std::vector<Comparison> chain_of(const TruthScene &scene,
                                        const std::vector<Pixel> &pixels,
                                        const std::vector<Judge> &judges)
{
    const Run &run = scene.run;
    std::vector<Judge> images = {light_of(run, judges)};
    for (const char *name : {"footprint", "pcf"})
        for (const Judge &judge : judges)
            if (judge.name == name)
                images.push_back(judge);
    for (const Truth &truth : models_of(scene))
        images.push_back({truth.name, picture_of(run, pixels, truth)});
    images.push_back({"program", Picture{run.width, run.height, 1, {}}});
    images.back().values.values.resize(pixels.size());
    std::vector<Kind> kinds;
    for (const Pixel &pixel : pixels) {
        Kind kind = kind_of(pixel, {0});
        for (size_t i = 0; i + 1 < images.size(); i++)
            if (kind == Kind::COUNTED)
                kind = kind_of(pixel, value_at(images[i].values, pixel));
        kinds.push_back(kind);
        images.back().values.at(pixel.x, pixel.y) =
            float(pixel.receiver.visibility);
    }
    std::vector<Comparison> links;
    for (size_t i = 1; i < images.size(); i++)
        links.push_back(link(kinds, images[i - 1].values, images[i].values,
                             images[i].name));
    return links;
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

// The truth that a technique is shown beside.
static const Comparison &main_of(const std::vector<Comparison> &comparisons)
{
    for (const char *name : {"footprint", "area", "hard"})
        for (const Comparison &comparison : comparisons)
            if (comparison.name == name)
                return comparison;
    throw BadInput("no truth to show");
}

void print_errors(const Run &run, const ErrorOptions &options)
{
    TruthScene scene(run);
    std::vector<Pixel> pixels = pixels_of(scene);
    std::vector<Judge> judges = judges_of(scene, pixels, options);
    std::vector<Comparison> comparisons;
    for (const Judge &judge : judges)
        comparisons.push_back(compare(run, pixels, judge));
    if (options.chain)
        for (Comparison &comparison : chain_of(scene, pixels, judges))
            comparisons.push_back(std::move(comparison));
    if (!options.pictures_in.empty())
        write_pictures(options.pictures_in, main_of(comparisons));
    std::printf("truth,pixels,apart,nonfinite,rmse,p99,max,share,mean\n");
    std::vector<std::string> seams;
    if (options.seams)
        seams = seams_of(scene);
    for (const Comparison &comparison : comparisons) {
        print(comparison.name, comparison, [](size_t) { return true; });
        if (options.seams)
            print_seams(comparison.name, comparison, seams);
        if (!options.write_into.empty())
            write_comparison(options.write_into, comparison);
    }
}
