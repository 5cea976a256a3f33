#include "tests/oracle/truths/kept_truth.h"

#include <cinttypes> // PRIx64
#include <cstdint>
#include <cstdio> // rename, snprintf
#include <filesystem>
#include <nlohmann/json.hpp>
#include <unistd.h> // getpid

#include "tests/oracle/lib/verdict.h" // BadInput

// What changes a program's visibility but no truth. An option that is not
// named here is taken to change them all.
static const char *const HARMLESS[] = {
    "output",          "dump",      "bench",    "show",         "window",
    "context",         "shaders",   "bias",     "slope-bias",   "format",
    "moments",         "sat",       "sat-by",   "min-variance", "variance-bias",
    "bleed-reduction", "reduction", "deferred", "slope-term",   "slope-from",
    "list-scenes"};

// 64 bits by Fowler, Noll and Vo (FNV-1a).
static uint64_t hash_of(const std::string &bytes)
{
    uint64_t hash = 0xcbf29ce484222325u;
    for (char byte : bytes)
        hash = (hash ^ uint8_t(byte)) * 0x100000001b3u;
    return hash;
}

static void append(std::string &bytes, std::initializer_list<double> values)
{
    for (double value : values)
        bytes.append(reinterpret_cast<const char *>(&value), sizeof value);
}

static void append_view(std::string &bytes, const MapView &view)
{
    for (const glm::dvec4 &row : view.rows)
        append(bytes, {row.x, row.y, row.z, row.w});
    append(bytes, {view.position.x, view.position.y, view.position.z,
                   double(view.lamp), view.projected ? 1.0 : 0.0, view.cone,
                   view.near, view.far, double(view.width), double(view.height),
                   view.border, view.handover, view.end});
}

// What the pixels show and where it is in the map; not how bright it is.
static void append_pixels(std::string &bytes, const TruthScene &scene)
{
    for (int y = 0; y < scene.run.height; y++)
        for (int x = 0; x < scene.run.width; x++) {
            Receiver r = scene.receivers.at(x, y);
            append(bytes, {double(r.layer), r.u, r.v, r.t, r.position.x,
                           r.position.y, r.position.z, r.normal.x, r.normal.y,
                           r.normal.z, r.share, r.next.x, r.next.y, r.next.z});
        }
}

KeptTruths::KeptTruths(const TruthScene &scene, const std::string &folder)
    : run_(scene.run), folder_(scene.run.settings.adaptive ? "" : folder)
{
    if (folder_.empty())
        return;
    nlohmann::json options = nlohmann::json::parse(scene.run.options);
    for (const char *name : HARMLESS)
        options.erase(name);
    std::string bytes = options.dump() + ' ' + std::to_string(scene.run.step);
    for (const MapView &view : scene.run.views)
        append_view(bytes, view);
    append_pixels(bytes, scene);
    char text[17];
    std::snprintf(text, sizeof text, "%016" PRIx64, hash_of(bytes));
    key_ = text;
}

static bool is_truth(const Picture &picture, const Run &run)
{
    return picture.width == run.width && picture.height == run.height &&
           picture.channels == TRUTH_CHANNELS;
}

Picture KeptTruths::find(const std::string &name, const std::string &details,
                         const std::function<Picture()> &make) const
{
    if (folder_.empty())
        return make();
    std::string path =
        folder_ + "/" + name + "." + key_ + "." + details + ".exr";
    if (std::filesystem::exists(path)) {
        try {
            Picture kept = load_picture(path);
            if (is_truth(kept, run_))
                return kept;
        } catch (const BadInput &) { // make it again
        }
    }
    Picture made = make();
    // Whole or not at all; and a full disk is no reason to know nothing.
    std::string partial = path + "." + std::to_string(getpid()) + ".exr";
    try {
        save_picture(made, partial);
        std::filesystem::rename(partial, path);
    } catch (const std::exception &) {
        std::error_code ignored;
        std::filesystem::remove(partial, ignored);
    }
    return made;
}
