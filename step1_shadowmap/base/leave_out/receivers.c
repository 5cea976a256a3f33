#include "step1_shadowmap/base/leave_out/receivers.h"

#include <math.h> // ceil, fabs, floor, fmax, fmin, isfinite, sqrt, INFINITY

#include "step1_shadowmap/base/scene/dvec.h"       // dvec_cross, dvec_dot
#include "step1_shadowmap/base/leave_out/facing.h" // Facing
#include "step1_shadowmap/base/light/region.h"     // POLYGON_MAX_CORNERS
#include "step1_shadowmap/base/leave_out/volume.h" // volume_of_receivers

enum {
    // Of a mesh with more triangles only the box around it is looked at.
    MAX_TRIANGLES = 2048,
    // Around all that is looked up: a receiver's place is computed in single
    // precision.
    MARGIN_TEXELS = 2
};

// A pixel's middle may be this far outside of the triangle that covers it, in
// pixels: rasterisers round corners to 1/256.
#define SNAP (1.0 / 64)

// Roundings of single precision, in units of the largest number that takes part
// in computing a place in the map.
#define ROUNDINGS (32 * 0x1p-24)

// A margin that holds every map, in texels.
#define NOWHERE 1e9

// One triangle as far as it is seen, relative to the camera.
typedef struct Patch {
    double corners[POLYGON_MAX_CORNERS][3];
    int count;
    double normal[3]; // of any length
    double size;      // of the largest coordinate of the whole triangle
} Patch;

// What is looked up of a layer so far, in texels.
typedef struct Reach {
    double low[2], high[2];
} Reach;

typedef struct Collector {
    const Views *views;
    double pixel[2][3]; // how a ray of view depth 1 changes to the next pixel
    Volume picture;
    Volume receivers[VIEW_MAX_LAYERS];
    Reach reach[VIEW_MAX_LAYERS];
    double deepest[VIEW_MAX_LAYERS];
} Collector;

static void include(Collector *all, int layer, const double texel[2],
                    double margin, double depth)
{
    Reach *reach = &all->reach[layer];
    for (int axis = 0; axis < 2; axis++) {
        reach->low[axis] = fmin(reach->low[axis], texel[axis] - margin);
        reach->high[axis] = fmax(reach->high[axis], texel[axis] + margin);
    }
    all->deepest[layer] = fmax(all->deepest[layer], depth);
}

// Where a position is in a layer, in texels; returns its w.
static double texel_of(const Views *views, int layer, const double position[3],
                       double texel[2])
{
    const double(*map)[4] = views->light[layer].map_from_relative;
    const int size[2] = {views->width, views->height};
    double w = dvec_dot(map[3], position) + map[3][3];
    for (int axis = 0; axis < 2; axis++) {
        texel[axis] =
            size[axis] * (dvec_dot(map[axis], position) + map[axis][3]) / w;
    }
    return w;
}

// How far a pixel that shows the patch can be from its corner in space, along
// each of the picture's axes. A ray r (view depth 1) meets the plane dot(n, p)
// = d at p = r d / dot(n, r), the one beside it, r + s, at p + z (s - r n.s /
// n.r) / (1 + n.s / n.r). False: the plane is seen edge on, and it may be
// anywhere.
static bool snap_steps(const Collector *all, const Patch *patch,
                       const double corner[3], double steps[2][3])
{
    double depth = dvec_dot(all->views->clip_from_relative[3], corner);
    double away = dvec_dot(patch->normal, corner) / depth;
    double tilts[2], left = 1;
    for (int axis = 0; axis < 2; axis++) {
        tilts[axis] = SNAP * dvec_dot(patch->normal, all->pixel[axis]) / away;
        left -= fabs(tilts[axis]);
    }
    for (int axis = 0; axis < 2; axis++) {
        for (int k = 0; k < 3; k++) {
            steps[axis][k] =
                (SNAP * depth * all->pixel[axis][k] - tilts[axis] * corner[k]) /
                left;
        }
    }
    return left > 0;
}

// The same across the map, in texels, from a corner with this place and w.
static double snap_texels(const Collector *all, const Patch *patch, int layer,
                          const double corner[3], const double texel[2],
                          double w)
{
    const double(*map)[4] = all->views->light[layer].map_from_relative;
    const int size[2] = {all->views->width, all->views->height};
    double steps[2][3], along[2] = {0, 0};
    if (!snap_steps(all, patch, corner, steps)) {
        return NOWHERE;
    }
    double least = w; // and this is where the map's own division ends
    for (int step = 0; step < 2; step++) {
        double towards = dvec_dot(map[3], steps[step]);
        least -= fabs(towards);
        for (int axis = 0; axis < 2; axis++) {
            along[axis] += fabs(size[axis] * dvec_dot(map[axis], steps[step]) -
                                texel[axis] * towards);
        }
    }
    return least > 0 ? fmax(along[0], along[1]) / least : NOWHERE;
}

// How far off single precision can place it, in texels.
static double rounding_texels(const Views *views, int layer, double patch_size,
                              const double texel[2], double w)
{
    const double(*map)[4] = views->light[layer].map_from_relative;
    const int size[2] = {views->width, views->height};
    double most = 0;
    for (int axis = 0; axis < 2; axis++) {
        double sum = 0;
        for (int k = 0; k < 4; k++) {
            sum += (k < 3 ? patch_size : 1) * (size[axis] * fabs(map[axis][k]) +
                                               fabs(texel[axis] * map[3][k]));
        }
        most = fmax(most, ROUNDINGS * sum / w);
    }
    return most;
}

