#include "step1_shadowmap/base/context.h"

// glad before osmesa.h: both define the GL types.
#include <glad/gl.h>

#include <GL/osmesa.h>
#include <stddef.h> // NULL
#include <stdlib.h> // free

#include "step1_shadowmap/base/die.h" // die, allocate
#include "step1_shadowmap/base/gl.h"  // gl_load

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

Context context_create(void)
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

void context_destroy(Context *context)
{
    OSMesaDestroyContext(context->osmesa);
    free(context->pixels);
    *context = (Context){0};
}
