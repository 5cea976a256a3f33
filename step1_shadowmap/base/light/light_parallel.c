#include <math.h>   // fmax, fmin, INFINITY
#include <string.h> // memcpy

#include "step1_shadowmap/base/scene/dvec.h" // dvec_copy, dvec_dot, dvec_frame
#include "step1_shadowmap/base/light/light_view.h" // fit_directional
#include "step1_shadowmap/base/light/region.h"     // region_include_scene

static void include_point(LightFrame *frame, const double point[3])
{
    for (int axis = 0; axis < 3; axis++) {
        frame->low[axis] = fmin(frame->low[axis], point[axis]);
        frame->high[axis] = fmax(frame->high[axis], point[axis]);
    }
}

static bool holds_point(const void *range, const double point[3])
{
    const LightFrame *frame = range;
    bool inside = true;
    for (int axis = 0; axis < 3; axis++) {
        inside = inside && point[axis] >= frame->low[axis] &&
                 point[axis] <= frame->high[axis];
    }
    return inside;
}

static void include_object(LightFrame *frame, const Object *object,
                           const double origin[3])
{
    for (size_t k = 0; k < object->mesh->vertex_count; k++) {
        double relative[3];
        double point[3];
        vertex_relative(object, origin, k, relative);
        frame_coordinates(frame->axes, relative, point);
        include_point(frame, point);
    }
}

void bound_casters(LightFrame *frame, const Scene *scene,
                   const double origin[3])
{
    const double up[3] = {0, 1, 0};
    *frame = (LightFrame){.low = {INFINITY, INFINITY, INFINITY},
                          .high = {-INFINITY, -INFINITY, -INFINITY}};
    double(*axes)[3] = frame->axes;
    dvec_copy(scene->light.direction, axes[2]);
    dvec_frame(axes[2], up, axes[0], axes[1]);
    bool any = false;
    for (int i = 0; i < scene->object_count; i++) {
        any = any || scene->objects[i].casts;
    }
    for (int i = 0; i < scene->object_count; i++) {
        const Object *object = &scene->objects[i];
        if ((object->casts || !any) &&
            !(object_box_is != NULL &&
              object_box_is(object, origin, axes, holds_point, frame))) {
            include_object(frame, object, origin);
        }
    }
}

// A filter at the map's edge reads far depth where a surface goes on outside.
// Far is only far if it is behind that part of the surface too, so the range
// holds what is within one border around the map; else a lit floor that leaves
// the map falling away from the light is darkened along the edge.
static void bound_depth(LightFrame *frame, const Scene *scene,
                        const Views *views)
{
    double texel = (frame->high[0] - frame->low[0]) / views->width;
    double around = texel * views->border;
    Region region = {.normals = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}},
                     .limits = {frame->high[0] + around, around - frame->low[0],
                                frame->high[1] + around,
                                around - frame->low[1]}};
    region_include_scene(&region, frame->axes, scene, views->origin);
    frame->low[2] = region.low;
    frame->high[2] = region.high;
}

// Widens the rectangle to the whole map: the border around it, and square
// texels, so that a filter is as wide along u as along v.
static void widen_to_map(LightFrame *frame, const Views *views)
{
    const int size[2] = {views->width, views->height};
    double texel = 0;
    for (int axis = 0; axis < 2; axis++) {
        double extent = frame->high[axis] - frame->low[axis];
        // One texel less than fits: nothing touches the border's edge.
        double inner = fmax(size[axis] - 2 * views->border - 1, 0.5);
        texel = fmax(texel, extent / inner);
    }
    texel = texel > 0 ? texel : 1;
    for (int axis = 0; axis < 2; axis++) {
        double middle = 0.5 * (frame->low[axis] + frame->high[axis]);
        frame->low[axis] = middle - 0.5 * size[axis] * texel;
        frame->high[axis] = middle + 0.5 * size[axis] * texel;
    }
}

void fit_directional(Views *views, const Scene *scene, const ViewsSize *size)
{
    (void)size;
    const Light *light = &scene->light;
    LightView *view = &views->light[0];
    views->layers = 1;
    LightFrame frame;
    bound_casters(&frame, scene, views->origin);
    widen_to_map(&frame, views);

    double from_anchor[3];
    dvec_subtract(views->origin, light->anchor, from_anchor);
    double base = dvec_dot(light->direction, from_anchor);
    if (light->near == 0 && light->far == 0) {
        bound_depth(&frame, scene, views);
        // A plane that faces the light has no depth of its own.
        double range = fmax(frame.high[2] - frame.low[2],
                            1e-6 * (frame.high[0] - frame.low[0]));
        // Nothing is at depth 0: rounding is bounded relative to the stored
        // moments in step 5, but a receiver's own depth errs by as much near
        // 0 as it does near 1.
        view->near = base + frame.low[2] - range / 16;
        view->far = base + frame.high[2] + range / 256;
    } else {
        view->near = light->near;
        view->far = light->far;
    }
    frame.low[2] = view->near - base;
    frame.high[2] = view->far - base;
    for (int row = 0; row < 3; row++) {
        double extent = frame.high[row] - frame.low[row];
        for (int k = 0; k < 3; k++) {
            view->map_from_relative[row][k] = frame.axes[row][k] / extent;
        }
        view->map_from_relative[row][3] = -frame.low[row] / extent;
    }
    view->map_from_relative[3][3] = 1;
    memcpy(view->depth_from_relative, view->map_from_relative[2],
           sizeof view->depth_from_relative);
    for (int k = 0; k < 3; k++) {
        views->light_position[k] = -light->direction[k];
    }
}
