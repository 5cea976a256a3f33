// --light: spot and point lights, each with its views.
#include <math.h> // fmax, fmin, sin, tan, INFINITY

#include "step1_shadowmap/base/light/light_view.h" // fit_directional
#include "step1_shadowmap/base/light/region.h"     // region_include_scene
#include "step1_shadowmap/base/seams/technique.h"
#include "step1_shadowmap/base/scene/dvec.h" // dvec_copy, dvec_dot, dvec_frame

static struct {
    const char *kind;   // or NULL: the scene's own
    ViewsFit *parallel; // of another technique, for a parallel light
} settings;

static const Option options[] = {
    {.name = "light",
     .kind = OPTION_CHOICE,
     .choices = "directional,spot,point",
     .help = "the kind of light, in place of the scene's own"},
    {0},
};

// A spot loses its brightness between this part of its cone and the edge.
#define BRIGHT_PART 0.8

// Distances from the light between which everything is that it can see.
typedef struct DepthRange {
    double near, far;
} DepthRange;

// Half the extent of a view at distance 1 along u and v, so that what must not
// come nearer to the map's edge than the border (`inner`, at the same distance)
// leaves it free. One texel less than fits: nothing touches the border's edge.
static void widen_by_border(const Views *views, double inner, double half[2])
{
    const int size[2] = {views->width, views->height};
    for (int axis = 0; axis < 2; axis++) {
        double free = fmax(size[axis] - 2 * views->border - 1, 0.5);
        half[axis] = inner * size[axis] / free;
    }
}

// Widens the range to what one view sees. No point is nearer than the depth
// along the axis, and of a triangle a corner is the farthest.
static void include_view(DepthRange *range, const Scene *scene,
                         double axes[3][3], const double half[2])
{
    Region region = {.normals = {{1, 0, -half[0]},
                                 {-1, 0, -half[0]},
                                 {0, 1, -half[1]},
                                 {0, -1, -half[1]}}};
    region_include_scene(&region, axes, scene, scene->light.position);
    range->near = fmin(range->near, region.low);
    range->far = fmax(range->far, region.farthest);
}

// Nothing is at depth 0 or 1 but what the light's own range cuts off there.
static void finish_range(DepthRange *range, const Light *light)
{
    if (light->near != 0 || light->far != 0) {
        range->near = light->near;
        range->far = light->far;
        return;
    }
    range->far = range->far > 0 ? range->far * (1 + 1.0 / 256) : 1;
    range->near = fmin(fmax(range->near * (1 - 1.0 / 64), 1e-3 * range->far),
                       0.5 * range->far);
}

// The view along axes[2]. With d = dot(axes[2], p - light) rows give (u d, v d,
// z d, d) of a relative position p; z is a depth for the depth test alone, of
// the projective kind, since only that is linear across a triangle in the map.
static void set_view(LightView *view, double axes[3][3], const double half[2],
                     const double position[3], const DepthRange *range)
{
    double scale = range->far / (range->far - range->near);
    for (int k = 0; k < 3; k++) {
        double along = axes[2][k];
        view->map_from_relative[0][k] = 0.5 * (axes[0][k] / half[0] + along);
        view->map_from_relative[1][k] = 0.5 * (axes[1][k] / half[1] + along);
        view->map_from_relative[2][k] = scale * along;
        view->map_from_relative[3][k] = along;
    }
    for (int row = 0; row < 4; row++) {
        double *m = view->map_from_relative[row];
        m[3] = -dvec_dot(m, position);
    }
    view->map_from_relative[2][3] -= scale * range->near;
    view->near = range->near;
    view->far = range->far;
    view->depth_from_relative[3] = -range->near / (range->far - range->near);
}

static void set_light(Views *views, const Light *light, const DepthRange *range)
{
    dvec_subtract(light->position, views->origin, views->light_position);
    views->light_position[3] = 1;
    views->depth_per_distance = 1 / (range->far - range->near);
}

