// Points for averages by ray casting: stratified, from a fixed seed, the same
// on every machine.
#ifndef ORACLE_STRATA_H
#define ORACLE_STRATA_H

#include <glm/glm.hpp>
#include <vector>

// One pattern: a point in each of m x m cells of the unit square.
using Pattern = std::vector<glm::dvec2>;

// Different patterns, so that neighbouring pixels do not repeat one error.
class Strata
{
  public:
    // Throws BadInput when `rays` is not the square of a whole number m > 1.
    explicit Strata(double rays);

    const Pattern &at(int x, int y) const;
    std::vector<Pattern> &all()
    {
        return patterns_;
    }

  private:
    std::vector<Pattern> patterns_;
};

// From the unit square to the unit disc, equal areas to equal areas (Shirley
// and Chiu, A Low Distortion Map Between Disk and Square, 1997).
glm::dvec2 disc_point(const glm::dvec2 &square);

// The error of the mean over m x m strata of a function that is 0 on one side
// of an edge and 1 on the other. Only the strata which the edge crosses, at
// most `crossed` m of them, have an error, each a coin of variance at most
// 1/4: a standard deviation of sqrt(crossed m) / (2 m^2).
double strata_deviation(double rays, double crossed);

#endif
