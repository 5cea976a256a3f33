// The interactive window: the picture on the screen, and a camera that the
// mouse and the keys move. main.c owns the loop:
//     while (window_next(&window, &camera)) { draw; window_show(...); }
#ifndef BASE_WINDOW_H
#define BASE_WINDOW_H

#include "step1_shadowmap/base/gl/context.h"         // Context, Input
#include "step1_shadowmap/base/picture/scene_draw.h" // SceneDraw
#include "step1_shadowmap/base/run/settings.h"       // BaseSettings
#include "step1_shadowmap/base/system/stopwatch.h"   // Stopwatch

typedef struct Window {
    const Context *context;
    const BaseSettings *settings;
    Program present; // from the linear picture to the screen
    GLuint empty_vao;
    char subject[80]; // of the title: the step and its main parameter
    Input input;
    double first_distance; // from camera to target; 0 before the first frame
    bool reload;           // the user wants the shaders read again
    bool shader_error;     // the last reload failed: the title says so
    bool save;             // the user wants the picture in a file
} Window;

// `subject` is a printf format for what the title says between the scene and
// the time. Both pointers have to stay valid.
Window window_create(const Context *context, const BaseSettings *settings,
                     const char *subject, ...)
    __attribute__((format(printf, 3, 4)));

// Waits until there is another frame to draw (the first time there is) and
// moves the camera as the user asked. Sets `reload` where the shaders are to be
// read again before it is drawn. False: the user closes the window.
bool window_next(Window *window, Camera *camera);

// Shows the picture, with the time of its passes in the title; writes it to
// --output if the user asked for that.
void window_show(const Window *window, const SceneDraw *picture,
                 const Stopwatch *stopwatch);

// Ends a reload: if the stages' shaders compiled, the window's own are compiled
// again as well. The title says so if one did not.
void window_reload(Window *window, bool compiled);

void window_destroy(Window *window);

#endif
