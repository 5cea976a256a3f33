#include "step1_shadowmap/base/seams/technique.h"

#include "step1_shadowmap/base/system/die.h" // die

void techniques_join(OptionTable tables[], int count)
{
    for (int i = 0; techniques[i] != NULL; i++) {
        if (count + 1 == OPTION_TABLES || i == TECHNIQUES_MAX) {
            die("more than %d techniques", i);
        }
        if (techniques[i]->options != NULL) {
            tables[count++] =
                options_table(techniques[i]->options, techniques[i]->settings);
        }
    }
}

static int count_techniques(void)
{
    int count = 0;
    while (techniques[count] != NULL) {
        count++;
    }
    return count;
}

void techniques_check(Frame *frame)
{
    for (int i = count_techniques() - 1; i >= 0; i--) {
        if (techniques[i]->check != NULL) {
            techniques[i]->check(frame);
        }
    }
}

void techniques_prepare(Frame *frame)
{
    for (int i = count_techniques() - 1; i >= 0; i--) {
        frame->technique[i] = techniques[i]->prepare(frame);
    }
}

void techniques_create(Frame *frame, Picture *picture)
{
    for (int i = 0; techniques[i] != NULL; i++) {
        if (frame->technique[i] && techniques[i]->create != NULL) {
            techniques[i]->create(frame, picture);
        }
    }
}

// Where nothing is looked up there is nothing to draw for it.
static bool draws(const Frame *frame, int i)
{
    return frame->technique[i] && (frame->looks_up || frame->dump != NULL);
}

void techniques_before(const Frame *frame)
{
    for (int i = 0; techniques[i] != NULL; i++) {
        if (draws(frame, i) && techniques[i]->before != NULL) {
            techniques[i]->before(frame);
        }
    }
}

void techniques_after(Frame *frame)
{
    for (int i = 0; techniques[i] != NULL; i++) {
        if (draws(frame, i) && techniques[i]->after != NULL) {
            techniques[i]->after(frame);
            frame_lap(frame, techniques[i]->pass);
        }
    }
}

void techniques_look(const Frame *frame, GLuint program)
{
    for (int i = 0; techniques[i] != NULL; i++) {
        if (frame->technique[i] && techniques[i]->look != NULL) {
            techniques[i]->look(frame, program);
        }
    }
}

bool techniques_shade(const Frame *frame, const Picture *picture)
{
    for (int i = 0; techniques[i] != NULL; i++) {
        if (frame->technique[i] && techniques[i]->shade != NULL) {
            techniques[i]->shade(frame, picture);
            return true;
        }
    }
    return false;
}
