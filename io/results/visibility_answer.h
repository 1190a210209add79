// What points and faces see, as it is told.
#pragma once

#include <string>

namespace hottel {

// One answer in two forms: a JSON object, and lines. Both end in a newline.
//
//   (1) a coordinate stands as the nearest double and exactly, a measure as the nearest double and in closed form
//   (2) a quotient stands as a double with bounds at most one ulp apart; null where the denominator is 0
struct VisibilityAnswer {
  std::string json, text;
};

}  // namespace hottel
