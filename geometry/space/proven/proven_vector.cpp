#include "geometry/space/proven/proven_vector.h"

#include <algorithm>
#include <type_traits>

#include "kernel/wide_real.h"

namespace hottel {
namespace {

// What components of the powers of a moving vector may be off, in units of what they were made of: products of sums of
// products of numbers that are off by some units each come to 35 at most.
constexpr double kOfTerms = 64 * 0x1p-53;
// Of a power that was rounded from integers, a part of its largest component.
constexpr double kOfPower = 0x1p-50;

template <class Real>
double largest(const LocalVector3<Real>& a) {
  return std::max({ball_arithmetic_3::size_of(a.x), ball_arithmetic_3::size_of(a.y), ball_arithmetic_3::size_of(a.z)});
}

LocalVector3<double> local(const Direction3& a) { return {a.x, a.y, a.z}; }

// Times a power of two: nothing is rounded, but for what underflows.
template <class Real>
void scale(ProvenVector3<Real>& v) {
  const LocalVector3<Real>& last = v.power[2];
  v.is_linear = last.x == 0 && last.y == 0 && last.z == 0 && v.error[2] == 0;
  const double size = std::max({largest(v.power[0]), largest(v.power[1]), largest(v.power[2])});
  if (!(size > 0) || !std::isfinite(size)) return;
  // In two steps, each by a power that a double is.
  const int shift = -std::ilogb(size), first = shift / 2;
  for (const double power : {std::ldexp(1.0, first), std::ldexp(1.0, shift - first)})
    for (std::size_t k = 0; k < 3; ++k) {
      v.power[k] = Real(power) * v.power[k];
      v.error[k] = v.error[k] * power + 0x1p-1000;
    }
}

}  // namespace

ProvenVector3<double> proven_vector_3(const MovingVector3& vector) {
  ProvenVector3<double> result{{local(plain(vector.first)), local(vector.second), local(vector.third)}, {}, 0, true};
  result.error = {vector.first.error, kOfTerms * vector.terms[1] + kOfPower * size_of(vector.second),
                  kOfTerms * vector.terms[2] + kOfPower * size_of(vector.third)};
  result.base = vector.base;
  scale(result);
  return result;
}

template <class Real>
ProvenVector3<Real> proven_vector_3(const WideVector3<Real>& vector) {
  ProvenVector3<Real> result{{vector.first, vector.second, vector.third}, {}, vector.base, true};
  for (std::size_t k = 0; k < 3; ++k) {
    const LocalVector3<Real>& p = result.power[k];
    const bool is_zero = p.x == 0 && p.y == 0 && p.z == 0;
    result.error[k] = is_zero ? 0 : 8 * kRoundoff<Real> * largest(p);
  }
  scale(result);
  return result;
}

template <class Real>
ProvenVector3<double> in_doubles_3(const ProvenVector3<Real>& vector) {
  ProvenVector3<double> result;
  const auto in_double = [](const Real& a) { return static_cast<double>(a); };
  for (std::size_t k = 0; k < 3; ++k) {
    const LocalVector3<Real>& p = vector.power[k];
    result.power[k] = {in_double(p.x), in_double(p.y), in_double(p.z)};
    result.error[k] = ball_arithmetic_3::up(vector.error[k] + 0x1p-52 * largest(result.power[k]));
  }
  result.base = vector.base;
  result.is_linear = vector.is_linear;
  return result;
}

template ProvenVector3<WideReal> proven_vector_3(const WideVector3<WideReal>&);
template ProvenVector3<double> in_doubles_3(const ProvenVector3<WideReal>&);

}  // namespace hottel
