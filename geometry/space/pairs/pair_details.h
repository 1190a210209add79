// What the measure of a pair of patches is made of.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/space/pieces/stretch_map.h"
#include "geometry/space/stretches/stretch.h"

namespace hottel {

// The stretches along which a pair is measured, in the order in which they were looked at, those with something seen.
//
//   (1) the measures of all pieces sum up to the measure along edges of the pair, but for rounding; each alone depends
//       on where moments are taken about, and may be negative
//   (2) t is that of the stretch: from + t (to - from)
//   (3) equal planes and labels of signatures mean the same within one pair, and nothing across pairs
struct PairDetails3 {
  // A direction in which what is seen has a corner: to a vertex, or where two edges, or where surfaces meet, cross.
  struct Corner {
    std::uint64_t label;                               // equal for equal ones of one pair
    std::optional<WeightedPoint3> vertex;              // else:
    std::vector<std::array<WeightedPoint3, 2>> edges;  // the ends of each
    std::vector<std::uint32_t> surfaces;               // whose own plane it is, or that cross each other there
    bool is_of_others = false;                         // some of it is not of the two patches alone
    std::vector<Direction3> ways;                      // at some t from low to high, evenly; of either sense
  };
  struct Piece {
    double low, high;                // of t
    std::uint32_t arcs;              // that bound what is seen
    double measure;                  // what it adds to S, as PairResult3
    std::vector<ArcEnd3> signature;  // as StretchPiece3
    std::vector<Corner> corners;     // where they are wanted
  };
  struct Stretch {
    StretchRole3 role;
    std::uint32_t patch;  // that it is on: 0 is i, 1 is j; 0 for outlines
    WeightedPoint3 from, to;
    std::vector<std::uint32_t> surfaces;  // whose closure contains it and that may stand between, ascending
    std::uint32_t relied = 0;             // polynomials of which signs were relied on
    std::vector<Piece> pieces;
  };

  // Surfaces that may stand between, with those that are one convex polygon with such a one, ascending.
  std::vector<std::uint32_t> between;
  std::vector<std::uint32_t> hiders;  // the same of one polygon that hides each point of a patch from all of the other
  bool wants_corners = false;
  std::uint32_t looked_at = 0;  // stretches, those along which nothing is seen too
  std::vector<Stretch> stretches;
};

}  // namespace hottel