// One view that holds the cone.
static void fit_spot(Views *views, const Scene *scene)
{
    const Light *light = &scene->light;
    const double up[3] = {0, 1, 0};
    double axes[3][3];
    double half[2];
    DepthRange range = {INFINITY, 0};
    dvec_copy(light->direction, axes[2]);
    dvec_frame(axes[2], up, axes[0], axes[1]);
    widen_by_border(views, tan(light->cone), half);
    include_view(&range, scene, axes, half);
    finish_range(&range, light);
    set_light(views, light, &range);
    views->layers = 1;
    set_view(&views->light[0], axes, half, views->light_position, &range);
}

// Six views, each a little wider than the 90 degrees that it answers for, so
// that a filter at its rim reads what lies behind the seam from its own layer.
// They share near and far: a depth means the same in each.
static void fit_point(Views *views, const Scene *scene)
{
    double axes[6][3][3] = {0};
    double half[2];
    DepthRange range = {INFINITY, 0};
    widen_by_border(views, 1, half);
    views->layers = 6;
    for (int face = 0; face < 6; face++) {
        const double up[3] = {0, 1, 0};
        axes[face][2][face / 2] = face % 2 ? -1 : 1;
        dvec_frame(axes[face][2], up, axes[face][0], axes[face][1]);
        include_view(&range, scene, axes[face], half);
    }
    finish_range(&range, &scene->light);
    set_light(views, &scene->light, &range);
    for (int face = 0; face < 6; face++) {
        set_view(&views->light[face], axes[face], half, views->light_position,
                 &range);
    }
}

static void fit(Views *views, const Scene *scene, const ViewsSize *size)
{
    if (scene->light.kind == LIGHT_SPOT) {
        fit_spot(views, scene);
    } else if (scene->light.kind == LIGHT_POINT) {
        fit_point(views, scene);
    } else {
        (settings.parallel != NULL ? settings.parallel
                                   : fit_directional)(views, scene, size);
    }
}

static const ShowMode shows[] = {
    {"layer", "step1_shadowmap/techniques/lights/show_layer.glsl",
     "step1_shadowmap/techniques/lights/scale_hue.glsl",
     "0          layer of the map            7", false},
    {NULL, NULL, NULL, NULL, false},
};

static void check(Frame *frame)
{
    base_add_shows(&frame->settings, shows);
    frame->settings.light = settings.kind;
    settings.parallel = frame->settings.fit;
    frame->settings.fit = fit;
}

static bool prepare(Frame *frame)
{
    static const char *const spot[] = {
        "step1_shadowmap/techniques/lights/layer_only.glsl",
        "step1_shadowmap/techniques/lights/scene_lights.frag", NULL};
    static const char *const point[] = {
        "step1_shadowmap/techniques/lights/layer_face.glsl",
        "step1_shadowmap/techniques/lights/scene_lights.frag", NULL};
    static const char *const distance[] = {
        "step1_shadowmap/techniques/lights/distance_depth.glsl", NULL};
    LightKind kind = frame->scene.light.kind;
    if (kind == LIGHT_DIRECTIONAL) {
        return false;
    }
    gl_put_instead(&frame->shaders, "step1_shadowmap/shaders/linear_depth.glsl",
                   distance);
    gl_put_instead(&frame->shaders, "step1_shadowmap/shaders/scene.frag",
                   kind == LIGHT_SPOT ? spot : point);
    return true;
}

// 1 - cos(angle), without taking two numbers near 1 from each other.
static float spread_of(double angle)
{
    double half = sin(0.5 * angle);
    return (float)(2 * half * half);
}

// A light that is not a spot has a cone that holds every direction.
static void look(const Frame *frame, GLuint program)
{
    const Light *light = &frame->scene.light;
    bool spot = light->kind == LIGHT_SPOT;
    glUniform1f(glGetUniformLocation(program, "reference_distance"),
                (float)light->reference);
    glUniform3f(glGetUniformLocation(program, "cone_axis"),
                (float)light->direction[0], (float)light->direction[1],
                (float)light->direction[2]);
    glUniform2f(glGetUniformLocation(program, "cone_spreads"),
                spot ? spread_of(light->cone) : 4,
                spot ? spread_of(BRIGHT_PART * light->cone) : 3);
}

const Technique map_lights = {.options = options,
                              .settings = &settings,
                              .check = check,
                              .prepare = prepare,
                              .look = look};
