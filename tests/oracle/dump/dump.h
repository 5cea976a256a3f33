// What a program wrote with --dump: run.json and its pictures. Only the files;
// nothing here knows a formula.
#ifndef ORACLE_DUMP_H
#define ORACLE_DUMP_H

#include <array>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "tests/oracle/lib/picture.h"

enum class Lamp { DIRECTIONAL, SPOT, POINT };

// One layer of the shadow map.
struct MapView {
    Lamp lamp;
    // Rows U, V, Z, W of map_from_relative: u = U.(p, 1) / W.(p, 1), and so on.
    // A parallel light's W is 0 0 0 1 and its Z is T: t = T.(p, 1). A spot's
    // or point light's Z serves the depth test; t = (|p - position| - near) /
    // (far - near).
    std::array<glm::dvec4, 4> rows;
    // Where `projected`, t = Z.(p, 1) / W.(p, 1) instead.
    bool projected;      // --depth projected of a spot or point light
    glm::dvec3 position; // of the light, relative
    double cone;         // half of a spot's angle, radians
    double near, far;  // world units from the plane through the light's anchor,
                       // or from the light's position
    int width, height; // texels
    double border;     // texels
    // Texels that the program says lookups need: from u, v up to u, v.
    std::array<int, 4> looked_up;

    // Of a split: view depths where it begins to hand over to the next one, and
    // where it ends. 0 where there are no splits.
    double handover, end;

    bool split() const
    {
        return end > 0;
    }
    bool parallel() const
    {
        return lamp == Lamp::DIRECTIONAL;
    }
};

enum class Blur { NONE, BOX, BOXES, GAUSSIAN, BINOMIAL };

// The settings that a check needs; what a step does not have keeps the value
// that means "not done".
struct Settings {
    bool shadows = true;    // off: no map, and what faces the light is lit
    double bias = 0;        // of the depth range
    double slope_bias = 0;  // of half a kernel's depth change
    int kernel = 1;         // texels
    bool bilinear = false;  // each tap of the kernel a mean of 2 x 2 texels
    bool poisson = false;   // 32 taps in a disc in place of the n x n
    bool adaptive = false;  // the kernel is the widest, pixels choose theirs
    bool projected = false; // --depth
    bool slope_term = false;
    bool slope_derivatives = false; // else from the triangle's plane
    bool half = false;              // moments are stored as 16-bit floats
    int msaa = 1;                   // samples per texel
    bool central = false;           // as mean and variance, not M1 and M2
    Blur blur = Blur::NONE;
    int radius = 0;        // texels of the downsampled map
    int downsample = 1;    // map texels per downsampled texel, along an axis
    bool mips = false;     // a chain over the filtered map
    int anisotropy = 1;    // most taps per pixel
    bool hardware = false; // the texture unit chooses levels and taps
    bool sat = false;      // the box comes from a table of sums
    bool adaptive_box = false; // which differs in width from pixel to pixel
    bool soft = false;         // the penumbra is each receiver's own
    double light_size = 0; // diameter, of a parallel light at a distance of 1
    double penumbra_scale = 1;
    bool hybrid = false; // depths are compared in the penumbra
    bool auto_variance = true;
    double min_variance = 0; // used when not auto_variance
    double bleed_reduction = 0;
    double variance_bias = 0;
    bool smooth = false; // the reduction's form

    // Whether all pixels have the same filter, or step 2's table of widths.
    // Where not, only the light's own truth is known.
    bool has_weights() const
    {
        return !adaptive_box && !soft;
    }
    bool reduces() const
    {
        return bleed_reduction != 0 || smooth;
    }
};

struct Run {
    std::string folder;
    int step;
    std::string scene;   // as scene_create takes it
    std::string light;   // the same, empty: the scene's own
    std::string options; // all of them, as JSON
    Settings settings;
    int width, height; // of the picture, pixels
    glm::dvec3 origin; // world space, the camera's position
    std::array<glm::dvec4, 4> clip_from_relative; // rows
    std::vector<MapView> views;                   // one per layer
    // Where in a texel its depths are taken, in texels from the lower left
    // corner: in the middle, and with --msaa where the driver says.
    std::vector<glm::dvec2> places;
};

// Reads DIR/run.json. Throws BadInput when something is missing.
Run load_run(const std::string &folder);

// Reads DIR/name and insists on its shape. Throws BadInput.
Picture load_file(const Run &run, const std::string &name, int width,
                  int height, int channels);

// depth.L.exr (steps 1, 2) or moments.L.exr: channel 0 is the depth in both.
Picture load_map(const Run &run, int layer);

// The depths taken in a texel, before they are averaged: with --msaa
// samples.L.S.exr for each place S, else the map itself.
std::vector<Picture> load_samples(const Run &run, int layer);

// blurred.L.exr in steps 4 and 5, moments.L.exr in step 3.
Picture load_filtered(const Run &run, int layer);

// One pixel of the picture.
struct Receiver {
    bool shown;           // an object, not the background
    int layer;            // of the shadow map
    double u, v, t;       // as the shader used them
    glm::dvec3 position;  // relative to the origin
    glm::dvec3 normal;    // unit length, towards the viewer
    double visibility;    // what the program says
    double share = 0;     // of the next layer in it
    glm::dvec3 next = {}; // u, v, t in that
    // What footprint.exr has to be multiplied by in this layer, and in the next
    // one: the splits differ in size only.
    double footprint_scale = 1, next_scale = 1;

    // The same point in the next layer; after the last one all is lit.
    Receiver in_next() const;
};

// The four pictures that say what each pixel shows.
class Receivers
{
  public:
    explicit Receivers(const Run &run);
    Receiver at(int x, int y) const;

  private:
    Picture receiver_, position_, normal_, visibility_;
    Picture handover_; // empty without splits
    int layers_;
    std::vector<double> widths_; // of the map in the world, by layer
};

#endif
