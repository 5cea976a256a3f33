#include "step1_shadowmap/base/gl/context.h"

// glad before osmesa.h: both define the GL types. Mesa 25's osmesa.h says
// APIENTRY, which Mesa's own GL/gl.h would define.
#include <glad/gl.h>
#ifndef APIENTRY
#define APIENTRY GLAD_API_PTR
#endif

#include <GL/osmesa.h>
#define GLFW_INCLUDE_NONE // no GL header of its own
#include <GLFW/glfw3.h>
#include <ctype.h>  // tolower
#include <stddef.h> // NULL
#include <stdlib.h> // free, getenv
#include <string.h> // strlen

#include "step1_shadowmap/base/system/die.h" // die, allocate
#include "step1_shadowmap/base/gl/gl.h"      // gl_load

// We draw into framebuffer objects only, so the default framebuffer that
// OSMesa binds is as small as it may be.
enum { SIDE = 1 };

static OSMesaContext create_core_context(void)
{
    const int attributes[] = {OSMESA_FORMAT,
                              OSMESA_RGBA,
                              OSMESA_DEPTH_BITS,
                              0,
                              OSMESA_PROFILE,
                              OSMESA_CORE_PROFILE,
                              OSMESA_CONTEXT_MAJOR_VERSION,
                              3,
                              OSMESA_CONTEXT_MINOR_VERSION,
                              3,
                              0};
    return OSMesaCreateContextAttribs(attributes, NULL);
}

static Context create_offscreen(void)
{
    Context context = {.osmesa = create_core_context()};
    if (context.osmesa == NULL) {
        die("OSMesa offers no OpenGL 3.3 core context; these programs need "
            "one");
    }
    context.pixels = allocate(SIDE * SIDE * 4, 1);
    if (!OSMesaMakeCurrent(context.osmesa, context.pixels, GL_UNSIGNED_BYTE,
                           SIDE, SIDE)) {
        die("OSMesa cannot make its OpenGL context current");
    }
    gl_load((GlLoader)OSMesaGetProcAddress);
    return context;
}

static const char *glfw_reason(void)
{
    const char *reason = NULL;
    glfwGetError(&reason);
    return reason == NULL ? "no reason given" : reason;
}

static void type(Input *input, int letter)
{
    size_t length = strlen(input->typed);
    if (length + 1 < INPUT_MAX_TYPED) {
        input->typed[length] = (char)tolower(letter); // shift, caps lock
    }
}

// Whether a key types no Latin letter: on a Cyrillic or Greek keyboard.
static bool is_foreign(int key, int scancode)
{
    const char *name = glfwGetKeyName(key, scancode);
    return name != NULL && (unsigned char)*name >= 128;
}

// A foreign letter's key counts for what an American keyboard has in its place.
static void on_key(GLFWwindow *window, int key, int scancode, int action,
                   int modifiers)
{
    const int command = GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER;
    Input *input = glfwGetWindowUserPointer(window);
    if (action == GLFW_RELEASE) {
        return;
    }
    if (key >= GLFW_KEY_A && key <= GLFW_KEY_Z && !(modifiers & command) &&
        is_foreign(key, scancode)) {
        type(input, key);
    }
    input->close = input->close || key == GLFW_KEY_ESCAPE;
    input->arrows[0] += (key == GLFW_KEY_RIGHT) - (key == GLFW_KEY_LEFT);
    input->arrows[1] += (key == GLFW_KEY_DOWN) - (key == GLFW_KEY_UP);
}

// Latin letters come as characters, not as keys: those are named after their
// place on an American keyboard.
static void on_character(GLFWwindow *window, unsigned int character)
{
    if (character < 128) {
        type(glfwGetWindowUserPointer(window), (int)character);
    }
}

static void on_cursor(GLFWwindow *window, double x, double y)
{
    Input *input = glfwGetWindowUserPointer(window);
    if (glfwGetMouseButton(window, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS) {
        input->drag[0] += x - input->cursor[0];
        input->drag[1] += y - input->cursor[1];
    }
    input->cursor[0] = x;
    input->cursor[1] = y;
}

static void on_wheel(GLFWwindow *window, double x, double y)
{
    (void)x;
    Input *input = glfwGetWindowUserPointer(window);
    input->wheel += y;
}

static void on_exposed(GLFWwindow *window)
{
    Input *input = glfwGetWindowUserPointer(window);
    input->exposed = true;
}

static void on_resized(GLFWwindow *window, int width, int height)
{
    (void)width, (void)height;
    on_exposed(window);
}

static Context create_window(const int size[2])
{
    // Where no Wayland is named, its library says so in lines of its own.
#if defined(GLFW_PLATFORM) && defined(__linux__)
    if (getenv("WAYLAND_DISPLAY") == NULL) {
        glfwInitHint(GLFW_PLATFORM, GLFW_PLATFORM_X11);
    }
#endif
    if (!glfwInit()) {
        die("no display: --window needs one (%s); without --window the "
            "picture goes to a file",
            glfw_reason());
    }
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE); // macOS insists
    glfwWindowHint(GLFW_RESIZABLE, GLFW_FALSE);
    glfwWindowHint(GLFW_ALPHA_BITS, 0); // opaque
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    Context context = {
        .window = glfwCreateWindow(size[0], size[1], "drawing", NULL, NULL)};
    if (context.window == NULL) {
        die("cannot open a window with OpenGL 3.3 (%s)", glfw_reason());
    }
    glfwMakeContextCurrent(context.window);
    gl_load(glfwGetProcAddress);
    return context;
}

Context context_create(bool window, const int size[2])
{
    return window ? create_window(size) : create_offscreen();
}

// From the first call on, so that the callbacks always have an Input.
static void listen(GLFWwindow *window, Input *input)
{
    glfwSetWindowUserPointer(window, input);
    glfwGetCursorPos(window, &input->cursor[0], &input->cursor[1]);
    glfwSetKeyCallback(window, on_key);
    glfwSetCharCallback(window, on_character);
    glfwSetCursorPosCallback(window, on_cursor);
    glfwSetScrollCallback(window, on_wheel);
    glfwSetWindowRefreshCallback(window, on_exposed);
    glfwSetFramebufferSizeCallback(window, on_resized);
}

void context_wait(const Context *context, Input *input)
{
    *input = (Input){.cursor = {input->cursor[0], input->cursor[1]}};
    if (glfwGetWindowUserPointer(context->window) == NULL) {
        listen(context->window, input);
    }
    glfwWaitEvents();
    input->close = input->close || glfwWindowShouldClose(context->window);
}

void context_framebuffer_size(const Context *context, int size[2])
{
    glfwGetFramebufferSize(context->window, &size[0], &size[1]);
}

void context_show(const Context *context, const char *title)
{
    glfwSwapBuffers(context->window);
    glfwSetWindowTitle(context->window, title);
}

void context_destroy(Context *context)
{
    if (context->window != NULL) {
        glfwDestroyWindow(context->window);
        glfwTerminate();
    } else {
        OSMesaDestroyContext(context->osmesa);
        free(context->pixels);
    }
    *context = (Context){0};
}
