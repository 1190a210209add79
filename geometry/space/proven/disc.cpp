// Inverses, roots and arc tangents of discs.
#include <algorithm>

#include "geometry/space/proven/ball.h"

namespace hottel {
namespace {

using namespace ball_arithmetic_3;

// How far the centre is from a point at least.
double distance(const Disc3& a, double re, double im) {
  const double x = a.re - re, y = a.im - im;
  return down(std::sqrt(x * x + y * y));
}

constexpr Disc3 kUnknown{0, 0, kNothingKnown};

}  // namespace

// |1 / w - 1 / c| = |w - c| / |w c|.
Disc3 inverse(const Disc3& a) {
  const double least = distance(a, 0, 0), inner = down(least - a.rad);
  if (!(inner > kTiny)) return kUnknown;
  const double square = a.re * a.re + a.im * a.im;
  return {a.re / square, -a.im / square, up(a.rad / (least * inner) + 12 * kUnit / least)};
}

// With x = r / |c| < 1 the series of the root about c gives |sqrt(w) - sqrt(c)| <= sqrt|c| (1 - sqrt(1 - x)), which is
// r / (sqrt|c| (1 + sqrt(1 - x))). It is the principal one where the disc does not meet the negative numbers: to the
// right of zero it meets none without zero.
Disc3 root(const Disc3& a) {
  const double least = distance(a, 0, 0);
  const bool misses_cut = least > a.rad && (a.re > 0 || std::fabs(a.im) > a.rad);
  if (!misses_cut || !(least > kTiny)) return kUnknown;
  const double modulus = std::sqrt(a.re * a.re + a.im * a.im);
  const double larger = std::sqrt((modulus + std::fabs(a.re)) / 2), smaller = std::fabs(a.im) / (2 * larger);
  const double rest = std::max(0.0, down(down(1 - up(a.rad / least))));
  const double radius = a.rad / down(std::sqrt(least) * (1 + std::sqrt(rest)));
  Disc3 result{a.re > 0 ? larger : smaller, std::copysign(a.re > 0 ? smaller : larger, a.im), 0};
  result.rad = up(radius + 24 * kUnit * result.parts());
  return result;
}

// Its slope is 1 / ((w - i) (w + i)). The cuts are the imaginary numbers from i and -i outward: a disc that holds
// neither of these and has its centre between them, by height, does not meet a cut.
//
// Re = atan2(2 x, 1 - |z|^2) / 2, where 1 - |z|^2 is rounded by 4 units of 1 + |z|^2 at most, and the length of both is
// |z - i| |z + i|. |Im| = log(1 + 4 |y| / (x^2 + (1 - |y|)^2)) / 4: nothing cancels.
Disc3 arc_tangent(const Disc3& a) {
  const double upper = distance(a, 0, 1), lower = distance(a, 0, -1);
  const double inner = down(upper - a.rad), other = down(lower - a.rad);
  const bool misses_cuts = std::fabs(a.re) > up(a.rad) || std::fabs(a.im) < 1;
  if (!(inner > 0x1p-40 && other > 0x1p-40) || !misses_cuts) return kUnknown;
  const double y = std::fabs(a.im), square = a.re * a.re + y * y;
  const double re = std::atan2(2 * a.re, 1 - square) / 2;
  const double height = std::log1p(4 * y / (a.re * a.re + (1 - y) * (1 - y))) / 4;
  const double rounding = 4 * kUnit * (1 + square) / (upper * lower) + (kOfLibrary + 2) * kUnit * std::fabs(re) +
                          (kOfLibrary + 12) * kUnit * height;
  return {re, std::copysign(height, a.im), up(a.rad / (inner * other) + rounding)};
}

}  // namespace hottel
