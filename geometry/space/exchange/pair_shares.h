// What of the tolerance each pair of patches may take.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/space/prepared/element_table.h"

namespace hottel {

// The tolerance is on S of two holders (ElementTable3), relative to the smaller of their areas, into whatever patches
// covers, claims and solids cut them. Half of it is shared out by the product of the areas of two patches, half to all
// pairs of patches alike: so what is cut off a large face as a sliver is not held to the tolerance of the sliver.
//
//   (1) the shares of all pairs of patches of two holders are together allowed() at most; that of the only one is that
//   (2) of a pair of one holder with itself, those of all ordered pairs are
//
// The unit is that of PairIntegrator3.
class PairShares3 {
 public:
  // COST: a microsecond a patch. REQUIRES: the table is one of these vertices.
  PairShares3(const ElementTable3& table, const Vertices3& vertices, double tolerance);

  // What S of two holders may be off: the tolerance times the smaller area. The sky has none.
  double allowed(std::uint32_t i, std::uint32_t j) const;
  // What it may be off for one pair of patches.
  double share(const ElementTable3::Part& a, const ElementTable3::Part& b) const;
  // The smaller of both areas.
  double least_area(std::uint32_t i, std::uint32_t j) const;

 private:
  struct Holder {
    double area = 0;          // of what is not covered, as bounded from below
    double of_patches = 0;    // the area of all
    std::uint32_t count = 0;  // of patches, at most
  };
  double part_of_area(const ElementTable3::Part& part) const;

  const Vertices3& vertices_;
  double tolerance_;
  std::vector<Holder> holders_;  // the sky last
};

}  // namespace hottel
