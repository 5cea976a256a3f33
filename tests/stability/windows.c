#include "tests/stability/windows.h"

#include <math.h>   // nextafterf
#include <string.h> // memcpy

// splitmix64: Steele, Lea, Flood, Fast splittable pseudorandom number
// generators, OOPSLA 2014.
uint32_t random_bits(Random *random)
{
    uint64_t z = random->state += 0x9e3779b97f4a7c15U;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return (uint32_t)((z ^ (z >> 31)) >> 32);
}

double random_part(Random *random)
{
    return random_bits(random) * 0x1p-32;
}

int random_below(Random *random, int below)
{
    return (int)(random_part(random) * below);
}

// Every float in [0, 1] is as likely as any other: mostly tiny ones.
static float random_float(Random *random)
{
    uint32_t bits = random_bits(random) % 0x3f800001U;
    float value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

static double kernel_weight(Kernel kernel, int taps, int i, Random *random)
{
    double from = (double)(i - taps / 2);
    // exp(-x^2 / 2) is 1e-6 at 5.2565.
    double sigmas = kernel == KERNEL_GAUSSIAN ? 6 * from / taps
                                              : 2 * 5.2565 * from / (taps - 1);
    switch (kernel) {
    case KERNEL_GAUSSIAN:
    case KERNEL_WIDE_GAUSSIAN:
        return exp(-0.5 * sigmas * sigmas);
    case KERNEL_RANDOM:
        return random_part(random) + 1e-6;
    default:
        return 1;
    }
}

void chain_set_kernel(Chain *chain, Kernel kernel, int taps, Random *random)
{
    double weights[MAX_TAPS];
    double sum = 0;
    for (int i = 0; i < taps; i++) {
        weights[i] = kernel_weight(kernel, taps, i, random);
        sum += weights[i];
    }
    chain->taps = taps;
    for (int i = 0; i < taps; i++) {
        chain->weights[i] = (float)(weights[i] / sum);
    }
}

static float clamp(double depth)
{
    return (float)fmin(fmax(depth, 0), 1);
}

enum { ANY, UNIFORM, ADJACENT, TWO, EQUAL, ENDS, NEAR, KINDS };

static float random_depth(Random *random, int kind, float base, double gap)
{
    switch (kind) {
    case ANY:
        return random_float(random);
    case UNIFORM:
        return (float)random_part(random);
    case ADJACENT:
        return nextafterf(base, (float)random_below(random, 2));
    case TWO:
        return clamp(base - gap * random_below(random, 2));
    case ENDS:
        return (float)random_below(random, 2);
    case NEAR:
        return clamp(base + gap * (random_part(random) - 0.5));
    default:
        return base;
    }
}

void random_window(Random *random, const Chain *chain, Window *window)
{
    int side = chain_side(chain);
    int kind = random_below(random, KINDS);
    float base = random_below(random, 3) == 0 ? random_float(random)
                                              : (float)random_part(random);
    double gap = pow(10, -8 * random_part(random));
    for (int i = 0; i < side * side; i++) {
        window->depths[i] = random_depth(random, kind, base, gap);
    }
    switch (random_below(random, 5)) {
    case 0:
        window->t = random_float(random);
        break;
    case 1:
        window->t = (float)random_part(random);
        break;
    case 2:
        window->t = clamp(base + gap * random_part(random));
        break;
    case 3:
        window->t = nextafterf(base, 1);
        break;
    default:
        window->t = window->depths[random_below(random, side * side)];
    }
}
