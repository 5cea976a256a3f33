#include "step1_shadowmap/base/leave_out/volume.h"

#include <math.h> // fabs, sqrt

#include "step1_shadowmap/base/scene/dvec.h"   // dvec_dot
#include "step1_shadowmap/base/light/region.h" // polygon_clip

// By how much more than the whole map receivers are looked for, of the whole:
// far more than single precision errs.
#define MARGIN 1e-4

// The same of a point light's face and of a split, which another one is beside:
// more than a pixel shows of a triangle beyond its edges, where a rasteriser
// rounds them.
#define WIDE_MARGIN 1e-2

// What single precision errs at most, of the sum of the magnitudes.
#define ROUNDING 1e-5

// Adds the half-space where the sum of some rows, times (p, 1), is not
// negative: a + factor b >= 0.
static void add_plane(Volume *volume, const double a[4], double factor,
                      const double b[4])
{
    double *normal = volume->normals[volume->count];
    for (int k = 0; k < 3; k++) {
        normal[k] = -(a[k] + factor * b[k]);
    }
    volume->limits[volume->count++] = a[3] + factor * b[3];
}

// Both a <= limit and a >= -limit.
static void add_slab(Volume *volume, const double a[4], const double limit[4])
{
    add_plane(volume, limit, 1, a);
    add_plane(volume, limit, -1, a);
}

Volume volume_of_picture(const Views *views)
{
    const double(*clip)[4] = views->clip_from_relative;
    Volume volume = {.count = 0};
    add_slab(&volume, clip[0], clip[3]);
    add_slab(&volume, clip[1], clip[3]);
    return volume;
}

Volume volume_of_texels(const Views *views, int layer, const double low[2],
                        const double high[2])
{
    const double(*map)[4] = views->light[layer].map_from_relative;
    Volume volume = {.count = 0};
    for (int axis = 0; axis < 2; axis++) {
        double most[4];
        for (int k = 0; k < 4; k++) {
            most[k] = high[axis] * map[3][k];
        }
        add_plane(&volume, map[axis], -low[axis], map[3]);
        add_plane(&volume, most, -1, map[axis]);
    }
    return volume;
}

// A point light's position falls into the view of its largest coordinate.
static void add_face(Volume *volume, const Views *views, int face)
{
    int axis = face / 2;
    double along[4] = {0, 0, 0, 0};
    along[axis] = (face % 2 ? -1 : 1) * (1 + WIDE_MARGIN);
    along[3] = -along[axis] * views->light_position[axis];
    for (int i = 1; i < 3; i++) {
        double across[4] = {0, 0, 0, 0};
        across[(axis + i) % 3] = 1;
        across[3] = -views->light_position[(axis + i) % 3];
        add_slab(volume, across, along);
    }
}

// A split's are those from where the one before it begins to hand over to where
// it ends; the last one is looked up behind its end too.
static void add_split(Volume *volume, const Views *views, int layer)
{
    const double *depth = views->clip_from_relative[3];
    double margin = WIDE_MARGIN * views->light[layer].end;
    if (layer > 0) {
        const double begin[4] = {0, 0, 0,
                                 margin - views->light[layer - 1].handover};
        add_plane(volume, begin, 1, depth);
    }
    if (layer + 1 < views->layers) {
        const double end[4] = {0, 0, 0, margin + views->light[layer].end};
        add_plane(volume, end, -1, depth);
    }
}

Volume volume_of_receivers(const Views *views, int layer)
{
    const LightView *view = &views->light[layer];
    bool local = views->light_position[3] != 0;
    // Outside of a spot's cone, which leaves the border free, it is dark.
    double free = local && views->layers == 1 ? views->border : 0;
    double edge[2] = {free / views->width - MARGIN,
                      free / views->height - MARGIN};
    const double other_edge[2] = {1 - edge[0], 1 - edge[1]};
    Volume volume = volume_of_texels(views, layer, edge, other_edge);
    if (local) {
        // Nothing nearer than the near plane is in the map; and no point of it
        // is further from the light's plane than 1000 times its depth along
        // the axis.
        const double near[4] = {0, 0, 0, -1e-3 * view->near};
        add_plane(&volume, near, 1, view->map_from_relative[3]);
    }
    if (local && views->layers > 1) {
        add_face(&volume, views, layer);
    }
    if (view->end > 0) {
        add_split(&volume, views, layer);
    }
    return volume;
}

bool volume_misses(const Volume *volume, double corners[8][3])
{
    for (int i = 0; i < volume->count; i++) {
        int beyond = 0;
        for (int corner = 0; corner < 8; corner++) {
            double along = -volume->limits[i];
            double size = fabs(volume->limits[i]);
            for (int k = 0; k < 3; k++) {
                double part = volume->normals[i][k] * corners[corner][k];
                along += part;
                size += fabs(part);
            }
            beyond += along > ROUNDING * size;
        }
        if (beyond == 8) {
            return true;
        }
    }
    return false;
}

int volume_clip(const Volume *volume, double polygon[][3], int count)
{
    for (int i = 0; i < volume->count && count > 0; i++) {
        count =
            polygon_clip(polygon, count, volume->normals[i], volume->limits[i]);
    }
    return count;
}

double view_light_depth(const Views *views, int layer, const double position[3])
{
    const double *row = views->light[layer].depth_from_relative;
    double away[3];
    dvec_subtract(position, views->light_position, away);
    return dvec_dot(row, position) + row[3] +
           views->depth_per_distance * sqrt(dvec_dot(away, away));
}

double view_light_steepest(const Views *views, int layer)
{
    const double *row = views->light[layer].depth_from_relative;
    return sqrt(dvec_dot(row, row)) + views->depth_per_distance;
}

void object_box(const Object *object, const double origin[3],
                double corners[8][3])
{
    const Mesh *mesh = object->mesh;
    const float *bounds[2] = {mesh->low, mesh->high};
    for (int corner = 0; corner < 8; corner++) {
        for (int row = 0; row < 3; row++) {
            const double *m = object->transform[row];
            corners[corner][row] = m[3] - origin[row];
            for (int k = 0; k < 3; k++) {
                corners[corner][row] +=
                    m[k] * (double)bounds[corner >> k & 1][k];
            }
        }
    }
}

bool object_box_is(const Object *object, const double origin[3],
                   double axes[3][3], bool holds(const void *, const double[3]),
                   const void *range)
{
    double corners[8][3], point[3];
    bool all = true;
    object_box(object, origin, corners);
    for (int i = 0; i < 8 && all; i++) {
        frame_coordinates(axes, corners[i], point);
        all = holds(range, point);
    }
    return all;
}
