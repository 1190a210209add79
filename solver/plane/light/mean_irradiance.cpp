#include "solver/plane/light/mean_irradiance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace hottel {
namespace {

using std::numbers::pi;

struct Direction {
  double x, y;
};

double cross(const Direction& a, const Direction& b) { return a.x * b.y - a.y * b.x; }
double dot(const Direction& a, const Direction& b) { return a.x * b.x + a.y * b.y; }

// The angle from a to b, known to lie in [0, pi]: rounding must not turn a small one around. Small ones, which are
// most, by the series of the arc tangent, less than 2^-57 of which is left out.
inline double angle_up_to_half_turn(const Direction& a, const Direction& b) {
  const double y = std::max(cross(a, b), 0.0), x = dot(a, b);
  if (!(y < x / 8)) return std::atan2(y, x);
  const double t = y / x, z = t * t;
  const double low = 1.0 / 3 - z * (1.0 / 5 - z * (1.0 / 7 - z / 9));
  const double high = 1.0 / 11 - z * (1.0 / 13 - z * (1.0 / 15 - z / 17));
  return t - t * z * (low + z * z * (z * z) * high);
}

// What is seen around an eye, step by step: step k leads from seen vertex k to the next one.
class Panorama {
 public:
  Panorama(const Vertices2& vertices, const Eye2& eye, const View2& view)
      : vertices_(vertices), eye_(eye), seen_(view.seen) {}

  std::size_t size() const { return seen_.size(); }
  std::size_t next(std::size_t k) const { return k + 1 == size() ? 0 : k + 1; }
  const View2::Seen& operator[](std::size_t k) const { return seen_[k]; }
  Direction direction(std::size_t k) const {
    const auto& p = vertices_.approximate(seen_[k].vertex);
    return {p.x - eye_.x(), p.y - eye_.y()};
  }

  // Only the sky is seen under half a turn or more.
  double angle(std::size_t k) const {
    const Direction a = direction(k), b = direction(next(k));
    if (seen_[k].behind != kSky) return angle_up_to_half_turn(a, b);
    if (size() == 1) return 2 * pi;
    const int turn = eye_.orientation(seen_[k].vertex, seen_[next(k)].vertex);
    if (turn == 0) return pi;
    return turn > 0 ? angle_up_to_half_turn(a, b) : 2 * pi - angle_up_to_half_turn(b, a);
  }

 private:
  const Vertices2& vertices_;
  const Eye2& eye_;
  std::span<const View2::Seen> seen_;
};

// The integral over directions, in radians.
class Integral {
 public:
  Integral(const FaceRadiosity2& radiosity, std::span<double> result) : radiosity_(radiosity), sum_(result) {
    std::fill(sum_.begin(), sum_.end(), 0.0);
  }
  void add(std::uint32_t shade, double weight) {
    const double* value = radiosity_.of_shade(shade).data();
    for (double& sum : sum_) sum += *value++ * weight;
  }
  void set_nan() { std::fill(sum_.begin(), sum_.end(), std::numeric_limits<double>::quiet_NaN()); }
  void scale(double factor) {
    for (double& value : sum_) value *= factor;
  }

