// Numbers of many digits, for oracles.
#pragma once

#include <gmpxx.h>

#include <boost/multiprecision/mpfr.hpp>
#include <type_traits>

#include "tests/oracle/space/space_polygon.h"

namespace hottel::oracle {

template <unsigned kDigits>
using RealOf = boost::multiprecision::number<
    boost::multiprecision::mpfr_float_backend<kDigits, boost::multiprecision::allocate_stack>,
    boost::multiprecision::et_off>;

// The number as a Real, rounded once an operation.
template <class Real>
Real real(const mpz_class& z) {
  if constexpr (std::is_same_v<Real, double>)
    return z.get_d();
  else
    return Real(z.get_mpz_t());
}
template <class Real>
Real real(const mpq_class& q) {
  return real<Real>(q.get_num()) / real<Real>(q.get_den());
}

// Vectors of such numbers.
template <class Real>
struct VectorOf {
  Real x{}, y{}, z{};
  friend VectorOf operator+(const VectorOf& a, const VectorOf& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend VectorOf operator-(const VectorOf& a, const VectorOf& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend VectorOf operator*(const Real& s, const VectorOf& a) { return {s * a.x, s * a.y, s * a.z}; }
  friend Real dot(const VectorOf& a, const VectorOf& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
  friend VectorOf cross(const VectorOf& a, const VectorOf& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }
};

template <class Real>
VectorOf<Real> vector_of(const SpacePoint& p) {
  return {real<Real>(p.x), real<Real>(p.y), real<Real>(p.z)};
}

}  // namespace hottel::oracle
