// The continuous kernel that a step's filter stands for, along one axis.
#ifndef ORACLE_AXIS_KERNEL_H
#define ORACLE_AXIS_KERNEL_H

#include <vector>

#include "tests/oracle/dump/dump.h"

// Step 1: the box of one texel. Step 2: the box of its n texels; bilinear:
// and another of one texel over it. Steps 3 to 5: the blur's weights, over the
// box of one texel and the tent of the bilinear lookup (two boxes), all in
// texels of the downsampled map.
class AxisKernel
{
  public:
    AxisKernel(int step, const Settings &settings);

    // Where the share s of the kernel's weight lies to the left: map texels
    // from the receiver. Right to 1/256 texel: it is a table.
    double quantile(double s) const;

    double half_width() const; // in map texels

  private:
    double cell_, first_; // in map texels: of the table, and its left end
    std::vector<double> cumulative_; // at the right end of each cell
};

#endif
