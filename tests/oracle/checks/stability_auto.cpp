#include "tests/oracle/checks/stability_auto.h"

#include <cmath> // sqrt

#include "tests/oracle/filters/chebyshev_bound.h" // depth_noise
#include "tests/oracle/stages/guard.h"            // guard_of

static double cantelli(double variance, double behind)
{
    return behind > 0 ? variance / (variance + behind * behind) : 1;
}

static double raw(const Guard &guard, double t, const MostComputed &most)
{
    double variance =
        most.variance + guard.variance * most.m2 + guard.variance_fixed;
    double mean = most.mean * (1 + guard.mean) + guard.mean_fixed;
    return cantelli(variance, t - mean);
}

static double central(const Guard &guard, double noise, double t,
                      const MostComputed &most)
{
    double deviation = std::sqrt(most.variance + guard.variance_fixed);
    double spread = guard.spread * deviation;
    double mean = most.mean + guard.mean * rounded_part(most.mean) + spread +
                  guard.mean_fixed;
    deviation += spread + guard.variance * rounded_part(std::sqrt(most.m2)) +
                 guard.mean_fixed;
    return cantelli(deviation * deviation + noise * noise, t - mean);
}

MostWithAuto most_with_auto(const Run &run)
{
    Guard guard = guard_of(run);
    return [&run, guard](const Receiver &r, const MostComputed &most) {
        if (!run.settings.central)
            return raw(guard, r.t, most);
        double noise = depth_noise(run.views[size_t(r.layer)], r.position);
        return central(guard, noise, r.t, most);
    };
}
