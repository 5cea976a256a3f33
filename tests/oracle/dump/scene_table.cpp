#include "tests/oracle/dump/scene_table.h"

#include <algorithm> // max
#include <cmath>     // abs

const Object *SceneTable::find(const std::string &name) const
{
    for (int i = 0; i < scene.object_count; i++)
        if (name == scene.objects[i].name)
            return &scene.objects[i];
    return nullptr;
}

std::vector<glm::dvec3> object_points(const Object &object,
                                      const glm::dvec3 &origin)
{
    std::vector<glm::dvec3> points;
    for (size_t i = 0; i < object.mesh->vertex_count; i++) {
        const float *p = object.mesh->vertices[i].position;
        glm::dvec3 world;
        for (int k = 0; k < 3; k++) {
            const double *m = object.transform[k];
            world[k] = m[0] * p[0] + m[1] * p[1] + m[2] * p[2] + m[3];
        }
        points.push_back(world - origin);
    }
    return points;
}

std::vector<Triangle> scene_triangles(const Scene &scene,
                                      const glm::dvec3 &origin)
{
    std::vector<Triangle> triangles;
    for (int i = 0; i < scene.object_count; i++) {
        const Mesh &mesh = *scene.objects[i].mesh;
        auto points = object_points(scene.objects[i], origin);
        for (size_t k = 0; k + 2 < mesh.index_count; k += 3)
            triangles.push_back({points[mesh.indices[k]],
                                 points[mesh.indices[k + 1]],
                                 points[mesh.indices[k + 2]], i});
    }
    return triangles;
}

double scene_extent(const Scene &scene, const glm::dvec3 &origin)
{
    double extent = 0;
    for (int i = 0; i < scene.object_count; i++)
        for (const glm::dvec3 &p : object_points(scene.objects[i], origin))
            for (int k = 0; k < 3; k++)
                extent = std::max(extent, std::abs(p[k]));
    return extent;
}
