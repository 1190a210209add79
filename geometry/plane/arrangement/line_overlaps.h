// Segments that cover each other: told apart before they meet others.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/plane/arrangement/segment.h"
#include "geometry/plane/predicates/vertices.h"

namespace hottel {

// Segments with the same two ends, gathered; a segment and its reverse count as the same.
//
//   (1) every segment is a member of one group
//   (2) groups are in the order of their first members; members ascend
class EqualSegments2 {
 public:
  explicit EqualSegments2(const std::vector<Segment2>& segments);  // COST: O(n log n)

  std::size_t size() const { return begin_.size() - 1; }
  std::span<const std::uint32_t> members(std::size_t group) const {  // ascending, not empty
    return {members_.data() + begin_[group], members_.data() + begin_[group + 1]};
  }

 private:
  std::vector<std::uint32_t> members_, begin_;
};

// A part of a line and the segments that cover it, ascending.
struct CoveredSegment2 {
  Segment2 segment;
  std::vector<std::uint32_t> sources;
};

// Cuts segments wherever another one on the same line begins or ends inside them.
//
//   (1) no two of the results share more than a point of one line; each is covered by every source from end to end
//   (2) every given segment is the union of the results that name it
//   (3) results point along their first source
// REQUIRES: the members of each given group have the same two ends.
// COST: O(n log n + k) for k sources in all, and a rational slope a segment.
std::vector<CoveredSegment2> cut_along_lines(const Vertices2& vertices, const std::vector<Segment2>& segments,
                                             const std::vector<std::span<const std::uint32_t>>& groups);

}  // namespace hottel
