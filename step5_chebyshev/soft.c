#include "step5_chebyshev/soft.h"

#include <math.h>  // ceil, cos, fmax, pow, sqrt
#include <stdio.h> // snprintf

// Of penumbra.glsl: texels of the filtered map.
enum { LEAST_DISC = 4 };

// How many texels across the map one unit is, of a spot or point light at a
// distance of 1 along the view's axis. There the rows hold half of the axis.
static double texels_per_unit(const Views *views, const LightView *view)
{
    double squares = 0;
    for (int k = 0; k < 3; k++) {
        double across =
            view->map_from_relative[0][k] - 0.5 * view->map_from_relative[3][k];
        squares += across * across;
    }
    return sqrt(squares) * views->width;
}

// By how much a small circle grows in the map where it is furthest off the
// view's axis, at an angle c: to 1 / cos(c) along one direction, to
// 1 / cos^2(c) along the other. In the corner of a point light's view cos^2(c)
// is 1/3.
static double widest_spread(const Light *light)
{
    double cosine =
        light->kind == LIGHT_POINT ? sqrt(1 / 3.0) : cos(light->cone);
    return pow(cosine, -1.5);
}

// Texels of the full map across the widest search, that of a receiver at the
// far plane for occluders at the near plane.
static double widest_search(double light_size, const Views *views,
                            const Light *light)
{
    double widest = 0; // a lamp at the near plane itself: infinite
    for (int layer = 0; layer < views->layers; layer++) {
        const LightView *view = &views->light[layer];
        double width = light_size * (view->far - view->near);
        if (light->kind != LIGHT_DIRECTIONAL) {
            width *= widest_spread(light) / (view->near * view->far);
        }
        widest = fmax(widest, width * texels_per_unit(views, view));
    }
    return widest;
}

// The least border's that is enough for the views which are fitted with it: the
// wider the border, the larger the texels, of which fewer are needed.
int soft_reach(const SoftSettings *settings, const BlurSettings *blur,
               const Frame *frame)
{
    const ViewsSize size = base_views_size(&frame->settings);
    int side = size.map[size.map[0] < size.map[1] ? 0 : 1];
    int low = LEAST_DISC * blur->downsample;
    int high = side / 8 > low ? side / 8 : low;
    while (low < high) {
        Views views;
        int middle = (low + high) / 2;
        views_fit(&views, &frame->scene, &size, blur_reach(blur) + middle);
        if (widest_search(settings->light_size, &views, &frame->scene.light) <=
            middle) {
            high = middle;
        } else {
            low = middle + 1;
        }
    }
    return blur_reach(blur) + high;
}

// How a view's distance d follows from t: d = (x + y t) / (z + w t).
static void set_distance(const Views *views, int layer, bool projected,
                         GLuint program)
{
    char name[48];
    snprintf(name, sizeof name, "distance_of_depth[%d]", layer);
    GLint place = glGetUniformLocation(program, name);
    float near = (float)views->light[layer].near;
    float far = (float)views->light[layer].far;
    if (views->light_position[3] == 0) {
        glUniform4f(place, 0, far - near, 1, 0);
    } else if (projected) {
        glUniform4f(place, near * far, 0, far, near - far);
    } else {
        glUniform4f(place, near, far - near, 1, 0);
    }
}

void soft_apply(const SoftSettings *settings, const Views *views,
                bool projected, GLuint program)
{
    glUniform1f(glGetUniformLocation(program, "light_size"),
                (float)settings->light_size);
    glUniform1f(glGetUniformLocation(program, "penumbra_scale"),
                (float)settings->penumbra_scale);
    for (int layer = 0; layer < views->layers; layer++) {
        set_distance(views, layer, projected, program);
    }
}
