// A line that cuts cells, and how well one knows where.
#pragma once

#include "solver/plane/light/cell_frame.h"

namespace hottel {

// Signed distance from a line through cells, positive on the left of its direction, in the unit of a frame.
//
//   (1) at() is within doubt() of the real distance, up to eight roundings of the distance itself
//   (2) doubt() grows with the distance of the point from the grid
class CutLine2 {
 public:
  CutLine2() = default;
  // The line through a point in a direction, which is known to kDirection of its length. REQUIRES a
  // direction of some length.
  CutLine2(const FinePoint2& point, const FinePoint2& direction, const CellFrame2& frame);

  double at(const FinePoint2& place) const;  // REQUIRES a place in the grid
  double doubt() const { return doubt_; }
  // The unit vector along which the distance grows: to the left of the line, rounded.
  const Vector2& gradient() const { return gradient_; }

  // Half the extent of a cell across the line: how far a corner of a cell may lie beyond its centre.
  double support() const { return support_; }
  // +1: a whole cell certainly lies left of the line, -1: right of it, 0: neither is certain. By plain doubles; the
  // same for the same line and cell, always. centre: of the cell, rounded.
  int side_of_cell(const Vector2& centre) const {
    const double rough = dot(gradient_, centre - rounded(point_));
    return rough > rough_support_ ? 1 : rough < -rough_support_ ? -1 : 0;
  }

 private:
  FinePoint2 point_, direction_;
  double inverse_length_ = 0, doubt_ = 0, support_ = 0, rough_support_ = 0;
  Vector2 gradient_{0, 0};
};

}  // namespace hottel
