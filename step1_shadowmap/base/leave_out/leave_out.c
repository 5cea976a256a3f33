#include "step1_shadowmap/base/leave_out/leave_out.h"

#include <math.h>   // INFINITY
#include <string.h> // strcmp

#include "step1_shadowmap/base/leave_out/casters.h"    // casters_list
#include "step1_shadowmap/base/leave_out/lone_plane.h" // lone_plane_is_lit
#include "step1_shadowmap/base/leave_out/receivers.h"  // receivers_find
#include "step1_shadowmap/base/seams/technique.h"      // gl_put_instead
#include "step1_shadowmap/base/system/die.h"           // die_usage

static LeaveOut state = {.shadows = "on"};

OptionTable leave_out_options(BaseSettings *settings)
{
    base_add_shows(settings, leave_out_shows);
    return options_table(leave_out_list, &state);
}

static bool has_shadows(const LeaveOut *left)
{
    return strcmp(left->shadows, "on") == 0;
}

static void check(const LeaveOut *left, Frame *frame)
{
    const BaseSettings *settings = &frame->settings;
    if (!has_shadows(left) && base_show_mode(settings)->reads_map) {
        die_usage("--show %s needs the map that --shadows off leaves out: drop "
                  "one of them",
                  settings->show);
    }
    frame->settings.prints = settings->prints || left->plan;
}

// A number for all that something is made from, to see whether it has changed.
// Fowler, Noll and Vo's hash, 64 bits: a change that it misses is once in 2^64.
#define STAMP_START 0xcbf29ce484222325

static void stamp_add(uint64_t *stamp, const void *data, size_t bytes)
{
    const unsigned char *byte = data;
    for (size_t i = 0; i < bytes; i++) {
        *stamp = (*stamp ^ byte[i]) * 0x100000001b3;
    }
}

// Of a scene, what may change from frame to frame.
static uint64_t stamp_scene(const Scene *scene)
{
    uint64_t stamp = STAMP_START;
    stamp_add(&stamp, &scene->camera, sizeof scene->camera);
    for (int i = 0; i < scene->object_count; i++) {
        stamp_add(&stamp, scene->objects[i].transform,
                  sizeof scene->objects[i].transform);
    }
    return stamp;
}

// What a layer's texels are made from: the view, to the last bit, and the
// objects. The origin is the camera, so a camera that moves changes every map
// in its last bits: such a map is another one.
static uint64_t stamp_layer(const Frame *frame, int layer)
{
    const Views *views = &frame->views;
    const LightView *view = &views->light[layer];
    uint64_t stamp = STAMP_START;
    stamp_add(&stamp, views->origin, sizeof views->origin);
    stamp_add(&stamp, views->light_position, sizeof views->light_position);
    stamp_add(&stamp, &views->depth_per_distance,
              sizeof views->depth_per_distance);
    stamp_add(&stamp, view->map_from_relative, sizeof view->map_from_relative);
    stamp_add(&stamp, view->depth_from_relative,
              sizeof view->depth_from_relative);
    for (int i = 0; i < view->seen.count; i++) {
        const Object *object = &frame->scene.objects[view->seen.objects[i]];
        stamp_add(&stamp, &object->mesh, sizeof object->mesh);
        stamp_add(&stamp, object->transform, sizeof object->transform);
    }
    return stamp;
}

static void look_nowhere(LeaveOut *left, Frame *frame, const char *why)
{
    for (int layer = 0; layer < frame->views.layers; layer++) {
        frame->views.light[layer].looked_up = (Rect){{0, 0}, {0, 0}};
    }
    left->lookups = false;
    left->why = why;
}

static void look_everywhere(LeaveOut *left, const char *why)
{
    left->whole = true;
    left->lookups = true;
    left->why = why;
}

// The texels of receivers; all of the layers that have some, if a lookup may be
// anywhere there.
static void look_at_receivers(LeaveOut *left, Frame *frame)
{
    double deepest[VIEW_MAX_LAYERS];
    Views *views = &frame->views;
    receivers_find(views, &frame->scene, frame->settings.size, deepest);
    left->lookups = false;
    for (int layer = 0; layer < views->layers; layer++) {
        Rect *looked_up = &views->light[layer].looked_up;
        left->layer[layer].deepest = deepest[layer];
        if (!rect_is_empty(looked_up)) {
            left->lookups = true;
            if (frame->lookups.anywhere) {
                *looked_up = (Rect){{0, 0}, {views->width, views->height}};
            }
        }
    }
    left->why = left->lookups
                    ? "visible surfaces that may face the light are in the map"
                    : "no visible surface that may face the light is in the "
                      "map";
}

