#include <stdio.h> // snprintf

#include "step1_shadowmap/base/seams/technique.h"
#include "step5_chebyshev/techniques/guard/guarded.h" // guarded_visibility

static struct {
    double bias; // of the squared depth range
} settings;

static const Option options[] = {
    {.name = "variance-bias",
     .kind = OPTION_NUMBER,
     .minimum = 0,
     .maximum = 1,
     .argument = "X",
     .help = "added to every variance, which is then at most 1"},
    {0},
};

static bool prepare(Frame *frame)
{
    static const char *const bias[] = {
        "step5_chebyshev/techniques/variance_bias/bias.glsl", NULL};
    char text[64];
    if (settings.bias == 0) {
        return false;
    }
    snprintf(text, sizeof text, "const float variance_bias = %.9g;",
             settings.bias);
    gl_put_in_front(&frame->shaders, text);
    gl_put_instead(&frame->shaders, "step5_chebyshev/shaders/visibility.glsl",
                   guarded_visibility);
    gl_put_instead(&frame->shaders, guarded_visibility[2], bias);
    return true;
}

const Technique chebyshev_variance_bias = {
    .options = options, .settings = &settings, .prepare = prepare};
