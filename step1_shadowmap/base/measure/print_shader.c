// --print-shader: what the compiler is given.
#include <stdio.h>  // printf
#include <stdlib.h> // exit, free

#include "step1_shadowmap/base/gl/shader_file.h" // shader_read
#include "step1_shadowmap/base/run/extras.h"     // measure_print_shader
#include "step1_shadowmap/base/system/die.h"     // die, printed_check

// The stage that this file is compiled in: that of the last one.
static GLenum stage_from(const char *const files[])
{
    while (shader_stage(*files) == 0) {
        files++;
    }
    return shader_stage(*files);
}

static const char *stage_name(GLenum stage)
{
    return stage == GL_VERTEX_SHADER     ? "vertex"
           : stage == GL_GEOMETRY_SHADER ? "geometry"
                                         : "fragment";
}

// As it is compiled, stage by stage: the version, the constants, and each
// file's name and text.
static void print(const Program *program)
{
    bool begins = true;
    for (const char *const *name = program->files; *name != NULL; name++) {
        char message[SHADER_MESSAGE_BYTES];
        char *text = shader_read(program->shaders->directory, *name, message);
        if (text == NULL) {
            die("%s", message);
        }
        if (begins) {
            printf("// ==== %s shader ====\n\n", stage_name(stage_from(name)));
            printf("%s%s\n\n", shader_version(stage_from(name)),
                   program->constants);
        }
        printf("// ---- %s ----\n\n%s\n", *name, text);
        free(text);
        begins = shader_stage(*name) != 0;
    }
}

void measure_print_shader(const Frame *frame, const Program *program)
{
    if (frame->settings.print_shader) {
        print(program);
        printed_check();
        exit(0);
    }
}
