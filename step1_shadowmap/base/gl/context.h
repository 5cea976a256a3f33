// The OpenGL context, off-screen or in a window, and what the window's user
// does. The only file that knows OSMesa and GLFW.
#ifndef BASE_CONTEXT_H
#define BASE_CONTEXT_H

#include <stdbool.h>

typedef struct Context {
    struct osmesa_context *osmesa; // NULL with a window
    unsigned char *pixels;     // the default framebuffer that OSMesa insists on
    struct GLFWwindow *window; // NULL off-screen
} Context;

// An OpenGL 3.3 core context, made current, with the GL functions loaded and
// every GL error fatal: of a window whose inside is `size` pixels, or without
// one. Dies where there is none, or no display for a window.
Context context_create(bool window, const int size[2]);

enum { INPUT_MAX_TYPED = 16 };

// What the user did to the window.
typedef struct Input {
    bool close;     // escape, or the window's own button
    bool exposed;   // what the window shows was lost, or its size has changed
    double drag[2]; // with the left button: to the right and down, pixels
    double wheel;   // notches away from the user
    int arrows[2];  // arrow keys: to the right and down
    char typed[INPUT_MAX_TYPED]; // other keys, ASCII, small letters; 0 at the
                                 // end
    double cursor[2]; // where the pointer is, from the window's top left
} Input;

// Waits until something happens to the window; then `input` holds all that
// happened since the last call. To be called with the same `input` each time.
void context_wait(const Context *context, Input *input);

// Width and height of the window's framebuffer: more than its size where the
// system scales it up.
void context_framebuffer_size(const Context *context, int size[2]);

// Brings what was drawn into framebuffer 0 to the window, then sets its title.
void context_show(const Context *context, const char *title);

void context_destroy(Context *context);

#endif