 private:
  const FaceRadiosity2& radiosity_;
  std::span<double> sum_;
};

// Neighbouring steps of one shade are taken together as long as they stay within half a turn.
void add_turn(const Panorama& around, const FaceRadiosity2& radiosity, std::size_t first, Integral& integral) {
  std::size_t k = first, left = around.size();
  std::uint32_t shade = radiosity.shade(around[k].behind);
  Direction from = around.direction(k);
  while (left > 0) {
    const std::size_t step = k;
    const std::uint32_t step_shade = shade;
    Direction to;
    const auto advance = [&] {
      k = around.next(k);
      --left;
      shade = radiosity.shade(around[k].behind);
      to = around.direction(k);
    };
    advance();
    if (step_shade != 0 && around[step].behind == kSky) {
      integral.add(step_shade, around.angle(step));
    } else if (step_shade != 0) {
      while (shade == step_shade && left > 0 && around[k].behind != kSky && dot(from, to) > 0 &&
             cross(from, around.direction(around.next(k))) > 0)
        advance();
      integral.add(step_shade, angle_up_to_half_turn(from, to));
    }
    from = to;
  }
}

// The mean over the directions of approach phi in a sector of angle alpha between two edges. From phi, one sees the
// first edge under pi - phi (if that is positive), the last one under pi - (alpha - phi), and in the rest of the turn
// what the vertex sees in the sector. Integrated over phi, what is seen between psi_1 and psi_2 counts W(psi_2) -
// W(psi_1), and each edge pi m - m²/2 with m = min(alpha, pi). Returns alpha.
double add_sector(const Panorama& around, const FaceRadiosity2& radiosity, std::size_t first, std::size_t last,
                  Integral& integral) {
  double alpha = 0;
  std::size_t k = first;
  do {
    alpha += around.angle(k);
    k = around.next(k);
  } while (k != last);
  const auto square = [](double value) { return value * value; };
  const auto weight = [&](double psi) {
    return alpha * psi + square(std::max(alpha - psi - pi, 0.0)) / 2 - square(std::max(psi - pi, 0.0)) / 2;
  };
  double psi = 0;
  k = first;
  do {
    const double end = psi + around.angle(k);
    integral.add(radiosity.shade(around[k].behind), std::max(weight(end) - weight(psi), 0.0));
    psi = end;
    k = around.next(k);
  } while (k != last);
  const double m = std::min(alpha, pi);
  integral.add(radiosity.shade(around[first].left), m * (pi - m / 2));
  integral.add(radiosity.shade(around[last].right), m * (pi - m / 2));
  return alpha;
}

// From an eye on edges: the mean over the sectors that are free. (Without solids, they are the whole turn.)
void add_sectors(const Panorama& around, const FaceRadiosity2& radiosity, const std::vector<std::size_t>& edges,
                 Integral& integral) {
  double alpha = 0;
  bool is_whole_turn = true;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const bool is_free = !radiosity.is_covered(around[edges[i]].behind);
    if (is_free) alpha += add_sector(around, radiosity, edges[i], edges[i + 1 == edges.size() ? 0 : i + 1], integral);
    is_whole_turn = is_whole_turn && is_free;
  }
  if (alpha > 0)
    integral.scale(1 / (2 * pi * (is_whole_turn ? 2 * pi : alpha)));
  else
    integral.set_nan();
}

}  // namespace

void mean_irradiance(const Vertices2& vertices, const FaceRadiosity2& radiosity, const Eye2& eye,
                     const Location2& location, const View2& view, std::span<double> result) {
  const Panorama around(vertices, eye, view);
  const std::size_t m = around.size();
  Integral integral(radiosity, result);
  if (m == 0) {
    integral.add(radiosity.shade(kSky), 1);
    return;
  }
  if (location.kind != Location2::Kind::kInTriangle) {
    thread_local std::vector<std::size_t> incident;
    incident.clear();
    for (std::size_t k = 0; k < m; ++k)
      if (around[k].left != kNoPiece) incident.push_back(k);
    if (!incident.empty()) {
      add_sectors(around, radiosity, incident, integral);
      return;
    }
  }
  if (radiosity.is_covered(around[0].behind)) {  // all that is seen from a point in the open is
    integral.set_nan();
    return;
  }
  const std::uint32_t last_shade = radiosity.shade(around[m - 1].behind);
  std::uint32_t before = last_shade;
  for (std::size_t k = 0; k < m; ++k) {
    const std::uint32_t shade = radiosity.shade(around[k].behind);
    if (shade != before) {
      add_turn(around, radiosity, k, integral);
      integral.scale(1 / (2 * pi));
      return;
    }
    before = shade;
  }
  integral.add(last_shade, 1);
}

}  // namespace hottel
