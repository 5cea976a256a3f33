// The disc of step 2's --pattern poisson: where its taps are.
#ifndef ORACLE_POISSON_DISC_H
#define ORACLE_POISSON_DISC_H

#include <array>
#include <glm/glm.hpp>

constexpr int POISSON_TAPS = 32;

// The taps of pixel (x, y), counted from below, in the unit disc: 32 fixed
// points, turned by one of 16 multiples of 22.5 degrees.
std::array<glm::dvec2, POISSON_TAPS> poisson_taps(int x, int y);

#endif
