// The oracle: recomputes what a program dumped, from the formulas and the
// scene table alone, and says PASS or FAIL line by line. It knows nothing of
// the programs' code. Exit status 0: no FAIL, 1: some, 2: bad usage or input.

#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "tests/oracle/lib/arguments.h"
#include "tests/oracle/checks/compare.h"
#include "tests/oracle/closed/disc.h"
#include "tests/oracle/dump/dump.h"
#include "tests/oracle/checks/errors.h"
#include "tests/oracle/dump/files.h"
#include "tests/oracle/dump/looked_up.h"
#include "tests/oracle/checks/lower.h"
#include "tests/oracle/closed/matrix.h"
#include "tests/oracle/filters/mip_levels.h"
#include "tests/oracle/dump/overlap.h"
#include "tests/oracle/closed/penumbra.h"
#include "tests/oracle/rays/ray_checks.h"
#include "tests/oracle/dump/scene_table.h"
#include "tests/oracle/lib/serve.h"
#include "tests/oracle/checks/shading.h"
#include "tests/oracle/dump/show_plan.h"
#include "tests/oracle/checks/stability.h"
#include "tests/oracle/stages/stage.h"
#include "tests/oracle/truths/truth_checks.h"
#include "tests/oracle/closed/two_depths.h"

static const char *const USAGE =
    "usage: oracle CHECK DIR [key=value ...]\n"
    "  files    every file is there, finite and in range\n"
    "  stage    each stage against its own input files\n"
    "  lower    step 5: p_max is not below the lit share of the texels\n"
    "  matrix   positions, the light's view and the camera\n"
    "  rays     depths, positions and visibility against ray casting\n"
    "  bias     what a depth bias leaves and takes (steps 1, 2): the share\n"
    "           of the lit pixels that is dark [acne-least=0] [acne-most=1],\n"
    "           of those in shadow that is not [lost-least=0] [lost-most=1]\n"
    "  looked-up  the texels that run.json says are looked up, against the\n"
    "           pixels that do [most=1]: how many times as many as these need\n"
    "  plan     --show plan: which pixels have to look a map up [none=1] none\n"
    "           [most=1]: as many as some need\n"
    "  shading  the picture from positions, normals and visibility\n"
    "  edge     scene edge: visibility is the lit share (steps 1, 2, 5)\n"
    "  bleed    scene bleed: the worst light bleeding (r=R, the gaps' ratio)\n"
    "  penumbra scene edge, --soft: its width follows the light's size\n"
    "  umbra    scene bleed, --hybrid: full shadow is black\n"
    "  errors   CSV of visibility against every truth [rays=256] [write=DIR]\n"
    "           [light-size=X], the light's diameter in world units; of a\n"
    "           directional one at a distance of 1, [seams=1] of a cube "
    "apart,\n"
    "           [chain=1] where the error comes from, [lower=0] without that\n"
    "           bound, [keep=DIR] truths from and for other runs,\n"
    "           [pictures=DIR] truth, result and difference as PNG\n"
    "  stability  CSV of what the numbers have lost, and of its bound\n"
    "  truths   the truths themselves where they are known: scenes edge,\n"
    "           bleed, empty, teapot:elevation=90 [rays=256] [light-size=0.2]\n"
    "  disc     step 2 --pattern poisson against grid=DIR, a dump of the "
    "grid\n"
    "  overlap  the same splits' maps under another camera (other=DIR)\n"
    "  compare  A B [max=0] [share=1]: two picture files\n"
    "  serve    SECONDS: answers such words, one line each, separated by "
    "tabs\n";

using Words = std::vector<std::string>;

// These checks need a kernel that is a product of one for each axis and the
// same for every pixel.
static Run load_separable(const std::string &folder)
{
    Run run = load_run(folder);
    const Settings &s = run.settings;
    if (s.poisson || s.adaptive || s.soft)
        throw BadInput(folder +
                       ": not for --pattern poisson, --adaptive or --soft");
    return run;
}

static void run_slopes(const Run &run, Report &report)
{
    SceneTable table(run.scene, run.light);
    RayScene rays(table.scene, run.origin);
    double extent = scene_extent(table.scene, run.origin);
    for (size_t layer = 0; layer < run.views.size(); layer++)
        check_slope(run, rays, extent, int(layer), report);
}

static void run_stages(const Run &run, Report &report)
{
    size_t maps = run.settings.shadows ? run.views.size() : 0;
    for (size_t layer = 0; layer < maps; layer++) {
        if (run.step >= 3)
            check_moments(run, int(layer), report);
        if (run.settings.msaa > 1)
            check_resolve(run, int(layer), report);
        if (run.step >= 4)
            check_blur(run, int(layer), report);
        if (run.settings.mips)
            check_mips(run, int(layer), report);
    }
    if (run.settings.slope_term)
        run_slopes(run, report);
    bool mips = run.settings.mips && !run.settings.soft;
    if (mips || run.settings.adaptive_box || run.settings.adaptive)
        check_footprint(run, report);
    check_visibility(run, report);
}

static void run_matrices(const Run &run, Report &report)
{
    SceneTable table(run.scene, run.light);
    check_receiver(run, report);
    for (size_t layer = 0; layer < run.views.size(); layer++)
        check_view(run, table, int(layer), report);
    if (run.settings.soft)
        check_soft_border(run, report);
    check_camera(run, table, report);
}

static void run_rays(const Run &run, Report &report)
{
    SceneTable table(run.scene, run.light);
    RayScene rays(table.scene, run.origin);
    double extent = scene_extent(table.scene, run.origin);
    for (size_t layer = 0; layer < run.views.size(); layer++)
        if (run.settings.msaa > 1)
            check_sample_depths(run, rays, extent, int(layer), report);
        else
            check_ray_depths(run, rays, extent, int(layer), report);
    check_ray_positions(run, table.scene, rays, extent, report);
    check_ray_visibility(run, table.scene, rays, extent, report);
}

