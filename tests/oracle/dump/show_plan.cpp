#include "tests/oracle/dump/show_plan.h"

#include <array>

#include "tests/oracle/dump/light.h" // facing, inside_map

// The legend is in the lowest rows.
static int legend_rows(int height)
{
    return 4 * (1 + height / 360) + 15 * (1 + height / 360);
}

static int in_map(const Run &run, const Receiver &receiver)
{
    return receiver.layer < int(run.views.size()) && inside_map(receiver);
}

// By its hue; -1: by none of the three.
static int shown_lookups(const Picture &image, int x, int y)
{
    float red = image.at(x, y, 0), blue = image.at(x, y, 2);
    if (red == blue && image.at(x, y, 1) == red)
        return 0;
    return red > 2 * blue ? 1 : blue > 2 * red ? 2 : -1;
}

void check_show_plan(const Run &run, bool none, int most, Report &report)
{
    Receivers receivers(run);
    Picture image = load_file(run, "image.exr", run.width, run.height, 3);
    std::array<size_t, 3> count = {0, 0, 0};
    size_t wrong = 0, all = 0;
    for (int y = legend_rows(run.height); y < run.height; y++)
        for (int x = 0; x < run.width; x++) {
            Receiver receiver = receivers.at(x, y);
            Facing side =
                receiver.shown
                    ? facing(receiver, run.views[size_t(receiver.layer)])
                    : Facing::AWAY;
            if (side == Facing::UNKNOWN)
                continue;
            int lookups = 0;
            if (side == Facing::TOWARDS && !none)
                lookups =
                    in_map(run, receiver) +
                    (receiver.share > 0 ? in_map(run, receiver.in_next()) : 0);
            all++;
            count[size_t(lookups)]++;
            wrong += shown_lookups(image, x, y) == lookups ? 0 : 1;
        }
    report.line(wrong == 0, "lookups as shown",
                "%zu of %zu pixels wrong; %zu need none, %zu one, %zu two",
                wrong, all, count[0], count[1], count[2]);
    report.line(100 * count[size_t(most)] > all, "lookups are to be shown",
                "up to %d", most);
}
