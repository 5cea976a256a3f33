#include "tests/stability/formulas.h"

#include <float.h>  // FLT_MIN
#include <math.h>   // fmaxf
#include <stdint.h> // uint32_t
#include <string.h> // memcpy

const Format formats[FORMATS] = {
    {.name = "fp32", .digits = 24, .roundoff = 0, .tiny = 0},
    {.name = "fp16", .digits = 11, .roundoff = 0x1p-11, .tiny = 0x1p-25},
    {.name = "fp16-truncated",
     .digits = 11,
     .truncates = true,
     .roundoff = 0x1p-10,
     .tiny = 0x1p-24},
};

// 2^exponent, for normal numbers.
static float power_of_2(int exponent)
{
    uint32_t bits = (uint32_t)(exponent + 127) << 23;
    float value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

float format_store(const Format *format, float value)
{
    if (format->digits == 24 || value == 0) {
        return value;
    }
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    int exponent = (int)(bits >> 23 & 0xff) - 127;
    float step = power_of_2((exponent < -14 ? -14 : exponent) - 10);
    float steps = value / step; // exact: step is a power of two
    return step * (format->truncates ? truncf(steps) : rintf(steps));
}

int chain_corners(const Chain *chain)
{
    return chain->lookup == LOOKUP_NONE ? 1 : 2;
}

// Of the map that is blurred.
static int blurred_side(const Chain *chain)
{
    return chain->taps + chain_corners(chain) - 1;
}

int chain_side(const Chain *chain)
{
    return chain->factor * blurred_side(chain);
}

// A texel: M1 and M2, or mean and variance.
typedef struct Pair {
    float first, second;
} Pair;

static Pair merge_raw(const Pair *texels, int stride, const float *weights,
                      int count)
{
    Pair sum = {0, 0};
    for (int i = 0; i < count; i++) {
        sum.first += weights[i] * texels[i * stride].first;
        sum.second += weights[i] * texels[i * stride].second;
    }
    return sum;
}

// mean = c + s, s = sum w (m - c); variance = sum w (v + (m - c)^2) - s^2,
// with c the mean of largest weight: what is subtracted is then never much
// larger than what is left.
static Pair merge_central(const Pair *texels, int stride, const float *weights,
                          int count, bool naive)
{
    int heaviest = 0;
    for (int i = 1; i < count; i++) {
        heaviest = weights[i] > weights[heaviest] ? i : heaviest;
    }
    float middle = naive ? 0 : texels[heaviest * stride].first;
    float shift = 0;
    float square = 0;
    for (int i = 0; i < count; i++) {
        float from = texels[i * stride].first - middle;
        shift += weights[i] * from;
        square += weights[i] * (texels[i * stride].second + from * from);
    }
    return (Pair){middle + shift, fmaxf(square - shift * shift, 0)};
}

static Pair merge(const Chain *chain, const Pair *texels, int stride,
                  const float *weights, int count)
{
    return chain->central ? merge_central(texels, stride, weights, count,
                                          chain->fault == NAIVE_MERGE)
                          : merge_raw(texels, stride, weights, count);
}

static Pair store(const Chain *chain, Pair pair)
{
    return (Pair){format_store(chain->format, pair.first),
                  format_store(chain->format, pair.second)};
}

static Pair texel(const Chain *chain, float depth)
{
    return store(chain, (Pair){depth, chain->central ? 0 : depth * depth});
}

// Every texel of the map that is blurred.
static void downsample(const Chain *chain, const Window *window, Pair *map)
{
    int factor = chain->factor;
    int side = blurred_side(chain);
    for (int i = 0; i < side * side; i++) {
        Pair group[4];
        float weights[4];
        for (int j = 0; j < factor * factor; j++) {
            int x = i % side * factor + j % factor;
            int y = i / side * factor + j / factor;
            group[j] = texel(chain, window->depths[y * side * factor + x]);
            weights[j] = 1 / (float)(factor * factor);
        }
        map[i] = factor == 1 ? group[0]
                             : store(chain, merge(chain, group, 1, weights,
                                                  factor * factor));
    }
}

static float lerp(float a, float b, float part)
{
    return a + part * (b - a);
}

static Pair merge_two_raw(Pair one, Pair other, float part)
{
    return (Pair){lerp(one.first, other.first, part),
                  lerp(one.second, other.second, part)};
}

// All terms of the variance are positive. The mean is taken from the larger
// part: what is added has no roundings of a distant depth's size.
static Pair merge_two_central(Pair one, Pair other, float part)
{
    float rest = 1 - part;
    float apart = other.first - one.first;
    float mean =
        part < 0.5F ? one.first + part * apart : other.first - rest * apart;
    return (Pair){mean, rest * one.second + part * other.second +
                            part * rest * apart * apart};
}

static Pair look_up(const Chain *chain, const Pair corners[4])
{
    Pair (*two)(Pair, Pair, float) =
        chain->central ? merge_two_central : merge_two_raw;
    if (chain->lookup == LOOKUP_NONE) {
        return corners[0];
    }
    return two(two(corners[0], corners[1], chain->across),
               two(corners[2], corners[3], chain->across), chain->up);
}

// Blurs rows, then columns: what is left is the lookup's 2 x 2 texels.
static Pair filter(const Chain *chain, const Window *window)
{
    Pair map[(MAX_TAPS + 1) * (MAX_TAPS + 1)];
    Pair rows[2 * (MAX_TAPS + 1)];
    Pair corners[4];
    int side = blurred_side(chain);
    int wide = chain_corners(chain);
    downsample(chain, window, map);
    for (int i = 0; i < wide * side; i++) {
        rows[i] = store(chain, merge(chain, map + i / wide * side + i % wide, 1,
                                     chain->weights, chain->taps));
    }
    for (int i = 0; i < wide * wide; i++) {
        corners[i] =
            store(chain, merge(chain, rows + i / wide * wide + i % wide, wide,
                               chain->weights, chain->taps));
    }
    return look_up(chain, corners);
}

static float guarded_variance(const Chain *chain, const Guard *guard,
                              float variance, Pair pair)
{
    if (!chain->central) {
        return variance + (guard->variance * pair.second + guard->tiny);
    }
    // What underflow took is inside the root: a square root magnifies it.
    float size = fminf(sqrtf(pair.first * pair.first + variance), 0.5F);
    float deviation = sqrtf(variance + guard->tiny) * (1 + guard->deviation) +
                      guard->variance * size + guard->tiny_shift;
    return deviation * deviation;
}

Estimate estimate(const Chain *chain, const Window *window, const Guard *guard)
{
    Pair pair = filter(chain, window);
    float sign = chain->fault == VARIANCE_SIGN ? -1 : 1;
    float square = pair.first * pair.first;
    float variance =
        chain->central ? sign * pair.second : sign * (pair.second - square);
    variance = fmaxf(variance, 0);
    float most = fmaxf(guarded_variance(chain, guard, variance, pair), FLT_MIN);
    float spread =
        chain->central ? guard->deviation * sqrtf(variance + guard->tiny) : 0;
    float mean = chain->central ? fminf(pair.first, 0.5F) : pair.first;
    float behind = (window->t - pair.first) -
                   (guard->mean * mean + spread + guard->tiny_shift);
    float p = behind > 0 ? most / (most + behind * behind) : 1;
    return (Estimate){pair.first, variance, p};
}

// One axis's weights on the texels of the map: the blur's, seen through the
// lookup's two neighbours and the downsampling.
static long double axis_weight(const Chain *chain, int index, float between)
{
    int i = index / chain->factor;
    long double sum = 0;
    for (int k = 0; k < chain->taps; k++) {
        sum += chain->weights[k];
    }
    long double weight = 0;
    if (i < chain->taps) {
        weight += (1 - (long double)between) * chain->weights[i];
    }
    if (i > 0) {
        weight += (long double)between * chain->weights[i - 1];
    }
    return weight / (sum * chain->factor);
}

// The moments about `middle`; all inputs are sums of doubles' worth of bits,
// and the variance is taken about the mean: nothing cancels.
Exact exact(const Chain *chain, const Window *window)
{
    int side = chain_side(chain);
    bool looks_up = chain->lookup != LOOKUP_NONE;
    long double across[MAX_SIDE];
    long double up[MAX_SIDE];
    for (int i = 0; i < side; i++) {
        across[i] = axis_weight(chain, i, looks_up ? chain->across : 0);
        up[i] = axis_weight(chain, i, looks_up ? chain->up : 0);
    }
    long double mean = 0;
    long double variance = 0;
    Exact result = {.lit = 0};
    for (int pass = 0; pass < 2; pass++) {
        for (int i = 0; i < side * side; i++) {
            long double weight = across[i % side] * up[i / side];
            float depth = format_store(chain->format, window->depths[i]);
            if (pass == 0) {
                mean += weight * depth;
                result.lit += depth >= window->t ? (double)weight : 0;
                result.most_depth = fmax(result.most_depth, depth);
            } else {
                variance += weight * (depth - mean) * (depth - mean);
            }
        }
    }
    long double behind = window->t - mean;
    result.mean = (double)mean;
    result.variance = (double)variance;
    result.m2 = (double)(variance + mean * mean);
    result.behind = (double)behind;
    result.p =
        behind > 0 ? (double)(variance / (variance + behind * behind)) : 1;
    return result;
}
