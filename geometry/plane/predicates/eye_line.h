// The line through two points that need not be vertices, and on which side of it the vertices lie.
#pragma once

#include "geometry/plane/predicates/vertices.h"

namespace hottel {

// The directed line from one eye to another: on which side of it vertices lie, when many are asked of one line.
//
//   (1) side(v) is the exact sign, whatever the coordinates: a filter in doubles with a proven error bound decides what
//       it can, 128-bit integers most of the rest, rationals all
//   (2) the opposite line answers with the opposite sign
//   (3) a vertex at one of the two points lies on the line: 0
//
// REQUIRES: both eyes and their vertices outlive the line, have the same vertices, and are different points.
class EyeLine2 {
 public:
  EyeLine2(const Eye2& from, const Eye2& to)
      : from_(&from),
        to_(&to),
        approximate_(from.vertices_->approximate_.data()),
        x_(from.x_),
        y_(from.y_),
        dx_(to.x_ - from.x_),
        dy_(to.y_ - from.y_),
        error_(from.error_ > to.error_ ? from.error_ : to.error_),
        length_(std::fabs(dx_) + std::fabs(dy_) + 2 * error_) {}

  // Where vertex v lies: +1 left of the line, -1 right of it, 0 on it; exactly.
  // COST: about 2 ns when the filter decides; about 20 ns when 128 bits do; else about 1 µs.
  int side(VertexId v) const {
    const Vertices2::Approximate& p = approximate_[v.index()];
    const double bx = p.x - x_, by = p.y - y_;
    const double left = dx_ * by, right = dy_ * bx, determinant = left - right;
    const double bound = Vertices2::kOrientationError * (std::fabs(left) + std::fabs(right)) +
                         error_ * (length_ + std::fabs(bx) + std::fabs(by));
    if (determinant > bound) return 1;
    if (determinant < -bound) return -1;
    return exact_side(v);
  }

 private:
  int exact_side(VertexId v) const;

  const Eye2 *from_, *to_;
  const Vertices2::Approximate* approximate_;
  double x_, y_, dx_, dy_, error_, length_;
};

}  // namespace hottel