// What of the views is looked up.
static void look(LeaveOut *left, Frame *frame)
{
    const char *why;
    if (!has_shadows(left)) {
        look_nowhere(left, frame, "--shadows off");
    } else if (left->keep_all) {
        look_everywhere(left, "--keep-all");
    } else if (base_show_mode(&frame->settings)->reads_map) {
        look_everywhere(left, "--show looks up every pixel");
    } else {
        look_at_receivers(left, frame);
        if (left->lookups && !frame->changes &&
            lone_plane_is_lit(frame, &why)) {
            left->lookups = false;
            left->why = why;
        }
    }
}

void leave_out_look(Frame *frame)
{
    static const char *const unshadowed[] = {
        "step1_shadowmap/base/leave_out/shaders/unshadowed.glsl", NULL};
    static const char *const plan[] = {
        "step1_shadowmap/base/leave_out/shaders/show_plan_nothing.glsl", NULL};
    LeaveOut *left = &state;
    const ViewsSize size = base_views_size(&frame->settings);
    uint64_t scene = stamp_scene(&frame->scene);
    if (left->fitted && left->scene == scene) {
        return;
    }
    check(left, frame);
    left->fitted = true;
    left->scene = scene;
    left->decided = left->whole = false;
    views_fit(&frame->views, &frame->scene, &size, frame->lookups.reach);
    casters_in_picture(&frame->views.seen, &frame->views, &frame->scene,
                       left->keep_all);
    left->in_picture = frame->views.seen.count;
    look(left, frame);
    frame->looks_up = left->lookups || (has_shadows(left) && frame->changes);
    frame->visibility = frame->looks_up ? NULL : unshadowed;
    if (!frame->looks_up) {
        gl_put_instead(&frame->shaders, leave_out_shows[0].shader, plan);
    }
}

static int least(int a, int b)
{
    return a < b ? a : b;
}

static int greatest(int a, int b)
{
    return a > b ? a : b;
}

// Wider by so many texels to each side along u and v, but no wider than a map
// of this size. What is empty stays empty.
static Rect rect_grow(const Rect *rect, int along_u, int along_v,
                      const int size[2])
{
    const int by[2] = {along_u, along_v};
    Rect result = {{0, 0}, {0, 0}};
    for (int axis = 0; axis < 2 && !rect_is_empty(rect); axis++) {
        result.low[axis] = greatest(rect->low[axis] - by[axis], 0);
        result.high[axis] = least(rect->high[axis] + by[axis], size[axis]);
    }
    return result;
}

// The texels of a map that is smaller by a factor which hold these.
static Rect rect_divide(const Rect *rect, int factor)
{
    Rect result = {{0, 0}, {0, 0}};
    for (int axis = 0; axis < 2 && !rect_is_empty(rect); axis++) {
        result.low[axis] = rect->low[axis] / factor;
        result.high[axis] = (rect->high[axis] + factor - 1) / factor;
    }
    return result;
}

// The texels of a map that is larger by a factor which these hold.
static Rect rect_multiply(const Rect *rect, int factor)
{
    Rect result = *rect;
    for (int axis = 0; axis < 2; axis++) {
        result.low[axis] *= factor;
        result.high[axis] *= factor;
    }
    return result;
}

// The smallest rectangle around both.
static Rect rect_join(const Rect *a, const Rect *b)
{
    if (rect_is_empty(a) || rect_is_empty(b)) {
        return rect_is_empty(a) ? *b : *a;
    }
    Rect result;
    for (int axis = 0; axis < 2; axis++) {
        result.low[axis] = least(a->low[axis], b->low[axis]);
        result.high[axis] = greatest(a->high[axis], b->high[axis]);
    }
    return result;
}

// Whether all texels of the inner one are in the outer one.
static bool rect_holds(const Rect *outer, const Rect *inner)
{
    bool holds = true;
    for (int axis = 0; axis < 2; axis++) {
        holds = holds && outer->low[axis] <= inner->low[axis] &&
                outer->high[axis] >= inner->high[axis];
    }
    return holds || rect_is_empty(inner);
}

// What the picture reads of a target's layer itself.
static Rect looked_up(const LeaveOut *left, const Frame *frame,
                      const Target *target, int layer)
{
    const Rect *receivers = &frame->views.light[layer].looked_up;
    const int size[2] = {target->width, target->height};
    if (!left->lookups || target->looked_up == 0 || rect_is_empty(receivers)) {
        return (Rect){{0, 0}, {0, 0}};
    }
    if (target->looked_up == TARGET_EVERYWHERE) {
        return (Rect){{0, 0}, {size[0], size[1]}};
    }
    Rect divided = rect_divide(receivers, frame->views.width / target->width);
    return rect_grow(&divided, target->looked_up, target->looked_up, size);
}

// What a pass that draws these texels reads of the target before it.
static Rect read_by(const Target *target, const Rect *texels)
{
    const int size[2] = {target->reads->width, target->reads->height};
    Rect rect = rect_multiply(texels, target->scale);
    return rect_grow(&rect, target->reach[0], target->reach[1], size);
}

