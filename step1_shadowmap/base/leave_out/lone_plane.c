#include "step1_shadowmap/base/leave_out/lone_plane.h"

#include <math.h>   // fabs, fmax, fmin, hypot, sqrt, INFINITY
#include <string.h> // memcmp

#include "step1_shadowmap/base/leave_out/casters.h" // casters_list
#include "step1_shadowmap/base/scene/dvec.h"        // dvec_cross, dvec_dot
#include "step1_shadowmap/base/light/region.h"      // vertex_relative

// By how much what a pixel or a texel shows of a surface can be off it, of its
// distance from the camera: 8 units of single precision (guard_central.glsl:
// measured 7.4). By how much u and v are, of the map: 4.
#define POSITION_ERROR (8 * 0x1p-24)
#define PLACE_ERROR (4 * 0x1p-24)

// Of lengths that are equal but for rounding.
#define EQUAL 1e-9

typedef struct Flat {
    double slope; // least change of t to the next texel, along the steepest way
    double error; // most that t, or where it is compared, may be off, in t
    double sine;  // of the least angle at which light meets the plane
} Flat;

// a + x e + y f for x and y from 0 to 1, relative to the camera, and the same
// in the map: texels, and t.
typedef struct Sheet {
    double corner[3], edges[2][3];
    double texel[2], texel_edges[2][2];
    double depth, depth_edges[2];
    double area; // signed, in texels
} Sheet;

// The corner of a square's mesh that is across from the first one; 0: it is
// none.
static size_t opposite_corner(double corners[4][3])
{
    for (size_t i = 1; i < 4; i++) {
        const double *a = corners[i % 3 + 1], *b = corners[(i + 1) % 3 + 1];
        double apart = 0, size = 0;
        for (int k = 0; k < 3; k++) {
            apart += fabs(corners[0][k] + corners[i][k] - a[k] - b[k]);
            size += fabs(corners[0][k] - corners[i][k]);
        }
        if (apart < EQUAL * size) {
            return i;
        }
    }
    return 0;
}

// Whether it is shaded with its own normal everywhere.
static bool has_plain_normals(const Mesh *mesh)
{
    const MeshVertex *first = &mesh->vertices[0];
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        const MeshVertex *vertex = &mesh->vertices[i];
        double across = 0;
        for (int k = 0; k < 3; k++) {
            across += (double)first->normal[k] * ((double)vertex->position[k] -
                                                  (double)first->position[k]);
        }
        if (fabs(across) > EQUAL ||
            memcmp(vertex->normal, first->normal, sizeof first->normal) != 0) {
            return false;
        }
    }
    return true;
}

static void find_edges(Sheet *sheet, double corners[4][3], size_t opposite)
{
    dvec_copy(corners[0], sheet->corner);
    for (size_t i = 0; i < 2; i++) {
        dvec_subtract(corners[(opposite + i) % 3 + 1], corners[0],
                      sheet->edges[i]);
    }
}

// Of a parallel light: no row has a divisor.
static void project(Sheet *sheet, const Views *views, int layer)
{
    const LightView *view = &views->light[layer];
    const int size[2] = {views->width, views->height};
    const double *depth_row = view->depth_from_relative;
    for (int axis = 0; axis < 2; axis++) {
        const double *row = view->map_from_relative[axis];
        sheet->texel[axis] =
            size[axis] * (dvec_dot(row, sheet->corner) + row[3]);
        for (int i = 0; i < 2; i++) {
            sheet->texel_edges[i][axis] =
                size[axis] * dvec_dot(row, sheet->edges[i]);
        }
    }
    sheet->depth = dvec_dot(depth_row, sheet->corner) + depth_row[3];
    for (int i = 0; i < 2; i++) {
        sheet->depth_edges[i] = dvec_dot(depth_row, sheet->edges[i]);
    }
    sheet->area = sheet->texel_edges[0][0] * sheet->texel_edges[1][1] -
                  sheet->texel_edges[0][1] * sheet->texel_edges[1][0];
}

// The only thing that may be drawn into these texels.
static bool find_sheet(Sheet *sheet, const Frame *frame, int layer,
                       const Rect *texels)
{
    DrawList list;
    double corners[4][3];
    casters_list(&list, &frame->views, &frame->scene, layer, texels, INFINITY);
    if (list.count != 1) {
        return false;
    }
    const Object *object = &frame->scene.objects[list.objects[0]];
    const Mesh *mesh = object->mesh;
    if (mesh->vertex_count != 4 || mesh->index_count != 6 ||
        !has_plain_normals(mesh)) {
        return false;
    }
    for (size_t i = 0; i < 4; i++) {
        vertex_relative(object, frame->views.origin, i, corners[i]);
    }
    size_t opposite = opposite_corner(corners);
    find_edges(sheet, corners, opposite);
    project(sheet, &frame->views, layer);
    return opposite != 0 && sheet->area != 0;
}

