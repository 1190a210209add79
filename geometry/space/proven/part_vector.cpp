#include "geometry/space/proven/part_vector.h"

#include <algorithm>
#include <cmath>

namespace hottel {
namespace {

using namespace ball_arithmetic_3;

constexpr double kRootOfThree = 1.7320508075688774;
// No ellipse is asked for that reaches further.
constexpr double kFarthest = 1e6;
// Half axes and what is made of them, a few operations each, are rounded less than this.
constexpr double kRoundings = 0x1p-45;

double at(const std::array<double, 3>& c, double r) { return c[0] + r * (c[1] + r * c[2]); }

// Two quadratics y^2 + a y + b, y^2 + d y + e, and what a quartic is: powers of y downward.
struct Quadratics {
  double a, b, d, e;
};
using Quartic = std::array<double, 5>;

Quartic product(const Quadratics& f) { return {1, f.a + f.d, f.b + f.e + f.a * f.d, f.a * f.e + f.b * f.d, f.b * f.e}; }

// The largest root of z^3 + b z^2 + c z + d, d <= 0, about: from above, where it is convex if it has three.
double largest_root(double b, double c, double d) {
  constexpr int kMostSteps = 40;
  double z = std::fabs(b) + std::sqrt(std::fabs(c)) + std::cbrt(-d);
  for (int k = 0; k < kMostSteps; ++k) {
    const double slope = (3 * z + 2 * b) * z + c, step = (((z + b) * z + c) * z + d) / slope;
    if (!(slope > 0 && step > 1e-9 * z)) break;
    z -= step;
  }
  return std::max(z, 0.0);
}

// The factors of a quartic that is nowhere negative, about. With w = y + s it is (w^2 + k w + m) (w^2 - k w + l), where
// k^2 = z solves a cubic: m + l = p + z, m l = r, and l - m has the sign of q.
//
// SEE: Descartes, La Geometrie, 1637, book 3.
Quadratics quadratics_of(const Quartic& c) {
  const double s = c[1] / 4, s2 = s * s;
  const double p = c[2] - 6 * s2, q = c[3] - 2 * s * c[2] + 8 * s2 * s;
  const double r = c[4] - s * c[3] + s2 * c[2] - 3 * s2 * s2;
  const double z = largest_root(2 * p, p * p - 4 * r, -q * q), k = std::sqrt(z), sum = p + z;
  const double apart = std::copysign(std::sqrt(std::max(0.0, sum * sum - 4 * r)), q);
  return {2 * s + k, s2 + k * s + (sum - apart) / 2, 2 * s - k, s2 - k * s + (sum + apart) / 2};
}

// One step of Newton toward the factors.
void refine(const Quartic& c, Quadratics& f) {
  const Quartic found = product(f);
  const double rest1 = c[1] - found[1], other = c[2] - found[2] - f.a * rest1;
  const double u = c[3] - found[3] - f.a * other - f.b * rest1, v = c[4] - found[4] - f.b * other;
  const double apart = f.a - f.d, wide = f.e - f.b;
  const double determinant = wide * wide + apart * (f.a * wide + f.b * apart);
  const double to_a = (u * wide + v * apart) / determinant;
  const double to_b = (v * (wide + f.a * apart) - u * f.b * apart) / determinant;
  if (!std::isfinite(to_a + to_b)) return;
  f = {f.a + to_a, f.b + to_b, f.d + (rest1 - to_a), f.e + (other - to_b + apart * to_a)};
}

}  // namespace

// Off by a unit each are how far `low` and the middle are from the base, the half length, sums and products.
PartVector3::PartVector3(const ProvenVector3<double>& vector, double low, double half) {
  const auto& [p, q, r] = vector.power;
  const double from = low - vector.base, d = from + half, far = std::fabs(d);
  const double off = kUnit * (std::fabs(from) + far + half);
  const double e0 = kRootOfThree * vector.error[0], e1 = kRootOfThree * vector.error[1];
  const double of_p = length(p), of_q = length(q);
  if (vector.is_linear) {
    power = {p + d * q, half * q, {}};
    error = {up(e0 + far * e1 + off * (of_q + e1) + kUnit * (of_p + 2 * far * of_q)),
             up(half * (e1 + 2 * kUnit * of_q)), 0};
  } else {
    const double e2 = kRootOfThree * vector.error[2], of_r = length(r);
    power = {p + d * (q + d * r), half * (q + (2 * d) * r), (half * half) * r};
    error = {up(e0 + far * (e1 + far * e2) + off * (of_q + e1 + (2 * far + off) * (of_r + e2)) +
                kUnit * (of_p + far * (3 * of_q + 4 * far * of_r))),
             up(half * (e1 + 2 * far * e2 + 2 * off * (of_r + e2) + kUnit * (3 * of_q + 8 * far * of_r))),
             up(half * half * (e2 + 5 * kUnit * of_r))};
  }
  size = {length(power[0]), length(power[1]), length(power[2])};
}

std::array<double, 3> PartVector3::off_at_nodes() const {
  return {up(error[0] + kUnit * size[0]), up(error[1] + 6 * kUnit * size[1]), up(error[2] + 10 * kUnit * size[2])};
}

// The height is 1 - a^2 / (4 b) to the half, and b is no less than a^2 / 4 in spite of rounding.
VectorOnEllipse3::Factor VectorOnEllipse3::factor(double linear, double square) {
  const double least = linear * linear / 4 * (1 + 0x1p-50);
  Factor result;
  result.linear = linear;
  result.square = std::max(square, least);
  result.root = std::sqrt(result.square);
  result.ends = (std::sqrt(1 + linear + result.square) + std::sqrt(std::max(0.0, 1 - linear + result.square))) / 2;
  if (result.square > 0) result.height = std::sqrt(std::max(0.0, 1 - least / result.square - 4 * kUnit));
  return result;
}

VectorOnEllipse3::VectorOnEllipse3(const PartVector3& vector) : size_(vector.size), error_(vector.error) {
  const auto& [v, w, z] = vector.power;
  turn_ = {length(cross(v, w)), 0, 0};
  first_ = dot(v, v);
  if (!(first_ > kTiny)) return;
  // Its zeros are those of y^4 + c[1] y^3 + .. + c[4], y = 1 / x: none is far from 0.
  Quartic c{1, 2 * dot(v, w) / first_, dot(w, w) / first_, 0, 0};
  if (vector.is_linear()) {
    factors_[0] = factor(c[1], c[2]);
  } else {
    turn_ = {turn_[0], 2 * length(cross(v, z)), length(cross(w, z))};
    c = {1, c[1], c[2] + 2 * dot(v, z) / first_, 2 * dot(w, z) / first_, dot(z, z) / first_};
    Quadratics f = quadratics_of(c);
    for (int k = 0; k < 2; ++k) refine(c, f);
    factors_ = {factor(f.a, f.b), factor(f.d, f.e)};
  }
  const Quadratics f{factors_[0].linear, factors_[0].square, factors_[1].linear, factors_[1].square};
  const Quartic found = product(f);
  const Quartic sizes = product({std::fabs(f.a), f.b, std::fabs(f.d), f.e});
  reach_ = kFarthest;
  for (std::size_t k = 1; k < 5; ++k) rest_[k] = std::fabs(c[k] - found[k]) + 8 * kUnit * (std::fabs(c[k]) + sizes[k]);
  for (const Factor& one : factors_)
    if (one.ends < kFarthest * one.root) reach_ = std::min(reach_, one.ends / one.root);
}

VectorOnEllipse3::Bounds VectorOnEllipse3::within(double half_axis) const {
  const double r = half_axis * (1 + kRoundings);
  Bounds result;
  result.off = up(at(error_, r));
  result.most = up(at(size_, r) + result.off);
  const double slope = size_[1] + 2 * r * size_[2], slope_off = error_[1] + 2 * r * error_[2];
  result.turn = up(at(turn_, r) + result.off * (slope + slope_off) + result.most * (slope_off + 8 * kUnit * slope));
  double least = 1;
  for (const Factor& one : factors_) {
    const double apart = one.ends - r * one.root - kRoundings * one.ends;
    least *= apart > 0 ? apart * std::max(apart, one.height) : 0;
  }
  const double rest = r * (rest_[1] + r * (rest_[2] + r * (rest_[3] + r * rest_[4])));
  const double off = (2 * result.most + result.off) * result.off + 16 * kUnit * result.most * result.most;
  result.least_square = down(first_ * down(down(least) - up(rest))) - up(off);
  return result;
}

}  // namespace hottel
