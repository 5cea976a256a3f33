#include "step1_shadowmap/base/light/view.h"

#include <math.h>   // fmax, fmin, tan
#include <stdio.h>  // snprintf
#include <string.h> // memset

#include "step1_shadowmap/base/scene/dvec.h" // dvec_copy, dvec_frame, dvec_subtract
#include "step1_shadowmap/base/light/light_view.h" // fit_directional, fit_point, ...
#include "step1_shadowmap/base/light/region.h" // region_include_scene

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
    region_include_scene(&region, axes, scene, views->origin);
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

void views_fit(Views *views, const Scene *scene, const ViewsSize *size,
               int reach)
{
    double aspect = (double)size->picture[0] / size->picture[1];
    memset(views, 0, sizeof *views);
    dvec_copy(scene->camera.position, views->origin);
    fit_camera(views, scene, aspect);
    views->width = size->map[0];
    views->height = size->map[1];
    int side = least(views->width, views->height);
    views->border = least(greatest(2 * reach, side / 16), (side - 1) / 2);
    (size->fit != NULL ? size->fit : fit_directional)(views, scene, size);
    draw_list_all(&views->seen, scene);
    for (int layer = 0; layer < views->layers; layer++) {
        LightView *view = &views->light[layer];
        draw_list_all(&view->seen, scene);
        view->looked_up = (Rect){{0, 0}, {views->width, views->height}};
    }
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

static void set_vector(GLuint program, const char *name, const double vector[4])
{
    glUniform4f(glGetUniformLocation(program, name), (float)vector[0],
                (float)vector[1], (float)vector[2], (float)vector[3]);
}

void view_set_light(GLuint program, const Views *views)
{
    set_vector(program, "light_position", views->light_position);
    glUniform1f(glGetUniformLocation(program, "depth_per_distance"),
                (float)views->depth_per_distance);
    for (int layer = 0; layer < views->layers; layer++) {
        const LightView *view = &views->light[layer];
        char name[48];
        snprintf(name, sizeof name, "map_from_relative[%d]", layer);
        view_set_matrix(program, name, view->map_from_relative);
        snprintf(name, sizeof name, "depth_from_relative[%d]", layer);
        set_vector(program, name, view->depth_from_relative);
    }
}
