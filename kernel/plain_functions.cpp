// Logarithms, exponentials and powers. Tables are made by the compiler.
#include "kernel/plain_functions.h"

#include <array>
#include <bit>
#include <cstdint>
#include <limits>

#include "kernel/doubles.h"
#include "kernel/two_doubles.h"

namespace hottel::same_bits {
namespace {

using Two = DoubleDouble;

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

constexpr Two kLn2{0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56};

// ---- Logarithms
//
// x = 2^k z, and z c = 1 + r for an entry c = m / 128 near 1 / z: ln x = k ln 2 - ln c + ln(1 + r), |r| < 0.0095.

// Entries by the first seven bits of z less kLeast, which has those of 0.703125: so they are around 1 too.
constexpr std::uint64_t kLeast = std::bit_cast<std::uint64_t>(0.703125);
constexpr int kLogBits = 7;
constexpr std::size_t kLogEntries = 1 << kLogBits;
constexpr double kOnGrid = 0x1.8p10;  // added and taken away: rounded to a multiple of 2^-42

struct LogEntry {
  double inverse;  // c
  Two log;         // -ln c, of which hi is a multiple of 2^-42
};

constexpr double upper_log_bits(double x) { return (x + kOnGrid) - kOnGrid; }

// ln(m / 128) less ln((m - 1) / 128).
constexpr Two log_step(int m) {
  const Two half = odd_series(over(Two{1, 0}, 2 * m - 1), 1);
  return {2 * half.hi, 2 * half.lo};
}

constexpr std::array<LogEntry, kLogEntries> log_entries() {
  constexpr int kFirst = 90, kLast = 184;
  std::array<Two, kLast + 1> logs{};  // of m / 128
  for (int m = 129; m <= kLast; ++m) logs[m] = plus(logs[m - 1], log_step(m));
  for (int m = 127; m >= kFirst; --m) {
    const Two step = log_step(m + 1);
    logs[m] = plus(logs[m + 1], {-step.hi, -step.lo});
  }
  std::array<LogEntry, kLogEntries> entries{};
  for (std::size_t k = 0; k < kLogEntries; ++k) {
    const std::uint64_t from = kLeast + (static_cast<std::uint64_t>(k) << (52 - kLogBits));
    const double low = std::bit_cast<double>(from), high = std::bit_cast<double>(from + (1ull << (52 - kLogBits)));
    const int m = static_cast<int>(256 / (low + high) + 0.5);
    const double hi = -upper_log_bits(logs[m].hi);
    entries[k] = {m / 128.0, {hi, (-logs[m].hi - hi) - logs[m].lo}};
  }
  return entries;
}
constexpr std::array<LogEntry, kLogEntries> kLogs = log_entries();
constexpr double kLn2Upper = upper_log_bits(kLn2.hi), kLn2Lower = (kLn2.hi - kLn2Upper) + kLn2.lo;

// x = 2^k z with its entry, and r.
struct LogParts {
  const LogEntry& entry;
  double k, r;
};

// REQUIRES: bits of a normal positive number.
LogParts log_parts(std::uint64_t bits, int exponent) {
  const std::uint64_t above = bits - kLeast;
  const LogEntry& entry = kLogs[(above >> (52 - kLogBits)) % kLogEntries];
  const double z = std::bit_cast<double>(bits - (above & (0xfffull << 52)));
  // z and 1 + r are multiples of 2^-53 and 2^-60: so nothing here is rounded.
  const double zh = upper_half(z), r = (zh * entry.inverse - 1) + (z - zh) * entry.inverse;
  return {entry, static_cast<double>((static_cast<std::int64_t>(above) >> 52) + exponent), r};
}

// ln(1 + r) - r + r^2 / 2, off by 2^-67.
double log_from_cubes(double r) {
  const double square = r * r;
  return r * square *
         ((1.0 / 3 - r * (1.0 / 4)) +
          square * ((1.0 / 5 - r * (1.0 / 6)) + square * ((1.0 / 7 - r * (1.0 / 8)) + square * (1.0 / 9))));
}

// Cubes count for little, and r alone is not rounded: what is off is the last sum.
double log_of_normal(std::uint64_t bits, int exponent) {
  const auto [entry, k, r] = log_parts(bits, exponent);
  const Two first = ordered_sum(k * kLn2Upper + entry.log.hi, r);
  const double rest = first.lo + (k * kLn2Lower + entry.log.lo);
  return first.hi + (rest + (r * r * -0.5 + log_from_cubes(r)));
}

// The same as two doubles, off by 2^-68 of it.
Two long_log(std::uint64_t bits, int exponent) {
  const auto [entry, k, r] = log_parts(bits, exponent);
  const double rh = upper_half(r),
               half = -0.5 * rh * rh;  // -r^2 / 2 in two parts
  const double other = -0.5 * (r - rh) * (r + rh);
  const Two first = ordered_sum(k * kLn2Upper + entry.log.hi, r), second = ordered_sum(first.hi, half);
  const double rest = (k * kLn2Lower + entry.log.lo) + first.lo + second.lo + other;
  return ordered_sum(second.hi, rest + log_from_cubes(r));
}

bool is_normal_and_positive(std::uint64_t bits) { return bits - (1ull << 52) < (0x7feull << 52); }

// 1 / ln 2 and 1 / ln 10.
constexpr Two kBinary{0x1.71547652b82fep+0, 0x1.777d0ffda0d24p-56},
    kDecimal{0x1.bcb7b1526e50ep-2, 0x1.95355baaafad3p-57};

constexpr int kRaised = 54;  // subnormal numbers are made normal by this power of two

// The same of any number that is finite and above 0.
Two long_log_of(double x) {
  return x < 0x1p-1022 ? long_log(std::bit_cast<std::uint64_t>(x * 0x1p54), -kRaised)
                       : long_log(std::bit_cast<std::uint64_t>(x), 0);
}

// Of 0, infinity, and what has no logarithm.
double special_log(double x) {
  if (x == 0) return -kInfinity;
  return x > 0 ? x : kNothing;
}

// The logarithm in units of that of another number, given by its inverse.
double log_in(const Two& inverse, double x) {
  if (!(x > 0 && x < kInfinity)) return special_log(x);
  const Two ln = times(long_log_of(x), inverse);
  return ln.hi + ln.lo;
}

// ---- Exponentials
//
// x = (128 k + j) ln 2 / 128 + r, and e^x = 2^k 2^(j / 128) e^r, |r| < 0.0028.

constexpr int kExpBits = 7;
constexpr std::size_t kExpEntries = 1 << kExpBits;
constexpr double kExpUpper = ((kLn2.hi / kExpEntries) + 0x1.8p10) - 0x1.8p10,
                 kExpLower = (kLn2.hi / kExpEntries - kExpUpper) + kLn2.lo / kExpEntries;
constexpr double kPerLn2 = kExpEntries / kLn2.hi;
constexpr double kWhole = 0x1.8p52;  // added and taken away: rounded to a whole number

constexpr std::array<Two, kExpEntries> exp_entries() {
  const Two step{kLn2.hi / kExpEntries, kLn2.lo / kExpEntries};
  Two ratio{1, 0}, power{1, 0};
  for (int n = 1; n <= 14; ++n) {
    power = over(times(power, step), n);
    ratio = plus(ratio, power);
  }
  std::array<Two, kExpEntries> entries{};
  entries[0] = {1, 0};
  for (std::size_t j = 1; j < kExpEntries; ++j) entries[j] = times(entries[j - 1], ratio);
  return entries;
}
constexpr std::array<Two, kExpEntries> kExps = exp_entries();

// e^(x + more) as 2^k (entry + rest).
struct ExpParts {
  std::int64_t k;
  Two entry;
  double rest;
};

// REQUIRES: |x| < 1100, |more| < 2^-40.
ExpParts exp_parts(double x, double more) {
  const double shifted = x * kPerLn2 + kWhole, steps = shifted - kWhole;
  const auto whole = static_cast<std::int64_t>(steps);
  const double r = (x - steps * kExpUpper) - (steps * kExpLower - more), square = r * r;
  const double less_one = r + square * (0.5 + r * (1.0 / 6) + square * (1.0 / 24 + r * (1.0 / 120)));
  const Two& entry = kExps[static_cast<std::size_t>(whole) % kExpEntries];
  return {whole >> kExpBits, entry, entry.hi * less_one + entry.lo};
}

// REQUIRES: -1022 <= k <= 1023.
double power_of_two(std::int64_t k) { return std::bit_cast<double>(static_cast<std::uint64_t>(k + 1023) << 52); }

// 2^k x, rounded once at most. REQUIRES: 1/2 < |x| < 4, |k| < 1500.
double scaled(double x, std::int64_t k) {
  if (k > 1000) return x * power_of_two(1000) * power_of_two(k - 1000);
  if (k < -1000) return x * power_of_two(k + 600) * power_of_two(-600);
  return x * power_of_two(k);
}

// x + x^2/2 + ... + x^10/10!. REQUIRES: |x| <= 1/16.
double series_of_expm1(double x) {
  const double square = x * x;
  const double tail =
      1.0 / 6 + x * (1.0 / 24) +
      square * ((1.0 / 120 + x * (1.0 / 720)) +
                square * ((1.0 / 5040 + x * (1.0 / 40320)) + square * (1.0 / 362880 + x * (1.0 / 3628800))));
  return x + (0.5 * square + x * square * tail);
}

constexpr double kMostExp = 710, kLeastExp = -746;  // beyond: infinite, or 0

double exp_of(double x, double more) {
  if (x > kMostExp) return kInfinity;
  if (x < kLeastExp) return 0;
  const auto [k, entry, rest] = exp_parts(x, more);
  return scaled(entry.hi + rest, k);
}

}  // namespace

double log(double x) {
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
  if (is_normal_and_positive(bits)) [[likely]]
    return log_of_normal(bits, 0);
  if (!(x > 0 && x < kInfinity)) return special_log(x);
  return log_of_normal(std::bit_cast<std::uint64_t>(x * 0x1p54), -kRaised);
}

double log2(double x) { return log_in(kBinary, x); }
double log10(double x) { return log_in(kDecimal, x); }

// 1 + x is rounded to u: what was lost, over u, is the difference of the logarithms.
double log1p(double x) {
  if (!(x > -1)) return x == -1 ? -kInfinity : kNothing;
  if (x == kInfinity || std::fabs(x) < 0x1p-54) return x;
  const Two u = exact_sum(1, x);
  const Two value = long_log(std::bit_cast<std::uint64_t>(u.hi), 0);
  const double lost = u.lo / u.hi;
  return value.hi + (value.lo + lost * (1 - 0.5 * lost));
}

double exp(double x) { return x != x ? x : exp_of(x, 0); }

double expm1(double x) {
  if (x != x || std::fabs(x) < 0x1p-54) return x;
  if (std::fabs(x) < 0x1p-4) return series_of_expm1(x);
  if (x > kMostExp) return kInfinity;
  if (x < -50) return -1;
  const auto [k, entry, rest] = exp_parts(x, 0);
  if (k > 60) return scaled(entry.hi + rest, k);
  const double scale = power_of_two(k);
  const Two whole = exact_sum(scale * entry.hi, -1);
  return whole.hi + (whole.lo + scale * rest);
}

double pow(double x, double y) {
  if (y == 0 || x == 1) return 1;
  if (x != x || y != y || x < 0) return kNothing;
  if (x == 0 || x == kInfinity || std::isinf(y)) {
    if (x == 0 || x == kInfinity) return (x == 0) == (y > 0) ? 0 : kInfinity;
    return (x > 1) == (y > 0) ? kInfinity : 0;
  }
  const Two ln = long_log_of(x);
  const double first = y * ln.hi;
  if (!(first < 2 * kMostExp)) return kInfinity;
  if (first < 2 * kLeastExp) return 0;
  if (std::fabs(first) < 0x1p-60) return 1;
  const Two product = exact_product(y, ln.hi);
  return exp_of(product.hi, product.lo + y * ln.lo);
}

}  // namespace hottel::same_bits
