#include "geometry/space/unobstructed/local_outline.h"

#include <algorithm>
#include <type_traits>

#include "geometry/space/vectors/integer_reals.h"
#include "kernel/wide_real.h"

namespace hottel {
namespace {

template <class Real>
LocalVector3<Real> position(const LocalPair3& pair, int side, const LocalPair3::Corner& corner, int exponent) {
  LocalVector3<Real> p;
  if constexpr (std::is_same_v<Real, double>) {
    const BoundedVector& q = corner.position;
    p = {std::ldexp(q.x, -exponent), std::ldexp(q.y, -exponent), std::ldexp(q.z, -exponent)};
  } else {
    const auto [top, bottom] = pair.exact_position(side, corner);
    integer_reals::set_quotient(top.x, bottom, pair.shift() + exponent, p.x);
    integer_reals::set_quotient(top.y, bottom, pair.shift() + exponent, p.y);
    integer_reals::set_quotient(top.z, bottom, pair.shift() + exponent, p.z);
  }
  return p;
}

}  // namespace

template <class Real>
LocalOutline3<Real>::LocalOutline3(const LocalPair3& pair, int side, int exponent) {
  is_exact = (std::is_same_v<Real, double> ? pair.is_small() : pair.is_long()) && !pair.has_inexact_cut();
  const auto& outline = pair.outline(side);
  for (const LocalPair3::Corner& corner : outline) {
    corners.push_back(position<Real>(pair, side, corner, exponent));
    const double length_of_corner = static_cast<double>(length(corners.back()));
    size = std::max(size, length_of_corner);
    if (is_exact)
      off.push_back(0);
    else if constexpr (std::is_same_v<Real, double>)
      off.push_back(1.8 * std::ldexp(corner.position.error, -exponent));
    else
      off.push_back(4 * kRoundoff<Real> * length_of_corner);
    most_off = std::max(most_off, off.back());
  }
  for (const LocalVector3<Real>& p : corners) centre = centre + Real(1) / static_cast<Real>(corners.size()) * p;
  for (const LocalVector3<Real>& p : corners) radius = std::max(radius, static_cast<double>(length(p - centre)));
  radius = radius * (1 + 0x1p-40) + most_off + 16 * kRoundoff<Real> * size;
  size *= 1 + 0x1p-40;
}

// The cross product is off by 2.9 roundoffs of the product of both lengths, and its length by 2.5 of itself.
template <class Real>
std::vector<PatchCell3<Real>> cells_of(const LocalOutline3<Real>& outline) {
  std::vector<PatchCell3<Real>> result;
  const auto& corners = outline.corners;
  for (std::size_t k = 1; k + 1 < corners.size(); k += 2) {
    PatchCell3<Real> cell{{0, k, k + 1, std::min(k + 2, corners.size() - 1)}, {}, 0};
    for (std::size_t c = 0; c < 4; ++c) {
      const LocalVector3<Real>& p = corners[cell.corner[c]];
      const LocalVector3<Real> a = corners[cell.corner[(c + 1) % 4]] - p, b = corners[cell.corner[(c + 3) % 4]] - p;
      const double size_a = static_cast<double>(length(a)), size_b = static_cast<double>(length(b));
      const double off_a = 2 * outline.most_off + kRoundoff<Real> * size_a,
                   off_b = 2 * outline.most_off + kRoundoff<Real> * size_b;
      cell.density[c] = {length(cross(a, b)),
                         6 * kRoundoff<Real> * size_a * size_b + off_a * size_b + off_b * size_a + off_a * off_b};
      cell.most_density =
          std::max(cell.most_density, static_cast<double>(cell.density[c].value) + cell.density[c].error);
    }
    result.push_back(cell);
  }
  return result;
}

template struct LocalOutline3<double>;
template struct LocalOutline3<long double>;
template struct LocalOutline3<WideReal>;
template std::vector<PatchCell3<double>> cells_of(const LocalOutline3<double>&);
template std::vector<PatchCell3<long double>> cells_of(const LocalOutline3<long double>&);

}  // namespace hottel
