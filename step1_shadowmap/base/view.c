#include "step1_shadowmap/base/view.h"

#include <math.h>   // fmax, fmin, INFINITY, tan
#include <stdio.h>  // snprintf
#include <string.h> // memset

#include "step1_shadowmap/base/dvec.h" // dvec_cross, dvec_dot, dvec_frame, ...

// A triangle gains at most a corner from each half-space.
enum { MAX_CORNERS = 8 };

// The light's axes and what they span.
typedef struct LightFrame {
    double axes[3][3]; // right, up, direction: unit, in world axes
    double low[3], high[3];
} LightFrame;

static void vertex_relative(const Object *object, const double origin[3],
                            size_t vertex, double position[3])
{
    const float *local = object->mesh->vertices[vertex].position;
    for (int row = 0; row < 3; row++) {
        const double *m = object->transform[row];
        position[row] = m[0] * (double)local[0] + m[1] * (double)local[1] +
                        m[2] * (double)local[2] + (m[3] - origin[row]);
    }
}

static void frame_coordinates(double axes[3][3], const double position[3],
                              double result[3])
{
    for (int axis = 0; axis < 3; axis++) {
        result[axis] = dvec_dot(axes[axis], position);
    }
}

static void include_point(LightFrame *frame, const double point[3])
{
    for (int axis = 0; axis < 3; axis++) {
        frame->low[axis] = fmin(frame->low[axis], point[axis]);
        frame->high[axis] = fmax(frame->high[axis], point[axis]);
    }
}

// The bounds of everything that casts, or of everything if nothing does.
static void bound_casters(LightFrame *frame, const Scene *scene,
                          const double origin[3])
{
    bool any = false;
    for (int i = 0; i < scene->object_count; i++) {
        any = any || scene->objects[i].casts;
    }
    for (int i = 0; i < scene->object_count; i++) {
        const Object *object = &scene->objects[i];
        for (size_t k = 0; k < object->mesh->vertex_count; k++) {
            double relative[3];
            double point[3];
            vertex_relative(object, origin, k, relative);
            frame_coordinates(frame->axes, relative, point);
            if (object->casts || !any) {
                include_point(frame, point);
            }
        }
    }
}

// Cuts a convex polygon with the half-space dot(normal, p) <= limit
// (Sutherland and Hodgman). Returns the new number of corners.
static int clip(double polygon[][3], int count, const double normal[3],
                double limit)
{
    double result[MAX_CORNERS][3];
    int kept = 0;
    for (int i = 0; i < count; i++) {
        const double *a = polygon[i];
        const double *b = polygon[(i + 1) % count];
        double inside_a = limit - dvec_dot(normal, a);
        double inside_b = limit - dvec_dot(normal, b);
        if (inside_a >= 0) {
            dvec_copy(a, result[kept++]);
        }
        if ((inside_a >= 0) != (inside_b >= 0)) {
            double part = inside_a / (inside_a - inside_b);
            for (int k = 0; k < 3; k++) {
                result[kept][k] = a[k] + part * (b[k] - a[k]);
            }
            kept++;
        }
    }
    memcpy(polygon, result, sizeof result[0] * (size_t)kept);
    return kept;
}

// Four half-spaces, and the range along the third axis of what is in them.
typedef struct Region {
    double normals[4][3];
    double limits[4];
    double low, high;
} Region;

// Widens the region's range to the part of one triangle that is inside, in the
// coordinates of the axes.
static void include_triangle(Region *region, double axes[3][3],
                             const Object *object, const double origin[3],
                             const uint32_t corners[3])
{
    double polygon[MAX_CORNERS][3];
    for (int k = 0; k < 3; k++) {
        double relative[3];
        vertex_relative(object, origin, corners[k], relative);
        frame_coordinates(axes, relative, polygon[k]);
    }
    int count = 3;
    for (int i = 0; i < 4; i++) {
        count = clip(polygon, count, region->normals[i], region->limits[i]);
    }
    for (int k = 0; k < count; k++) {
        region->low = fmin(region->low, polygon[k][2]);
        region->high = fmax(region->high, polygon[k][2]);
    }
}

