// A mesh without its normals: where only the outline counts, corners that
// differ in nothing else are one vertex.
#ifndef BASE_SHAPE_H
#define BASE_SHAPE_H

#include "step1_shadowmap/base/scene/mesh.h" // Mesh

typedef struct Shape {
    float (*positions)[3]; // object space, no two with the same bits
    uint32_t *indices;     // as many as the mesh has, in the same order
    size_t count;          // of the positions
} Shape;

// The same triangles, to the last bit.
Shape shape_of_mesh(const Mesh *mesh);

void shape_destroy(Shape *shape);

#endif
