#include "step5_chebyshev/chebyshev.h"

#include <string.h> // strcmp

const Option chebyshev_options[] = {
    {.name = "min-variance",
     .kind = OPTION_NUMBER,
     .offset = offsetof(ChebyshevSettings, min_variance),
     .minimum = 0,
     .maximum = 1,
     .choices = "auto",
     .argument = "X",
     .help = "least variance, in units of the squared depth range; auto: "
             "add what rounding can hide of it, from format and filter"},
    {.name = "variance-bias",
     .kind = OPTION_NUMBER,
     .offset = offsetof(ChebyshevSettings, variance_bias),
     .minimum = 0,
     .maximum = 1,
     .argument = "X",
     .help = "added to every variance, which is then at most 1"},
    {.name = "bleed-reduction",
     .kind = OPTION_NUMBER,
     .offset = offsetof(ChebyshevSettings, bleed_reduction),
     .minimum = 0,
     .maximum = 0.9999,
     .argument = "X",
     .help = "visibility up to X becomes 0, the rest is stretched"},
    {.name = "reduction",
     .kind = OPTION_CHOICE,
     .offset = offsetof(ChebyshevSettings, reduction),
     .choices = "linear,smooth",
     .help = "how what is above the bleed reduction is stretched"},
    {0},
};

ChebyshevSettings chebyshev_settings(void)
{
    return (ChebyshevSettings){.min_variance = OPTION_AUTO,
                               .bleed_reduction = 0.18,
                               .reduction = "linear"};
}

const char *chebyshev_reduction_shader(const ChebyshevSettings *settings)
{
    return strcmp(settings->reduction, "smooth") == 0
               ? "step5_chebyshev/shaders/reduction_smooth.glsl"
               : "step5_chebyshev/shaders/reduction_linear.glsl";
}

const char *chebyshev_guard_shader(const ChebyshevSettings *settings,
                                   const MomentsSettings *moments)
{
    if (settings->min_variance != OPTION_AUTO) {
        return "step5_chebyshev/shaders/guard_constant.glsl";
    }
    return moments_are_central(moments)
               ? "step5_chebyshev/shaders/guard_central.glsl"
               : "step5_chebyshev/shaders/guard_raw.glsl";
}

void chebyshev_apply(const ChebyshevSettings *settings,
                     const GuardNumbers *guard, GLuint program)
{
    glUseProgram(program);
    glUniform1f(glGetUniformLocation(program, "variance_bias"),
                (float)settings->variance_bias);
    glUniform1f(glGetUniformLocation(program, "bleed_reduction"),
                (float)settings->bleed_reduction);
    // What the program does not use has no location and is ignored.
    glUniform1f(glGetUniformLocation(program, "min_variance"),
                (float)settings->min_variance);
    glUniform1f(glGetUniformLocation(program, "guard_spread"), guard->spread);
    glUniform2fv(glGetUniformLocation(program, "guard_variance"), 1,
                 guard->variance);
    glUniform2fv(glGetUniformLocation(program, "guard_mean"), 1, guard->mean);
}
