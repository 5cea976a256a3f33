// The scene's meshes in the memory of OpenGL.
#ifndef BASE_GEOMETRY_H
#define BASE_GEOMETRY_H

#include <glad/gl.h>

#include "step1_shadowmap/base/draw_list.h" // DrawList
#include "step1_shadowmap/base/scene.h"     // Scene

typedef struct Geometry {
    GLuint vao[SCENE_MAX_MESHES];
    GLuint vertices[SCENE_MAX_MESHES];
    GLuint indices[SCENE_MAX_MESHES];
} Geometry;

Geometry geometry_create(const Scene *scene);

void geometry_destroy(Geometry *geometry);

// Draws the listed objects with the program in use. Vertex attribute 0 is the
// position, 1 the normal, both in object space. Sets, per object, the uniforms
// relative_from_object (mat4, to positions relative to `origin`),
// normal_from_object (mat3) and albedo (vec3), where the program has them.
void geometry_draw(const Geometry *geometry, const Scene *scene,
                   const DrawList *list, const double origin[3],
                   GLuint program);

#endif
