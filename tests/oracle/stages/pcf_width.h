// Step 2's width where it is not the same for every pixel.
#ifndef ORACLE_PCF_WIDTH_H
#define ORACLE_PCF_WIDTH_H

#include <vector>

#include "tests/oracle/dump/dump.h"

// --adaptive: the least odd number of texels that is not less than the longer
// axis of the ellipse that the pixel covers, 3 or more, and at most --kernel.
class PcfWidth
{
  public:
    explicit PcfWidth(const Run &run);

    // The width of pixel (x, y); two where rounding decides between them.
    std::vector<int> at(const Receiver &r, int x, int y, int map_width,
                        int map_height) const;

  private:
    int kernel_;
    Picture footprint_; // empty where every pixel has the same
};

#endif
