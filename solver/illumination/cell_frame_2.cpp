#include "solver/illumination/cell_frame_2.h"

#include <cmath>

#include "kernel/rational.h"

namespace hottel {
namespace {

DoubleDouble fine(const Rational& value) {
  const double hi = to_double(value);
  if (!std::isfinite(hi)) return {hi, 0};
  return {hi, to_double(value - Rational(hi))};
}

DoubleDouble difference(const DoubleDouble& a, const DoubleDouble& b) {
  double s, e, t, f, hi, lo;
  two_sum(a.hi, -b.hi, s, e);
  two_sum(a.lo, -b.lo, t, f);
  e += t;
  two_sum(s, e, hi, lo);
  return {hi, lo + f};
}

// The product, with the rounding of its leading part.
DoubleDouble product(const DoubleDouble& a, const DoubleDouble& b) {
  double p, e;
  two_product(a.hi, b.hi, p, e);
  return {p, e + (a.hi * b.lo + a.lo * b.hi)};
}

}  // namespace

FinePoint2 operator-(const FinePoint2& a, const FinePoint2& b) { return {difference(a.x, b.x), difference(a.y, b.y)}; }

CutLine2::CutLine2(const FinePoint2& point, const FinePoint2& direction, double size_of_direction, double reach)
    : point_(point), direction_(direction) {
  const double length = std::hypot(direction.x.hi, direction.y.hi);
  inverse_length_ = 1 / length;
  gradient_ = {-direction.y.hi * inverse_length_, direction.x.hi * inverse_length_};
  const double far = reach + std::fabs(point.x.hi) + std::fabs(point.y.hi);
  doubt_ = 8 * kFine * far * (1 + size_of_direction * inverse_length_);
  rough_doubt_ = doubt_ + 0x1p-49 * far;
}

double CutLine2::at(const FinePoint2& place) const {
  const FinePoint2 from = place - point_;
  const DoubleDouble left = product(direction_.x, from.y), right = product(direction_.y, from.x);
  double s, e;
  two_sum(left.hi, -right.hi, s, e);
  return (s + (e + (left.lo - right.lo))) * inverse_length_;
}

CellFrame2::CellFrame2(const Vertices2& vertices, const Grid2& grid) : nx_(grid.nx) {
  const Rational width = (grid.max.x - grid.min.x) / Rational(Integer(static_cast<unsigned long>(grid.nx)));
  const Rational height = (grid.max.y - grid.min.y) / Rational(Integer(static_cast<unsigned long>(grid.ny))) / width;
  height_ = fine(height);
  for (std::uint32_t iy = 0; iy < grid.ny; ++iy)
    rows_.push_back(fine(height * Rational(Integer(2 * static_cast<unsigned long>(iy) + 1)) / 2));
  for (VertexId v = 0; v < vertices.size(); ++v) {
    const ExactPoint2 p = vertices.to_scene(vertices.exact(v));
    vertices_.push_back({fine((p.x - grid.min.x) / width), fine((p.y - grid.min.y) / width)});
  }
  extent_ = (nx_ + height_.hi * grid.ny) * 1.0000001;
}

}  // namespace hottel
