// Polynomials of a real or complex number, with all that their coefficients may be off. Internal to geometry/space.
#pragma once

#include <array>
#include <cstddef>

#include "geometry/space/proven/ball.h"
#include "geometry/space/proven/proven_vector.h"

namespace hottel {

// The sum of coefficient[k] u^k, k < count.
struct ProvenPolynomial3 {
  // Of n . (b x e), where each of the three is of degree 2.
  static constexpr std::size_t kMost = 7;

  std::array<Ball3<double>, kMost> coefficient{};
  std::size_t count = 0;

  friend ProvenPolynomial3 operator+(const ProvenPolynomial3& a, const ProvenPolynomial3& b);
  friend ProvenPolynomial3 operator-(const ProvenPolynomial3& a, const ProvenPolynomial3& b);
  // REQUIRES: the degree is below kMost.
  friend ProvenPolynomial3 operator*(const ProvenPolynomial3& a, const ProvenPolynomial3& b);
};

// A constant.
ProvenPolynomial3 polynomial_3(const Ball3<double>& value);

// A vector as polynomials of u = t - from.
ProvenPoint3<ProvenPolynomial3> about(const ProvenVector3<double>& vector, double from);

// Returns a disc with all values of a polynomial over a disc, for all coefficients in their balls: its value at the
// centre, and the sum of |p^(j)| r^j / j! there.
//
//   (1) no further from what the values span than the sum for j > 1, and rounding
Disc3 over(const ProvenPolynomial3& polynomial, const Disc3& disc);

}  // namespace hottel
