#include "geometry/space/predicates/sun_frame.h"

#include <algorithm>

#include "kernel/coprime_integers.h"
#include "kernel/support/failure.h"

namespace hottel {

SunFrame3::SunFrame3(const Vertices3& vertices, const Vector3& direction) : vertices_(vertices) {
  HOTTEL_REQUIRE(!direction.is_zero());
  const auto [x, y, z] = coprime_integers<3>({direction.x, direction.y, direction.z});
  direction_ = {x, y, z};
  k_ = abs(x) >= abs(y) && abs(x) >= abs(z) ? 0 : abs(y) >= abs(z) ? 1 : 2;
  i_ = (k_ + 1) % 3;
  j_ = (k_ + 2) % 3;
  steep_ = part(direction_, k_);
  sign_ = sgn(steep_);
  reach_ = 1;
  c_ = 1;
  if (vertices.size() == 0) return;
  Integer low[3], high[3];
  for (std::size_t n = 0; n < vertices.size(); ++n) {
    const IntegerVector& place = vertices.exact(VertexId3(n));
    const Integer values[3] = {first(place), second(place), sign_ * part(place, k_)};
    for (int a = 0; a < 3; ++a) {
      if (n == 0 || values[a] < low[a]) low[a] = values[a];
      if (n == 0 || values[a] > high[a]) high[a] = values[a];
    }
  }
  u_ = (low[0] + high[0]) / 2;
  v_ = (low[1] + high[1]) / 2;
  depth_ = low[2];
  reach_ = std::max(reach_, Integer(high[2] - low[2]));
  // As far as the image is wide: all of it is within half a right angle.
  c_ = std::max({c_, Integer(high[0] - low[0]), Integer(high[1] - low[1])});
}

// With the sign of the steepest component in one of both the image is not mirrored, whatever it is.
Integer SunFrame3::first(const IntegerVector& place) const {
  return sign_ * (steep_ * part(place, i_) - part(place, k_) * part(direction_, i_));
}

Integer SunFrame3::second(const IntegerVector& place) const {
  return steep_ * part(place, j_) - part(place, k_) * part(direction_, j_);
}

IntegerVector SunFrame3::toward(const IntegerVector& place, const Integer& weight) const {
  return {first(place) - u_ * weight, second(place) - v_ * weight, c_ * weight};
}

IntegerVector SunFrame3::toward(const Point3& point) const {
  const Point3 p = vertices_.from_scene(point);
  const Integer weight = lcm(lcm(p.x.get_den(), p.y.get_den()), p.z.get_den());
  const auto numerator = [&](const Rational& value) -> Integer { return value.get_num() * (weight / value.get_den()); };
  return primitive(toward({numerator(p.x), numerator(p.y), numerator(p.z)}, weight));
}

BoundedVector SunFrame3::approximate(VertexId3 v) const {
  const IntegerVector& place = vertices_.exact(v);
  const Integer depth = sign_ * part(place, k_) - depth_;
  const Integer apart = 2 * reach_ - depth;
  const double factor = rounded_quotient(reach_, apart, 0);
  const auto part_of_c = [&](const Integer& value) { return factor * rounded_quotient(value, c_, 0); };
  BoundedVector result{part_of_c(first(place) - u_), part_of_c(second(place) - v_), factor};
  result.size = std::max({std::fabs(result.x), std::fabs(result.y), std::fabs(result.z)});
  result.error = 0x1p-48 * result.size;
  return result;
}

int SunFrame3::facing(const IntegerVector& normal) const { return -dot_sign(normal, direction_); }

// The ray of (u, v) meets the plane N . p = h at the depth sign (h d_k - N_i sign u - N_j v) / (N . d).
IntegerVector SunFrame3::crossing(const Plane& s, const Plane& t) const {
  struct Depth {
    IntegerVector numerator;  // to be multiplied with a vector, whose z is c
    Integer denominator;
  };
  const auto depth_of = [&](const Plane& plane) {
    const Integer n_i = sign_ * part(plane.normal, i_), n_j = part(plane.normal, j_);
    const Integer height = dot(plane.normal, plane.anchor) * steep_ - n_i * u_ - n_j * v_;
    return Depth{{-n_i * c_, -n_j * c_, height}, sign_ * dot(plane.normal, direction_)};
  };
  const Depth of_s = depth_of(s), of_t = depth_of(t);
  const IntegerVector m =
      primitive(difference(multiple(of_s.denominator, of_t.numerator), multiple(of_t.denominator, of_s.numerator)));
  return sgn(of_s.denominator) == sgn(of_t.denominator) ? m : opposite(m);
}

Point3 SunFrame3::meeting(const IntegerVector& vector, const Plane& plane) const {
  const Rational u = Rational(u_) + Rational(c_ * vector.x) / Rational(vector.z);
  const Rational v = Rational(v_) + Rational(c_ * vector.y) / Rational(vector.z);
  const Rational height(dot(plane.normal, plane.anchor) * steep_);
  const Rational along =
      (height - Rational(sign_ * part(plane.normal, i_)) * u - Rational(part(plane.normal, j_)) * v) /
      Rational(dot(plane.normal, direction_));
  std::array<Rational, 3> place;
  place[i_] = (sign_ * u + along * part(direction_, i_)) / steep_;
  place[j_] = (v + along * part(direction_, j_)) / steep_;
  place[k_] = along;
  const Point3& origin = vertices_.origin();
  const Rational& scale = vertices_.scale();
  return {origin.x + scale * place[0], origin.y + scale * place[1], origin.z + scale * place[2]};
}

// The image of a plane across the rays is larger than it by |d_k| |d|, the square of the unit of integer form included.
Ball SunFrame3::area(const IntegerVector& a, const IntegerVector& b, const IntegerVector& c, long precision) const {
  Rational doubled(dot(a, cross(b, c)) * c_ * c_, a.z * b.z * c.z);
  doubled.canonicalize();
  const Rational& scale = vertices_.scale();
  const Rational image = doubled / 2 * scale * scale / abs(steep_);
  return Ball::of(image, precision).over(Ball::root(dot(direction_, direction_), precision), precision);
}

}  // namespace hottel
