// Truths that took long to make, kept in files between runs: many techniques
// have the same filter, and so the same truth.
#ifndef ORACLE_KEPT_TRUTH_H
#define ORACLE_KEPT_TRUTH_H

#include <functional>
#include <string>

#include "tests/oracle/lib/picture.h"
#include "tests/oracle/truths/truth.h"

// The value, how far it can be below and above, and 1 where it is apart.
constexpr int TRUTH_CHANNELS = 4;

class KeptTruths
{
  public:
    // In `folder`; empty: nothing is kept, and nothing of a filter whose width
    // each pixel chooses. The folder is for one build of the oracle: a file
    // does not know which code made it.
    KeptTruths(const TruthScene &scene, const std::string &folder);

    // The truth `name`, with `details` besides everything that a run may have
    // to do with it: from its file, or made, and kept where that is possible.
    // The same values either way, to the last bit.
    Picture find(const std::string &name, const std::string &details,
                 const std::function<Picture()> &make) const;

  private:
    const Run &run_;
    std::string folder_, key_;
};

#endif
