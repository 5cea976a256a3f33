// A rasterised depth against ray cast ones.
#ifndef ORACLE_RAY_COMPARE_H
#define ORACLE_RAY_COMPARE_H

#include <algorithm> // max
#include <functional>

#include "tests/oracle/rays/rays.h"
#include "tests/oracle/lib/rounding.h"

// The ray through a pixel, or a texel, moved from its centre by a fraction of
// a pixel along both axes.
using RayAt = std::function<Ray(double, double)>;

enum class Verdict {
    AGREES,     // with the surface through the centre
    SILHOUETTE, // with another surface, within SUBPIXEL of the centre
    DIFFERS
};

// An outline through every pixel would excuse no larger share than this.
constexpr double MOST_SILHOUETTE = 2 * SUBPIXEL;

struct RayComparison {
    size_t agrees = 0, silhouette = 0, differs = 0;
    double worst = 0; // largest error where it agrees
    // The error that is the largest share of what is allowed there, and that.
    double largest_share = 0, error = 0, allowed = 0;

    void add(double found, double most); // an error that is allowed

    void add(const RayComparison &other)
    {
        agrees += other.agrees;
        silhouette += other.silhouette;
        differs += other.differs;
        worst = std::max(worst, other.worst);
    }
    size_t all() const
    {
        return agrees + silhouette + differs;
    }
    double silhouette_share() const
    {
        return all() ? double(silhouette) / double(all()) : 0;
    }
};

// A rasterised distance along the ray through a centre.
struct Measured {
    double value;
    double empty;    // the value where there is nothing; farther hits are cut
    double rounding; // of value
};

// Counts one pixel or texel. It agrees with a surface when it differs by no
// more than the surface's own slope over SUBPIXEL, since that is how far the
// rasteriser may move a triangle, plus the rounding.
Verdict compare_with_rays(const RayScene &rays, const RayAt &ray_at,
                          const Measured &measured, RayComparison &count);

#endif
