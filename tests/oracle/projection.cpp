#include "tests/oracle/projection.h"

#include <glm/gtc/matrix_transform.hpp> // lookAt, perspective

PictureCamera::PictureCamera(const Camera &camera, int width, int height)
    : width_(width), height_(height)
{
    glm::dvec3 forward = vec3_of(camera.target) - vec3_of(camera.position);
    glm::dmat4 view = glm::lookAt(glm::dvec3(0), forward, vec3_of(camera.up));
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
    return {glm::dot(view.rows[0], p), glm::dot(view.rows[1], p),
            glm::dot(view.rows[2], p)};
}

glm::dvec3 point_of_map(const MapView &view, const glm::dvec3 &map)
{
    glm::dmat3 columns(glm::dvec3(view.rows[0]), glm::dvec3(view.rows[1]),
                       glm::dvec3(view.rows[2]));
    glm::dvec3 shift(view.rows[0].w, view.rows[1].w, view.rows[2].w);
    return glm::inverse(glm::transpose(columns)) * (map - shift);
}
