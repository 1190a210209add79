// Normals and directions without their zeros at ends of pieces (MovingPlanes3).
#include <algorithm>
#include <cmath>

#include "geometry/space/moving/moving_planes.h"
#include "kernel/exact_double.h"
#include "kernel/wide_real.h"

namespace hottel {
namespace {

// Where a vector is this part of what its powers come to, it may be zero.
constexpr double kShort = 0x1p-7;

// Whether a0 + a1 s + a2 s^2 is not negative from low to high, and zero at the ends at most: as its coefficients in the
// form of Bernstein tell.
bool is_not_negative(const std::array<Integer, 3>& a, const Rational& low, const Rational& high) {
  const Rational a0(a[0]), a1(a[1]), a2(a[2]);
  const Rational b = a0 + a1 * (low + high) / 2 + a2 * low * high;
  return sgn(a0 + low * (a1 + low * a2)) >= 0 && sgn(a0 + high * (a1 + high * a2)) >= 0 && sgn(b) >= 0;
}

using Powers = std::array<IntegerVector, 3>;

// (s - root) (u0 + u1 s) of which the first factor is zero at no s between low and high. False where it is not that.
bool divide_by_root(Powers& p, const Rational& low, const Rational& high) {
  const IntegerVector across = cross(p[1], p[2]), other = cross(p[0], p[2]);
  const bool is_x = across.x != 0, is_y = across.y != 0;
  const Integer& bottom = is_x ? across.x : is_y ? across.y : across.z;
  const Integer& top = is_x ? other.x : is_y ? other.y : other.z;
  // root = -top / bottom, where all three components are zero.
  const IntegerVector at_root =
      sum(difference(multiple(bottom * bottom, p[0]), multiple(top * bottom, p[1])), multiple(top * top, p[2]));
  if (!is_zero(at_root)) return false;
  Rational root(-top, bottom);
  root.canonicalize();
  const int sign = root <= low ? 1 : root >= high ? -1 : 0;
  if (sign == 0) return false;
  // u1 = p2, u0 = p1 + root p2, both times |bottom|.
  const int turned = sign * sgn(bottom);
  p[0] = multiple(turned, difference(multiple(bottom, p[1]), multiple(top, p[2])));
  p[1] = multiple(turned * bottom, p[2]);
  p[2] = {};
  return true;
}

}  // namespace

MovingPlanes3::ExactPolynomial MovingPlanes3::without_zeros(const ExactPolynomial& exact, double low,
                                                            double high) const {
  const Rational base = exact_value(t_), from = exact_value(low) - base, to = exact_value(high) - base;
  ExactPolynomial result = exact;
  Powers& p = result.powers;
  if (!is_zero(p[2]) && !is_zero(cross(p[1], p[2])) && !divide_by_root(p, from, to)) return exact;
  // One direction, times a number.
  const bool is_one_direction = is_zero(cross(p[0], p[1])) && is_zero(cross(p[0], p[2])) && !is_zero(p[0]);
  if (is_one_direction && is_not_negative({dot(p[0], p[0]), dot(p[0], p[1]), dot(p[0], p[2])}, from, to))
    p[1] = p[2] = {};
  return result;
}

bool MovingPlanes3::is_short_somewhere(const MovingVector3& vector, double low, double high) const {
  const double from = low - vector.base, to = high - vector.base, reach = std::max(std::fabs(from), std::fabs(to));
  const double whole = size_of(plain(vector.first)) + reach * (size_of(vector.second) + reach * size_of(vector.third));
  const double between = std::clamp(nearest_to_zero(vector, from, to), from, to);
  double least = whole;
  for (const double s : {from, between, to}) least = std::min(least, size_of(value_at(vector, s)));
  return !(least > kShort * whole);
}

template <class Real>
MovingPlanes3::WholeVector<Real> MovingPlanes3::whole_normal(PlaneId3 plane, double low, double high) {
  if constexpr (std::is_same_v<Real, double>) {
    MovingVector3 result = normal(plane);
    result.base = t_;
    if (is_fine(result, low, high) && !is_short_somewhere(result, low, high)) return result;
  }
  return whole_vector<Real>({{exact_normal(plane), exact_turn(plane), {}}}, low, high);
}

template <class Real>
MovingPlanes3::WholeVector<Real> MovingPlanes3::whole_direction(const MovingCorner3& corner, double low, double high) {
  if constexpr (std::is_same_v<Real, double>) {
    MovingVector3 result = corner.direction;
    result.base = t_;
    if (is_fine(result, low, high) && !is_short_somewhere(result, low, high)) return result;
  }
  return whole_vector<Real>(exact_direction(corner), low, high);
}

template MovingPlanes3::WholeVector<double> MovingPlanes3::whole_normal<double>(PlaneId3, double, double);
template MovingPlanes3::WholeVector<double> MovingPlanes3::whole_direction<double>(const MovingCorner3&, double,
                                                                                   double);
template MovingPlanes3::WholeVector<WideReal> MovingPlanes3::whole_normal<WideReal>(PlaneId3, double, double);
template MovingPlanes3::WholeVector<WideReal> MovingPlanes3::whole_direction<WideReal>(const MovingCorner3&, double,
                                                                                       double);

}  // namespace hottel
