#include "geometry/space/unobstructed/rectangle_form.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "kernel/plain_functions.h"

namespace hottel {
namespace {

std::optional<Rational> rational_root(const Rational& square) {
  const Integer numerator = sqrt(square.get_num()), denominator = sqrt(square.get_den());
  if (numerator * numerator != square.get_num() || denominator * denominator != square.get_den()) return std::nullopt;
  return Rational(numerator) / denominator;
}

// A rectangle in the frame of its two sides and its normal, all of rational length.
struct Rectangle {
  Point3 corner;
  std::array<Vector3, 3> axes;  // of length 1
  Rational wide, high;
};

Vector3 scaled(const Vector3& v, const Rational& factor) { return {v.x * factor, v.y * factor, v.z * factor}; }

std::optional<Rectangle> rectangle_of(const std::vector<Point3>& p) {
  if (p.size() != 4) return std::nullopt;
  const Vector3 u = p[1] - p[0], v = p[3] - p[0], opposite = p[2] - p[1];
  if (dot(u, v) != 0 || !(opposite == v)) return std::nullopt;
  const auto wide = rational_root(dot(u, u)), high = rational_root(dot(v, v));
  if (!wide || !high || *wide == 0 || *high == 0) return std::nullopt;
  const Vector3 x = scaled(u, 1 / *wide), y = scaled(v, 1 / *high);
  return Rectangle{p[0], {x, y, cross(x, y)}, *wide, *high};
}

struct Interval {
  Rational low, high;
};

// The corners of a rectangle along an axis, from an origin.
Interval extent(const Rectangle& r, const Vector3& axis, const Point3& origin) {
  const Rational at = dot(r.corner - origin, axis), u = r.wide * dot(r.axes[0], axis),
                 v = r.high * dot(r.axes[1], axis);
  const Rational zero = 0;
  return {at + std::min(u, zero) + std::min(v, zero), at + std::max(u, zero) + std::max(v, zero)};
}

bool is_along(const Rectangle& r, const Vector3& axis) {
  return std::ranges::any_of(r.axes, [&](const Vector3& own) { return cross(own, axis).is_zero(); });
}

// (1/2) sum over corners with signs of a term of x - xi, y - eta.
template <class Term>
void add_corners(const Interval& x, const Interval& y, const Interval& xi, const Interval& eta, const Term& term) {
  for (int k = 0; k < 16; ++k) {
    const auto end = [k](const Interval& of, int bit) -> const Rational& { return k >> bit & 1 ? of.high : of.low; };
    const int ones = (k & 1) + (k >> 1 & 1) + (k >> 2 & 1) + (k >> 3 & 1);
    term(Rational(ones % 2 == 0 ? 1 : -1) / 2, end(x, 0), end(y, 1), end(xi, 2), end(eta, 3));
  }
}

ArcSum3 parallel(const Interval& x, const Interval& y, const Interval& xi, const Interval& eta, const Rational& z) {
  ArcSum3 sum;
  const Rational square = z * z;
  add_corners(x, y, xi, eta,
              [&](const Rational& sign, const Rational& a, const Rational& b, const Rational& c, const Rational& d) {
                const Rational dx = a - c, dy = b - d;
                sum.add_arc(sign * dy, dx * dx + square, dy);
                sum.add_arc(sign * dx, dy * dy + square, dx);
                sum.add_log(-sign * square / 2, dx * dx + dy * dy + square);
              });
  return sum;
}

// x and xi from the line that both planes share, y and eta along it.
ArcSum3 perpendicular(const Interval& x, const Interval& y, const Interval& xi, const Interval& eta) {
  ArcSum3 sum;
  add_corners(x, y, xi, eta,
              [&](const Rational& sign, const Rational& a, const Rational& b, const Rational& c, const Rational& d) {
                const Rational square = a * a + c * c, way = b - d, whole = square + way * way;
                if (square != 0) sum.add_arc(sign * way, square, way);
                if (whole != 0) sum.add_log(-sign * (square - way * way) / 4, whole);
              });
  return sum;
}

// The part that is not below 0; nothing where that has no length.
std::optional<Interval> above_zero(const Interval& of) {
  if (of.high <= 0) return std::nullopt;
  return Interval{std::max<Rational>(of.low, 0), of.high};
}

// `to` stands at right angles on the plane of `from`.
ArcSum3 at_right_angles(const Rectangle& from, const Rectangle& to) {
  const Vector3 along = cross(from.axes[2], to.axes[2]);
  const Point3 on_both = to.corner;
  const auto x = above_zero(extent(from, to.axes[2], on_both));
  const auto xi = above_zero(extent(to, from.axes[2], from.corner));
  if (!x || !xi) return {};
  return perpendicular(*x, extent(from, along, on_both), *xi, extent(to, along, on_both));
}

// The whole exponent of a small prime in a number, which is divided by it.
long exponent_of(Integer& number, unsigned long prime) {
  const Integer divisor(prime);
  return static_cast<long>(mpz_remove(number.get_mpz_t(), number.get_mpz_t(), divisor.get_mpz_t()));
}

constexpr std::array<unsigned long, 25> kPrimes{2,  3,  5,  7,  11, 13, 17, 19, 23, 29, 31, 37, 41,
                                                43, 47, 53, 59, 61, 67, 71, 73, 79, 83, 89, 97};

template <class Key>
void add_to(std::map<Key, Rational>& terms, const Key& key, const Rational& coefficient) {
  Rational& sum = terms[key];
  sum += coefficient;
  if (sum == 0) terms.erase(key);
}

// c sqrt(r) with r = p / q as c / q sqrt(p q), without the squares of small primes.
std::pair<Rational, Integer> simple_root(const Rational& square) {
  Integer under = square.get_num() * square.get_den();
  Rational before = Rational(1) / square.get_den();
  if (const auto root = rational_root(Rational(under))) return {before * *root, 1};
  for (const unsigned long prime : kPrimes)
    while (mpz_divisible_ui_p(under.get_mpz_t(), prime * prime) != 0) {
      under /= prime * prime;
      before *= prime;
    }
  return {before, under};
}

// A term after others: " - 1/2*x"; the first one without blanks and plus.
void append(std::string& text, Rational coefficient, const std::string& factor) {
  const bool is_negative = coefficient < 0;
  if (text.empty())
    text += is_negative ? "-" : "";
  else
    text += is_negative ? " - " : " + ";
  coefficient = abs(coefficient);
  text += (coefficient == 1 ? "" : hottel::to_string(coefficient) + "*") + factor;
}

std::string root_text(const Integer& under) { return "sqrt(" + under.get_str() + ")"; }

}  // namespace

void ArcSum3::add_arc(const Rational& coefficient, const Rational& square, const Rational& numerator) {
  if (numerator == 0 || coefficient == 0) return;
  add_to<std::pair<Rational, Rational>>(arcs_, {square, abs(numerator)}, numerator < 0 ? -coefficient : coefficient);
}

void ArcSum3::add_log(const Rational& coefficient, const Rational& of) {
  if (coefficient == 0) return;
  Integer numerator = of.get_num(), denominator = of.get_den();
  for (const unsigned long prime : kPrimes)
    if (const long exponent = exponent_of(numerator, prime) - exponent_of(denominator, prime); exponent != 0)
      add_to(logs_, Rational(prime), coefficient * exponent);
  if (numerator != 1) add_to(logs_, Rational(numerator), coefficient);
  if (denominator != 1) add_to(logs_, Rational(denominator), -coefficient);
}

std::string ArcSum3::to_string() const {
  std::string text;
  for (const auto& [key, coefficient] : arcs_) {
    const auto& [square, numerator] = key;
    const auto [before, under] = simple_root(square);
    if (under == 1) {
      append(text, coefficient * before, "atan(" + hottel::to_string(Rational(numerator / before)) + ")");
      continue;
    }
    const Rational ratio = numerator / before / under;  // p / (before sqrt(u)) = ratio sqrt(u)
    append(text, coefficient * before,
           root_text(under) + "*atan(" + (ratio == 1 ? "" : hottel::to_string(ratio) + "*") + root_text(under) + ")");
  }
  for (const auto& [of, coefficient] : logs_) append(text, coefficient, "log(" + hottel::to_string(of) + ")");
  return text.empty() ? "0" : "(" + text + ")/pi";
}

double ArcSum3::value() const {
  long double sum = 0;
  for (const auto& [key, coefficient] : arcs_) {
    const long double root = std::sqrt(static_cast<long double>(to_double(key.first)));
    sum += to_double(coefficient) * root * same_bits::atan(to_double(key.second) / root);
  }
  for (const auto& [of, coefficient] : logs_)
    sum += to_double(coefficient) * same_bits::log(static_cast<long double>(to_double(of)));
  return static_cast<double>(sum / std::numbers::pi_v<long double>);
}

std::optional<ArcSum3> rectangle_exchange(const std::vector<Point3>& from, const std::vector<Point3>& to) {
  const std::optional<Rectangle> a = rectangle_of(from), b = rectangle_of(to);
  if (!a || !b || !is_along(*b, a->axes[0]) || !is_along(*b, a->axes[1])) return std::nullopt;
  if (dot(a->axes[2], b->axes[2]) == 0) return at_right_angles(*a, *b);
  const Rational height = dot(b->corner - a->corner, a->axes[2]);
  if (dot(a->axes[2], b->axes[2]) > 0 || height <= 0) return ArcSum3();
  return parallel(extent(*a, a->axes[0], a->corner), extent(*a, a->axes[1], a->corner),
                  extent(*b, a->axes[0], a->corner), extent(*b, a->axes[1], a->corner), height);
}

std::optional<Rational> rectangle_area(const std::vector<Point3>& corners) {
  const std::optional<Rectangle> rectangle = rectangle_of(corners);
  return rectangle ? std::optional<Rational>(rectangle->wide * rectangle->high) : std::nullopt;
}

}  // namespace hottel
