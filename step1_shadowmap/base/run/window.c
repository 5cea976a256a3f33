#include "step1_shadowmap/base/run/window.h"

#include <math.h>  // atan2, cos, fmax, fmin, lround, pow, sin, sqrt
#include <stdio.h> // puts, snprintf

#include "step1_shadowmap/base/system/die.h" // printed_check
#include "step1_shadowmap/base/scene/dvec.h" // dvec_cross, dvec_dot, ...

static const double PI = 3.14159265358979323846;

Window window_create(const Context *context, Shaders *shaders,
                     const char *subject)
{
    static const char *const files[] = {
        "step1_shadowmap/base/picture/shaders/fullscreen.vert",
        "step1_shadowmap/base/picture/shaders/present.frag", NULL};
    Window window = {.context = context,
                     .present = gl_program(shaders, NULL, files)};
    snprintf(window.subject, sizeof window.subject, "%s", subject);
    puts("h prints what the keys do in the window");
    printed_check();
    return window;
}

// Moves the camera on a sphere around its target, by angles in radians: to its
// right, and up. It stops short of the poles, where up has no direction.
static void orbit(Camera *camera, double right, double up)
{
    const double limit = 0.499 * PI;
    double axes[3][3]; // to the camera's right, up, from the target to it
    double offset[3];
    dvec_subtract(camera->position, camera->target, offset);
    dvec_copy(camera->up, axes[1]);
    dvec_normalize(axes[1]);
    double height = dvec_dot(offset, axes[1]);
    for (int i = 0; i < 3; i++) {
        axes[2][i] = offset[i] - height * axes[1][i];
    }
    double away = sqrt(dvec_dot(axes[2], axes[2]));
    double distance = sqrt(dvec_dot(offset, offset));
    dvec_normalize(axes[2]);
    dvec_cross(axes[1], axes[2], axes[0]);
    double elevation = fmax(-limit, fmin(atan2(height, away) + up, limit));
    for (int i = 0; i < 3; i++) {
        double level = cos(right) * axes[2][i] + sin(right) * axes[0][i];
        camera->position[i] =
            camera->target[i] +
            distance * (cos(elevation) * level + sin(elevation) * axes[1][i]);
    }
}

static double distance_to_target(const Camera *camera)
{
    double offset[3];
    dvec_subtract(camera->position, camera->target, offset);
    return sqrt(dvec_dot(offset, offset));
}

// Each notch goes a tenth of the way to the target.
static void zoom(const Window *window, Camera *camera, double notches)
{
    double first = window->first_distance;
    double old = distance_to_target(camera);
    double distance = old * pow(0.9, notches);
    distance = fmax(first / 50, fmin(distance, first * 50));
    for (int i = 0; i < 3; i++) {
        double offset = camera->position[i] - camera->target[i];
        camera->position[i] = camera->target[i] + offset * (distance / old);
    }
}

static void print_keys(void)
{
    puts("left drag, arrow keys   orbit\n"
         "wheel, + -              zoom\n"
         "r                       reload the shaders\n"
         "s                       save the picture\n"
         "h                       print this\n"
         "escape                  close");
    printed_check();
}

// Does what was typed; returns how many notches to zoom.
static int react_to_typed(Window *window)
{
    int notches = 0;
    for (const char *key = window->input.typed; *key != '\0'; key++) {
        window->reload = window->reload || *key == 'r';
        window->save = window->save || *key == 's';
        notches += (*key == '+' || *key == '=') - (*key == '-');
        if (*key == 'h') {
            print_keys();
        }
    }
    return notches;
}

// Returns whether there is something to draw.
static bool react(Window *window, const BaseSettings *settings, Camera *camera)
{
    const double arrow = PI / 36;
    // As far as the picture is high: half a turn.
    const double pixel = PI / settings->size[1];
    const Input *input = &window->input;
    double right = input->drag[0] * pixel + input->arrows[0] * arrow;
    double down = input->drag[1] * pixel + input->arrows[1] * arrow;
    double notches = input->wheel + react_to_typed(window);
    // The scene follows the pointer, so the camera goes the other way.
    if (right != 0 || down != 0) {
        orbit(camera, -right, down);
    }
    if (notches != 0) {
        zoom(window, camera, notches);
    }
    return right != 0 || down != 0 || notches != 0 || window->reload ||
           window->save || input->exposed;
}

bool window_next(Window *window, const BaseSettings *settings, Camera *camera)
{
    window->reload = window->save = false;
    if (window->first_distance == 0) {
        window->first_distance = distance_to_target(camera);
        return true;
    }
    do {
        context_wait(window->context, &window->input);
    } while (!window->input.close && !react(window, settings, camera));
    return !window->input.close;
}

// As large as it fits, in the middle: a window manager may give the window
// another shape than the picture's.
static void fit(const Window *window, const int picture[2], int corner[2],
                int size[2])
{
    int inside[2];
    context_framebuffer_size(window->context, inside);
    double zoom =
        fmin((double)inside[0] / picture[0], (double)inside[1] / picture[1]);
    for (int i = 0; i < 2; i++) {
        size[i] = (int)lround(zoom * picture[i]);
        corner[i] = (inside[i] - size[i]) / 2;
    }
}

static void present(const Window *window, const Frame *frame, GLuint picture)
{
    int corner[2], size[2];
    fit(window, frame->settings.size, corner, size);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glViewport(corner[0], corner[1], size[0], size[1]);
    glDisable(GL_DEPTH_TEST);
    GLuint program = gl_use(window->present);
    glUniform2f(glGetUniformLocation(program, "corner"), (float)corner[0],
                (float)corner[1]);
    glUniform2f(glGetUniformLocation(program, "size"), (float)size[0],
                (float)size[1]);
    glUniform1i(glGetUniformLocation(program, "picture"), 0);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, picture);
    gl_draw_fullscreen(frame->empty_vao);
}

void window_show(const Window *window, const Frame *frame,
                 const Picture *picture)
{
    const BaseSettings *settings = &frame->settings;
    char title[256], time[32] = "";
    if (frame_milliseconds != NULL) {
        snprintf(time, sizeof time, " - %.1f ms", frame_milliseconds());
    }
    snprintf(title, sizeof title, "%s - %s%s%s", settings->scene,
             window->subject, time,
             window->shader_error ? " - shader error" : "");
    present(window, frame, picture->target.textures[0]);
    context_show(window->context, title);
    if (window->save) {
        picture_write(picture, settings->output);
        base_say_written(settings, settings->output, "");
    }
}
