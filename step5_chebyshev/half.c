// How far 16-bit floats can move the visibility p from that of 32 bits, known
// before anything is drawn. That needs depths which do not come near each other
// unless they are the same: all surfaces are perpendicular to a parallel light,
// and of any two that are not in one plane one is at least g behind the other.
//
// Let t be a receiver's depth, b = t - M > 0 its distance from the mean of the
// filter's depths m, V their variance, r^2 = V + b^2 the mean of (t - m)^2. As
// an m before t is at least g before it, b <= mean of (t - m)^2 / g: b <= r^2 /
// g, and b <= r. Of p = V / r^2, with the deviation d = sqrt(V),
//     |dp/db| = 2 V b / r^4 <= 2 b / r^2 <= 2 / g,
//     |dp/dd| = 2 d b^2 / r^4 <= 2 b^2 / r^3 <= 2 / g.
// So p moves by at most 2 / g of what b and d move by:
// * A stored depth is off by e, half a step of 16 bits below 1. That moves t -
//   m by 2 e and d by e, and the planes stay g - 2 e apart.
// * What the guard adds (guard.h) and what it adds that for: twice its number
//   for the mean, and for d, which is at most 1/2. So d grows and b shrinks, at
//   most to 0. Then r^2 >= g b holds on the way: V >= b (g - b) does while b is
//   below g / 2; and from 0.4 g on the bounds hold of themselves, both being
//   below 0.8 / b. (Moves of more than g / 10 are too large in any case.)
// The same of 32 bits is 2^-13 of it. Reduction stretches p.
#include "step5_chebyshev/half.h"

#include <math.h>   // fmax, fmin, sqrt
#include <stdio.h>  // snprintf
#include <stdlib.h> // qsort
#include <string.h> // strcmp

#include "step1_shadowmap/base/scene/dvec.h"   // dvec_dot
#include "step1_shadowmap/base/light/volume.h" // volume_object_box
#include "step5_chebyshev/guard_settings.h"    // guard_of_settings

// A depth between 1/2 and 1, stored; and how far those of one plane are from
// each other: single precision.
#define STORED 0x1p-12
#define SAME 1e-6

static int compare_depths(const void *a, const void *b)
{
    double first = *(const double *)a, second = *(const double *)b;
    return (first > second) - (first < second);
}

// Where an object is in a parallel light's layer. False: not at one depth.
static bool one_depth(const Views *views, int layer, const Object *object,
                      double *depth)
{
    const double *row = views->light[layer].depth_from_relative;
    double corners[8][3], low = 1, high = 0;
    volume_object_box(object, views->origin, corners);
    for (int i = 0; i < 8; i++) {
        double t = fmin(fmax(dvec_dot(row, corners[i]) + row[3], 0), 1);
        low = fmin(low, t);
        high = fmax(high, t);
    }
    *depth = low;
    return high - low < SAME;
}

// The least distance of two planes in any layer; 0: there are other surfaces.
static double least_gap(const Facts *facts)
{
    double least = 1;
    for (int layer = 0; layer < facts->layer_count; layer++) {
        const DrawList *list = &facts->views->light[layer].seen;
        double depths[SCENE_MAX_OBJECTS];
        for (int i = 0; i < list->count; i++) {
            const Object *object = &facts->scene->objects[list->objects[i]];
            if (!one_depth(facts->views, layer, object, &depths[i])) {
                return 0;
            }
        }
        qsort(depths, (size_t)list->count, sizeof *depths, compare_depths);
        for (int i = 1; i < list->count; i++) {
            double gap = depths[i] - depths[i - 1];
            least = gap < SAME ? least : fmin(least, gap);
        }
    }
    return least;
}

static double largest_error(const ShadingSettings *settings, double gap)
{
    const ChebyshevSettings *bound = &settings->chebyshev;
    MomentsSettings moments = settings->moments;
    moments.format = "rg16f";
    GuardNumbers guard = guard_of_settings(&moments, &settings->blur, NULL, 1);
    double stored = STORED + SAME;
    double spread = 0.5 * (double)guard.spread;
    double mean = 0.5 * (double)guard.mean[0] + (double)guard.mean[1];
    double root =
        0.5 * (double)guard.variance[0] + sqrt((double)guard.variance[1]);
    double moved = 3 * stored + 2 * (mean + spread) + 2 * (root + spread);
    double stretched = strcmp(bound->reduction, "smooth") == 0 ? 1.5 : 1;
    stretched /= 1 - bound->bleed_reduction;
    return gap > 4 * stored
               ? fmin(1.001 * stretched * 2 * moved / (gap - 2 * stored), 1)
               : 1;
}

// Why there is no bound, or NULL.
static const char *why_unknown(const ShadingSettings *settings,
                               const Facts *facts)
{
    const MomentsSettings *moments = &settings->moments;
    const BlurSettings *blur = &settings->blur;
    bool proven = settings->chebyshev.min_variance == OPTION_AUTO;
    bool plain = !settings->soft && !blur->mips && !blur->sat &&
                 moments->msaa == 1 && !moments->slope_term;
    return !facts->lookups                        ? "nothing is looked up"
           : facts->later                         ? "what is shown changes"
           : !moments_are_central(moments)        ? "--moments raw"
           : !proven                              ? "--min-variance is not auto"
           : !plain                               ? "not known for this filter"
           : facts->views->light_position[3] != 0 ? "the light is not parallel"
                                                  : NULL;
}

void half_choose(ShadingSettings *settings, Facts *facts)
{
    char text[64];
    const char *why = why_unknown(settings, facts);
    double error = 1;
    if (why == NULL) {
        double gap = least_gap(facts);
        error = gap > 0 ? largest_error(settings, gap) : 1;
        snprintf(text, sizeof text, "visibility is off by at most %.5f", error);
        why = gap > 0 ? text : "depths come as near each other as they like";
    }
    moments_choose_format(&settings->moments, facts, error, why);
}
