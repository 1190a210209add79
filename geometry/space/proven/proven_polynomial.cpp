#include "geometry/space/proven/proven_polynomial.h"

#include <algorithm>

namespace hottel {
namespace {

using namespace ball_arithmetic_3;

}  // namespace

ProvenPolynomial3 operator+(const ProvenPolynomial3& a, const ProvenPolynomial3& b) {
  const bool is_longer = a.count >= b.count;
  ProvenPolynomial3 sum = is_longer ? a : b;
  const ProvenPolynomial3& other = is_longer ? b : a;
  for (std::size_t k = 0; k < other.count; ++k) sum.coefficient[k] = sum.coefficient[k] + other.coefficient[k];
  return sum;
}

ProvenPolynomial3 operator-(const ProvenPolynomial3& a, const ProvenPolynomial3& b) {
  ProvenPolynomial3 opposite = b;
  for (std::size_t k = 0; k < b.count; ++k) opposite.coefficient[k] = -b.coefficient[k];
  return a + opposite;
}

ProvenPolynomial3 operator*(const ProvenPolynomial3& a, const ProvenPolynomial3& b) {
  ProvenPolynomial3 product;
  product.count = a.count == 0 || b.count == 0 ? 0 : a.count + b.count - 1;
  // A sum of up to seven products is rounded by eight units of their sizes at most.
  for (std::size_t k = 0; k < product.count; ++k) {
    double mid = 0, rad = 0, size = 0;
    for (std::size_t m = k < b.count ? 0 : k + 1 - b.count; m <= std::min(k, a.count - 1); ++m) {
      const Ball3<double>&p = a.coefficient[m], &q = b.coefficient[k - m];
      const double term = p.mid * q.mid;
      mid += term;
      size += std::fabs(term);
      rad += std::fabs(p.mid) * q.rad + p.rad * (std::fabs(q.mid) + q.rad);
    }
    product.coefficient[k] = {mid, up(rad + 8 * kUnit * size)};
  }
  return product;
}

ProvenPolynomial3 polynomial_3(const Ball3<double>& value) {
  ProvenPolynomial3 result;
  result.coefficient[0] = value;
  result.count = 1;
  return result;
}

// With s = d + u: p + s q + s^2 r = (p + d (q + d r)) + u (q + 2 d r) + u^2 r.
ProvenPoint3<ProvenPolynomial3> about(const ProvenVector3<double>& vector, double from) {
  using Number = Ball3<double>;
  const Number d = Number::of(from, 0) + Number::of(-vector.base, 0);
  const auto component = [&](double LocalVector3<double>::*axis) {
    const Number p = Number::of(vector.power[0].*axis, vector.error[0]);
    const Number q = Number::of(vector.power[1].*axis, vector.error[1]);
    ProvenPolynomial3 result;
    if (vector.is_linear) {
      result.coefficient = {p + d * q, q};
      result.count = 2;
      return result;
    }
    const Number r = Number::of(vector.power[2].*axis, vector.error[2]), dr = d * r;
    result.coefficient = {p + d * (q + dr), q + (dr + dr), r};
    result.count = 3;
    return result;
  };
  return {component(&LocalVector3<double>::x), component(&LocalVector3<double>::y),
          component(&LocalVector3<double>::z)};
}

// Horner's scheme, again and again, leaves the Taylor coefficients at the centre c. Every a_k comes into the j-th by k
// - j products with c and k sums at most, in each of which it is rounded by 4 units: into all together by 64 units of
// |a_k| (|c| + r)^k at most.
Disc3 over(const ProvenPolynomial3& polynomial, const Disc3& disc) {
  constexpr double kRoundings = 64 * kUnit;
  const std::size_t count = polynomial.count;
  if (count == 0) return {};
  std::array<double, ProvenPolynomial3::kMost> re{}, im{};
  for (std::size_t k = 0; k < count; ++k) re[k] = polynomial.coefficient[k].mid;
  for (std::size_t j = 0; j + 1 < count; ++j)
    for (std::size_t k = count - 1; k-- > j;) {
      const double x = re[k + 1], y = im[k + 1];
      re[k] += x * disc.re - y * disc.im;
      im[k] += x * disc.im + y * disc.re;
    }
  const double farthest = disc.size() + disc.rad;
  double spread = 0, off = 0;
  for (std::size_t k = count; k-- > 0;) {
    const Ball3<double>& a = polynomial.coefficient[k];
    off = off * farthest + (a.rad + kRoundings * std::fabs(a.mid));
    if (k > 0) spread = (spread + std::sqrt(re[k] * re[k] + im[k] * im[k])) * disc.rad;
  }
  return {re[0], im[0], up(up(spread + off))};
}

}  // namespace hottel
