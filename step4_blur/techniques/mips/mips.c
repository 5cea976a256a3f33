// --mips: coarser copies of the filtered map, for pixels that cover many of its
// texels.
#include "step4_blur/techniques/mips/mips.h"

#include <string.h> // strcmp

#include "step1_shadowmap/base/picture/picture.h" // Picture
#include "step1_shadowmap/base/seams/technique.h"
#include "step1_shadowmap/base/system/die.h" // die_usage
#include "step1_shadowmap/techniques/shared/footprint.h"

static struct Settings {
    bool asked;          // a mip-map chain of the result
    int anisotropy;      // most lookups for one pixel
    const char *sampler; // of the levels: explicit or hardware
} settings = {.anisotropy = 1, .sampler = "explicit"};

static struct {
    Program *copy;
    Target level0; // copied, where there is no filtered map
    Program *program;
    Target *map;                     // level 0
    Target targets[MIPS_MAX_LEVELS]; // from level 1 on
    int levels;
} state;

static const Option options[] = {
    {.name = "mips",
     .kind = OPTION_FLAG,
     .offset = offsetof(struct Settings, asked),
     .help = "a mip-map chain of the filtered map; each pixel looks up the "
             "level of its own size"},
    {.name = "anisotropy",
     .kind = OPTION_INTEGER,
     .offset = offsetof(struct Settings, anisotropy),
     .minimum = 1,
     .maximum = 16,
     .argument = "N",
     .help = "with --mips: up to N lookups along the pixel's longer axis in "
             "the map"},
    {.name = "sampler",
     .kind = OPTION_CHOICE,
     .offset = offsetof(struct Settings, sampler),
     .choices = "explicit,hardware",
     .help = "with --mips: who chooses and blends the levels, the shader or "
             "the texture unit"},
    {0},
};

static bool uses_hardware(void)
{
    return strcmp(settings.sampler, "hardware") == 0;
}

static void check(Frame *frame)
{
    const int *size = frame->settings.map_size;
    int factor = options_integer(frame->options, "downsample");
    if (options_given(frame->options, "anisotropy") && !settings.asked) {
        die_usage("--anisotropy %d needs --mips: add --mips or drop "
                  "--anisotropy",
                  settings.anisotropy);
    }
    if (options_given(frame->options, "sampler") && !settings.asked) {
        die_usage("--sampler %s needs --mips: add --mips or drop --sampler",
                  settings.sampler);
    }
    if (settings.asked && size[0] % factor == 0 && size[1] % factor == 0 &&
        (size[0] / factor % 2 != 0 || size[1] / factor % 2 != 0)) {
        die_usage("--mips cannot halve a map of %dx%d texels: give an even "
                  "--map-size or drop --mips",
                  size[0] / factor, size[1] / factor);
    }
    if (uses_hardware() && options_is(frame->options, "moments", "central")) {
        die_usage("--sampler hardware averages both channels, and the variance "
                  "of --moments central is no average: drop one of them");
    }
}

static const char *const *lookup_files(void)
{
    static const char *const trilinear[] = {
        map_footprint_steps,
        map_footprint_file,
        "step1_shadowmap/techniques/shared/ellipse.glsl",
        "step3_moments/techniques/shared/merge_raw.glsl",
        "step3_moments/techniques/shared/between_raw.glsl",
        "step4_blur/techniques/mips/mip_levels.glsl",
        "step4_blur/techniques/mips/lookup_trilinear.glsl",
        NULL};
    static const char *const hardware[] = {
        map_footprint_steps, map_footprint_file,
        "step4_blur/techniques/mips/lookup_hardware.glsl", NULL};
    return uses_hardware() ? hardware : trilinear;
}

static bool prepare(Frame *frame)
{
    static const char *const anisotropic[] = {
        "step4_blur/techniques/mips/lookup_anisotropic.glsl", NULL};
    if (!settings.asked) {
        return false;
    }
    if (settings.anisotropy > 1) {
        gl_put_instead(&frame->shaders,
                       "step4_blur/techniques/mips/lookup_trilinear.glsl",
                       anisotropic);
    }
    gl_put_instead(&frame->shaders,
                   "step3_moments/shaders/lookup_bilinear.glsl",
                   lookup_files());
    frame->lookups.kernel = 0;
    frame->lookups.spread = 0;
    return true;
}

int mips_count(const int size[2])
{
    int count = 1;
    while ((size[0] >> (count - 1)) % 2 == 0 &&
           (size[1] >> (count - 1)) % 2 == 0 && count < MIPS_MAX_LEVELS) {
        count++;
    }
    return count;
}

// How many texels of the finest level a lookup may read beyond the 90 degrees
// of a point light's face. Nothing was drawn beyond its border: the seams would
// show. No other light's map ends where receivers are: of splits the next one
// has taken over before.
static double free_texels(const Frame *frame)
{
    const Views *views = &frame->views;
    bool point = views->light_position[3] != 0 && views->layers > 1;
    return point
               ? views->border / options_integer(frame->options, "downsample") -
                     options_integer(frame->options, "radius")
               : 1e9;
}

// The coarsest level that stays within these texels. In texels of the finest,
// one of level k holds 1.5 (2^k - 1) to both sides of its centre, for 1 3 3 1
// adds 1.5 of each level's own, and a bilinear lookup adds 2^k.
static int last_level(int levels, double free)
{
    int last = levels - 1;
    while (last > 0 && 2.5 * (1 << last) - 1.5 > free) {
        last--;
    }
    return last;
}