// By how much what a pixel shows of the patch can be deeper than its corner,
// rounding included.
static double snap_depth(const Collector *all, const Patch *patch, int layer,
                         const double corner[3])
{
    double steps[2][3], way = ROUNDINGS * patch->size;
    if (!snap_steps(all, patch, corner, steps)) {
        return NOWHERE;
    }
    for (int axis = 0; axis < 2; axis++) {
        way += sqrt(dvec_dot(steps[axis], steps[axis]));
    }
    return view_light_steepest(all->views, layer) * way;
}

static void include_patch(Collector *all, const Patch *patch, int layer)
{
    Patch part = *patch;
    part.count = volume_clip(&all->receivers[layer], part.corners, part.count);
    for (int i = 0; i < part.count; i++) {
        const double *corner = part.corners[i];
        double texel[2];
        double w = texel_of(all->views, layer, corner, texel);
        double margin =
            snap_texels(all, patch, layer, corner, texel, w) +
            rounding_texels(all->views, layer, patch->size, texel, w);
        margin = isfinite(margin) ? margin : NOWHERE;
        include(all, layer, texel, margin,
                view_light_depth(all->views, layer, corner) +
                    snap_depth(all, patch, layer, corner));
    }
}

static void include_triangle(Collector *all, const Facing *facing,
                             const Object *object, const uint32_t corners[3])
{
    Patch patch = {.count = 3};
    double edges[2][3];
    for (int k = 0; k < 3; k++) {
        vertex_relative(object, all->views->origin, corners[k],
                        patch.corners[k]);
        for (int axis = 0; axis < 3; axis++) {
            patch.size = fmax(patch.size, fabs(patch.corners[k][axis]));
        }
    }
    dvec_subtract(patch.corners[1], patch.corners[0], edges[0]);
    dvec_subtract(patch.corners[2], patch.corners[0], edges[1]);
    dvec_cross(edges[0], edges[1], patch.normal);
    if (!facing_may_be_lit(facing, object->mesh, corners, patch.corners,
                           patch.normal)) {
        return;
    }
    patch.count = volume_clip(&all->picture, patch.corners, patch.count);
    for (int layer = 0; layer < all->views->layers && patch.count > 0;
         layer++) {
        include_patch(all, &patch, layer);
    }
}

// A box around a mesh of small triangles, somewhat larger than it: rounding
// moves what a pixel shows of them by less than a few triangles. Of a box that
// reaches behind the light's own plane the place in the map has no bounds.
static void include_box(Collector *all, double corners[8][3], int layer)
{
    const LightView *view = &all->views->light[layer];
    bool local = all->views->light_position[3] != 0;
    for (int i = 0; i < 8; i++) {
        double texel[2];
        double w = texel_of(all->views, layer, corners[i], texel);
        bool before = !local || w > 1e-3 * view->near;
        include(all, layer, texel, before ? 0 : NOWHERE,
                view_light_depth(all->views, layer, corners[i]));
    }
}

static void grow_box(double corners[8][3], double factor)
{
    for (int k = 0; k < 3; k++) {
        double middle = 0;
        for (int i = 0; i < 8; i++) {
            middle += corners[i][k] / 8;
        }
        for (int i = 0; i < 8; i++) {
            corners[i][k] = middle + factor * (corners[i][k] - middle);
        }
    }
}

static void include_object(Collector *all, const Object *object)
{
    const Mesh *mesh = object->mesh;
    double corners[8][3];
    object_box(object, all->views->origin, corners);
    grow_box(corners, 1.25);
    if (volume_misses(&all->picture, corners)) {
        return;
    }
    if (mesh->index_count > 3 * MAX_TRIANGLES) {
        for (int layer = 0; layer < all->views->layers; layer++) {
            if (!volume_misses(&all->receivers[layer], corners)) {
                include_box(all, corners, layer);
            }
        }
        return;
    }
    Facing facing = facing_of_object(object, all->views);
    for (size_t i = 0; i < mesh->index_count; i += 3) {
        include_triangle(all, &facing, object, mesh->indices + i);
    }
}

// How the ray through a pixel, of view depth 1, changes to the next pixel to
// the right and above.
static void find_pixel(Collector *all, const int picture[2])
{
    for (int axis = 0; axis < 2; axis++) {
        const double *row = all->views->clip_from_relative[axis];
        double length = dvec_dot(row, row); // over the tangent, squared
        for (int k = 0; k < 3; k++) {
            all->pixel[axis][k] = 2 * row[k] / length / picture[axis];
        }
    }
}

static Rect rounded(const Reach *reach, const int size[2])
{
    Rect rect = {{0, 0}, {0, 0}};
    for (int axis = 0; axis < 2; axis++) {
        double low = floor(reach->low[axis]) - MARGIN_TEXELS;
        double high = ceil(reach->high[axis]) + MARGIN_TEXELS;
        rect.low[axis] = (int)fmin(fmax(low, 0), size[axis]);
        rect.high[axis] = (int)fmin(fmax(high, 0), size[axis]);
    }
    return rect;
}

void receivers_find(Views *views, const Scene *scene, const int picture[2],
                    double deepest[])
{
    const int size[2] = {views->width, views->height};
    Collector all = {.views = views, .picture = volume_of_picture(views)};
    find_pixel(&all, picture);
    for (int layer = 0; layer < views->layers; layer++) {
        all.receivers[layer] = volume_of_receivers(views, layer);
        all.reach[layer] =
            (Reach){{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
    }
    for (int i = 0; i < views->seen.count; i++) {
        include_object(&all, &scene->objects[views->seen.objects[i]]);
    }
    for (int layer = 0; layer < views->layers; layer++) {
        views->light[layer].looked_up = rounded(&all.reach[layer], size);
        deepest[layer] = all.deepest[layer];
    }
}
