#include "step5_chebyshev/chebyshev.h"

#include <string.h> // strcmp

#include "step1_shadowmap/base/die.h" // die

const Option chebyshev_options[] = {
    {.name = "min-variance",
     .kind = OPTION_NUMBER,
     .offset = offsetof(ChebyshevSettings, min_variance),
     .minimum = 0,
     .maximum = 1,
     .choices = "auto",
     .argument = "X",
     .help = "least variance, in units of the squared depth range; auto: "
             "what the format's rounding can hide"},
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

// The largest relative error of rounding one number to the nearest of the
// format. (Software Mesa cuts 16-bit stores off instead: twice as much.)
static double unit_roundoff(GLenum format)
{
    switch (format) {
    case GL_RG32F:
        return 0x1p-24;
    case GL_RG16F:
        return 0x1p-11;
    default:
        die("no unit roundoff for the format 0x%x", format);
    }
}

void chebyshev_apply(const ChebyshevSettings *settings, GLenum format,
                     GLuint program)
{
    bool automatic = settings->min_variance == OPTION_AUTO;
    double constant = automatic ? 0 : settings->min_variance;
    double relative = automatic ? 4 * unit_roundoff(format) : 0;
    glUseProgram(program);
    glUniform1f(glGetUniformLocation(program, "min_variance"), (float)constant);
    glUniform1f(glGetUniformLocation(program, "min_variance_of_m2"),
                (float)relative);
    glUniform1f(glGetUniformLocation(program, "variance_bias"),
                (float)settings->variance_bias);
    glUniform1f(glGetUniformLocation(program, "bleed_reduction"),
                (float)settings->bleed_reduction);
}
