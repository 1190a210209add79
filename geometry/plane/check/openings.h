// The narrow places through which space between surfaces opens to infinity.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/plane/arrangement/arrangement.h"
#include "geometry/plane/scene/scene.h"

namespace hottel {

// A place is called an opening when it is narrower than this part of the length of the walls behind it. It decides
// only what is worth telling.
inline constexpr double kOpeningPart = 1.0 / 8;

// A narrow place, in scene coordinates. It is a straight gap from one end to the other.
struct Opening2 {
  Point2 from, to;               // what bounds it: two vertices, or a vertex and the nearest point of an edge
  double part = 0;               // its width over the length of the walls behind it, about
  bool closes_the_room = false;  // nothing else leads out from behind it
};

// The openings of a scene. Of all ways from a side of a piece to infinity through the triangulation the one with the
// widest narrowest place is taken. Its narrow places lie one behind the other, each with less of the walls behind it;
// the opening is the outermost one that has no narrower one with at least half of its walls behind it.
//   (1) every opening is narrower than kOpeningPart of the walls behind it
//   (2) widths are in doubles and about right: they decide nothing but what is told
//   (3) its two ends are exact: a vertex, and a vertex or the nearest point of a piece
// COST: O(n log n) for n triangles.
class Openings2 {
 public:
  explicit Openings2(const Arrangement2& arrangement);

  const std::vector<Opening2>& all() const { return openings_; }
  // Returns the opening that separates a side of a piece from infinity, as an index into all(); nothing where none is
  // narrow, or no way leads out.
  std::optional<std::uint32_t> behind(PieceSideId side) const;

 private:
  std::vector<Opening2> openings_;
  std::vector<std::uint32_t> of_side_;
};

}  // namespace hottel
