// Triangle meshes in memory: built here, drawn by the picture, and handed to
// the ray caster of the tests. Nothing here knows OpenGL.
#ifndef BASE_MESH_H
#define BASE_MESH_H

#include <stdbool.h>
#include <stddef.h> // size_t
#include <stdint.h> // uint32_t

typedef struct MeshVertex {
    float position[3]; // object space
    float normal[3];   // object space, unit length
} MeshVertex;

typedef struct Mesh {
    MeshVertex *vertices;
    uint32_t *indices; // three per triangle, counter-clockwise from outside
    size_t vertex_count;
    size_t index_count;
    float low[3], high[3]; // of the box around it, see mesh_find_box
} Mesh;

// Sets the box from the vertices.
void mesh_find_box(Mesh *mesh);

// For those who build one: an empty mesh with room, of whose counts the
// functions below add to. No more segments than MESH_MAX_SEGMENTS keep every
// vertex and index number far inside 32 bits.
enum { MESH_MAX_SEGMENTS = 4096 };
Mesh mesh_allocate(size_t max_vertices, size_t max_indices);
void mesh_add_vertex(Mesh *mesh, const double position[3],
                     const double normal[3]);

// Joins the (rows + 1) x (columns + 1) vertices from `first` on, stored row by
// row, to triangles. The outside is where (along a row) x (to the next row)
// points, or the opposite side if the grid is a mirror image: a reflection
// turns counter-clockwise into clockwise.
void mesh_add_grid(Mesh *mesh, size_t first, size_t columns, size_t rows,
                   bool mirrored);

// A square of side 1 in the plane y = 0, centred at the origin, facing +y.
Mesh mesh_plane(void);

// A cube of side 1 centred at the origin, flat normals (24 vertices).
Mesh mesh_box(void);

// The Utah teapot (Martin Newell, 1975) tessellated from its Bezier patches,
// each into segments x segments quads (at least 1), normals from the patches'
// derivatives. Scaled to height 1, y up, its foot on y = 0, its axis through
// the origin, the spout towards +x.
Mesh mesh_teapot(int segments);

// Frees the arrays and leaves an empty mesh.
void mesh_destroy(Mesh *mesh);

#endif
