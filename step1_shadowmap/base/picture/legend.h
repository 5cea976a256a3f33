// What the colours of a --show picture mean, drawn into its corner.
#ifndef BASE_LEGEND_H
#define BASE_LEGEND_H

#include "step1_shadowmap/base/gl/gl.h" // Shaders

// One choice of --show.
typedef struct ShowMode {
    const char *name;
    const char *shader; // file that defines vec3 show(...)
    const char *scale;  // file that defines vec3 scale_color(float) for values
                        // from 0 to 1, which the legend shows; or NULL
    const char *legend; // what the scale means: "low .. what .. high"
    bool reads_map;     // every pixel looks the map up, lit or not
} ShowMode;

typedef struct Legend {
    Program *program; // NULL: no legend
    const char *text;
    int width, height; // of the picture, pixels
} Legend;

Legend legend_create(Shaders *shaders, const ShowMode *mode, int width,
                     int height);

// Draws over colour attachment 0 of the bound framebuffer.
void legend_draw(const Legend *legend, GLuint empty_vao);

#endif
