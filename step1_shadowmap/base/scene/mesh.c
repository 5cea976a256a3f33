#include "step1_shadowmap/base/scene/mesh.h"

#include <math.h>   // fmaxf, fminf, INFINITY
#include <stdlib.h> // free

#include "step1_shadowmap/base/system/die.h"
#include "step1_shadowmap/base/scene/dvec.h"
#include "step1_shadowmap/base/scene/teapot.h"

Mesh mesh_allocate(size_t max_vertices, size_t max_indices)
{
    return (Mesh){
        .vertices = allocate(max_vertices, sizeof(MeshVertex)),
        .indices = allocate(max_indices, sizeof(uint32_t)),
    };
}

void mesh_add_vertex(Mesh *mesh, const double position[3],
                     const double normal[3])
{
    MeshVertex *vertex = &mesh->vertices[mesh->vertex_count++];
    for (int i = 0; i < 3; i++) {
        vertex->position[i] = (float)position[i];
        vertex->normal[i] = (float)normal[i];
    }
}

static bool mesh_same_position(const Mesh *mesh, size_t a, size_t b)
{
    const float *p = mesh->vertices[a].position;
    const float *q = mesh->vertices[b].position;
    return p[0] == q[0] && p[1] == q[1] && p[2] == q[2];
}

// Where a grid's edge shrinks to a pole, one of a quad's two triangles has no
// area; it is left out, since its geometric normal would be 0 / 0.
static void mesh_add_triangle(Mesh *mesh, size_t a, size_t b, size_t c)
{
    if (mesh_same_position(mesh, a, b) || mesh_same_position(mesh, b, c) ||
        mesh_same_position(mesh, c, a)) {
        return;
    }
    mesh->indices[mesh->index_count++] = (uint32_t)a;
    mesh->indices[mesh->index_count++] = (uint32_t)b;
    mesh->indices[mesh->index_count++] = (uint32_t)c;
}

void mesh_add_grid(Mesh *mesh, size_t first, size_t columns, size_t rows,
                   bool mirrored)
{
    for (size_t row = 0; row < rows; row++) {
        for (size_t column = 0; column < columns; column++) {
            size_t a = first + row * (columns + 1) + column;
            size_t b = a + 1;
            size_t c = a + columns + 1;
            size_t d = c + 1;
            mesh_add_triangle(mesh, a, mirrored ? c : b, mirrored ? b : c);
            mesh_add_triangle(mesh, d, mirrored ? b : c, mirrored ? c : b);
        }
    }
}

// A unit square whose normal is the axis (0, 1, 2 for x, y, z) times `side`
// (+1 or -1), `offset` away from the origin along that normal.
static void mesh_add_square(Mesh *mesh, int axis, double side, double offset)
{
    int u = (axis + 1) % 3; // u x v = axis
    int v = (axis + 2) % 3;
    size_t first = mesh->vertex_count;
    for (int corner = 0; corner < 4; corner++) {
        double position[3] = {0};
        double normal[3] = {0};
        position[axis] = side * offset;
        position[u] = side * (corner % 2 - 0.5); // reversed on the -axis side
        position[v] = corner / 2 - 0.5;
        normal[axis] = side;
        mesh_add_vertex(mesh, position, normal);
    }
    mesh_add_grid(mesh, first, 1, 1, false);
}

Mesh mesh_plane(void)
{
    Mesh mesh = mesh_allocate(4, 6);
    mesh_add_square(&mesh, 1, 1.0, 0.0);
    return mesh;
}

Mesh mesh_box(void)
{
    Mesh mesh = mesh_allocate(6 * 4, 6 * 6);
    for (int axis = 0; axis < 3; axis++) {
        mesh_add_square(&mesh, axis, 1.0, 0.5);
        mesh_add_square(&mesh, axis, -1.0, 0.5);
    }
    return mesh;
}

// The four cubic Bernstein polynomials at t, B_i = C(3, i) t^i (1 - t)^(3 - i).
// At t = 0 and t = 1 they are exactly 0 or 1, so two patches that share a row
// of control points have exactly the same vertices there.
static void bernstein(double t, double value[4])
{
    double s = 1 - t;
    value[0] = s * s * s;
    value[1] = 3 * t * s * s;
    value[2] = 3 * t * t * s;
    value[3] = t * t * t;
}

// Their derivatives with respect to t.
static void bernstein_slope(double t, double slope[4])
{
    double s = 1 - t;
    slope[0] = -3 * s * s;
    slope[1] = 3 * s * s - 6 * t * s;
    slope[2] = 6 * t * s - 3 * t * t;
    slope[3] = 3 * t * t;
}

