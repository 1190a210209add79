// A pair of elements that a method gets most wrong, and what makes it hard.
#pragma once

#include <optional>
#include <string>

#include "solver/compare/matrix_errors.h"

namespace hottel {

// How much of a pair is hidden, how near and at what angle its elements are: why a method may find it hard. Numbers are
// for people: rounded, without bounds.
struct PairExplanation {
  std::optional<double> visibility;  // S / S0; nothing when they do not face each other. Of the sky: its factor
  std::optional<double> distance;    // between their middles [scene unit]; nothing of the sky
  std::optional<double> angle;       // between their normals [degrees], 180 when they look at each other
  std::string reason;                // in words, e.g. "partly hidden, touching"
};

// A pair that a method gets most wrong, with its elements by name; "sky" for the sky.
struct ExplainedPair {
  std::string method, from, to;
  PairError error;
  PairExplanation explanation;
};

}  // namespace hottel