// Refuses (status 2) what the texture unit cannot do by itself.
static void check_sampler(int layers, int anisotropy)
{
    // A driver may take the pixel's length from the coordinates of the pixel
    // beside it (llvmpipe does), and those may be in another layer.
    if (anisotropy > 1 && layers > 1) {
        die_usage("--sampler hardware takes --anisotropy with a map of one "
                  "layer only, not with this one of %d: drop one of them",
                  layers);
    }
    GLfloat most = 1;
    if (GLAD_GL_EXT_texture_filter_anisotropic) {
        glGetFloatv(GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT, &most);
    }
    if ((GLfloat)anisotropy > most) {
        die_usage("--sampler hardware takes --anisotropy 1 to %g with this "
                  "driver, not %d: drop one of them",
                  (double)most, anisotropy);
    }
}

// Makes only these levels readable. While one level is drawn, none but the
// level before it may be: reading what is being drawn has no defined result.
static void limit_levels(int first, int last)
{
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BASE_LEVEL, first);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, last);
}

// A chain needs a texture of its own, and the moments' is not ours.
static Target *create_level0(Frame *frame, Target *map)
{
    static const char *const copy[] = {
        "step1_shadowmap/base/picture/shaders/fullscreen.vert",
        "step4_blur/shaders/map_texel.glsl",
        "step4_blur/shaders/downsample.frag", NULL};
    if (options_integer(frame->options, "radius") > 0 ||
        options_integer(frame->options, "downsample") > 1) {
        return map;
    }
    state.copy = gl_program(&frame->shaders, "const int factor = 1;", copy);
    state.level0 = target_reading(map->reads, "copy", 1);
    state.level0.why = "of which --mips are made";
    target_add_before(&frame->targets, &state.level0, map);
    target_take_place(map, &state.level0);
    return map;
}

// Each level is half as wide and high as the one before; the last is the one
// that cannot be halved without a rest, for a texel that began elsewhere than
// two finer ones would shift the shadows. The picture looks them up as far as
// level `last`.
static void create_levels(Frame *frame, Target *owner, int last)
{
    Target *map = state.map;
    for (int level = 1; level < state.levels; level++) {
        Target *target = &state.targets[level];
        *target =
            target_reading(level == 1 ? map : target - 1, "mip-map levels", 2);
        target->why = "--mips";
        target->file = "blurred";
        target->shares = owner;
        target->level = level;
        target->reach[0] = target->reach[1] = 1;
        target->looked_up = level <= last ? map->looked_up : 0;
        target_add(&frame->targets, target);
    }
}

// Taps along the pixel's longer axis may be anywhere.
static void create(Frame *frame, Picture *picture)
{
    static const char *const files[] = {
        "step1_shadowmap/base/picture/shaders/fullscreen.vert",
        "step3_moments/techniques/shared/merge_raw.glsl",
        "step3_moments/techniques/shared/store_float.glsl",
        "step4_blur/shaders/map_texel.glsl",
        "step4_blur/techniques/mips/mips.frag",
        NULL};
    Target *map = state.map = create_level0(frame, picture->map);
    Target *owner = map;
    const int size[2] = {map->width, map->height};
    if (uses_hardware()) {
        check_sampler(map->layers, settings.anisotropy);
    }
    while (owner->shares != NULL) {
        owner = owner->shares;
    }
    map->looked_up = settings.anisotropy > 1 ? TARGET_EVERYWHERE : 1;
    state.program = gl_program(&frame->shaders, NULL, files);
    state.levels = owner->levels = mips_count(size);
    create_levels(frame, owner, last_level(state.levels, free_texels(frame)));
}

// Of the texture that is bound. The shader blends the levels itself, unless the
// texture unit is to do so.
static void set_filter(void)
{
    GLenum target = GL_TEXTURE_2D_ARRAY;
    GLint filter = uses_hardware() ? GL_LINEAR_MIPMAP_LINEAR
                   : state.map->sampling.filter == GL_LINEAR
                       ? GL_LINEAR_MIPMAP_NEAREST
                       : GL_NEAREST_MIPMAP_NEAREST;
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, filter);
    if (uses_hardware() && settings.anisotropy > 1) {
        glTexParameterf(target, GL_TEXTURE_MAX_ANISOTROPY_EXT,
                        (GLfloat)settings.anisotropy);
    }
}

// Fills levels 1 and on, each from the one before.
static void after(const Frame *frame)
{
    if (state.copy != NULL) {
        frame_filter(frame, state.copy, &state.level0);
    }
    GLuint texture = target_texture(state.map);
    glBindTexture(GL_TEXTURE_2D_ARRAY, texture);
    set_filter();
    for (int level = 1; level < state.levels; level++) {
        glBindTexture(GL_TEXTURE_2D_ARRAY, texture);
        limit_levels(level - 1, level - 1);
        frame_filter(frame, state.program, &state.targets[level]);
    }
    glBindTexture(GL_TEXTURE_2D_ARRAY, texture);
    limit_levels(0, state.levels - 1);
}

static void look(const Frame *frame, GLuint program)
{
    double free = free_texels(frame);
    int last = last_level(state.levels, free);
    if (!frame->looks_up) {
        return;
    }
    if (uses_hardware()) {
        glBindTexture(GL_TEXTURE_2D_ARRAY, target_texture(state.map));
        glTexParameterf(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LOD, (GLfloat)last);
    }
    glUniform1i(glGetUniformLocation(program, "last_level"), last);
    glUniform1i(glGetUniformLocation(program, "anisotropy"),
                settings.anisotropy);
    glUniform1f(glGetUniformLocation(program, "free_texels"), (float)free);
}

const Technique blur_mips = {.options = options,
                             .settings = &settings,
                             .check = check,
                             .prepare = prepare,
                             .create = create,
                             .after = after,
                             .pass = "blur",
                             .look = look};
