// Exact questions about points, answered without Integers where coordinates are short. Internal to geometry/space.
#pragma once

#include <cstdint>
#include <optional>

#include "kernel/determinant.h"
#include "kernel/int128.h"

namespace hottel {

// The number, where it has up to `most` bits, at most 62.
inline std::optional<std::int64_t> short_integer_3(const Integer& a, int most) {
  if (mpz_size(a.get_mpz_t()) > 1) return {};
  const auto size = static_cast<std::uint64_t>(mpz_getlimbn(a.get_mpz_t(), 0));
  if (size >> most != 0) return {};
  return sgn(a) < 0 ? -static_cast<std::int64_t>(size) : static_cast<std::int64_t>(size);
}

// Bits of factors whose product has 62.
inline constexpr int kShortFactor3 = 31;

// Whether point / weight is a vertex. COST: some nanoseconds, if coordinates are short.
inline bool is_at_vertex_3(const IntegerVector& point, const Integer& weight, const IntegerVector& vertex) {
  thread_local Integer product;
  const auto w = short_integer_3(weight, kShortFactor3);
  const auto is_same = [&](const Integer& a, const Integer& b) {
    if (const auto p = short_integer_3(a, 2 * kShortFactor3), v = short_integer_3(b, kShortFactor3); w && p && v)
      return *p == *w * *v;
    mpz_mul(product.get_mpz_t(), weight.get_mpz_t(), b.get_mpz_t());
    return a == product;
  };
  return is_same(point.x, vertex.x) && is_same(point.y, vertex.y) && is_same(point.z, vertex.z);
}

// Where point / weight lies of the plane through a vertex: +1 where the normal points to, -1 behind, 0 on it.
// COST: some nanoseconds, if coordinates are short.
inline int plane_side_3(const IntegerVector& normal, const IntegerVector& point, const Integer& weight,
                        const IntegerVector& vertex) {
  const auto w = short_integer_3(weight, kShortFactor3);
  Int128 sum = 0;
  const auto add = [&](const Integer& a, const Integer& b, const Integer& c) {
    const auto n = short_integer_3(a, 2 * kShortFactor3), p = short_integer_3(b, 2 * kShortFactor3),
               v = short_integer_3(c, kShortFactor3);
    if (!n || !p || !v) return false;
    sum += static_cast<Int128>(*n) * (*p - *w * *v);  // three numbers below 2^125
    return true;
  };
  if (w && add(normal.x, point.x, vertex.x) && add(normal.y, point.y, vertex.y) && add(normal.z, point.z, vertex.z))
    return sum > 0 ? 1 : sum < 0 ? -1 : 0;
  return dot_sign(normal, difference(point, multiple(weight, vertex)));
}

}  // namespace hottel
