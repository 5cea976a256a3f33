// The OpenGL context. The only file that knows OSMesa.
#ifndef BASE_CONTEXT_H
#define BASE_CONTEXT_H

typedef struct Context {
    struct osmesa_context *osmesa;
    unsigned char *pixels; // the default framebuffer that OSMesa insists on
} Context;

// An OpenGL 3.3 core context without a window, made current, with the GL
// functions loaded and every GL error fatal. Dies where there is none.
Context context_create(void);

void context_destroy(Context *context);

#endif
