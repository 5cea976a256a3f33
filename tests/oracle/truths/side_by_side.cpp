#include "tests/oracle/truths/side_by_side.h"

#include <algorithm> // clamp
#include <filesystem>
#include <glm/glm.hpp>

#include "tests/oracle/lib/verdict.h" // BadInput

static void make_folder(const std::string &folder)
{
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    if (failure)
        throw BadInput(folder + ": cannot be made: " + failure.message());
}

void write_comparison(const std::string &folder, const Comparison &comparison)
{
    const std::string &name = comparison.name;
    make_folder(folder);
    save_picture(comparison.truth, folder + "/truth." + name + ".exr");
    save_picture(comparison.error, folder + "/error." + name + ".exr");
    save_bare(comparison.error, folder + "/error." + name + ".bin");
}

// From too dark to too light; the same as in error_picture.gp.
static glm::dvec3 false_colour(double error)
{
    static const double AT[] = {-1, -0.25, 0, 0.25, 1};
    static const glm::dvec3 COLOURS[] = {{8, 48, 107},
                                         {107, 174, 214},
                                         {247, 247, 247},
                                         {251, 106, 74},
                                         {103, 0, 13}};
    size_t i = 0;
    while (i < 3 && error > AT[i + 1])
        i++;
    double part = std::clamp((error - AT[i]) / (AT[i + 1] - AT[i]), 0.0, 1.0);
    return glm::mix(COLOURS[i], COLOURS[i + 1], part) / 255.0;
}

void write_pictures(const std::string &folder, const Comparison &comparison)
{
    const Picture &error = comparison.error;
    Picture truth = comparison.truth;
    Picture difference{error.width, error.height, 3, {}};
    difference.values.resize(3 * error.values.size());
    for (size_t i = 0; i < error.values.size(); i++) {
        if (comparison.kinds[i] != Kind::COUNTED)
            truth.values[i] = comparison.result.values[i];
        glm::dvec3 colour = false_colour(double(error.values[i]));
        for (int c = 0; c < 3; c++)
            difference.values[3 * i + size_t(c)] = float(colour[c]);
    }
    make_folder(folder);
    save_bytes(truth, folder + "/truth.png");
    save_bytes(comparison.result, folder + "/result.png");
    save_bytes(difference, folder + "/difference.png");
}
