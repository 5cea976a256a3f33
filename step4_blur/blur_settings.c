#include "step4_blur/blur.h"

#include <string.h> // strcmp

#include "step1_shadowmap/base/system/die.h" // die_usage

// The published filter of 7 taps.
enum { BINOMIAL_RADIUS = 3 };

const Option blur_options[] = {
    {.name = "blur",
     .kind = OPTION_CHOICE,
     .offset = offsetof(BlurSettings, kernel),
     .choices = "none,box,boxes,gaussian,binomial",
     .help = "the filter's kernel; boxes: three boxes in a row; the binomial "
             "one is 7 texels wide"},
    {.name = "radius",
     .kind = OPTION_INTEGER,
     .offset = offsetof(BlurSettings, radius),
     .minimum = 0,
     .maximum = 1024,
     .argument = "N",
     .help = "the filter is 2 N + 1 texels wide, of the map it runs on"},
    {.name = "blur-by",
     .kind = OPTION_CHOICE,
     .offset = offsetof(BlurSettings, by),
     .choices = "auto,compute,fragments",
     .help = "what blurs: running boxes in compute shaders, whose time does "
             "not grow with the radius, where the driver has them, or "
             "fragments"},
    {.name = "downsample",
     .kind = OPTION_INTEGER,
     .offset = offsetof(BlurSettings, downsample),
     .minimum = 1,
     .maximum = 16,
     .argument = "N",
     .help = "average N x N texels into one before the blur"},
    {.name = "mips",
     .kind = OPTION_FLAG,
     .offset = offsetof(BlurSettings, mips),
     .help = "a mip-map chain of the filtered map; each pixel looks up the "
             "level of its own size"},
    {.name = "anisotropy",
     .kind = OPTION_INTEGER,
     .offset = offsetof(BlurSettings, anisotropy),
     .minimum = 1,
     .maximum = 16,
     .argument = "N",
     .help = "with --mips: up to N lookups along the pixel's longer axis in "
             "the map"},
    {.name = "sampler",
     .kind = OPTION_CHOICE,
     .offset = offsetof(BlurSettings, sampler),
     .choices = "explicit,hardware",
     .help = "with --mips: who chooses and blends the levels, the shader or "
             "the texture unit"},
    {.name = "sat",
     .kind = OPTION_FLAG,
     .offset = offsetof(BlurSettings, sat),
     .help = "average the box from a summed-area table, in constant time"},
    {.name = "sat-by",
     .kind = OPTION_CHOICE,
     .offset = offsetof(BlurSettings, sat_by),
     .choices = "auto,compute,fragments",
     .help = "what sums the table: running sums in compute shaders, where the "
             "driver has them, or recursive doubling in fragments"},
    {0},
};

BlurSettings blur_settings(void)
{
    return (BlurSettings){.kernel = "box",
                          .radius = 3,
                          .by = "auto",
                          .downsample = 1,
                          .anisotropy = 1,
                          .sampler = "explicit",
                          .sat_by = "auto"};
}

bool blur_uses_hardware(const BlurSettings *settings)
{
    return strcmp(settings->sampler, "hardware") == 0;
}

int blur_used_radius(const BlurSettings *settings)
{
    return strcmp(settings->kernel, "none") == 0 ? 0 : settings->radius;
}

// A box of an even width has its middle half a texel from a texel's: two of
// them, one to each side, make up for it. The first box is of odd width.
static int three_boxes(int radius, BlurSides filters[BLUR_MAX_FILTERS])
{
    int odd = (radius + 1) / 3; // to each side; the others share what is left
    int left = radius - odd;
    int count = 0;
    if (odd > 0) {
        filters[count++] = (BlurSides){{odd, odd}};
    }
    filters[count++] = (BlurSides){{left / 2, left - left / 2}};
    filters[count++] = (BlurSides){{left - left / 2, left / 2}};
    return count;
}

int blur_filters(const BlurSettings *settings,
                 BlurSides filters[BLUR_MAX_FILTERS])
{
    int radius = blur_used_radius(settings);
    if (radius == 0) {
        return 0;
    }
    if (strcmp(settings->kernel, "boxes") == 0) {
        return three_boxes(radius, filters);
    }
    filters[0] = (BlurSides){{radius, radius}};
    return 1;
}

