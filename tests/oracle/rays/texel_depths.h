// What a triangle covers of a map, and its depths there.
#ifndef ORACLE_TEXEL_DEPTHS_H
#define ORACLE_TEXEL_DEPTHS_H

#include "tests/oracle/dump/dump.h"
#include "tests/oracle/lib/interval.h"
#include "tests/oracle/dump/scene_table.h"

// Whether the triangle overlaps the square with this middle that reaches as far
// as `reach` along both axes, in texels.
bool overlaps(const MapView &view, const Triangle &triangle,
              const glm::dvec2 &middle, double reach);

// Where the triangle overlaps the texel x, y grown by SUBPIXEL to each side:
// the stored depths from the least to the most, held within [0, 1] as the map
// holds them. False where they do not overlap.
//
// A rasteriser moves the triangle's corners, each by less than SUBPIXEL, and
// with them all its points; so a fragment that takes its position at a place in
// the texel that the moved triangle covers has a depth of this range.
bool depths_in_texel(const MapView &view, const Triangle &triangle, int x,
                     int y, Interval &depths);

#endif
