#include "step1_shadowmap/techniques/shared/footprint.h"

#include <string.h> // strcmp

#include "step1_shadowmap/base/picture/picture.h" // PICTURE_FOOTPRINT
#include "step1_shadowmap/base/seams/technique.h"

const char map_footprint_file[] =
    "step1_shadowmap/techniques/shared/footprint.glsl";
const char map_footprint_steps[] =
    "step1_shadowmap/techniques/shared/steps.glsl";

static struct {
    bool used;
    Target derivatives; // across the screen, for --plan
} state;

static bool prepare(Frame *frame)
{
    (void)frame;
    return true;
}

static bool is_used(const Frame *frame, const Picture *picture)
{
    const char *files[PROGRAM_MAX_FILES + 1];
    bool found = false;
    gl_find_files(&frame->shaders, picture->visibility, files);
    for (int i = 0; files[i] != NULL; i++) {
        found = found || strcmp(files[i], map_footprint_file) == 0;
    }
    return found;
}

static void create(Frame *frame, Picture *picture)
{
    static const char *const dump[] = {
        "step1_shadowmap/techniques/shared/dump_footprint.glsl", NULL};
    state.used = is_used(frame, picture);
    if (state.used && frame->settings.dump != NULL) {
        picture->target.formats[PICTURE_FOOTPRINT] = GL_RGBA32F;
        gl_put_instead(&frame->shaders,
                       "step1_shadowmap/base/picture/shaders/dump.glsl", dump);
    }
    state.derivatives = (Target){
        .pass = "derivatives",
        .kind = TARGET_NOTHING,
        .idle = !state.used,
        .why = state.used ? "lookups as wide as a pixel is in the map"
                          : "no lookup asks how wide a pixel is in the map"};
    target_add(&frame->targets, &state.derivatives);
}

bool map_footprint_is_used(void)
{
    return state.used;
}

const Technique map_footprint = {.prepare = prepare, .create = create};
