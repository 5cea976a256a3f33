#include "step5_chebyshev/chebyshev.h"

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
    {.name = "bleed-reduction",
     .kind = OPTION_NUMBER,
     .offset = offsetof(ChebyshevSettings, bleed_reduction),
     .minimum = 0,
     .maximum = 0.9999,
     .argument = "X",
     .help = "visibility up to X becomes 0, the rest is stretched"},
    {0},
};

ChebyshevSettings chebyshev_settings(void)
{
    return (ChebyshevSettings){.min_variance = OPTION_AUTO,
                               .bleed_reduction = 0.18};
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
    glUniform1f(glGetUniformLocation(program, "bleed_reduction"),
                (float)settings->bleed_reduction);
}
