// Sums of directed segments of space.
#pragma once

#include <map>
#include <optional>

#include "kernel/determinant.h"

namespace hottel {

// A sum of directed segments, each with a factor. It is zero iff on each line each point is as often an end as a
// beginning: where the outlines of polygons cancel, what they cover has no border.
//
//   (1) exact: segments of one line add up wherever they begin and end
//
// COST: O(log n) a segment.
class OutlineSum3 {
 public:
  void add(const IntegerVector& from, const IntegerVector& to, long factor = 1);

  bool is_zero() const { return !open_end(); }
  // Returns a point that on some line is not as often an end as a beginning; nothing where the sum is zero.
  std::optional<IntegerVector> open_end() const;

 private:
  // A point of a line: the line's direction (its first coordinate that is not zero is positive), the line's moment, and
  // how far along the line the point is.
  struct Key {
    IntegerVector way, moment;
    Integer place;
    bool operator<(const Key& other) const;
  };
  struct End {
    long count = 0;
    IntegerVector point;
  };

  std::map<Key, End> ends_;
};

}  // namespace hottel
