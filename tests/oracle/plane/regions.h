// The connected parts of the plane without some pieces, by cutting it into trapezoids. Rational coordinates, nothing
// shared with what it checks.
#pragma once

#include <gmpxx.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace hottel::oracle {

// From a to b, the smaller point first. Pieces given together have disjoint interiors and no end inside another.
struct Stretch {
  std::pair<mpq_class, mpq_class> a, b;
};

struct Region {
  bool is_bounded;
  std::pair<mpq_class, mpq_class> inside;  // a point of it, straight above or below no vertex
};

// The regions, and on which of them each side of each piece looks.
struct Regions {
  std::vector<Region> all;
  std::vector<std::size_t> left, right;  // by piece
};

// Cuts the plane along the vertical through every vertex. Between two of them the pieces divide it into trapezoids; two
// trapezoids are of one region iff they touch along a vertical where no piece lies. COST: O(n^2) for n pieces.
Regions regions_of(const std::vector<Stretch>& pieces);

}  // namespace hottel::oracle
