// A receiver's own plane, as the light sees it through one layer of its map.
#ifndef ORACLE_OWN_PLANE_H
#define ORACLE_OWN_PLANE_H

#include <glm/glm.hpp>

#include "tests/oracle/dump/dump.h"

class OwnPlane
{
  public:
    // Through the point, relative, and across the normal.
    OwnPlane(const MapView &view, const glm::dvec3 &point,
             const glm::dvec3 &normal);

    // Where the light's ray through u, v meets the plane, relative; false
    // where it does not.
    bool meets(double u, double v, glm::dvec3 &point) const;

    // The depth t there; infinite where they do not meet.
    double depth(double u, double v) const;

  private:
    bool parallel_;
    double near_, range_;
    // The ray through u, v: an origin and a direction that are both linear in
    // u and v. A parallel light's direction, and another light's origin, does
    // not change.
    glm::dvec3 origin_[3], direction_[3];
    glm::dvec3 normal_;
    double offset_; // dot(normal, point)

    // How far along the ray, in its direction's length; infinite: nowhere.
    double along(const glm::dvec3 &origin, const glm::dvec3 &direction) const;
};

#endif
