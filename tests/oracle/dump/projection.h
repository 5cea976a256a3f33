// The oracle's own matrices, made with GLM in double from the scene table.
#ifndef ORACLE_PROJECTION_H
#define ORACLE_PROJECTION_H

#include <glm/glm.hpp>

#include "tests/oracle/dump/dump.h"
#include "tests/oracle/dump/scene_table.h"

// The camera of a picture of width x height pixels, at the origin of the
// relative space.
class PictureCamera
{
  public:
    PictureCamera(const Camera &camera, int width, int height);

    // Through the picture at x, y in pixels from its lower left corner (a
    // pixel's centre at .5). Its length along the view direction is 1, so
    // that a distance in units of it is a depth.
    glm::dvec3 ray(double x, double y) const;

    // The pixel coordinates x, y of a relative point, and its depth.
    glm::dvec3 pixel_of(const glm::dvec3 &point) const;

    double focal_length() const; // in pixels
    glm::dmat4 clip() const
    {
        return clip_;
    }

  private:
    glm::dmat4 clip_; // rows x, y and w count; z needs a near and a far
    glm::dmat4 inverse_;
    double width_, height_;
};

// u, v and t of a relative point, in double.
glm::dvec3 map_point(const MapView &view, const glm::dvec3 &relative);

// Above and below t is linear. What the map holds and the receiver compares
// with where --depth says so: z / w of the point at u, v and t; else t itself.
double stored_depth(const MapView &view, double u, double v, double t);

// The way back.
double linear_depth(const MapView &view, double u, double v, double stored);

// W of the point whose stored depth is z / w.
double distance_along_axis(const MapView &view, double stored);

// The relative point at u, v and t.
glm::dvec3 point_of_map(const MapView &view, const glm::dvec3 &map);

#endif
