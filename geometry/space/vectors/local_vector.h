// Vectors, approximations and sums in doubles, long doubles, LongerReal or WideReal.
#pragma once

#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>

namespace hottel {

// A vector of local coordinates (LocalPair3).
template <class Real>
struct LocalVector3 {
  Real x = 0, y = 0, z = 0;

  friend LocalVector3 operator+(const LocalVector3& a, const LocalVector3& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  friend LocalVector3 operator-(const LocalVector3& a, const LocalVector3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  friend LocalVector3 operator-(const LocalVector3& a) { return {-a.x, -a.y, -a.z}; }
  friend LocalVector3 operator*(Real s, const LocalVector3& a) { return {s * a.x, s * a.y, s * a.z}; }
};

template <class Real>
Real dot(const LocalVector3<Real>& a, const LocalVector3<Real>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class Real>
LocalVector3<Real> cross(const LocalVector3<Real>& a, const LocalVector3<Real>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class Real>
Real square(const LocalVector3<Real>& a) {
  return dot(a, a);
}
template <class Real>
Real length(const LocalVector3<Real>& a) {
  using std::sqrt;
  return sqrt(dot(a, a));
}

// 2^-bits.
constexpr double power_of_half(int bits) { return bits == 0 ? 1 : power_of_half(bits - 1) / 2; }

// The largest relative error of one operation.
template <class Real>
inline constexpr double kRoundoff = power_of_half(std::numeric_limits<Real>::digits);

// Distances below this are not looked at, where sizes are about 1.
template <class Real>
inline constexpr double kLeastDistance = std::numeric_limits<Real>::digits > 200   ? 0x1p-400
                                         : std::numeric_limits<Real>::digits > 100 ? 0x1p-200
                                                                                   : 0x1p-110;

template <class Real>
Real pi_of() {
  if constexpr (std::is_floating_point_v<Real>)
    return std::numbers::pi_v<Real>;
  else
    return 4 * atan(Real(1));
}

// A real number of which an approximation is known, and how far off that is at most.
template <class Real>
struct Approximation {
  Real value = 0;
  double error = 0;
};

// A sum that is off by at most 2 roundoffs of itself, and by n^2 roundoff^2 of the sum of the absolute values.
// SEE: Neumaier 1974.
template <class Real>
class CompensatedSum {
 public:
  void add(Real value) {
    using std::fabs;
    const Real next = sum_ + value;
    rest_ += fabs(sum_) >= fabs(value) ? (sum_ - next) + value : (value - next) + sum_;
    sum_ = next;
  }
  Real value() const { return sum_ + rest_; }

 private:
  Real sum_ = 0, rest_ = 0;
};

}  // namespace hottel
