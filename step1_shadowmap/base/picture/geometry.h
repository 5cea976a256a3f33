// The scene's meshes in the memory of OpenGL.
#ifndef BASE_GEOMETRY_H
#define BASE_GEOMETRY_H

#include <glad/gl.h>

#include "step1_shadowmap/base/scene/scene.h" // DrawList, Scene
#include "step1_shadowmap/base/system/die.h"  // IF_LINKED

// A mesh's triangles without its normals: positions in object space, and as
// many indices as the mesh has, in the same order.
typedef struct Shape {
    float (*positions)[3];
    uint32_t *indices;
    size_t count; // of the positions
} Shape;

// base/leave_out makes it, and the caller frees both arrays; without it
// what the map does not need is drawn too.
IF_LINKED bool shape_of_mesh(const Mesh *mesh, Shape *result);

// What a pass reads of each mesh.
typedef struct GeometryStream {
    GLuint vao[SCENE_MAX_MESHES];
    GLuint vertices[SCENE_MAX_MESHES];
    GLuint indices[SCENE_MAX_MESHES];
} GeometryStream;

typedef struct Geometry {
    GeometryStream surfaces; // positions and normals
    GeometryStream shapes;   // positions alone, with fewer vertices
    GLuint instances;        // what differs between objects of one mesh
} Geometry;

Geometry geometry_create(const Scene *scene);

void geometry_destroy(Geometry *geometry);

// Draws the listed objects with the program in use, those of one mesh that
// follow each other at once. Vertex attributes, of the vertex and then of the
// object (see scene.vert):
//   0      vec3    position, object space
//   1      vec3    normal, object space
//   2 - 5  mat4x3  to positions relative to `origin`
//   6 - 8  mat3    the normal's, to the world's axes
//   9      vec3    albedo
void geometry_draw(const Geometry *geometry, const Scene *scene,
                   const DrawList *list, const double origin[3]);

// The same without 1 and 6 to 9: the same triangles for a pass that needs no
// more than where they are.
void geometry_draw_shapes(const Geometry *geometry, const Scene *scene,
                          const DrawList *list, const double origin[3]);

#endif
