// Where two faces of a point light's cube meet.
#ifndef ORACLE_SEAM_H
#define ORACLE_SEAM_H

#include "tests/oracle/dump/dump.h"

// The nearest edge of the 90 degrees that a receiver's face answers for.
struct Seam {
    double texels; // from the receiver, along u or v
    int face;      // on the other side: +x, -x, +y, -y, +z, -z
};

// Throws BadInput for a light that is no point light.
Seam nearest_seam(const Receiver &receiver, const MapView &view);

#endif
