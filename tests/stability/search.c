#include "tests/stability/search.h"

#include <math.h>   // fabs
#include <string.h> // memcpy

#include "tests/stability/bound.h" // p_bound

Measured measure_window(const Chain *chain, Quantity quantity, bool guarded,
                        const Window *window)
{
    Guard guard = guarded ? guard_of(chain) : (Guard){0};
    Exact truth = exact(chain, window);
    Estimate found = estimate(chain, window, &guard);
    Measured m;
    if (quantity == OF_P) {
        m.error = fabs((double)found.p - truth.p);
        m.bound = p_bound(chain, &truth, guarded);
    } else {
        m.error = fabs((double)found.variance - truth.variance);
        m.bound = variance_bound(chain, &truth);
    }
    m.ratio = m.bound > 0 ? m.error / m.bound : m.error > 0;
    m.finite =
        isfinite(found.mean) && isfinite(found.variance) && isfinite(found.p);
    return m;
}

static float between(double value, double least, double most)
{
    return (float)fmin(fmax(value, least), most);
}

static void move_t(Place *place, double by)
{
    place->window.t = between((double)place->window.t + by, place->low,
                              fmin(place->high + place->reach, 1));
}

static void move_depth(const Place *start, Place *place, int texel, double by)
{
    double was = start->window.depths[texel];
    place->window.depths[texel] = between(
        place->window.depths[texel] + by, fmax(was - start->reach, start->low),
        fmin(was + start->reach, start->high));
}

// Moves a texel, some of them or all, or t: by a part of the reach or by bits.
static void move(const Chain *chain, Random *random, const Place *start,
                 Place *place)
{
    int texels = chain_side(chain) * chain_side(chain);
    int kind = random_below(random, 5);
    double size = start->reach * pow(2, -26 * random_part(random));
    double by = size * (2 * random_part(random) - 1);
    if (kind == 4) {
        move_t(place, by);
        return;
    }
    int first = random_below(random, texels);
    int end = kind == 0   ? first + 1
              : kind == 3 ? texels
                          : first + random_below(random, texels);
    first = kind == 3 ? 0 : first;
    for (int i = first; i < end && i < texels; i++) {
        double own = kind == 1 ? by : by * (2 * random_part(random) - 1);
        move_depth(start, place, i, own);
    }
}

// Only the texels that there are: a place has room for many.
static void copy_place(const Chain *chain, const Place *from, Place *to)
{
    size_t texels = (size_t)chain_side(chain) * (size_t)chain_side(chain);
    memcpy(to->window.depths, from->window.depths,
           texels * sizeof to->window.depths[0]);
    to->window.t = from->window.t;
    to->low = from->low;
    to->high = from->high;
    to->reach = from->reach;
}

double search_worst(const SearchCase *search)
{
    Random random = {search->seed};
    static Place start, best, next;
    double ratio = -1;
    double most = 0;
    for (int i = 0; i < search->steps; i++) {
        // Now and then from elsewhere: hills have tops that are not the top.
        if (i % 200 == 0) {
            search->start(search->context, &random, &start);
            copy_place(&search->chain, &start, &best);
            ratio = -1;
        }
        copy_place(&search->chain, &best, &next);
        if (ratio >= 0) {
            move(&search->chain, &random, &start, &next);
        }
        Measured m = measure_window(&search->chain, search->quantity,
                                    search->guarded, &next.window);
        bool promise = search->quantity != OF_P || m.bound <= NO_PROMISE;
        double now = promise ? m.ratio : 0;
        if (now > ratio) {
            ratio = now;
            copy_place(&search->chain, &next, &best);
        }
        most = fmax(most, now);
    }
    return most;
}
