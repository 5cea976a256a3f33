// Meshes and objects that only some scenes have.
#include <math.h> // cos, sin

#include "step1_shadowmap/base/scene/dvec.h" // dvec_frame
#include "step1_shadowmap/base/scenes/build.h"
#include "step1_shadowmap/base/system/die.h" // die

static const double PI = 3.14159265358979323846;

Mesh mesh_tiles(int side)
{
    size_t corners = (size_t)side + 1, tiles = (size_t)side * (size_t)side;
    Mesh mesh = mesh_allocate(corners * corners, 6 * tiles);
    const double up[3] = {0, 1, 0};
    for (int z = 0; z <= side; z++) {
        for (int x = 0; x <= side; x++) {
            const double place[3] = {(double)x / side - 0.5, 0,
                                     (double)z / side - 0.5};
            mesh_add_vertex(&mesh, place, up);
        }
    }
    mesh_add_grid(&mesh, 0, (size_t)side, (size_t)side, true);
    return mesh;
}

static void check_segments(int segments)
{
    if (segments < 4 || segments > MESH_MAX_SEGMENTS) {
        die("a sphere of %d segments; use 4 to %d", segments,
            MESH_MAX_SEGMENTS);
    }
}

Mesh mesh_sphere(int segments)
{
    check_segments(segments);
    size_t columns = (size_t)segments;
    size_t rows = columns / 2;
    Mesh mesh = mesh_allocate((columns + 1) * (rows + 1), 6 * columns * rows);
    for (size_t row = 0; row <= rows; row++) {
        // sin(pi) rounds to 1e-16 and cos(2 pi) to less than 1; so the pole
        // gets its radius and the last column its angle by hand, or the
        // sphere would not close exactly.
        double polar = PI * (double)row / (double)rows;
        double radius = row % rows == 0 ? 0.0 : sin(polar);
        for (size_t column = 0; column <= columns; column++) {
            double angle =
                2 * PI * (double)(column % columns) / (double)columns;
            double position[3] = {radius * cos(angle), cos(polar),
                                  radius * sin(angle)};
            mesh_add_vertex(&mesh, position, position);
        }
    }
    mesh_add_grid(&mesh, 0, columns, rows, false);
    return mesh;
}

Object *scene_add_block(Scene *scene, const char *name, const Mesh *box,
                        const double size[3], const double foot[3])
{
    const double middle[3] = {foot[0], foot[1] + 0.5 * size[1], foot[2]};
    return scene_add_object(scene, name, box, size, middle);
}

Object *scene_add_facing_plane(Scene *scene, const char *name, const Mesh *mesh,
                               double along, const double shift[2],
                               const double size[2], double angle)
{
    const double hint[3] = {0, 1, 0};
    const Light *light = &scene->light;
    double right[3];
    double up[3];
    dvec_frame(light->direction, hint, right, up);
    const double one[3] = {1, 1, 1};
    Object *object = scene_add_object(scene, name, mesh, one, light->anchor);
    for (int row = 0; row < 3; row++) {
        double x = cos(angle) * right[row] + sin(angle) * up[row];
        double z = sin(angle) * right[row] - cos(angle) * up[row];
        double *m = object->transform[row];
        m[0] = size[0] * x;
        m[1] = -light->direction[row]; // the plane's normal
        m[2] = size[1] * z;
        m[3] = light->anchor[row] + along * light->direction[row] +
               shift[0] * x + shift[1] * z;
    }
    return object;
}
