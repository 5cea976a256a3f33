// --splits: parallel splits, a view of each part of what the camera sees.
#include <math.h>  // fmax, fmin, pow, round, sqrt, tan
#include <stdio.h> // snprintf

#include "step1_shadowmap/base/light/light_view.h" // bound_casters
#include "step1_shadowmap/base/picture/picture.h"  // PICTURE_HANDOVER
#include "step1_shadowmap/base/seams/technique.h"
#include "step1_shadowmap/base/scene/dvec.h" // dvec_dot, dvec_normalize
#include "step1_shadowmap/base/system/die.h" // die_usage

static struct {
    int count; // views of a parallel light
} settings = {1};

static const Option options[] = {
    {.name = "splits",
     .kind = OPTION_INTEGER,
     .minimum = 1,
     .maximum = VIEW_MAX_LAYERS,
     .argument = "N",
     .help = "parts of the view with a map each, of a parallel light; 1: one "
             "map, of everything that casts"},
    {0},
};

// The first split begins this part of the way to where shadows end: the
// logarithmic positions want a beginning that is not 0.
#define FIRST_BEGIN 0.01
// Part of each position that is logarithmic, which keeps the texels equal in
// the picture; the rest is uniform, which keeps the near splits from being
// wasted on what is right before the camera.
#define LOGARITHMIC 0.75
// Part of a split in which the next one takes over, or light does.
#define HANDOVER 0.1

// View depth where split i of `count` ends. Zhang, Sun, Xu, Lun,
// Parallel-split shadow maps for large-scale virtual environments, VRCIA 2006.
static double split_end(int i, int count, double far)
{
    double near = FIRST_BEGIN * far;
    double part = (i + 1.0) / count;
    double logarithmic = near * pow(far / near, part);
    double uniform = near + (far - near) * part;
    return LOGARITHMIC * logarithmic + (1 - LOGARITHMIC) * uniform;
}

typedef struct Ball {
    double centre[3]; // world space
    double radius;
} Ball;

// The ball around what the camera sees between two view depths: as large
// however the camera moves and turns, so that the texels keep their size.
// `spread` is the squared tangent from the view's axis to its corners.
static Ball slice_ball(const Camera *camera, double spread, double begin,
                       double end)
{
    // On the axis, as far from the far corners as from the near ones.
    double along = fmin(0.5 * (begin + end) * (1 + spread), end);
    Ball ball = {.radius =
                     sqrt((end - along) * (end - along) + end * end * spread)};
    double forward[3];
    dvec_subtract(camera->target, camera->position, forward);
    dvec_normalize(forward);
    for (int k = 0; k < 3; k++) {
        ball.centre[k] = camera->position[k] + along * forward[k];
    }
    return ball;
}

// Where the view's middle is along an axis of the light, and how much of it has
// to be held: the ball, or all that casts if that is less, since around it
// everything is lit. Neither changes when the camera moves or turns.
typedef struct Span {
    double middle; // from the world's origin
    double extent;
} Span;

static Span held_span(const Views *views, const LightFrame *casters,
                      const Ball *ball, int row)
{
    const double *axis = casters->axes[row];
    Span all = {dvec_dot(axis, views->origin) +
                    0.5 * (casters->low[row] + casters->high[row]),
                casters->high[row] - casters->low[row]};
    Span seen = {dvec_dot(axis, ball->centre), 2 * ball->radius};
    return row < 2 && all.extent < seen.extent ? all : seen;
}

