// The ends of a colour bar, from values and how much of the area has them.
#pragma once

#include <optional>
#include <vector>

#include "viewer/picture/picture_options.h"

namespace hottel {

// The ends of a scale that were asked for. Values beyond have the colour of its end.
struct AskedScale {
  std::optional<double> lower{}, upper{};  // nothing: that of the values
  bool is_logarithmic = false;
  friend bool operator==(const AskedScale&, const AskedScale&) = default;
};

// A value, and how much has it.
struct AreaValue {
  double value = 0, area = 1;
};

// A scale for values, and the least and the greatest of them all.
struct FittedScale {
  ColourScale scale;
  double least = 0, greatest = 0;
};

// Values that a scale does not tell apart.
struct ScaleSense {
  bool has_sign = false;  // colours part at 0
  double noise = 0;       // of what has a sign: what is not farther from 0 is 0
};

// The share of the area that may lie beyond an end that is cut once, and how often an end may be cut.
inline constexpr double kCutShare = 0.05;
inline constexpr int kCuts = 4;

// Returns the scale of values.
//
//   (1) its ends are the least and the greatest value. An end is cut to the value beyond which lies k times kCutShare
//       of the area or less, where what is cut off is more than k times as long as all from there to the value beyond
//       which lies kCutShare at the other end, for the least k from 1 to kCuts with which it is: lamps do not flatten a
//       room, the larger they are the more they must stand out, and what has no lamp is shown whole
//   (2) of what has a sign the ends are as far from 0: as the farthest value, or cut by the same rule of distances
//       from 0, in either direction
//   (3) values that six digits do not tell apart have one colour: the scale is empty then (lower == upper), and
//       nothing is cut to such a one. Roundings make no pattern
//   (4) a logarithmic scale runs from the least value above 0 to the greatest, and is not cut
//   (5) ends that were asked for win; of what has a sign, one that was left out is as far on the other side of 0
//   (6) cuts_lower and cuts_upper say whether values lie beyond the ends
// REQUIRES finite values, areas >= 0; where all are 0, every value counts alike. COST: n log n.
FittedScale fitted_scale(std::vector<AreaValue> values, const AskedScale& asked, const ScaleSense& sense);

}  // namespace hottel
