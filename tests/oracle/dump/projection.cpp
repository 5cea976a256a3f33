#include "tests/oracle/dump/projection.h"

#include <cmath>                        // isinf
#include <glm/gtc/matrix_transform.hpp> // lookAt, perspective

// Where the camera looks along its up vector, x takes its place.
static glm::dvec3 up_for(const glm::dvec3 &forward, const glm::dvec3 &up)
{
    double across = glm::length(glm::cross(glm::normalize(forward), up));
    return across < 1e-6 * glm::length(up) ? glm::dvec3(1, 0, 0) : up;
}

PictureCamera::PictureCamera(const Camera &camera, int width, int height)
    : width_(width), height_(height)
{
    glm::dvec3 forward = vec3_of(camera.target) - vec3_of(camera.position);
    glm::dmat4 view = glm::lookAt(glm::dvec3(0), forward,
                                  up_for(forward, vec3_of(camera.up)));
    // Any near and far will do: rays and pixels do not depend on them.
    clip_ = glm::perspective(camera.fov_y, width_ / height_, 1.0, 2.0) * view;
    inverse_ = glm::inverse(clip_);
}

glm::dvec3 PictureCamera::ray(double x, double y) const
{
    glm::dvec4 ndc(2 * x / width_ - 1, 2 * y / height_ - 1, -1, 1);
    glm::dvec4 point = inverse_ * ndc; // on the plane at depth 1
    return glm::dvec3(point) / point.w;
}

glm::dvec3 PictureCamera::pixel_of(const glm::dvec3 &point) const
{
    glm::dvec4 c = clip_ * glm::dvec4(point, 1);
    return {(c.x / c.w + 1) / 2 * width_, (c.y / c.w + 1) / 2 * height_, c.w};
}

double PictureCamera::focal_length() const
{
    // A ray half the picture up has this slope against the axis.
    glm::dvec3 side = ray(width_ / 2, height_) - ray(width_ / 2, height_ / 2);
    return height_ / 2 / glm::length(side);
}

glm::dvec3 map_point(const MapView &view, const glm::dvec3 &relative)
{
    glm::dvec4 p(relative, 1);
    double w = glm::dot(view.rows[3], p);
    double t = glm::dot(view.rows[2], p);
    if (!view.parallel())
        t = (glm::distance(relative, view.position) - view.near) /
            (view.far - view.near);
    return {glm::dot(view.rows[0], p) / w, glm::dot(view.rows[1], p) / w, t};
}

// Where u is constant U - u W is 0: a plane through the light. Two such planes
// meet in the ray.
static glm::dvec3 direction_of_map(const MapView &view, double u, double v)
{
    glm::dvec3 axis(view.rows[3]);
    glm::dvec3 across = glm::dvec3(view.rows[0]) - u * axis;
    glm::dvec3 up = glm::dvec3(view.rows[1]) - v * axis;
    glm::dvec3 ray = glm::normalize(glm::cross(across, up));
    return glm::dot(ray, axis) < 0 ? -ray : ray;
}

glm::dvec3 point_of_map(const MapView &view, const glm::dvec3 &map)
{
    if (!view.parallel())
        return view.position + (view.near + map.z * (view.far - view.near)) *
                                   direction_of_map(view, map.x, map.y);
    glm::dmat3 columns(glm::dvec3(view.rows[0]), glm::dvec3(view.rows[1]),
                       glm::dvec3(view.rows[2]));
    glm::dvec3 shift(view.rows[0].w, view.rows[1].w, view.rows[2].w);
    return glm::inverse(glm::transpose(columns)) * (map - shift);
}

double stored_depth(const MapView &view, double u, double v, double t)
{
    if (!view.projected || std::isinf(t))
        return t;
    glm::dvec4 p(point_of_map(view, {u, v, t}), 1);
    return glm::dot(view.rows[2], p) / glm::dot(view.rows[3], p);
}

// z / w = far / (far - near) (1 - near / w), solved for w.
double distance_along_axis(const MapView &view, double stored)
{
    return view.near * view.far / (view.far - stored * (view.far - view.near));
}

double linear_depth(const MapView &view, double u, double v, double stored)
{
    if (!view.projected)
        return stored;
    double cosine =
        glm::dot(direction_of_map(view, u, v), glm::dvec3(view.rows[3]));
    double distance = distance_along_axis(view, stored) / cosine;
    return (distance - view.near) / (view.far - view.near);
}
