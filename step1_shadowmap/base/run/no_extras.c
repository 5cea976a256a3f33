// A run without the rooms of extras.h: everything is drawn, once.
#include "step1_shadowmap/base/run/extras.h"

#define UNLESS_LINKED __attribute__((weak))

static const Option none[] = {{0}};

UNLESS_LINKED OptionTable leave_out_options(BaseSettings *settings)
{
    (void)settings;
    return options_table(none, NULL);
}

UNLESS_LINKED void leave_out_look(Frame *frame)
{
    const ViewsSize size = base_views_size(&frame->settings);
    views_fit(&frame->views, &frame->scene, &size, frame->lookups.reach);
    frame->looks_up = true;
}

UNLESS_LINKED void leave_out_begin(Frame *frame, bool anew)
{
    (void)frame, (void)anew;
}

UNLESS_LINKED bool leave_out_nothing(Frame *frame)
{
    (void)frame;
    return true;
}

UNLESS_LINKED OptionTable bench_options(void)
{
    return options_table(none, NULL);
}

UNLESS_LINKED void bench_check(Frame *frame)
{
    (void)frame;
}

UNLESS_LINKED bool bench_next(Frame *frame, int drawn)
{
    (void)frame;
    return drawn == 0;
}

UNLESS_LINKED void bench_print(void)
{
}

UNLESS_LINKED void measure_dump(const Frame *frame)
{
    (void)frame;
}
