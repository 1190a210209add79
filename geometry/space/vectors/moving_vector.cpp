#include "geometry/space/vectors/moving_vector.h"

#include <limits>

namespace hottel {

Direction3 value_at(const MovingVector3& a, double s) { return plain(a.first) + s * (a.second + s * a.third); }

double shortest_between(const MovingVector3& a, double low, double high) {
  const Direction3 first = plain(a.first);
  const bool is_linear = size_of(a.third) == 0;
  // A simple zero at an end costs digits in proportion to the part of the piece in which they are lost: harmless.
  const double margin = is_linear ? 0.01 * (high - low) : 0;
  low += margin;
  high -= margin;
  double best = low, least = std::numeric_limits<double>::infinity();
  const auto take = [&](double s) {
    s = std::clamp(s, low, high);
    const Direction3 d = value_at(a, s);
    if (const double square = dot(d, d); square < least) {
      least = square;
      best = s;
    }
  };
  if (is_linear) {
    const double square = dot(a.second, a.second);
    return square > 0 ? std::clamp(-dot(first, a.second) / square, low, high) : low;
  }
  constexpr int kSamples = 4;
  for (int k = 0; k <= kSamples; ++k) take(low + k * (high - low) / kSamples);
  // From there along the tangent, a few times.
  for (int k = 0; k < 3; ++k) {
    const Direction3 slope = a.second + (2 * best) * a.third;
    const double square = dot(slope, slope);
    if (square > 0) take(best - dot(value_at(a, best), slope) / square);
  }
  return best;
}

double nearest_to_zero(const MovingVector3& vector, double low, double high) {
  if (size_of(vector.third) != 0) return shortest_between(vector, low, high);
  const double square = dot(vector.second, vector.second);
  return square > 0 ? -dot(plain(vector.first), vector.second) / square : low;
}

MovingVector3 opposite(const MovingVector3& vector) {
  const BoundedVector& a = vector.first;
  return {{-a.x, -a.y, -a.z, a.size, a.error}, -vector.second, -vector.third, vector.terms, vector.base};
}

double ldexp_3(double value, long exponent) {
  return std::ldexp(value, static_cast<int>(std::clamp(exponent, -4000L, 4000L)));
}

void split_double_3(double t, Integer& mantissa, unsigned& places) {
  int exponent = 0;
  mantissa = static_cast<long>(std::ldexp(std::frexp(t, &exponent), 53));
  places = 0;
  if (mantissa == 0) return;
  const auto all = static_cast<mp_bitcnt_t>(53 - exponent);
  const mp_bitcnt_t zeros = std::min(mpz_scan1(mantissa.get_mpz_t(), 0), all);
  mantissa >>= zeros;
  places = static_cast<unsigned>(all - zeros);
}

}  // namespace hottel
