#include "solver/plane/light/cut_line.h"

#include <cmath>

namespace hottel {
namespace {

// The product, with the rounding of its leading part.
DoubleDouble product(const DoubleDouble& a, const DoubleDouble& b) {
  double p, e;
  two_product(a.hi, b.hi, p, e);
  return {p, e + (a.hi * b.lo + a.lo * b.hi)};
}

}  // namespace

CutLine2::CutLine2(const FinePoint2& point, const FinePoint2& direction, const CellFrame2& frame)
    : point_(point), direction_(direction) {
  inverse_length_ = 1 / std::hypot(direction.x.hi, direction.y.hi);
  gradient_ = {-direction.y.hi * inverse_length_, direction.x.hi * inverse_length_};
  const double far = frame.extent() + size_of(point);
  doubt_ = 2 * (kDirection + 4 * kFine) * far;
  support_ = (std::fabs(gradient_.x) + frame.height() * std::fabs(gradient_.y)) / 2;
  rough_support_ = support_ + doubt_ + 0x1p-49 * far;
}

double CutLine2::at(const FinePoint2& place) const {
  const FinePoint2 from = place - point_;
  const DoubleDouble left = product(direction_.x, from.y), right = product(direction_.y, from.x);
  double s, e;
  two_sum(left.hi, -right.hi, s, e);
  return (s + (e + (left.lo - right.lo))) * inverse_length_;
}

}  // namespace hottel
