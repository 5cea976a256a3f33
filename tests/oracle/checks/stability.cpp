#include "tests/oracle/checks/stability.h"

#include <cmath>  // abs
#include <cstdio> // printf
#include <filesystem>

#include "tests/oracle/closed/matrix.h"   // receiver_depth
#include "tests/oracle/rays/ray_checks.h" // compare_ray_depths
#include "tests/oracle/checks/stability_rows.h"
#include "tests/oracle/stages/stage.h" // for_each_expected

// t as the shader had it, from the position that it had.
static StabilityRow receiver_row(const Run &run)
{
    Receivers receivers(run);
    StabilityRow row{"receiver"};
    for (int y = 0; y < run.height; y++)
        for (int x = 0; x < run.width; x++) {
            Receiver r = receivers.at(x, y);
            if (!r.shown)
                continue;
            row.all++;
            Interval t = receiver_depth(run.views[size_t(r.layer)], r.position);
            row.add(std::abs(r.t - (t.lo + t.hi) / 2), t.width() / 2);
        }
    return row;
}

static StabilityRow depth_row(const Run &run)
{
    SceneTable table(run.scene, run.light);
    RayScene rays(table.scene, run.origin);
    double extent = scene_extent(table.scene, run.origin), rounding = 0;
    StabilityRow row{"depth"};
    for (size_t layer = 0; layer < run.views.size(); layer++) {
        RayComparison count = compare_ray_depths(run, rays, extent, int(layer),
                                                 DepthTest::ROUNDED, rounding);
        row.all += count.all();
        if (count.agrees > 0)
            row.add(count.error, count.allowed);
        row.compared += count.agrees - (count.agrees > 0 ? 1 : 0);
        if (count.differs > 0) // from all surfaces that it may be of
            row.add(1, 0);
    }
    return row;
}

// Where rounding decides a comparison, both answers are right: not compared.
static StabilityRow visibility_row(const Run &run)
{
    StabilityRow row{"visibility"};
    for_each_expected(run, [&](const Receiver &r, Interval truth) {
        row.all += r.shown ? 1 : 0;
        if (r.shown && !(truth.width() > 0.01))
            row.add(std::abs(r.visibility - (truth.lo + truth.hi) / 2),
                    truth.width() / 2);
    });
    return row;
}

static size_t non_finite(const Run &run)
{
    size_t count = 0;
    for (const auto &file : std::filesystem::directory_iterator(run.folder))
        if (file.path().extension() == ".exr")
            count += count_non_finite(load_picture(file.path().string()));
    return count;
}

static void print(StabilityRow row, size_t bad)
{
    if (row.compared == 0) {
        row.error = row.open_error;
        row.bound = row.open_bound;
    }
    std::printf("%s,%zu,%zu,%.3g,%.3g,%.3g,", row.quantity.c_str(),
                row.compared, row.all, row.error, row.bound, row.ratio);
    if (row.searched >= 0)
        std::printf("%.3g", row.searched);
    std::printf(",%zu,%.3g\n", bad, row.below);
}

void print_stability(const Run &run)
{
    size_t bad = non_finite(run);
    std::printf("quantity,compared,all,error,bound,ratio,searched,nonfinite,"
                "below\n");
    if (run.step == 1) {
        print(receiver_row(run), bad);
        print(depth_row(run), bad);
    }
    if (run.step == 2)
        print(visibility_row(run), bad);
    if (run.step == 3 || run.step == 4)
        print(variance_row(run), bad);
    if (run.step == 5)
        print(p_row(run), bad);
}
