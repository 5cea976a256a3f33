// A lesson that was copied alone: no techniques take part.
#include "step1_shadowmap/base/picture/picture.h"

#define UNLESS_LINKED __attribute__((weak))

UNLESS_LINKED void techniques_join(OptionTable tables[], int count)
{
    (void)tables, (void)count;
}

UNLESS_LINKED void techniques_check(Frame *frame)
{
    (void)frame;
}

UNLESS_LINKED void techniques_prepare(Frame *frame)
{
    (void)frame;
}

UNLESS_LINKED void techniques_create(Frame *frame, Picture *picture)
{
    (void)frame, (void)picture;
}

UNLESS_LINKED void techniques_before(const Frame *frame)
{
    (void)frame;
}

UNLESS_LINKED void techniques_after(Frame *frame)
{
    (void)frame;
}

UNLESS_LINKED void techniques_look(const Frame *frame, GLuint program)
{
    (void)frame, (void)program;
}

UNLESS_LINKED bool techniques_shade(const Frame *frame, const Picture *picture)
{
    (void)frame, (void)picture;
    return false;
}
