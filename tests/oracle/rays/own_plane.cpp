#include "tests/oracle/rays/own_plane.h"

#include <cmath> // INFINITY

#include "tests/oracle/dump/projection.h"

// A parallel light: u, v and t are linear, so a unit of t is a vector.
static void parallel_rays(const MapView &view, glm::dvec3 origin[3],
                          glm::dvec3 direction[3])
{
    origin[0] = point_of_map(view, {0, 0, 0});
    origin[1] = point_of_map(view, {1, 0, 0}) - origin[0];
    origin[2] = point_of_map(view, {0, 1, 0}) - origin[0];
    direction[0] = point_of_map(view, {0, 0, 1}) - origin[0];
    direction[1] = direction[2] = glm::dvec3(0);
}

// A perspective: u is constant on the plane through the light across U - u W,
// v on that across V - v W, and the ray is where they meet,
//   (U - u W) x (V - v W) = U x V - u (W x V) - v (U x W).
static void perspective_rays(const MapView &view, glm::dvec3 origin[3],
                             glm::dvec3 direction[3])
{
    glm::dvec3 u(view.rows[0]), v(view.rows[1]), w(view.rows[3]);
    origin[0] = view.position;
    origin[1] = origin[2] = glm::dvec3(0);
    direction[0] = glm::cross(u, v);
    direction[1] = -glm::cross(w, v);
    direction[2] = -glm::cross(u, w);
    // Away from the light, not towards it. W.(U x V) is the same for all rays.
    if (glm::dot(w, direction[0]) < 0)
        for (int i = 0; i < 3; i++)
            direction[i] = -direction[i];
}

OwnPlane::OwnPlane(const MapView &view, const glm::dvec3 &point,
                   const glm::dvec3 &normal)
    : parallel_(view.parallel()), near_(view.near),
      range_(view.far - view.near), normal_(normal),
      offset_(glm::dot(normal, point))
{
    if (parallel_)
        parallel_rays(view, origin_, direction_);
    else
        perspective_rays(view, origin_, direction_);
}

double OwnPlane::along(const glm::dvec3 &origin,
                       const glm::dvec3 &direction) const
{
    double towards = glm::dot(normal_, direction);
    double distance = (offset_ - glm::dot(normal_, origin)) / towards;
    // Only what lies before a spot or point light is seen from it.
    bool seen = towards != 0 && (parallel_ || distance > 0);
    return seen ? distance : INFINITY;
}

bool OwnPlane::meets(double u, double v, glm::dvec3 &point) const
{
    glm::dvec3 origin = origin_[0] + u * origin_[1] + v * origin_[2];
    glm::dvec3 ray = direction_[0] + u * direction_[1] + v * direction_[2];
    double distance = along(origin, ray);
    if (std::isinf(distance))
        return false;
    point = origin + distance * ray;
    return true;
}

double OwnPlane::depth(double u, double v) const
{
    glm::dvec3 origin = origin_[0] + u * origin_[1] + v * origin_[2];
    glm::dvec3 ray = direction_[0] + u * direction_[1] + v * direction_[2];
    double distance = along(origin, ray);
    return parallel_ ? distance
                     : (distance * glm::length(ray) - near_) / range_;
}
