// Ray casting: which surface comes first along a ray.
#ifndef ORACLE_RAYS_H
#define ORACLE_RAYS_H

#include <cmath> // INFINITY
#include <glm/glm.hpp>
#include <vector>

#include "tests/oracle/rays/embree.h"
#include "tests/oracle/dump/scene_table.h"

struct Ray {
    glm::dvec3 origin;    // relative space
    glm::dvec3 direction; // of any length: distances are counted in it
};

struct Hit {
    int triangle = -1; // -1: nothing was hit
    double distance = INFINITY;

    bool found() const
    {
        return triangle >= 0;
    }
};

// The scene for Embree, relative to the origin so that its floats are as good
// far from the world's centre as near it. Embree only decides which triangle is
// hit; where it is hit is computed again in double.
class RayScene
{
  public:
    RayScene(const Scene &scene, const glm::dvec3 &origin);
    ~RayScene();
    RayScene(const RayScene &) = delete;
    RayScene &operator=(const RayScene &) = delete;

    // The first surface at a distance of `start` or more, either side of it.
    Hit first(const Ray &ray, double start = 0) const;
    // Whether anything lies on the ray up to a distance of `end`.
    bool occluded(const Ray &ray, double end = INFINITY) const;

    // Whether some triangle within `radius` of the point crosses the plane
    // through it: none means that nothing can stand between two points of the
    // plane in that ball.
    bool crosses_plane(const glm::dvec3 &point, const glm::dvec3 &normal,
                       double radius) const;
    const std::vector<Triangle> &triangles() const
    {
        return triangles_;
    }
    const Triangle &triangle(int i) const
    {
        return triangles_[size_t(i)];
    }

  private:
    std::vector<Triangle> triangles_;
    RTCDevice device_;
    RTCScene scene_;
};

// Where the ray meets the triangle's whole plane; infinite along it.
double plane_distance(const Ray &ray, const Triangle &triangle);

#endif
