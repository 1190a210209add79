#include "geometry/space/stretches/stretch_parts.h"

#include <algorithm>

namespace hottel {
namespace {

// b - a, times both weights.
IntegerVector way(const WeightedPoint3& a, const WeightedPoint3& b) {
  if (a.weight == b.weight) return multiple(a.weight, difference(b.numerator, a.numerator));
  return difference(multiple(a.weight, b.numerator), multiple(b.weight, a.numerator));
}

}  // namespace

std::array<Direction3, 2> ends_in_doubles(const Stretch3& stretch, double low, double high, long shift) {
  const auto place = [&](const IntegerVector& p) {
    return Direction3{rounded_quotient(p.x, stretch.weight, shift), rounded_quotient(p.y, stretch.weight, shift),
                      rounded_quotient(p.z, stretch.weight, shift)};
  };
  const Direction3 from = place(stretch.from), along = place(stretch.way);
  return {from + low * along, from + high * along};
}

std::optional<std::array<Rational, 2>> part_inside(const Stretch3& stretch, const std::vector<WeightedPoint3>& corners,
                                                   const IntegerVector& normal) {
  const WeightedPoint3 from{stretch.from, stretch.weight}, to = end_of(stretch);
  std::array<Rational, 2> part{0, 1};
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const WeightedPoint3 &corner = corners[k], &next = corners[(k + 1) % corners.size()];
    const IntegerVector across = cross(normal, way(corner, next));
    const Integer at_from = dot(across, way(corner, from)), at_to = dot(across, way(corner, to));
    if (sgn(at_from) <= 0 && sgn(at_to) <= 0) return std::nullopt;
    if (sgn(at_from) >= 0 && sgn(at_to) >= 0) continue;
    Rational zero(at_from, at_from - at_to);
    zero.canonicalize();
    if (sgn(at_from) < 0)
      part[0] = std::max(part[0], zero);
    else
      part[1] = std::min(part[1], zero);
  }
  if (part[0] >= part[1]) return std::nullopt;
  return part;
}

}  // namespace hottel
