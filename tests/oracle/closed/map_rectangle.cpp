#include <cmath> // abs

#include "tests/oracle/dump/projection.h"
#include "tests/oracle/lib/rounding.h"
#include "tests/oracle/closed/two_depths.h"

MapRectangle::MapRectangle(const SceneTable &table, const Run &run,
                           const std::string &name)
{
    const Object *object = table.find(name);
    if (!object)
        throw BadInput("the scene has no object '" + name + "'");
    const MapView &view = run.views.at(0);
    glm::dvec3 column[4]; // of map_from_object: images of x, y, z and 1
    for (int k = 0; k < 4; k++) {
        glm::dvec3 world(object->transform[0][k], object->transform[1][k],
                         object->transform[2][k]);
        for (size_t i = 0; i < 3; i++)
            column[k][int(i)] = glm::dot(glm::dvec3(view.rows[i]), world);
    }
    glm::dvec3 corner = map_point(view, -run.origin) + column[3];
    if (std::abs(column[0].z) + std::abs(column[2].z) > 1e-9)
        throw BadInput("'" + name + "' is not perpendicular to the light");
    glm::dvec2 size(view.width, view.height);
    glm::dvec2 x = glm::dvec2(column[0]) * size;
    glm::dvec2 z = glm::dvec2(column[2]) * size;
    centre_ = glm::dvec2(corner) * size;
    inverse_ = glm::inverse(glm::dmat2(x, z));
    depth_ = corner.z;
    // A distance d from a side is d times the length of the row of inverse_
    // that measures across it, in the plane's own units.
    glm::dmat2 rows = glm::transpose(inverse_);
    margin_ = SUBPIXEL * glm::dvec2(glm::length(rows[0]), glm::length(rows[1]));
}

Place MapRectangle::place(const glm::dvec2 &texels) const
{
    glm::dvec2 own = glm::abs(inverse_ * (texels - centre_));
    if (own.x > 0.5 + margin_.x || own.y > 0.5 + margin_.y)
        return Place::OUTSIDE;
    if (own.x < 0.5 - margin_.x && own.y < 0.5 - margin_.y)
        return Place::INSIDE;
    return Place::AMBIGUOUS;
}

std::vector<Place> places(const MapRectangle &rectangle, const MapView &view)
{
    std::vector<Place> all;
    for (int y = 0; y < view.height; y++)
        for (int x = 0; x < view.width; x++)
            all.push_back(rectangle.place({x + 0.5, y + 0.5}));
    return all;
}
