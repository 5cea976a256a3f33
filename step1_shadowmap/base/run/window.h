// The interactive window: the picture on the screen, and a camera that the
// mouse and the keys move.
#ifndef BASE_WINDOW_H
#define BASE_WINDOW_H

#include "step1_shadowmap/base/gl/context.h"      // Context, Input
#include "step1_shadowmap/base/picture/picture.h" // Picture

typedef struct Window {
    const Context *context;
    Program *present; // from the linear picture to the screen
    char subject[80]; // of the title: the step and its main parameter
    Input input;
    double first_distance; // from camera to target; 0 before the first frame
    bool reload;           // the user wants the shaders read again
    bool shader_error;     // the last reload failed: the title says so
    bool save;             // the user wants the picture in a file
} Window;

// `subject` is what the title says between the scene and the time. The context
// has to stay where it is.
Window window_create(const Context *context, Shaders *shaders,
                     const char *subject);

// Waits until there is another frame to draw (the first time there is) and
// moves the camera as the user asked. Sets `reload` where the shaders are to be
// read again before it is drawn. False: the user closes the window.
bool window_next(Window *window, const BaseSettings *settings, Camera *camera);

// Shows the picture, with the time of its passes in the title; writes it to
// --output if the user asked for that.
void window_show(const Window *window, const Frame *frame,
                 const Picture *picture);

#endif
