// The check `errors`: how far the program's visibility is from each truth.
#ifndef ORACLE_ERRORS_H
#define ORACLE_ERRORS_H

#include <string>

#include "tests/oracle/dump/dump.h"

struct ErrorOptions {
    double rays = 256;      // of each average
    double light_size = 0;  // diameter, see area_truth; 0: none
    std::string write_into; // a folder, or empty
    // Of a point light: also rows NAME.seamAB, the pixels whose filter reaches
    // over the edge between faces A and B of the cube, and NAME.rest.
    bool seams = false;
    // Also rows chain.NAME: the error's sources, one substitution after the
    // other from the light's truth to the program (see chain.h). Their signed
    // differences add up to program minus light's truth on every pixel.
    bool chain = false;
    std::string pictures_in; // a folder, or empty
    bool lower = true;       // the row of the lower bound
    std::string keep_in;     // a folder for truths, see kept_truth.h; or empty
};

// Prints CSV: truth,pixels,apart,nonfinite,rmse,p99,max,share,mean. Counted are
// the pixels that show an object with N.L > 0; `apart` of them (silhouettes,
// N.L under 0.1) and the non-finite are in no other column; the share is that
// of errors over 1/255, the mean that of the signed errors. Writes
// truth.NAME.exr, error.NAME.exr and error.NAME.bin (bare floats), top row
// first; the error is 0 where it is not counted. As pictures: truth.png,
// result.png and difference.png (blue: too dark, red: too light) of the
// footprint's truth, else the area light's, else the hard one; where a pixel is
// not counted the truth's picture shows the program's value.
void print_errors(const Run &run, const ErrorOptions &options);

#endif
