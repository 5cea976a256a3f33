// Triangle meshes in memory: built here, drawn by the picture, and handed to
// the ray caster of the tests. Nothing here knows OpenGL.
#ifndef BASE_MESH_H
#define BASE_MESH_H

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

// A square of side 1 in the plane y = 0, centred at the origin, facing +y.
Mesh mesh_plane(void);

// The same of side x side smaller squares. A rasteriser's positions inside a
// triangle are as exact as a float as large as the triangle, so where a large
// floor has to be flat to the last bits it is laid in tiles.
Mesh mesh_tiles(int side);

// A cube of side 1 centred at the origin, flat normals (24 vertices).
Mesh mesh_box(void);

// A sphere of radius 1 at the origin, smooth normals; `segments` around the
// equator and segments / 2 from pole to pole, at least 4.
Mesh mesh_sphere(int segments);

// The Utah teapot (Martin Newell, 1975) tessellated from its Bezier patches,
// each into segments x segments quads (at least 1), normals from the patches'
// derivatives. Scaled to height 1, y up, its foot on y = 0, its axis through
// the origin, the spout towards +x.
Mesh mesh_teapot(int segments);

// Frees the arrays and leaves an empty mesh.
void mesh_destroy(Mesh *mesh);

#endif
