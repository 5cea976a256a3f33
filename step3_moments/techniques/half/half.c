#include <string.h> // strcmp

#include "step1_shadowmap/base/seams/technique.h"

static struct {
    const char *format; // rg32f or rg16f
} settings = {"rg32f"};

static const Option options[] = {
    {.name = "format",
     .kind = OPTION_CHOICE,
     .choices = "rg32f,rg16f",
     .help = "what the two moments are stored in: 32 or 16 bit floats"},
    {0},
};

static bool prepare(Frame *frame)
{
    if (strcmp(settings.format, "rg16f") != 0) {
        return false;
    }
    frame->lookups.rounding = 0x1p-9;
    frame->lookups.spread = 0; // it is not shown that a lone plane stays lit
    return true;
}

static void create(Frame *frame, Picture *picture)
{
    (void)picture;
    for (int i = 0; i < frame->targets.count; i++) {
        if (frame->targets.list[i]->kind == TARGET_LAYERS) {
            frame->targets.list[i]->formats[0] = GL_RG16F;
        }
    }
}

const Technique moments_half = {.options = options,
                                .settings = &settings,
                                .prepare = prepare,
                                .create = create};
