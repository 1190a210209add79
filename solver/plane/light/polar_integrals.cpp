#include "solver/plane/light/polar_integrals.h"

#include <cmath>

#include "kernel/plain_functions.h"

namespace hottel {
namespace {

// 1 / (2k (2k + 1)): the mean of log(1 + s) over s in (-r, r) is -sum r^2k / (2k (2k + 1)).
constexpr std::array<double, 6> kEdge = {1.0 / 6, 1.0 / 20, 1.0 / 42, 1.0 / 72, 1.0 / 110, 1.0 / 156};

// The imaginary part of sum c_k w^k, k = 1, 2, ..., for a complex w.
double imaginary_of_series(const std::array<double, 6>& c, const Vector2& w) {
  double re = c[5], im = 0;
  for (int k = 4; k >= 0; --k) {
    const double next = re * w.x - im * w.y + c[static_cast<std::size_t>(k)];
    im = re * w.y + im * w.x;
    re = next;
  }
  return re * w.y + im * w.x;
}

// (a / b)² of complex numbers.
Vector2 squared_ratio(const Vector2& a, const Vector2& b) {
  const double scale = 1 / dot(b, b);
  const Vector2 q{dot(a, b) * scale, cross(b, a) * scale};
  return {q.x * q.x - q.y * q.y, 2 * q.x * q.y};
}

// The arc tangent for |r| < 1/14: the next term of the series is below 2^-57 of r.
double small_arc_tangent(double r) {
  const double s = r * r;
  return r - r * s * (1.0 / 3 - s * (1.0 / 5 - s * (1.0 / 7 - s * (1.0 / 9 - s * (1.0 / 11 - s * (1.0 / 13))))));
}

double polar_angle(const Vector2& z, const Vector2& axis) { return same_bits::atan2(cross(axis, z), dot(axis, z)); }

// The triangle between the pole and the edge from a to b: with d the distance of its line, t the place on it,
// the integral is d/2 (angle_b t_b - angle_a t_a) - d²/2 log(r_b / r_a).
double angle_over_triangle(const Vector2& a, const Vector2& b, const Vector2& along, double angle_a, double angle_b) {
  const double squared = dot(along, along), moment = cross(a, along);
  if (moment == 0 || squared == 0) return 0;
  return moment / (2 * squared) * (angle_b * dot(b, along) - angle_a * dot(a, along)) -
         moment * moment / (4 * squared) * same_bits::log(dot(b, b) / dot(a, a));
}

AreaAndAngle2 near_integrals(const CellPart2& part, const Vector2& z, const Vector2& axis) {
  AreaAndAngle2 sum;
  Vector2 from = part[part.size() - 1];
  double angle_from = polar_angle(z + from, axis);
  for (int k = 0; k < part.size(); ++k) {
    const Vector2 to = part[k];
    const double angle_to = polar_angle(z + to, axis);
    sum.area += cross(from, to) / 2;
    sum.angle += angle_over_triangle(z + from, z + to, to - from, angle_from, angle_to);
    from = to;
    angle_from = angle_to;
  }
  return sum;
}

// The same with all angles measured from z: the mean over each edge is that at its middle and a series.
AreaAndAngle2 far_integrals(const CellPart2& part, const Vector2& z, const Vector2& axis) {
  AreaAndAngle2 sum;
  Vector2 from = part[part.size() - 1];
  for (int k = 0; k < part.size(); ++k) {
    const Vector2 to = part[k], along = to - from, middle = 0.5 * (from + to), at = z + middle;
    const double turned = small_arc_tangent(cross(z, middle) / dot(z, at));
    const double mean = turned - imaginary_of_series(kEdge, squared_ratio(0.5 * along, at));
    sum.area += cross(from, to) / 2;
    sum.angle += (cross(z, along) + cross(from, to)) / 2 * mean;
    from = to;
  }
  sum.angle += polar_angle(z, axis) * sum.area;
  return sum;
}

}  // namespace

CellPart2::CellPart2(double height)
    : corner_{{{-0.5, -height / 2}, {0.5, -height / 2}, {0.5, height / 2}, {-0.5, height / 2}}} {}

void CellPart2::cut(double at_centre, const Vector2& gradient) {
  std::array<Vector2, 8> kept;
  int size = 0;
  if (size_ == 0) return;
  Vector2 from = corner_[static_cast<std::size_t>(size_ - 1)];
  double at_from = at_centre + dot(gradient, from);
  for (int k = 0; k < size_; ++k) {
    const Vector2 to = corner_[static_cast<std::size_t>(k)];
    const double at_to = at_centre + dot(gradient, to);
    if ((at_from < 0) != (at_to < 0))
      kept[static_cast<std::size_t>(size++)] = from + (at_from / (at_from - at_to)) * (to - from);
    if (at_to >= 0) kept[static_cast<std::size_t>(size++)] = to;
    from = to;
    at_from = at_to;
  }
  corner_ = kept;
  size_ = size;
}

PolarIntegrals2::PolarIntegrals2(double height) : height_(height), radius_(std::hypot(1.0, height) / 2) {
  const auto mean_power = [](double width, int n) { return same_bits::pow(width / 2, n) / (n + 1); };
  for (int k = 1; k <= kTerms; ++k) {
    double sum = 0, binomial = 1;
    for (int m = 0; m <= k; ++m) {
      sum += (m % 2 == 0 ? 1 : -1) * binomial * mean_power(1, 2 * (k - m)) * mean_power(height, 2 * m);
      binomial *= static_cast<double>((2 * k - 2 * m) * (2 * k - 2 * m - 1)) / ((2 * m + 1) * (2 * m + 2));
    }
    moments_[static_cast<std::size_t>(k - 1)] = sum / (2 * k);
  }
}

AreaAndAngle2 PolarIntegrals2::over_cell(const Vector2& z, const Vector2& axis) const {
  if (is_near(z)) return near_integrals(CellPart2(height_), z, axis);
  const double mean = polar_angle(z, axis) - imaginary_of_series(moments_, squared_ratio({1, 0}, z));
  return {height_, height_ * mean};
}

AreaAndAngle2 PolarIntegrals2::over(const CellPart2& part, const Vector2& z, const Vector2& axis) const {
  return is_near(z) ? near_integrals(part, z, axis) : far_integrals(part, z, axis);
}

double PolarIntegrals2::angle_error(const Vector2& z) const {
  const double factor = is_near(z) ? std::sqrt(dot(z, z)) + radius_ : radius_;
  return 160 * factor * factor;
}

}  // namespace hottel