static Share share_of(const Arguments &arguments, const std::string &name)
{
    return {arguments.number(name + "-least", 0),
            arguments.number(name + "-most", 1)};
}

static void run_bias(const std::string &folder, const Words &words,
                     Report &report)
{
    Arguments arguments(words,
                        {"acne-least", "acne-most", "lost-least", "lost-most"});
    Run run = load_run(folder);
    SceneTable table(run.scene, run.light);
    RayScene rays(table.scene, run.origin);
    check_bias(run, table.scene, rays, scene_extent(table.scene, run.origin),
               {share_of(arguments, "acne"), share_of(arguments, "lost")},
               report);
}

static void run_shading(const Run &run, Report &report)
{
    SceneTable table(run.scene, run.light);
    RayScene rays(table.scene, run.origin);
    double extent = scene_extent(table.scene, run.origin);
    check_shading(run, table.scene, rays, extent, report);
}

// Prints a table instead of lines that pass or fail.
static void run_errors(const std::string &folder, const Words &words)
{
    Arguments arguments(words, {"rays", "light-size", "write", "seams", "chain",
                                "lower", "keep", "pictures"});
    ErrorOptions options;
    options.chain = arguments.number("chain", 0) != 0;
    options.lower = arguments.number("lower", 1) != 0;
    options.keep_in = arguments.text("keep", "");
    options.pictures_in = arguments.text("pictures", "");
    options.seams = arguments.number("seams", 0) != 0;
    options.rays = arguments.number("rays", options.rays);
    options.light_size = arguments.number("light-size", 0);
    if (arguments.given("light-size") && !(options.light_size > 0))
        throw BadInput("light-size: more than 0");
    options.write_into = arguments.text("write", "");
    print_errors(load_run(folder), options);
}

static void run_truths(const std::string &folder, const Words &words,
                       Report &report)
{
    Arguments arguments(words, {"rays", "light-size"});
    double size = arguments.number("light-size", 0.2);
    if (!(size > 0))
        throw BadInput("light-size: more than 0");
    check_truths(load_separable(folder), arguments.number("rays", 256), size,
                 report);
}

static void run_check(const std::string &check, const std::string &folder,
                      const Words &words, Report &report)
{
    bool bleed = check == "bleed", disc = check == "disc";
    bool overlap = check == "overlap", looked_up = check == "looked-up";
    bool plan = check == "plan";
    Arguments arguments(words, bleed       ? Words{"r"}
                               : disc      ? Words{"grid"}
                               : overlap   ? Words{"other"}
                               : looked_up ? Words{"most"}
                               : plan      ? Words{"none", "most"}
                                           : Words{});
    Run run = load_run(folder);
    if (check == "files") {
        check_files(run, report);
    } else if (check == "stage") {
        run_stages(run, report);
    } else if (check == "lower") {
        check_lower(run, report);
    } else if (check == "matrix") {
        run_matrices(run, report);
    } else if (check == "penumbra") {
        check_penumbra(run, SceneTable(run.scene, run.light), report);
    } else if (check == "umbra") {
        check_umbra(run, SceneTable(run.scene, run.light), report);
    } else if (check == "rays") {
        run_rays(run, report);
    } else if (check == "shading") {
        run_shading(run, report);
    } else if (check == "edge") {
        check_edge(load_separable(folder), SceneTable(run.scene, run.light),
                   report);
    } else if (looked_up) {
        check_looked_up(run, arguments.number("most", 1), report);
    } else if (plan) {
        bool none = arguments.number("none", 0) != 0;
        int most = int(arguments.number("most", none ? 0 : 1));
        check_show_plan(run, none, most, report);
    } else if (overlap) {
        check_overlap(run, load_run(arguments.text("other", "")), report);
    } else if (disc) {
        check_disc(run, load_run(arguments.text("grid", "")), report);
    } else if (bleed) {
        double r = arguments.number("r", -1);
        if (r <= 0)
            throw BadInput("bleed needs r=R, the ratio of the gaps");
        check_bleed(run, SceneTable(run.scene, run.light), r, report);
    } else {
        throw BadInput("no check '" + check + "'");
    }
}

static void run_compare(const Words &words, Report &report)
{
    if (words.size() < 2)
        throw BadInput("compare needs two files");
    Arguments arguments(Words(words.begin() + 2, words.end()),
                        {"max", "share"});
    compare_pictures(words[0], words[1], arguments.number("max", 0),
                     arguments.number("share", 1), report);
}

// One check; the exit status.
static int answer(const Words &given)
{
    std::string check = given[0];
    Words words(given.begin() + 1, given.end());
    Words rest(given.begin() + 2, given.end());
    Report report;
    try {
        if (check == "errors") {
            run_errors(words[0], rest);
            return 0;
        }
        if (check == "stability") {
            Arguments(rest, {});
            print_stability(load_separable(words[0]));
            return 0;
        }
        if (check == "compare")
            run_compare(words, report);
        else if (check == "truths")
            run_truths(words[0], rest, report);
        else if (check == "bias")
            run_bias(words[0], rest, report);
        else
            run_check(check, words[0], rest, report);
    } catch (const std::exception &error) {
        std::fprintf(stderr, "oracle: %s\n", error.what());
        return 2;
    }
    return report.all_passed() ? 0 : 1;
}

int main(int count, char **values)
{
    Words words(values + 1, values + count);
    if (words.size() == 2 && words[0] == "serve")
        return serve(words[1], answer);
    if (words.size() < 2) {
        std::fputs(USAGE, stderr);
        return 2;
    }
    return answer(words);
}
