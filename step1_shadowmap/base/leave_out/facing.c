#include "step1_shadowmap/base/leave_out/facing.h"

#include <math.h> // fabs, sqrt

#include "step1_shadowmap/base/scene/dvec.h" // dvec_dot

// Far more than single precision errs, relative to the magnitudes.
#define SLACK 1e-5

// Normals go with the cofactors of the matrix, but for their length.
Facing facing_of_object(const Object *object, const Views *views)
{
    const double(*m)[4] = object->transform;
    Facing facing = {.views = views};
    double determinant = 0;
    for (int i = 0; i < 3; i++) {
        int a = (i + 1) % 3, b = (i + 2) % 3;
        for (int j = 0; j < 3; j++) {
            int c = (j + 1) % 3, d = (j + 2) % 3;
            double first = m[a][c] * m[b][d];
            double second = m[a][d] * m[b][c];
            facing.normal_from_object[i][j] = first - second;
            facing.magnitude[i][j] = fabs(first) + fabs(second);
        }
        determinant += m[0][i] * facing.normal_from_object[0][i];
    }
    for (int i = 0; i < 9 && determinant < 0; i++) {
        facing.normal_from_object[i / 3][i % 3] *= -1;
    }
    return facing;
}

// The most that the cosine between a vertex's normal and the light as seen from
// a position can be, times their lengths. Products of an exact 0 stay exact: a
// side of a box that is along the light stays unlit.
static double most_facing(const Facing *facing, const float normal[3],
                          double side, const double position[3])
{
    const double *light = facing->views->light_position;
    double sum = 0, magnitude = 0;
    for (int i = 0; i < 3; i++) {
        double towards = light[i] - light[3] * position[i];
        double size = fabs(light[i]) + light[3] * fabs(position[i]);
        for (int j = 0; j < 3; j++) {
            double part = side * (double)normal[j];
            sum += facing->normal_from_object[i][j] * part * towards;
            magnitude += facing->magnitude[i][j] * fabs(part) * size;
        }
    }
    return sum + SLACK * magnitude;
}

// Between the corners the normal and the way to the light are mixtures of
// those at the corners, so their product is a mixture of these nine.
static bool side_may_be_lit(const Facing *facing, const Mesh *mesh,
                            const uint32_t corners[3], double positions[][3],
                            double side)
{
    for (int i = 0; i < 9; i++) {
        const float *normal = mesh->vertices[corners[i / 3]].normal;
        if (most_facing(facing, normal, side, positions[i % 3]) > 0) {
            return true;
        }
    }
    return false;
}

bool facing_may_be_lit(const Facing *facing, const Mesh *mesh,
                       const uint32_t corners[3], double positions[][3],
                       const double across[3])
{
    // The camera is at 0: it sees the front where this is positive.
    double before = -dvec_dot(across, positions[0]);
    double length = sqrt(dvec_dot(across, across)) *
                    sqrt(dvec_dot(positions[0], positions[0]));
    bool front = before > -SLACK * length;
    bool back = before < SLACK * length;
    return (front && side_may_be_lit(facing, mesh, corners, positions, 1)) ||
           (back && side_may_be_lit(facing, mesh, corners, positions, -1));
}
