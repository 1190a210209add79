#include "geometry/space/integrals/moment_origin.h"

#include <algorithm>
#include <limits>
#include <type_traits>

#include "geometry/space/vectors/integer_reals.h"
#include "kernel/exact_double.h"
#include "kernel/wide_real.h"

namespace hottel {
namespace {

template <class Real>
ArcVector3<Real> unit(const IntegerVector& a) {
  const long bits_above = std::max(0L, bits(a) - std::numeric_limits<double>::digits);
  ArcVector3<Real> result;
  if constexpr (std::is_same_v<Real, double>) {
    const BoundedVector double_vector = rounded(a, bits_above);
    result = {double_vector.x, double_vector.y, double_vector.z};
  } else {
    integer_reals::set_quotient(a.x, 1, bits_above, result.x);
    integer_reals::set_quotient(a.y, 1, bits_above, result.y);
    integer_reals::set_quotient(a.z, 1, bits_above, result.z);
  }
  return unit_or_zero<Real>(result);
}

}  // namespace

MomentOrigin3::MomentOrigin3(const PairGeometry3& bodies, const double (&shift)[3], long vertex_shift)
    : bodies_(bodies) {
  if (!bodies.is_far(1) && set_on_common_line(shift[0])) return;
  set_in_the_middle();
  if (shift[0] == 0 && shift[1] == 0 && shift[2] == 0) return;
  Rational moved[3];
  const Integer* const numerators[] = {&point_.numerator.x, &point_.numerator.y, &point_.numerator.z};
  for (int a = 0; a < 3; ++a) {
    Rational place(*numerators[a], point_.weight);
    place.canonicalize();
    moved[a] = place + scaled_by_power_of_two(exact_value(shift[a]), vertex_shift);
  }
  const Integer common = lcm(lcm(moved[0].get_den(), moved[1].get_den()), moved[2].get_den());
  const auto over = [&common](const Rational& value) -> Integer {
    return value.get_num() * (common / value.get_den());
  };
  point_ = {{over(moved[0]), over(moved[1]), over(moved[2])}, common};
}

// The square of the longest way from the first corner of a patch, about.
double MomentOrigin3::extent(std::uint32_t patch) const {
  const std::vector<std::uint32_t>& corners = bodies_.bodies[patch].corners;
  double most = 0;
  for (const std::uint32_t corner : corners) {
    const Direction3 way = bodies_.place(corner) - bodies_.place(corners.front());
    most = std::max(most, dot(way, way));
  }
  return most;
}

void MomentOrigin3::set_in_the_middle() {
  const bool is_second_smaller = !bodies_.is_far(1) && extent(1) < extent(0);
  const std::vector<std::uint32_t>& corners = bodies_.bodies[is_second_smaller ? 1 : 0].corners;
  Integer common = 1;
  for (const std::uint32_t corner : corners) common = lcm(common, bodies_.points[corner].weight());
  IntegerVector sum;
  for (const std::uint32_t corner : corners) {
    const PairGeometry3::Point& p = bodies_.points[corner];
    const IntegerVector part = multiple(common / p.weight(), p.exact());
    sum = {sum.x + part.x, sum.y + part.y, sum.z + part.z};
  }
  point_ = {sum, common * static_cast<unsigned long>(corners.size())};
}

// The points in which the outline of a patch meets the plane of the other one.
std::vector<WeightedPoint3> MomentOrigin3::crossings(std::uint32_t patch) const {
  const std::vector<std::uint32_t>& corners = bodies_.bodies[patch].corners;
  const PairGeometry3::Body& other = bodies_.bodies[1 - patch];
  const PairGeometry3::Point& anchor = bodies_.points[other.corners.front()];
  std::vector<WeightedPoint3> result;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const std::uint32_t a = corners[k], b = corners[(k + 1) % corners.size()];
    const int at_a = bodies_.side(a, 1 - patch), at_b = bodies_.side(b, 1 - patch);
    const PairGeometry3::Point &p = bodies_.points[a], &q = bodies_.points[b];
    if (at_a == 0) result.push_back({p.exact(), p.weight()});
    if (at_a * at_b >= 0) continue;
    const auto height = [&](const PairGeometry3::Point& point) -> Integer {
      return abs(dot(other.exact_normal(),
                     difference(multiple(anchor.weight(), point.exact()), multiple(point.weight(), anchor.exact()))));
    };
    const Integer hp = height(p), hq = height(q);
    result.push_back({{hq * p.exact().x + hp * q.exact().x, hq * p.exact().y + hp * q.exact().y,
                       hq * p.exact().z + hp * q.exact().z},
                      hq * p.weight() + hp * q.weight()});
  }
  return result;
}

// In the middle of what patch 0 has of it, and `shift` times its length farther.
bool MomentOrigin3::set_on_common_line(double shift) {
  const std::vector<WeightedPoint3> here = crossings(0);
  if (here.size() != 2 || crossings(1).size() != 2) return false;
  const WeightedPoint3 &a = here[0], &b = here[1];
  const Rational share = Rational(1, 2) + exact_value(shift);
  const Integer &p = share.get_num(), &q = share.get_den();
  const IntegerVector from = multiple((q - p) * b.weight, a.numerator), to = multiple(p * a.weight, b.numerator);
  point_ = {{from.x + to.x, from.y + to.y, from.z + to.z}, q * a.weight * b.weight};
  is_on_common_line_ = true;
  return true;
}

IntegerVector MomentOrigin3::way_to(const Stretch3& stretch) const {
  return difference(multiple(point_.weight, stretch.from), multiple(stretch.weight, point_.numerator));
}

MomentOrigin3::Moment MomentOrigin3::moment_of(const Stretch3& stretch, const IntegerVector& way_to) const {
  return {cross(way_to, stretch.way), stretch.weight * stretch.weight * point_.weight};
}

// Nearly opposite normals lose the digits of their sum: it is at right angles to the line and to the difference.
template <class Real>
ArcVector3<Real> direction_of_both_normals(const PairGeometry3& bodies) {
  const IntegerVector &a = bodies.bodies[0].exact_normal(), &b = bodies.bodies[1].exact_normal();
  const ArcVector3<Real> n = unit<Real>(a), m = unit<Real>(b);
  const bool is_acute = dot(n, m) >= 0;
  return unit_or_zero<Real>(is_acute ? n + m : cross(unit<Real>(cross(a, b)), n - m));
}

template Direction3 direction_of_both_normals<double>(const PairGeometry3&);
template LocalVector3<long double> direction_of_both_normals<long double>(const PairGeometry3&);
template LocalVector3<LongerReal> direction_of_both_normals<LongerReal>(const PairGeometry3&);
template LocalVector3<WideReal> direction_of_both_normals<WideReal>(const PairGeometry3&);

}  // namespace hottel