static void include_scene(Region *region, double axes[3][3], const Scene *scene,
                          const double origin[3])
{
    region->low = INFINITY;
    region->high = -INFINITY;
    for (int i = 0; i < scene->object_count; i++) {
        const Object *object = &scene->objects[i];
        for (size_t k = 0; k < object->mesh->index_count; k += 3) {
            include_triangle(region, axes, object, origin,
                             object->mesh->indices + k);
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
    include_scene(&region, frame->axes, scene, views->origin);
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

static void fit_light(Views *views, const Scene *scene, LightView *view)
{
    const double up[3] = {0, 1, 0};
    const Light *light = &scene->light;
    LightFrame frame = {.low = {INFINITY, INFINITY, INFINITY},
                        .high = {-INFINITY, -INFINITY, -INFINITY}};
    dvec_copy(light->direction, frame.axes[2]);
    dvec_frame(light->direction, up, frame.axes[0], frame.axes[1]);
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
}

// The near and far planes are fitted to what is in the picture: a depth buffer
// has few digits left for surfaces that are far behind its near plane.
static void fit_camera(Views *views, const Scene *scene, double aspect)
{
    const Camera *camera = &scene->camera;
    double axes[3][3]; // right, up, forward
    dvec_subtract(camera->target, camera->position, axes[2]);
    dvec_normalize(axes[2]);
    dvec_frame(axes[2], camera->up, axes[0], axes[1]);
    double tall = tan(0.5 * camera->fov_y);
    double wide = tall * aspect;
    Region region = {
        .normals = {
            {1, 0, -wide}, {-1, 0, -wide}, {0, 1, -tall}, {0, -1, -tall}}};
    include_scene(&region, axes, scene, views->origin);
    double far = region.high > 0 ? 1.01 * region.high : 1;
    double near = fmin(fmax(0.99 * region.low, 1e-6 * far), 0.5 * far);
    for (int k = 0; k < 3; k++) {
        views->clip_from_relative[0][k] = axes[0][k] / wide;
        views->clip_from_relative[1][k] = axes[1][k] / tall;
        views->clip_from_relative[2][k] =
            axes[2][k] * (far + near) / (far - near);
        views->clip_from_relative[3][k] = axes[2][k];
    }
    views->clip_from_relative[2][3] = -2 * far * near / (far - near);
}

static int least(int a, int b)
{
    return a < b ? a : b;
}

static int greatest(int a, int b)
{
    return a > b ? a : b;
}

void views_fit(Views *views, const Scene *scene, const int picture[2],
               const int map[2], int reach)
{
    memset(views, 0, sizeof *views);
    dvec_copy(scene->camera.position, views->origin);
    fit_camera(views, scene, (double)picture[0] / picture[1]);
    views->width = map[0];
    views->height = map[1];
    int side = least(map[0], map[1]);
    views->border = least(greatest(2 * reach, side / 16), (side - 1) / 2);
    views->layers = 1;
    fit_light(views, scene, &views->light[0]);
}

void view_set_matrix(GLuint program, const char *name,
                     const double matrix[4][4])
{
    float rows[16];
    for (int i = 0; i < 16; i++) {
        rows[i] = (float)matrix[i / 4][i % 4];
    }
    glUniformMatrix4fv(glGetUniformLocation(program, name), 1, GL_TRUE, rows);
}

void view_set_layer(GLuint program, const Views *views, int layer)
{
    char name[32];
    snprintf(name, sizeof name, "map_from_relative[%d]", layer);
    view_set_matrix(program, name, views->light[layer].map_from_relative);
    glUniform1i(glGetUniformLocation(program, "layer"), layer);
}
