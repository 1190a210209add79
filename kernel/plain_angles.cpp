// Angles, sines and cosines. Tables are made by the compiler.
#include <array>
#include <bit>
#include <cstdint>
#include <limits>

#include "kernel/ball_number.h"
#include "kernel/plain_functions.h"
#include "kernel/two_doubles.h"

namespace hottel::same_bits {
namespace {

using Two = DoubleDouble;

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
constexpr Two kHalfTurn{0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};
constexpr Two kQuarterTurn{kHalfTurn.hi / 2, kHalfTurn.lo / 2};

// ---- Angles
//
// Of y / x in [0, 1]: the angle is that of an entry c = i / 64 and the arc tangent of s = (y - c x) / (x + c y), |s| <
// 1/126.

constexpr std::size_t kAngleEntries = 64;

// The arc tangents of i / 64.
constexpr std::array<Two, kAngleEntries + 1> arc_tangents() {
  std::array<Two, kAngleEntries + 1> angles{};
  constexpr double kAll = kAngleEntries;
  for (std::size_t i = 1; i <= kAngleEntries; ++i) {
    const auto n = static_cast<double>(i);
    angles[i] = plus(angles[i - 1], odd_series(over(Two{kAll, 0}, kAll * kAll + n * (n - 1)), -1));
  }
  return angles;
}

// Angles of four directions: along x; beyond the diagonal, where x and y change places; both with x turned round.
struct AngleTable {
  std::array<std::array<Two, kAngleEntries + 1>, 4> base;
};
constexpr AngleTable angle_table() {
  constexpr std::array<Two, kAngleEntries + 1> angles = arc_tangents();
  AngleTable table{};
  for (std::size_t i = 0; i <= kAngleEntries; ++i) {
    const Two& angle = angles[i];
    table.base[0][i] = angle;
    table.base[1][i] = plus(kQuarterTurn, {-angle.hi, -angle.lo});
    table.base[2][i] = plus(kHalfTurn, {-angle.hi, -angle.lo});
    table.base[3][i] = plus(kQuarterTurn, angle);
  }
  return table;
}
constexpr AngleTable kAngles = angle_table();

// The quotient of two numbers, good to some 2^-75 of it. REQUIRES: b > 0, normal, as is its inverse.
Two long_quotient(const Two& a, const Two& b) {
  const double inverse = 1 / b.hi, first = a.hi * inverse;
  const double fh = upper_half(first), fl = first - fh, bh = upper_half(b.hi), bl = b.hi - bh;
  const double left = ((a.hi - fh * bh) - fh * bl) - fl * b.hi;
  return {first, (left + (a.lo - first * b.lo)) * inverse};
}

// The angle of (more, less), 0 <= less <= more, seen from a direction. REQUIRES: `more` is of a size that loses
// nothing, and less is 0 or not below 2^-200 of it.
double angle_from(int direction, double less, double more) {
  const int i = static_cast<int>(less / more * kAngleEntries + 0.5);
  const double c = i * (1.0 / kAngleEntries);
  const double mh = upper_half(more), ml = more - mh, lh = upper_half(less), ll = less - lh;
  // What is lost of both sums is exact: so few are the bits of c.
  const double first = less - c * more, second = more + c * less;
  const Two over{first, ((less - first) - c * mh) - c * ml}, under{second, ((more - second) + c * lh) + c * ll};
  const Two s = long_quotient(over, under);
  const double square = s.hi * s.hi;
  const double bent = s.hi * square * (1.0 / 3 - square * (1.0 / 5 - square * (1.0 / 7 - square * (1.0 / 9))));
  const double sign = direction == 1 || direction == 2 ? -1 : 1;
  const Two& base = kAngles.base[static_cast<std::size_t>(direction)][static_cast<std::size_t>(i)];
  const Two sum = ordered_sum(base.hi, sign * s.hi);
  return sum.hi + (sum.lo + (base.lo + sign * (s.lo - bent)));
}

constexpr double kLargeEnough = 0x1p-400, kSmallEnough = 0x1p400, kFlat = 0x1p-70;

// The same of any size. REQUIRES: less < more.
double angle_of_any(int direction, double less, double more) {
  if (more < kLargeEnough) return angle_of_any(direction, less * 0x1p700, more * 0x1p700);
  if (less < kFlat * more) return direction == 0 ? less / more : angle_from(direction, 0, 1);
  const double scale = more > kSmallEnough ? 0x1p-700 : 1;
  return angle_from(direction, less * scale, more * scale);
}

// ---- Sines

constexpr double kMostQuick = 0x1p20;
constexpr double kToWhole = 0x1.8p52;  // added and taken away: rounded to a whole number

// The angle less a whole number of quarter turns, and that number modulo 4.
struct TurnParts {
  Two rest;
  unsigned quarters;
};

// Quarter turns in four parts, the first three of 33 bits: their products with numbers up to 2^20 are exact.
constexpr std::array<double, 4> kQuarterParts = {0x1.921fb544p+0, 0x1.0b4611a6p-34, 0x1.3198a2e0p-69,
                                                 0x1.b839a252049c1p-104};

// REQUIRES: |x| <= kMostQuick.
TurnParts turn_parts(double x) {
  const double turns = (x * (1 / kQuarterTurn.hi) + kToWhole) - kToWhole;
  const Two first = exact_sum(x - turns * kQuarterParts[0], -turns * kQuarterParts[1]);
  const Two second = exact_sum(first.hi, -turns * kQuarterParts[2]);
  const double rest = first.lo + second.lo - turns * kQuarterParts[3];
  return {ordered_sum(second.hi, rest), static_cast<unsigned>(static_cast<std::int64_t>(turns)) % 4};
}

// What is left of the series of the sine after the third power, in fifth powers, and of the cosine after the square, in
// fourth powers. What comes after that is 2^-62 at most.
double sine_tail(double q) {
  const double square = q * q;
  return (1.0 / 120 - q * (1.0 / 5040)) +
         square * ((1.0 / 362880 - q * (1.0 / 39916800)) +
                   square * ((1.0 / 6227020800 - q * (1.0 / 1307674368000)) + square * (1.0 / 355687428096000)));
}
double cosine_tail(double q) {
  const double square = q * q;
  return (1.0 / 24 - q * (1.0 / 720)) +
         square * ((1.0 / 40320 - q * (1.0 / 3628800)) +
                   square * ((1.0 / 479001600 - q * (1.0 / 87178291200)) + square * (1.0 / 20922789888000)));
}

// The third power of the first 17 bits is exact, so that a sixth of it is rounded once.
double sine_of(const Two& r) {
  const double x = r.hi, q = x * x, first = std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & 0xfffffff000000000);
  const double cube = first * first * first * (1.0 / 6);
  const double other = (x - first) * (q + x * first + first * first) * (1.0 / 6);
  const Two sum = ordered_sum(x, -cube);
  return sum.hi + (sum.lo + (r.lo * (1 - 0.5 * q) + (q * q * x * sine_tail(q) - other)));
}

// The square of the first 26 bits is exact.
double cosine_of(const Two& r) {
  const double x = r.hi, q = x * x, first = upper_half(x);
  const double other = 0.5 * (x - first) * (x + first) + x * r.lo;
  const Two sum = ordered_sum(1, -0.5 * first * first);
  return sum.hi + (sum.lo + (q * q * cosine_tail(q) - other));
}

// By balls of some thousand bits, which have room for every double.
template <class Function>
double of_huge(double x, Function function) {
  if (!std::isfinite(x)) return kNothing;
  BallNumber ball;
  arb_set_d(ball.x, x);
  function(ball.x, ball.x, 1200);
  return arf_get_d(arb_midref(ball.x), ARF_RND_NEAR);
}

double sine_by_quarters(double x, unsigned more) {
  const auto [rest, quarters] = turn_parts(x);
  const unsigned all = (quarters + more) % 4;
  const double value = all % 2 == 0 ? sine_of(rest) : cosine_of(rest);
  return all < 2 ? value : -value;
}

}  // namespace

double atan2(double y, double x) {
  if (x != x || y != y) return kNothing;
  const double a = std::fabs(x), b = std::fabs(y);
  const bool is_steep = b > a;
  const double more = is_steep ? b : a, less = is_steep ? a : b;
  const int direction = (std::signbit(x) ? 2 : 0) + (is_steep ? 1 : 0);
  double angle;
  if (more > kLargeEnough && more < kSmallEnough && less >= kFlat * more) [[likely]]
    angle = angle_from(direction, less, more);
  else if (less == more)
    angle = angle_from(direction, more == 0 ? 0 : 1, 1);
  else
    angle = angle_of_any(direction, less, more);
  return std::copysign(angle, y);
}

double acos(double x) { return std::fabs(x) <= 1 ? atan2(std::sqrt((1 - x) * (1 + x)), x) : kNothing; }

double sin(double x) {
  if (std::fabs(x) <= kMostQuick) [[likely]]
    return x == 0 ? x : sine_by_quarters(x, 0);
  return of_huge(x, arb_sin);
}

double cos(double x) {
  if (std::fabs(x) <= kMostQuick) [[likely]]
    return sine_by_quarters(x, 1);
  return of_huge(x, arb_cos);
}

}  // namespace hottel::same_bits
