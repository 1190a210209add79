#include "geometry/space/predicates/eye.h"

#include "kernel/int128.h"

namespace hottel {
namespace {

// Products with a small coordinate stay below 2^122, and sums with a numerator below 2^125.
constexpr std::size_t kDenominatorBits = 62;
constexpr long kNumeratorBits = 124;

Int128 to_int128(const Integer& value) {
  const Integer magnitude = abs(value);
  const Integer high = magnitude >> 64, low = magnitude - (high << 64);
  const Int128 result = (static_cast<Int128>(high.get_ui()) << 64) + static_cast<Int128>(low.get_ui());
  return sgn(value) < 0 ? -result : result;
}

// The nearest double: the compiler's own conversion is right but slow.
double nearest(Int128 value) {
  const auto low = static_cast<std::int64_t>(value);
  return value == low ? static_cast<double>(low) : static_cast<double>(value);
}

BoundedVector rounded(Int128 x, Int128 y, Int128 z) {
  BoundedVector result{nearest(x), nearest(y), nearest(z)};
  result.size = std::max({std::fabs(result.x), std::fabs(result.y), std::fabs(result.z)});
  if (result.size > 0x1p53) result.error = 0x1p-53 * result.size;
  return result;
}

}  // namespace

Eye3::Eye3(const Vertices3& vertices, const Point3& point) : vertices_(&vertices), exact_(vertices.size()) {
  const Point3 p = vertices.from_scene(point);
  denominator_ = lcm(lcm(p.x.get_den(), p.y.get_den()), p.z.get_den());
  const auto numerator = [this](const Rational& value) -> Integer {
    return value.get_num() * (denominator_ / value.get_den());
  };
  numerator_ = {numerator(p.x), numerator(p.y), numerator(p.z)};
  toward_.reserve(vertices.size());
  if (vertices.is_small() && bits(numerator_) <= kNumeratorBits &&
      mpz_sizeinbase(denominator_.get_mpz_t(), 2) <= kDenominatorBits)
    look_small();
  else
    look_large();
  unit_ = to_double(scaled_by_power_of_two(vertices.scale() / denominator_, shift_));
}

Eye3 Eye3::of_sun(const Vertices3& vertices, const Vector3& direction) {
  Eye3 result(vertices);
  result.sun_ = std::make_shared<const SunFrame3>(vertices, direction);
  result.toward_.reserve(vertices.size());
  for (std::size_t k = 0; k < vertices.size(); ++k) result.toward_.push_back(result.sun_->approximate(VertexId3(k)));
  return result;
}

void Eye3::look_small() {
  const Int128 x = to_int128(numerator_.x), y = to_int128(numerator_.y), z = to_int128(numerator_.z);
  const auto q = static_cast<Int128>(denominator_.get_si());
  for (std::size_t k = 0; k < vertices_->size(); ++k) {
    const Vertices3::Small& v = vertices_->small(VertexId3(k));
    toward_.push_back(rounded(q * v.x - x, q * v.y - y, q * v.z - z));
  }
}

void Eye3::look_large() {
  std::vector<IntegerVector> exact;
  exact.reserve(vertices_->size());
  long top = 0;
  for (std::size_t k = 0; k < vertices_->size(); ++k) {
    exact.push_back(exact_vector(VertexId3(k)));
    top = std::max(top, bits(exact.back()));
  }
  shift_ = std::max(0L, top - 60);
  for (const IntegerVector& w : exact) toward_.push_back(hottel::rounded(w, shift_));
}

IntegerVector Eye3::exact_vector(VertexId3 v) const {
  const IntegerVector& p = vertices_->exact(v);
  if (sun_) return sun_->toward(p, 1);
  return {denominator_ * p.x - numerator_.x, denominator_ * p.y - numerator_.y, denominator_ * p.z - numerator_.z};
}

const IntegerVector& Eye3::exact_toward(VertexId3 v) {
  std::unique_ptr<IntegerVector>& kept = exact_[v.index()];
  if (!kept) kept = std::make_unique<IntegerVector>(exact_vector(v));
  return *kept;
}

}  // namespace hottel
