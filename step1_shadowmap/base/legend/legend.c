// What the colours of a --show picture mean, drawn into its corner.

#include <string.h> // strchr, strlen

#include "step1_shadowmap/base/picture/picture.h" // legend_draw

enum { MAX_GLYPHS = 48 };

// 3 x 5 bits per letter, row by row from the top; the top left bit is 1 << 14.
static const char letters[] = "0123456789-.abcdefghijklmnopqrstuvwxyz";
static const int font[] = {
    0x7b6f, 0x2c97, 0x73e7, 0x73cf, 0x5bc9, 0x79cf, 0x79ef, 0x7252,
    0x7bef, 0x7bcf, 0x01c0, 0x0002, 0x2bed, 0x6bae, 0x3923, 0x6b6e,
    0x79a7, 0x79a4, 0x396b, 0x5bed, 0x7497, 0x126a, 0x5d35, 0x4927,
    0x5fed, 0x6b6d, 0x2b6a, 0x6ba4, 0x2b73, 0x6bad, 0x388e, 0x7492,
    0x5b6f, 0x5b6a, 0x5bfd, 0x5aad, 0x5a92, 0x72a7};

// Returns how many letters there are.
static int set_text(GLuint program, const char *text)
{
    int glyphs[MAX_GLYPHS] = {0};
    int count = (int)strlen(text);
    count = count < MAX_GLYPHS ? count : MAX_GLYPHS;
    for (int i = 0; i < count; i++) {
        const char *place = strchr(letters, text[i]);
        glyphs[i] = place == NULL ? 0 : font[place - letters]; // else blank
    }
    glUniform1iv(glGetUniformLocation(program, "glyphs"), MAX_GLYPHS, glyphs);
    glUniform1i(glGetUniformLocation(program, "glyph_count"), count);
    return count;
}

Program *legend_create(Frame *frame)
{
    const ShowMode *mode = base_show_mode(&frame->settings);
    const char *files[] = {
        "step1_shadowmap/base/picture/shaders/fullscreen.vert", mode->scale,
        "step1_shadowmap/base/legend/shaders/legend.frag", NULL};
    return mode->scale == NULL ? NULL
                               : gl_program(&frame->shaders, NULL, files);
}

void legend_draw(Program *legend, const Frame *frame)
{
    if (legend == NULL) {
        return;
    }
    GLuint program = gl_use(legend);
    int count = set_text(program, base_show_mode(&frame->settings)->legend);
    int zoom = 1 + frame->settings.size[1] / 360;
    int corner = 4 * zoom;
    int width = count * 4 * zoom;
    int height = 15 * zoom;
    glUniform2i(glGetUniformLocation(program, "corner"), corner, corner);
    glUniform1i(glGetUniformLocation(program, "width"), width);
    glUniform1i(glGetUniformLocation(program, "zoom"), zoom);
    // Only the picture: the other outputs of --dump keep what they have.
    GLenum all[] = {GL_COLOR_ATTACHMENT0};
    glDrawBuffers(1, all);
    glDisable(GL_DEPTH_TEST);
    glViewport(corner, corner, width, height);
    gl_draw_fullscreen(frame->empty_vao);
}
