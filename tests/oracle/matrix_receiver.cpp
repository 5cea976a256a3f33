#include <algorithm> // max
#include <cmath>     // abs

#include "tests/oracle/matrix.h"
#include "tests/oracle/rounding.h"

// One row times (p, 1): each entry rounded to float, three products, three
// sums; 5 roundings on any one term.
static double excess(const glm::dvec4 &row, const glm::dvec3 &p, double value,
                     double &worst)
{
    double exact = row.w, size = std::abs(row.w);
    for (int i = 0; i < 3; i++) {
        exact += row[i] * p[i];
        size += std::abs(row[i] * p[i]);
    }
    double error = std::abs(value - exact);
    worst = std::max(worst, error);
    return error - rounding_share(5) * size;
}

void check_receiver(const Run &run, Report &report)
{
    Receivers receivers(run);
    size_t wrong = 0, shown = 0;
    double worst = 0;
    for (int y = 0; y < run.height; y++)
        for (int x = 0; x < run.width; x++) {
            Receiver r = receivers.at(x, y);
            if (!r.shown)
                continue;
            const auto &rows = run.views[size_t(r.layer)].rows;
            double most = excess(rows[0], r.position, r.u, worst);
            most = std::max(most, excess(rows[1], r.position, r.v, worst));
            most = std::max(most, excess(rows[2], r.position, r.t, worst));
            shown++;
            wrong += most <= 0 ? 0 : 1;
        }
    report.line(wrong == 0, "receiver = map_from_relative * position",
                "%zu of %zu pixels outside the rounding, worst %.3g", wrong,
                shown, worst);
}
