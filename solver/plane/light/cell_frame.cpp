#include "solver/plane/light/cell_frame.h"

#include <cmath>

#include "kernel/exact_double.h"
#include "kernel/rational.h"

namespace hottel {
namespace {

DoubleDouble fine(const Rational& value) {
  const double hi = to_double(value);
  if (!std::isfinite(hi)) return {hi, 0};
  return {hi, to_double(value - exact_value(hi))};
}

DoubleDouble difference(const DoubleDouble& a, const DoubleDouble& b) {
  double s, e, t, f, hi, lo;
  two_sum(a.hi, -b.hi, s, e);
  two_sum(a.lo, -b.lo, t, f);
  e += t;
  two_sum(s, e, hi, lo);
  return {hi, lo + f};
}

}  // namespace

FinePoint2 operator-(const FinePoint2& a, const FinePoint2& b) { return {difference(a.x, b.x), difference(a.y, b.y)}; }

CellFrame2::CellFrame2(const Vertices2& vertices, const Grid2& grid) : nx_(grid.nx), vertices_(vertices) {
  const Rational width = (grid.max.x - grid.min.x) / Rational(Integer(static_cast<unsigned long>(grid.nx)));
  const Rational height = (grid.max.y - grid.min.y) / Rational(Integer(static_cast<unsigned long>(grid.ny))) / width;
  height_ = fine(height);
  for (std::uint32_t iy = 0; iy < grid.ny; ++iy)
    rows_.push_back(fine(height * Rational(Integer(2 * static_cast<unsigned long>(iy) + 1)) / 2));
  for (const VertexId v : vertices.ids()) {
    const Point2 p = vertices.to_scene(vertices.exact(v));
    places_.push_back({fine((p.x - grid.min.x) / width), fine((p.y - grid.min.y) / width)});
  }
  extent_ = (nx_ + height_.hi * grid.ny) * 1.0000001;
}

FinePoint2 CellFrame2::direction(VertexId a, VertexId b) const {
  const FinePoint2 way = vertex(b) - vertex(a);
  if ((size_of(vertex(a)) + size_of(vertex(b))) * kFine < size_of(way) * (kDirection / 2)) return way;
  const Point2 from = vertices_.exact(a), to = vertices_.exact(b);
  const Rational x = to.x - from.x, y = to.y - from.y;
  const Rational& longer = abs(x) > abs(y) ? x : y;
  const auto bits = [](const Integer& n) { return static_cast<long>(mpz_sizeinbase(n.get_mpz_t(), 2)); };
  const long shift = bits(longer.get_den()) - bits(longer.get_num());
  return {fine(scaled_by_power_of_two(x, shift)), fine(scaled_by_power_of_two(y, shift))};
}

}  // namespace hottel
