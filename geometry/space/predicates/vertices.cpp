#include "geometry/space/predicates/vertices.h"

namespace hottel {
namespace {

constexpr long kSmallBits = 60;
constexpr long kExactBits = 53;

Integer numerator_over(const Rational& value, const Integer& denominator) {
  return value.get_num() * (denominator / value.get_den());
}

}  // namespace

Vertices3::Vertices3(const std::vector<Point3>& points) {
  if (points.empty()) return;
  origin_ = points.front();
  std::vector<Point3> shifted;
  shifted.reserve(points.size());
  for (const Point3& p : points) shifted.push_back({p.x - origin_.x, p.y - origin_.y, p.z - origin_.z});

  Integer denominator = 1, factor = 0;
  for (const Point3& p : shifted)
    for (const Rational* value : {&p.x, &p.y, &p.z})
      if (!mpz_divisible_p(denominator.get_mpz_t(), value->get_den_mpz_t()))
        denominator = lcm(denominator, value->get_den());
  long top = 0;
  exact_.reserve(points.size());
  for (const Point3& p : shifted) {
    exact_.push_back(
        {numerator_over(p.x, denominator), numerator_over(p.y, denominator), numerator_over(p.z, denominator)});
    const IntegerVector& v = exact_.back();
    if (factor != 1) factor = gcd(factor, gcd(gcd(v.x, v.y), v.z));
  }
  if (factor == 0) factor = 1;
  for (IntegerVector& v : exact_) {
    if (factor != 1) v = {v.x / factor, v.y / factor, v.z / factor};
    top = std::max(top, bits(v));
  }
  scale_ = Rational(factor) / denominator;

  if (top <= kSmallBits)
    for (const IntegerVector& v : exact_) small_.push_back({v.x.get_si(), v.y.get_si(), v.z.get_si()});
  shift_ = top <= kExactBits ? 0 : top - kExactBits;
  approximate_.reserve(points.size());
  for (const IntegerVector& v : exact_) approximate_.push_back(rounded(v, shift_));
}

Point3 Vertices3::from_scene(const Point3& point) const {
  return {(point.x - origin_.x) / scale_, (point.y - origin_.y) / scale_, (point.z - origin_.z) / scale_};
}

}  // namespace hottel