// Boxes can be summed as they move; 16-bit floats cannot keep sums.
bool blur_can_run(const BlurSettings *settings, const MomentsSettings *moments)
{
    bool boxes = strcmp(settings->kernel, "box") == 0 ||
                 strcmp(settings->kernel, "boxes") == 0;
    return boxes && moments_format(moments) == GL_RG32F;
}

// What says how the map is looked up.
static void check_lookup(const BlurSettings *settings, const int map_size[2],
                         const OptionTable tables[])
{
    if (options_given(tables, "anisotropy") && !settings->mips) {
        die_usage("--anisotropy %d needs --mips: add --mips or drop "
                  "--anisotropy",
                  settings->anisotropy);
    }
    if (options_given(tables, "sampler") && !settings->mips) {
        die_usage("--sampler %s needs --mips: add --mips or drop --sampler",
                  settings->sampler);
    }
    if (options_given(tables, "sat-by") && !settings->sat) {
        die_usage("--sat-by %s needs --sat: add --sat or drop --sat-by",
                  settings->sat_by);
    }
    if (settings->sat && settings->mips) {
        die_usage("--sat contradicts --mips: drop one of them");
    }
    if (settings->sat && strcmp(settings->kernel, "box") != 0) {
        die_usage("--sat averages a box, not --blur %s: drop one of them",
                  settings->kernel);
    }
    int width = map_size[0] / settings->downsample;
    int height = map_size[1] / settings->downsample;
    if (settings->mips && (width % 2 != 0 || height % 2 != 0)) {
        die_usage("--mips cannot halve a map of %dx%d texels: give an even "
                  "--map-size or drop --mips",
                  width, height);
    }
}

static void check_compute(const BlurSettings *settings,
                          const MomentsSettings *moments,
                          const OptionTable tables[])
{
    const char *idle = settings->sat ? "--sat averages in place of a blur"
                       : blur_used_radius(settings) == 0
                           ? "--blur none or --radius 0 leaves nothing to blur"
                           : NULL;
    if (idle != NULL && options_given(tables, "blur-by")) {
        die_usage("--blur-by %s says what blurs, and %s: drop one of them",
                  settings->by, idle);
    }
    if (strcmp(settings->by, "compute") == 0 &&
        !blur_can_run(settings, moments)) {
        die_usage("--blur-by compute moves boxes of 32-bit floats, not --blur "
                  "%s of --format %s: drop one of them",
                  settings->kernel, moments->format);
    }
}

// Variances are no sums and no weighted means of variances.
static void check_moments(const BlurSettings *settings,
                          const MomentsSettings *moments)
{
    if (moments_are_central(moments) && settings->sat) {
        die_usage("--sat sums moments, and --moments central are no sums: "
                  "drop one of them");
    }
    if (moments_are_central(moments) && blur_uses_hardware(settings)) {
        die_usage("--sampler hardware averages both channels, and the variance "
                  "of --moments central is no average: drop one of them");
    }
}

void blur_check(const BlurSettings *settings, const MomentsSettings *moments,
                const BaseSettings *base, const OptionTable tables[])
{
    const int *map_size = base->map_size;
    if (blur_used_radius(settings) == 0 && settings->radius > 0 &&
        options_given(tables, "radius")) {
        die_usage("--radius %d contradicts --blur none: drop one of them",
                  settings->radius);
    }
    if (strcmp(settings->kernel, "binomial") == 0 &&
        settings->radius != BINOMIAL_RADIUS) {
        die_usage("--radius %d contradicts --blur binomial, whose radius is "
                  "%d: drop one of them",
                  settings->radius, BINOMIAL_RADIUS);
    }
    for (int axis = 0; axis < 2; axis++) {
        int side = map_size[axis] / settings->downsample;
        if (map_size[axis] % settings->downsample != 0) {
            die_usage("--downsample %d does not divide --map-size %dx%d",
                      settings->downsample, map_size[0], map_size[1]);
        }
        if (blur_used_radius(settings) > 0 &&
            2 * blur_used_radius(settings) + 1 > side) {
            die_usage("--radius %d is wider than the map: at %d texels "
                      "allowed are 0 to %d",
                      settings->radius, side, (side - 1) / 2);
        }
    }
    check_lookup(settings, map_size, tables);
    check_compute(settings, moments, tables);
    check_moments(settings, moments);
}

int blur_reach(const BlurSettings *settings)
{
    return (blur_used_radius(settings) + 1) * settings->downsample;
}
