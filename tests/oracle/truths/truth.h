// What visibility should be, in several meanings: each
// blames something else.
#ifndef ORACLE_TRUTH_H
#define ORACLE_TRUTH_H

#include <algorithm> // clamp
#include <functional>
#include <string>
#include <vector>

#include "tests/oracle/dump/dump.h"
#include "tests/oracle/rays/ideal_map.h"
#include "tests/oracle/stages/pcf_width.h"
#include "tests/oracle/dump/projection.h"
#include "tests/oracle/rays/rays.h"
#include "tests/oracle/dump/scene_table.h"

// The surface that a pixel shows, without the rounding of position.exr.
struct Surface {
    bool found = false; // else rays and the rasteriser see different ones
    int object = -1;    // index in the scene
    glm::dvec3 point;   // relative, on the triangle's plane
    glm::dvec3 normal;  // the triangle's, unit length, towards the viewer
};

struct Pixel {
    int x, y;
    Receiver receiver;
    Surface surface;
    bool counts;  // shows an object with N.L > 0
    bool grazing; // N.L < 0.1, with the shading or the triangle's normal
};

// Everything that the truths of one run are made from.
struct TruthScene {
    const Run &run;
    SceneTable table;
    RayScene rays;
    PictureCamera camera;
    Receivers receivers;
    double extent; // the largest coordinate
    double lift;   // off a surface, so that a ray does not meet it again
    std::vector<std::vector<IdealMap>> ideal; // by layer, and by Run::places
    PcfWidth widths;                          // of step 2's filter

    explicit TruthScene(const Run &the_run);
    const MapView &view(const Receiver &r) const
    {
        return run.views[size_t(r.layer)];
    }
    Pixel pixel(int x, int y) const;
    // Whether nothing lies between the point and the light's middle.
    bool lit(const MapView &view, const glm::dvec3 &point) const;
    // The pixel's point, off its surface.
    glm::dvec3 lifted(const Surface &surface) const
    {
        return surface.point + lift * surface.normal;
    }

    // How far a depth t in the map can be off: rasterised, or ray cast
    // against the plane of another triangle of the same flat surface.
    double float_rounding(const MapView &view) const;
    double tie_rounding(const MapView &view) const;
};

struct TruthValue {
    double value;
    bool apart = false; // not to be counted with the others
    // Where the truth itself is not sharp: it lies between value - below and
    // value + above, and only what is outside of that is an error.
    double below = 0, above = 0;

    double error(double visibility) const
    {
        double low = value - below, high = value + above;
        return visibility - std::clamp(visibility, low, high);
    }
};

// In the layer of this receiver alone: the pixel's own, or the same point in
// the next one.
using LayerTruth = std::function<TruthValue(const Pixel &, const Receiver &)>;

// What is outside the map is lit; where one split hands over to the next, a
// mixture of what is true in each.
TruthValue over_layers(const TruthScene &scene, const Pixel &pixel,
                       const LayerTruth &at);

struct Truth {
    std::string name;
    std::function<TruthValue(const Pixel &)> at; // for pixels that count
};

// The share of the stored texels at or behind t; `ties` behind t counts too.
Truth lower_truth(const TruthScene &scene, double ties = 0);

// The share of ideal texels not in front of the receiver's own plane by more
// than `ties` times what rounding explains; under 0: texels that are as deep
// as the plane are dark. Texels on an outline may count or not.
Truth pcf_truth(const TruthScene &scene, double ties = 1);

// Hard visibility averaged over the kernel, seen from the light on the
// receiver's plane.
Truth footprint_truth(const TruthScene &scene, double rays);

// Hard visibility of the pixel's point.
Truth hard_truth(const TruthScene &scene);

// The visible share of a disc around the light that faces the receiver. `size`
// is its diameter in world units, or of a parallel light at a distance of 1:
// twice the tangent of half the angle under which it is seen.
Truth area_truth(const TruthScene &scene, double rays, double size);

#endif
