// Closed forms where every surface is perpendicular to the light, so that the
// map holds only a few depths and it is known where: scenes edge and bleed.
#ifndef ORACLE_TWO_DEPTHS_H
#define ORACLE_TWO_DEPTHS_H

#include "tests/oracle/dump/dump.h"
#include "tests/oracle/lib/verdict.h"
#include "tests/oracle/dump/scene_table.h"

// Scene edge, steps 1, 2 and 5: visibility is the lit share of the filter.
void check_edge(const Run &run, const SceneTable &table, Report &report);

// Scene bleed, step 5 with bleed-reduction 0: the worst light bleeding is
// (r/(r+2))^2. `r` is what the caller expects the scene to have.
void check_bleed(const Run &run, const SceneTable &table, double r,
                 Report &report);

// Where a point of the map lies against a rectangle as the light sees it.
enum class Place { INSIDE, OUTSIDE, AMBIGUOUS };

// A mesh_plane (side 1, y = 0) seen in the map.
class MapRectangle
{
  public:
    // Throws BadInput when the object is missing or not perpendicular to the
    // light.
    MapRectangle(const SceneTable &table, const Run &run,
                 const std::string &name);

    // AMBIGUOUS within SUBPIXEL of the outline: the rasteriser may decide
    // either way.
    Place place(const glm::dvec2 &texels) const;

    // A position in texels in the plane's own units: -0.5 .. 0.5 inside.
    glm::dvec2 own(const glm::dvec2 &texels) const
    {
        return inverse_ * (texels - centre_);
    }

    // How much the own x and y change per texel across and up.
    glm::dmat2 own_per_texel() const
    {
        return glm::transpose(inverse_);
    }
    double depth() const
    {
        return depth_;
    } // t

  private:
    glm::dvec2 centre_;  // texels of the map
    glm::dmat2 inverse_; // from texels to the plane's own -0.5 .. 0.5
    glm::dvec2 margin_;  // SUBPIXEL in the plane's own units, per axis
    double depth_;
};

// The place of every texel's centre in a view, row by row.
std::vector<Place> places(const MapRectangle &rectangle, const MapView &view);

#endif
