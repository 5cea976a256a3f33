#include "step4_blur/blur.h"

#include <stdio.h> // snprintf

// Of the filtered map, texels.
typedef struct FilteredSize {
    int level[MIPS_MAX_LEVELS][2];
    int last; // level that is looked up
} FilteredSize;

static FilteredSize filtered_size(const BlurSettings *settings,
                                  const Facts *facts)
{
    FilteredSize size = {.last = 0};
    for (int axis = 0; axis < 2; axis++) {
        size.level[0][axis] = facts->size[axis] / settings->downsample;
    }
    if (settings->mips) {
        size.last = facts->whole ? mips_count(size.level[0]) - 1
                                 : blur_last_level(settings, facts->views,
                                                   size.level[0]);
    }
    for (int level = 1; level <= size.last; level++) {
        for (int axis = 0; axis < 2; axis++) {
            size.level[level][axis] = size.level[level - 1][axis] / 2;
        }
    }
    return size;
}

// What a lookup reads of one level: 2 x 2 texels around the receiver's place.
// Taps along the pixel's longer axis may be anywhere.
static Rect looked_up(const BlurSettings *settings, const Facts *facts,
                      const FilteredSize *size, int layer, int level)
{
    const Rect rect = facts_looked_up(facts, layer);
    const int *wide = size->level[level];
    if (settings->anisotropy > 1 && !rect_is_empty(&rect)) {
        return rect_whole(wide[0], wide[1]);
    }
    // A table is read just outside of the box too.
    int reach = settings->sat ? blur_used_radius(settings) + 2 : 1;
    Rect divided = rect_divide(&rect, settings->downsample << level);
    return rect_grow(&divided, reach, reach, wide);
}

// Level by level from the coarsest: texel i is made of 2 i - 1 to 2 i + 2.
static void decide_levels(BlurPlan *plan, const BlurSettings *settings,
                          const Facts *facts, const FilteredSize *size,
                          int layer)
{
    Rect finer = {{0, 0}, {0, 0}};
    for (int level = size->last; level >= 0; level--) {
        Rect rect = looked_up(settings, facts, size, layer, level);
        rect = rect_join(&rect, &finer);
        plan->levels[level][layer] = rect;
        if (level > 0) {
            finer = rect_multiply(&rect, 2);
            finer = rect_grow(&finer, 1, 1, size->level[level - 1]);
        }
    }
}

// From the result back to what is blurred: a pass reads as many texels around
// its own as its filter holds to the wider side.
static Rect decide_passes(BlurPlan *plan, const BlurSettings *settings,
                          const int size[2], int layer)
{
    BlurSides filters[BLUR_MAX_FILTERS];
    Rect rect = plan->levels[0][layer];
    int count = settings->sat ? 0 : blur_filters(settings, filters);
    for (int i = 2 * count - 1; i >= 0; i--) {
        const int *sides = filters[i % count].sides;
        int side = sides[0] > sides[1] ? sides[0] : sides[1];
        int axis = i / count;
        plan->passes[i][layer] = rect;
        rect =
            rect_grow(&rect, axis == 0 ? side : 0, axis == 1 ? side : 0, size);
    }
    return rect;
}

static void decide_layer(BlurPlan *plan, const BlurSettings *settings,
                         const Facts *facts, const FilteredSize *size,
                         int layer)
{
    decide_levels(plan, settings, facts, size, layer);
    plan->small[layer] = decide_passes(plan, settings, size->level[0], layer);
}

// How many texels of the layers are not in the rectangles.
static size_t saved(const Facts *facts, const int size[2], const Rect rects[])
{
    size_t texels = 0;
    for (int layer = 0; layer < facts->layer_count; layer++) {
        texels +=
            (size_t)size[0] * (size_t)size[1] - rect_texels(&rects[layer]);
    }
    return texels;
}

// A pass that was asked for is left out where no layer is filtered.
static void add_row(Facts *facts, const char *pass, size_t texels,
                    size_t texel_bytes, const char *why)
{
    plan_add(&facts->plan, pass, -1, facts->lookups, texels, texel_bytes, "%s",
             facts->lookups ? why : "no layer is looked up");
}

static void add_not_asked(Facts *facts, const char *pass, const char *why)
{
    plan_add(&facts->plan, pass, -1, false, 0, 0, "%s", why);
}

static void add_blur_rows(const BlurPlan *plan, const BlurSettings *settings,
                          const MomentsSettings *moments, Facts *facts,
                          const int size[2])
{
    BlurSides filters[BLUR_MAX_FILTERS];
    int count = blur_filters(settings, filters);
    char why[64];
    snprintf(why, sizeof why, "%s, by %s", settings->kernel,
             blur_runs(settings, moments) ? "running boxes in compute shaders"
                                          : "fragments");
    for (int i = 0; i < 2 * count; i++) {
        add_row(facts, i < count ? "blur along u" : "blur along v",
                saved(facts, size, plan->passes[i]),
                gl_texel_bytes(moments_format(moments)), why);
    }
}

