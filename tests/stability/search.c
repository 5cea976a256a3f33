#include "tests/stability/search.h"

#include <math.h> // fabs

#include "tests/stability/bound.h" // p_bound

static SearchResult measure(const SearchCase *search, const Window *window)
{
    const Chain *chain = &search->chain;
    Guard guard = search->guarded ? guard_of(chain) : (Guard){0};
    Exact truth = exact(chain, window);
    SearchResult result = {
        .error = fabs((double)estimate(chain, window, &guard).p - truth.p),
        .bound = p_bound(chain, &truth, search->guarded),
        .window = *window};
    result.ratio = result.error / result.bound;
    return result;
}

static float within(const SearchCase *search, double depth)
{
    return (float)fmin(fmax(depth, search->nearest), search->farthest);
}

// Half of the texels on each plane, t on the farther one.
static Window two_planes(const SearchCase *search, Random *random)
{
    Window window;
    int side = chain_side(&search->chain);
    float far =
        within(search, search->nearest + search->gap +
                           (search->farthest - search->nearest - search->gap) *
                               random_part(random));
    for (int i = 0; i < side * side; i++) {
        window.depths[i] =
            i % side < side / 2 ? within(search, far - search->gap) : far;
    }
    window.t = far;
    return window;
}

// Moves some texels, or all, or t, by a random part of the gap or by bits.
static void move(const SearchCase *search, Random *random, Window *window)
{
    int side = chain_side(&search->chain);
    int kind = random_below(random, 4);
    double size = search->gap * pow(2, -24 * random_part(random));
    double by = size * (2 * random_part(random) - 1);
    int start = random_below(random, side * side);
    int end = kind == 0 ? start + 1 : start + random_below(random, side * side);
    if (kind == 3) {
        window->t = within(search, window->t + by);
        return;
    }
    for (int i = start; i < end && i < side * side; i++) {
        double own = kind == 1 ? by * random_part(random) : by;
        window->depths[i] = within(search, window->depths[i] + own);
    }
}

SearchResult search_worst(const SearchCase *search)
{
    Random random = {search->seed};
    Window start = two_planes(search, &random);
    SearchResult best = measure(search, &start);
    for (int i = 0; i < search->steps; i++) {
        // Now and then from elsewhere: hills have tops that are not the top.
        Window next = i % 64 == 0 ? two_planes(search, &random) : best.window;
        move(search, &random, &next);
        SearchResult result = measure(search, &next);
        bool counts = result.bound <= NO_PROMISE;
        if (counts && (best.bound > NO_PROMISE || result.ratio > best.ratio)) {
            best = result;
        }
    }
    return best;
}