// sum over i, j of down[i] along[j] rows[i][j], turned from Newell's axes
// (z up) to ours (y up) by -90 degrees about x.
static void patch_sum(const double rows[4][4][3], const double along[4],
                      const double down[4], double result[3])
{
    double sum[3] = {0};
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) {
            for (int k = 0; k < 3; k++) {
                sum[k] += down[i] * along[j] * rows[i][j][k];
            }
        }
    }
    result[0] = sum[0];
    result[1] = sum[2];
    result[2] = -sum[1];
}

// The unit normal dS/du x dS/dv, outwards by the order of the rows.
static void patch_normal(const double rows[4][4][3], double u, double v,
                         double normal[3])
{
    double along[4], along_slope[4], down[4], down_slope[4];
    bernstein(u, along);
    bernstein_slope(u, along_slope);
    bernstein(v, down);
    bernstein_slope(v, down_slope);
    double to_right[3], to_next_row[3];
    patch_sum(rows, along_slope, down, to_right);
    patch_sum(rows, along, down_slope, to_next_row);
    if (dvec_dot(to_right, to_right) < 1e-20) {
        // A pole: the row is a single point and dS/du = 0. Just beside it,
        // dS/du is parallel to the derivative of the control row next to it.
        double inner_row[4] = {0, v < 0.5, v >= 0.5, 0};
        patch_sum(rows, along_slope, inner_row, to_right);
    }
    dvec_cross(to_right, to_next_row, normal);
    dvec_normalize(normal);
}

static void patch_add_vertices(Mesh *mesh, const double rows[4][4][3],
                               size_t segments)
{
    for (size_t row = 0; row <= segments; row++) {
        double v = (double)row / (double)segments;
        for (size_t column = 0; column <= segments; column++) {
            double u = (double)column / (double)segments;
            double along[4], down[4], position[3], normal[3];
            bernstein(u, along);
            bernstein(v, down);
            patch_sum(rows, along, down, position);
            for (int i = 0; i < 3; i++) {
                position[i] /= TEAPOT_HEIGHT;
            }
            patch_normal(rows, u, v, normal);
            mesh_add_vertex(mesh, position, normal);
        }
    }
}

// Appends the `count` vertices from `first` on, reflected in x and / or z.
// Changing a sign does not round, so the images meet the original exactly.
static void mesh_add_reflection(Mesh *mesh, size_t first, size_t count,
                                bool in_x, bool in_z)
{
    for (size_t i = 0; i < count; i++) {
        MeshVertex vertex = mesh->vertices[first + i];
        if (in_x) {
            vertex.position[0] = -vertex.position[0];
            vertex.normal[0] = -vertex.normal[0];
        }
        if (in_z) {
            vertex.position[2] = -vertex.position[2];
            vertex.normal[2] = -vertex.normal[2];
        }
        mesh->vertices[mesh->vertex_count++] = vertex;
    }
}

Mesh mesh_teapot(int segments)
{
    size_t n = (size_t)segments;
    size_t count = (n + 1) * (n + 1); // vertices of a patch
    size_t max_patches = 4 * TEAPOT_PATCH_COUNT;
    Mesh mesh = mesh_allocate(max_patches * count, max_patches * 6 * n * n);
    for (int i = 0; i < TEAPOT_PATCH_COUNT; i++) {
        const TeapotPatch *patch = &TEAPOT_PATCHES[i];
        size_t original = mesh.vertex_count;
        patch_add_vertices(&mesh, &TEAPOT_ROWS[patch->first_row], n);
        mesh_add_grid(&mesh, original, n, n, false);
        int images = patch->quarter ? 4 : 2;
        for (int image = 1; image < images; image++) {
            bool in_x = image / 2 == 1;
            bool in_z = image % 2 == 1;
            size_t first = mesh.vertex_count;
            mesh_add_reflection(&mesh, original, count, in_x, in_z);
            mesh_add_grid(&mesh, first, n, n, in_x != in_z);
        }
    }
    return mesh;
}

void mesh_find_box(Mesh *mesh)
{
    for (int k = 0; k < 3; k++) {
        mesh->low[k] = INFINITY;
        mesh->high[k] = -INFINITY;
        for (size_t i = 0; i < mesh->vertex_count; i++) {
            mesh->low[k] = fminf(mesh->low[k], mesh->vertices[i].position[k]);
            mesh->high[k] = fmaxf(mesh->high[k], mesh->vertices[i].position[k]);
        }
    }
}

void mesh_destroy(Mesh *mesh)
{
    free(mesh->vertices);
    free(mesh->indices);
    *mesh = (Mesh){0};
}