static void add_filter_rows(const BlurPlan *plan, const BlurSettings *settings,
                            const MomentsSettings *moments, Facts *facts,
                            const int size[2])
{
    if (settings->downsample > 1) {
        add_row(facts, "downsampling", saved(facts, size, plan->small),
                gl_texel_bytes(moments_format(moments)), "--downsample");
    } else {
        add_not_asked(facts, "downsampling", "--downsample 1");
    }
    if (settings->sat) {
        add_not_asked(facts, "blur", "the table holds every box");
    } else if (blur_used_radius(settings) > 0) {
        add_blur_rows(plan, settings, moments, facts, size);
    } else {
        add_not_asked(facts, "blur", "radius 0: it would copy the map");
    }
}

static void add_lookup_rows(const BlurPlan *plan, const BlurSettings *settings,
                            Facts *facts, const FilteredSize *size,
                            size_t texel_bytes)
{
    size_t texels = 0;
    for (int level = 1; level <= size->last; level++) {
        texels += saved(facts, size->level[level], plan->levels[level]);
    }
    if (settings->mips) {
        add_row(facts, "mip-map levels", texels, texel_bytes, "--mips");
    } else {
        add_not_asked(facts, "mip-map levels", "no lookup reads any");
    }
    if (settings->sat) {
        add_row(facts, "summed-area table",
                saved(facts, size->level[0], plan->levels[0]),
                2 * sizeof(GLuint),
                sat_uses_compute(settings->sat_by) ? "by compute shaders"
                                                   : "by fragments");
    } else {
        add_not_asked(facts, "summed-area table", "no lookup reads it");
    }
}

void blur_plan_bias(const BiasSettings *bias, Facts *facts,
                    const BlurSettings *settings,
                    const MomentsSettings *moments)
{
    if (!settings->mips && !settings->sat) {
        bias_plan(bias, facts, 2 * blur_reach(settings) + 1,
                  moments_format(moments));
    }
}

void blur_plan_decide(BlurPlan *plan, Facts *facts,
                      const BlurSettings *settings,
                      const MomentsSettings *moments)
{
    FilteredSize size = filtered_size(settings, facts);
    GLenum format = moments_format(moments);
    Rect needed[VIEW_MAX_LAYERS];
    for (int layer = 0; layer < facts->layer_count; layer++) {
        decide_layer(plan, settings, facts, &size, layer);
        needed[layer] =
            rect_multiply(&plan->small[layer], settings->downsample);
    }
    map_plan_decide(&plan->map, facts, needed, "moments", format);
    add_filter_rows(plan, settings, moments, facts, size.level[0]);
    add_lookup_rows(plan, settings, facts, &size, gl_texel_bytes(format));
}

// Every texel that is written is made of as many: one, the downsampled group's,
// or the four of the level before.
Touched blur_plan_touched(const BlurPlan *plan, const Blur *blur, GLenum format)
{
    const MapPlan *map = &plan->map;
    size_t bytes = gl_texel_bytes(format);
    size_t group = (size_t)blur->factor * (size_t)blur->factor;
    Touched touched = {0, 0};
    if (blur->downsample_program.id != 0) {
        touch(&touched, map_plan_texels_of(map, plan->small),
              (1 + group) * bytes);
    }
    for (int i = 0; i < 2 * blur->filter_count; i++) {
        touch(&touched, map_plan_texels_of(map, plan->passes[i]), 2 * bytes);
    }
    for (int level = 1; level < blur->mips.levels; level++) {
        touch(&touched, map_plan_texels_of(map, plan->levels[level]),
              5 * bytes);
    }
    if (blur->sat.layers > 0) {
        sat_touch(&blur->sat, map_plan_texels_of(map, plan->levels[0]), bytes,
                  &touched);
    }
    return touched;
}

static double filter_variance(const BlurSettings *settings, const int sides[2])
{
    float weights[2 * 1024 + 1];
    double mean = 0, square = 0;
    blur_weights(settings->kernel, sides, weights);
    for (int i = -sides[0]; i <= sides[1]; i++) {
        mean += (double)weights[i + sides[0]] * i;
        square += (double)weights[i + sides[0]] * i * i;
    }
    return square - mean * mean;
}

double blur_spread(const BlurSettings *settings)
{
    BlurSides filters[BLUR_MAX_FILTERS];
    int count = blur_filters(settings, filters);
    double texel = settings->downsample, variance = 0;
    if (settings->mips || settings->sat) {
        return 0;
    }
    for (int i = 0; i < count; i++) {
        variance += filter_variance(settings, filters[i].sides);
    }
    return texel * texel * variance;
}

BlurPlan blur_plan_whole(const BlurPlan *plan, const Blur *blur)
{
    BlurPlan whole = {.map = map_plan_whole(&plan->map)};
    for (int layer = 0; layer < blur->layers; layer++) {
        Rect rect = rect_whole(blur->width, blur->height);
        whole.small[layer] = rect;
        for (int i = 0; i < 2 * blur->filter_count; i++) {
            whole.passes[i][layer] = rect;
        }
        whole.levels[0][layer] = rect;
        for (int level = 1; level < blur->mips.levels; level++) {
            whole.levels[level][layer] =
                rect_whole(blur->width >> level, blur->height >> level);
        }
    }
    return whole;
}