// Whether the sheet covers the middle of a place in the map, between the near
// and the far plane. `position` is what is seen there.
static bool covers(const Sheet *sheet, const double texel[2],
                   double position[3])
{
    const double(*edges)[2] = sheet->texel_edges;
    double away[2] = {texel[0] - sheet->texel[0], texel[1] - sheet->texel[1]};
    double part[2] = {
        (away[0] * edges[1][1] - away[1] * edges[1][0]) / sheet->area,
        (edges[0][0] * away[1] - edges[0][1] * away[0]) / sheet->area};
    double depth = sheet->depth + part[0] * sheet->depth_edges[0] +
                   part[1] * sheet->depth_edges[1];
    for (int k = 0; k < 3; k++) {
        position[k] = sheet->corner[k] + part[0] * sheet->edges[0][k] +
                      part[1] * sheet->edges[1][k];
    }
    return part[0] >= 0 && part[0] <= 1 && part[1] >= 0 && part[1] <= 1 &&
           depth > 1e-3 && depth < 1 - 1e-3;
}

static double length(const double v[3])
{
    return sqrt(dvec_dot(v, v));
}

static void include_sheet(Flat *flat, const Sheet *sheet, const Views *views,
                          int layer, double farthest)
{
    const double *depth_row = views->light[layer].depth_from_relative;
    const double(*edges)[2] = sheet->texel_edges;
    const double *depths = sheet->depth_edges;
    double along_u =
        (depths[0] * edges[1][1] - depths[1] * edges[0][1]) / sheet->area;
    double along_v =
        (depths[1] * edges[0][0] - depths[0] * edges[1][0]) / sheet->area;
    double normal[3];
    dvec_cross(sheet->edges[0], sheet->edges[1], normal);
    double sine = fabs(dvec_dot(normal, views->light_position)) /
                  (length(normal) * length(views->light_position));
    double place = PLACE_ERROR * (fabs(along_u) * views->width +
                                  fabs(along_v) * views->height);
    // Off the plane by a little: the light meets it as much further on.
    double off = POSITION_ERROR * farthest * length(depth_row) / sine;
    flat->slope = fmin(flat->slope, hypot(along_u, along_v));
    flat->error = fmax(flat->error, place + off);
    flat->sine = fmin(flat->sine, sine);
}

static bool include_layer(Flat *flat, const Frame *frame, int layer,
                          const Rect *texels)
{
    Sheet sheet;
    double farthest = 0;
    if (!find_sheet(&sheet, frame, layer, texels)) {
        return false;
    }
    for (int i = 0; i < 4; i++) {
        const double texel[2] = {i % 2 ? texels->high[0] : texels->low[0],
                                 i / 2 ? texels->high[1] : texels->low[1]};
        double position[3];
        if (!covers(&sheet, texel, position)) {
            return false;
        }
        farthest = fmax(farthest, length(position));
    }
    include_sheet(flat, &sheet, &frame->views, layer, farthest);
    return true;
}

// Whether lookups that read so many texels to each side find nothing else.
static bool is_flat(const Frame *frame, int reach, Flat *flat)
{
    const Views *views = &frame->views;
    const int size[2] = {views->width, views->height};
    bool alone = views->light_position[3] == 0;
    *flat = (Flat){.slope = INFINITY, .error = 0, .sine = INFINITY};
    for (int layer = 0; layer < views->layers && alone; layer++) {
        Rect texels = views->light[layer].looked_up;
        if (rect_is_empty(&texels)) {
            continue;
        }
        for (int axis = 0; axis < 2; axis++) {
            texels.low[axis] -= reach;
            texels.high[axis] += reach;
            alone = alone && texels.low[axis] >= 0 &&
                    texels.high[axis] <= size[axis];
        }
        alone = alone && include_layer(flat, frame, layer, &texels);
    }
    return alone;
}

// It is too much biased to shadow itself. Where the light meets the plane at
// less than 0.02 the slope's part is held (depth_slope.glsl). The constant part
// is for rounding, of a mean by more than of a depth.
static bool is_biased(const Frame *frame)
{
    static const double least_sine = 0.03;
    const Lookups *lookups = &frame->lookups;
    Flat flat;
    return lookups->kernel > 0 &&
           is_flat(frame, lookups->kernel / 2 + 1, &flat) &&
           flat.sine > least_sine && lookups->slope_bias >= 1 &&
           lookups->bias > lookups->rounding + flat.error;
}

// A plane alone varies by V = spread slope^2 across the filter, and t is the
// mean of that but for rounding and the plane's own error. If what is added to
// the variance against rounding is no more than rounding can have taken,
// nothing is lost of V. So t is behind by no more than the error, and p = V /
// (V
// + error^2) is 1, as a sum in single precision is V where what is added is
// less than a half of 2^-24 V; another half is for V's own error.
static bool varies(const Frame *frame)
{
    const Lookups *lookups = &frame->lookups;
    Flat flat;
    return lookups->spread > 0 && is_flat(frame, lookups->reach, &flat) &&
           flat.error * flat.error <
               0x1p-26 * lookups->spread * flat.slope * flat.slope;
}

bool lone_plane_is_lit(const Frame *frame, const char **why)
{
    if (is_biased(frame)) {
        *why = "one plane alone, which its bias keeps lit";
        return true;
    }
    *why = "one plane alone, which varies too much to shadow itself";
    return varies(frame);
}