// A view that holds the ball, and no more depth than that: what casts into it
// from before its near plane is drawn at depth 0 (see shadow_map_draw), and the
// margins keep receivers, and what a filter reads around them, off both ends.
// Its middle is a whole number of texels from the world's origin, along all
// three axes: when the camera moves, the texels stay where they are in the
// world, and shadows do not crawl.
static void fit_ball(Views *views, const Light *light,
                     const LightFrame *casters, const Ball *ball,
                     LightView *view)
{
    const double(*axes)[3] = casters->axes;
    const int size[2] = {views->width, views->height};
    double texel = 0;
    for (int row = 0; row < 2; row++) {
        // Two texels less than fit: snapping moves the view by half a one.
        double inner = fmax(size[row] - 2 * views->border - 2, 0.5);
        double extent = held_span(views, casters, ball, row).extent;
        texel = fmax(texel, extent / inner);
    }
    double extent[3] = {size[0] * texel, size[1] * texel,
                        2 * ball->radius + 2 * texel};
    const double margin[3] = {0, 0, ball->radius / 8};
    double low[3];
    for (int row = 0; row < 3; row++) {
        double middle = held_span(views, casters, ball, row).middle;
        middle = texel * round(middle / texel);
        low[row] = middle - 0.5 * extent[row] - margin[row];
        extent[row] += 2 * margin[row];
        for (int k = 0; k < 3; k++) {
            view->map_from_relative[row][k] = axes[row][k] / extent[row];
        }
    }
    for (int row = 0; row < 3; row++) {
        double origin = dvec_dot(axes[row], views->origin);
        view->map_from_relative[row][3] = (origin - low[row]) / extent[row];
    }
    view->map_from_relative[3][3] = 1;
    dvec_copy(view->map_from_relative[2], view->depth_from_relative);
    view->depth_from_relative[3] = view->map_from_relative[2][3];
    view->near = low[2] - dvec_dot(axes[2], light->anchor);
    view->far = view->near + extent[2];
}

static void fit(Views *views, const Scene *scene, const ViewsSize *size)
{
    double aspect = (double)size->picture[0] / size->picture[1];
    int count = settings.count;
    const Camera *camera = &scene->camera;
    const Light *light = &scene->light;
    double tall = tan(0.5 * camera->fov_y);
    double spread = tall * tall * (1 + aspect * aspect);
    double begin = 0;
    LightFrame casters;
    bound_casters(&casters, scene, views->origin);
    views->layers = count;
    for (int i = 0; i < count; i++) {
        LightView *view = &views->light[i];
        double end = split_end(i, count, camera->reach);
        Ball ball = slice_ball(camera, spread, begin, end);
        fit_ball(views, light, &casters, &ball, view);
        view->end = end;
        begin = end - HANDOVER * (end - begin); // of the next one
        view->handover = begin;
    }
    for (int k = 0; k < 3; k++) {
        views->light_position[k] = -light->direction[k];
    }
}

static void check(Frame *frame)
{
    if (settings.count > 1) {
        frame->settings.fit = fit;
    }
}

static bool prepare(Frame *frame)
{
    static const char *const plain[] = {
        "step1_shadowmap/techniques/splits/layer_split.glsl",
        "step1_shadowmap/techniques/splits/handover_nothing.glsl",
        "step1_shadowmap/techniques/splits/scene_splits.frag", NULL};
    static const char *const dumped[] = {
        "step1_shadowmap/techniques/splits/layer_split.glsl",
        "step1_shadowmap/techniques/splits/handover.glsl",
        "step1_shadowmap/techniques/splits/scene_splits.frag", NULL};
    LightKind kind = frame->scene.light.kind;
    if (settings.count == 1) {
        return false;
    }
    if (kind != LIGHT_DIRECTIONAL) {
        die_usage("--splits %d are of a parallel light, and this one is a "
                  "%s light: drop --splits, or say --light directional",
                  settings.count, light_kind_name(kind));
    }
    gl_put_instead(&frame->shaders, "step1_shadowmap/shaders/scene.frag",
                   frame->settings.dump == NULL ? plain : dumped);
    return true;
}

static void create(Frame *frame, Picture *picture)
{
    if (frame->settings.dump != NULL) {
        picture->target.formats[PICTURE_HANDOVER] = GL_RGBA32F;
    }
}

static void look(const Frame *frame, GLuint program)
{
    const Views *views = &frame->views;
    glUniform1i(glGetUniformLocation(program, "layers"), views->layers);
    for (int layer = 0; layer < views->layers; layer++) {
        const LightView *view = &views->light[layer];
        char name[48];
        snprintf(name, sizeof name, "split_range[%d]", layer);
        glUniform2f(glGetUniformLocation(program, name), (float)view->handover,
                    (float)view->end);
    }
}

const Technique map_splits = {.options = options,
                              .settings = &settings,
                              .check = check,
                              .prepare = prepare,
                              .create = create,
                              .look = look};
