// What can be asked of leaving out, and what --plan prints.
#include <stdio.h>  // printf
#include <string.h> // strcmp

#include "step1_shadowmap/base/system/die.h"        // printed_check
#include "step1_shadowmap/base/leave_out/casters.h" // rect_is_empty
#include "step1_shadowmap/base/leave_out/leave_out.h"
#include "step1_shadowmap/base/seams/technique.h" // target_texel_bytes

const Option leave_out_list[] = {
    {.name = "plan",
     .kind = OPTION_FLAG,
     .offset = offsetof(LeaveOut, plan),
     .help = "print each pass, whether it is kept or left out, and why"},
    {.name = "keep-all",
     .kind = OPTION_FLAG,
     .offset = offsetof(LeaveOut, keep_all),
     .help = "leave nothing out: draw every map, all of it, in every frame"},
    {.name = "redraw",
     .kind = OPTION_FLAG,
     .offset = offsetof(LeaveOut, redraw),
     .help = "draw what is kept of the maps in every frame, not only when "
             "something has changed"},
    {.name = "shadows",
     .kind = OPTION_CHOICE,
     .offset = offsetof(LeaveOut, shadows),
     .choices = "on,off",
     .help = "off: the same frame without any map or lookup, to compare times"},
    {0},
};

const ShowMode leave_out_shows[] = {
    {"plan", "step1_shadowmap/base/leave_out/shaders/show_plan.glsl",
     "step1_shadowmap/base/leave_out/shaders/scale_lookups.glsl",
     "0          lookups in the map          2", false},
    {NULL, NULL, NULL, NULL, false},
};

typedef struct Saved {
    size_t texels; // that are not drawn
    size_t bytes;  // of these
} Saved;

static void print_row(const char *pass, bool kept, Saved saved, const char *why)
{
    printf("%-22s %-9s %13zu %13zu  %s\n", pass, kept ? "kept" : "left out",
           saved.texels, saved.bytes, why);
}

static size_t rect_texels(const Rect *rect)
{
    return rect_is_empty(rect) ? 0
                               : (size_t)(rect->high[0] - rect->low[0]) *
                                     (size_t)(rect->high[1] - rect->low[1]);
}

static void add(Saved *saved, const Target *target, int layer)
{
    size_t all = (size_t)target->width * (size_t)target->height;
    size_t texels = all - rect_texels(&target->layer[layer].wanted);
    saved->texels += texels;
    saved->bytes += texels * target_texel_bytes(target);
}

// A target that shows the scene: a row for each layer.
static Saved print_layers(const LeaveOut *left, const Frame *frame,
                          const Target *target)
{
    Saved sum = {0, 0};
    for (int layer = 0; layer < target->layers; layer++) {
        const Rect *wanted = &target->layer[layer].wanted;
        Saved saved = {0, 0};
        char pass[48], why[112], behind[48] = "";
        add(&saved, target, layer);
        add(&sum, target, layer);
        snprintf(pass, sizeof pass, "%s, layer %d", target->pass, layer);
        if (left->layer[layer].behind > 0) {
            snprintf(behind, sizeof behind, "; %d behind all receivers",
                     left->layer[layer].behind);
        }
        snprintf(why, sizeof why,
                 "%dx%d of %dx%d texels are read; %d of %d objects%s",
                 wanted->high[0] - wanted->low[0],
                 wanted->high[1] - wanted->low[1], target->width,
                 target->height, left->layer[layer].objects,
                 frame->scene.object_count, behind);
        print_row(pass, !rect_is_empty(wanted), saved,
                  rect_is_empty(wanted) ? "nothing looks it up" : why);
    }
    return sum;
}

// Targets of one pass's name, which follow each other: one row.
static Saved print_passes(const LeaveOut *left, const Targets *targets,
                          int first, int end)
{
    Saved saved = {0, 0};
    const Target *target = targets->list[first];
    for (int i = first; i < end; i++) {
        for (int layer = 0; layer < targets->list[i]->layers; layer++) {
            add(&saved, targets->list[i], layer);
        }
    }
    print_row(target->pass, left->lookups, saved,
              left->lookups ? target->why : "no layer is looked up");
    return saved;
}

static Saved print_target(const LeaveOut *left, const Frame *frame, int first,
                          int end)
{
    const Target *target = frame->targets.list[first];
    if (target->kind == TARGET_NOTHING || target->kind == TARGET_PICTURE) {
        print_row(target->pass, !target->idle, (Saved){0, 0}, target->why);
    } else if (target->reads == NULL) {
        return print_layers(left, frame, target);
    } else {
        return print_passes(left, &frame->targets, first, end);
    }
    return (Saved){0, 0};
}

static void print_picture(const LeaveOut *left, const Frame *frame)
{
    char why[64];
    snprintf(why, sizeof why, "%d of %d objects may be in it", left->in_picture,
             frame->scene.object_count);
    print_row("picture", true, (Saved){0, 0}, why);
    print_row("lookup", left->lookups, (Saved){0, 0}, left->why);
}

static void print_later(const LeaveOut *left)
{
    bool again = left->lookups && (left->keep_all || left->redraw);
    print_row("maps in later frames", again, (Saved){0, 0},
              !left->lookups ? "there are none"
              : again        ? "--redraw or --keep-all"
                      : "only where light, casters or views have changed");
}

void leave_out_print(const LeaveOut *left, const Frame *frame)
{
    const Targets *targets = &frame->targets;
    Saved sum = {0, 0};
    printf("%-22s %-9s %13s %13s  %s\n", "pass", "decision", "saved texels",
           "saved bytes", "why");
    print_picture(left, frame);
    for (int first = 0, end; first < targets->count; first = end) {
        const Target *target = targets->list[first];
        const char *pass = target->pass;
        bool told = target->kind == TARGET_PICTURE && target->why == NULL;
        for (end = first + 1;
             end < targets->count && targets->list[end]->pass == pass; end++) {
        }
        if (pass != NULL && !told) {
            Saved saved = print_target(left, frame, first, end);
            sum.texels += saved.texels;
            sum.bytes += saved.bytes;
        }
    }
    print_later(left);
    printf("%-22s %-9s %13zu %13zu\n", "all", "", sum.texels, sum.bytes);
    printed_check();
}