// From the last target back to the first.
static void want_layer(const LeaveOut *left, Frame *frame, int layer)
{
    Targets *targets = &frame->targets;
    for (int i = targets->count - 1; i >= 0; i--) {
        Target *target = targets->list[i];
        if (target->kind == TARGET_LAYERS || target->kind == TARGET_SAMPLES) {
            target->layer[layer].wanted = looked_up(left, frame, target, layer);
        }
    }
    for (int i = targets->count - 1; i >= 0; i--) {
        Target *target = targets->list[i];
        if (target->reads != NULL && target->kind != TARGET_PICTURE) {
            Rect read = read_by(target, &target->layer[layer].wanted);
            Rect *wanted = &target->reads->layer[layer].wanted;
            *wanted = rect_join(wanted, &read);
        }
    }
}

// What is behind all receivers is as good as nothing, where each depth is
// compared by itself and no bias pushes receivers behind it.
static bool is_behind_lit(const Lookups *lookups)
{
    return lookups->compares && lookups->bias >= 0 && lookups->slope_bias >= 0;
}

// The objects that are drawn into the texels which are wanted of the targets
// that show the scene.
static void list_casters(LeaveOut *left, Frame *frame, int layer)
{
    const Targets *targets = &frame->targets;
    DrawList *seen = &frame->views.light[layer].seen;
    double deepest =
        is_behind_lit(&frame->lookups) ? left->layer[layer].deepest : INFINITY;
    Rect texels = {{0, 0}, {0, 0}};
    for (int i = 0; i < targets->count; i++) {
        const Target *target = targets->list[i];
        if (target->reads == NULL &&
            (target->kind == TARGET_LAYERS || target->kind == TARGET_SAMPLES)) {
            texels = rect_join(&texels, &target->layer[layer].wanted);
        }
    }
    left->layer[layer].behind = casters_list(seen, &frame->views, &frame->scene,
                                             layer, &texels, deepest);
    left->layer[layer].objects = seen->count;
}

static bool has_changed(LeaveOut *left, const Frame *frame, int layer)
{
    const Rect *receivers = &frame->views.light[layer].looked_up;
    uint64_t made_from = stamp_layer(frame, layer);
    bool changed = made_from != left->layer[layer].drawn_from ||
                   !rect_holds(&left->layer[layer].drawn_for, receivers);
    left->layer[layer].drawn_from = made_from;
    left->layer[layer].drawn_for = *receivers;
    return changed;
}

void target_limit(const Rect *wanted)
{
    if (wanted == NULL) {
        glDisable(GL_SCISSOR_TEST);
    } else {
        glEnable(GL_SCISSOR_TEST);
        glScissor(wanted->low[0], wanted->low[1],
                  wanted->high[0] - wanted->low[0],
                  wanted->high[1] - wanted->low[1]);
    }
}

static void draw_layer(Frame *frame, int layer, bool draw)
{
    for (int i = 0; i < frame->targets.count; i++) {
        Target *target = frame->targets.list[i];
        bool wanted = draw && !rect_is_empty(&target->layer[layer].wanted);
        target->layer[layer].draw = wanted || target->kind == TARGET_PICTURE;
    }
}

static void decide_layer(LeaveOut *left, Frame *frame, int layer)
{
    if (left->whole) {
        left->layer[layer].objects = frame->scene.object_count;
    } else {
        want_layer(left, frame, layer);
        list_casters(left, frame, layer);
    }
}

static void decide(LeaveOut *left, Frame *frame)
{
    for (int layer = 0; layer < frame->views.layers && !left->decided;
         layer++) {
        decide_layer(left, frame, layer);
    }
    left->decided = true;
    if (left->plan && !left->printed) {
        leave_out_print(left, frame);
    }
    left->printed = true;
}

void leave_out_begin(Frame *frame, bool anew)
{
    LeaveOut *left = &state;
    bool always = anew || left->keep_all || left->redraw;
    decide(left, frame);
    for (int layer = 0; layer < frame->views.layers; layer++) {
        bool changed = left->lookups && has_changed(left, frame, layer);
        draw_layer(frame, layer, left->lookups && (changed || always));
    }
}

bool leave_out_nothing(Frame *frame)
{
    for (int layer = 0; layer < frame->views.layers; layer++) {
        draw_list_all(&frame->views.light[layer].seen, &frame->scene);
        for (int i = 0; i < frame->targets.count; i++) {
            Target *target = frame->targets.list[i];
            target->layer[layer].wanted =
                (Rect){{0, 0}, {target->width, target->height}};
            target->layer[layer].draw = target->kind != TARGET_PICTURE;
        }
    }
    return has_shadows(&state);
}
