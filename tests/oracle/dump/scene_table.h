// The scene table that the programs and the oracle share: the only thing they
// share. In C, so its headers are taken as such.
#ifndef ORACLE_SCENE_TABLE_H
#define ORACLE_SCENE_TABLE_H

#include <cstddef> // before the C headers, outside extern "C"
#include <cstdint>
#include <cstdio>

extern "C" {
#include "step1_shadowmap/base/scene/scene.h"
}

#include <glm/glm.hpp>
#include <string>
#include <vector>

// A Scene that frees itself. It must not be copied.
struct SceneTable {
    Scene scene;

    // `light` replaces the kind of its light; empty: its own.
    explicit SceneTable(const std::string &text, const std::string &light = "")
    {
        scene_create(&scene, text.c_str(),
                     light.empty() ? nullptr : light.c_str());
    }
    ~SceneTable()
    {
        scene_destroy(&scene);
    }
    SceneTable(const SceneTable &) = delete;
    SceneTable &operator=(const SceneTable &) = delete;

    // nullptr when there is none of that name.
    const Object *find(const std::string &name) const;
};

// A triangle relative to the origin (the camera), in double.
struct Triangle {
    glm::dvec3 a, b, c;
    int object; // index in the scene

    glm::dvec3 normal() const
    {
        return glm::cross(b - a, c - a);
    }
};

std::vector<Triangle> scene_triangles(const Scene &scene,
                                      const glm::dvec3 &origin);

// The object's vertices relative to the origin.
std::vector<glm::dvec3> object_points(const Object &object,
                                      const glm::dvec3 &origin);

// The largest coordinate of any vertex relative to the origin: the size of the
// numbers in a 32-bit program, and so of their rounding.
double scene_extent(const Scene &scene, const glm::dvec3 &origin);

inline glm::dvec3 vec3_of(const double (&v)[3])
{
    return {v[0], v[1], v[2]};
}

#endif
