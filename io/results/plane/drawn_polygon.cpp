#include "io/results/plane/drawn_polygon.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/plane/arrangement/solids.h"
#include "kernel/plain_functions.h"

namespace hottel {
namespace {

using Vertex = DrawnPolygon2::Vertex;

// The points between two corners of an arc.
void add_arc(const Point2& eye, double range, const RoundedPolygon2& polygon, std::size_t k,
             std::vector<Vertex>& line) {
  constexpr double kPi = std::numbers::pi;
  const double largest_step = 2 * same_bits::acos(1 - 0x1p-10);
  const double x = to_double(eye.x), y = to_double(eye.y);
  const auto angle_of = [&](const RoundedPolygon2::Corner& c) { return same_bits::atan2(c.y - y, c.x - x); };
  const std::size_t next = k + 1 == polygon.corners.size() ? 0 : k + 1;
  const double begin = angle_of(polygon.corners[k]);
  double turn = next == k ? 2 * kPi : angle_of(polygon.corners[next]) - begin;
  if (turn < 0) turn += 2 * kPi;
  const double steps = std::max(1.0, std::ceil(turn / largest_step));
  for (double step = 1; step < steps; ++step) {
    const double angle = begin + turn * step / steps;
    line.push_back({{x + range * same_bits::cos(angle), y + range * same_bits::sin(angle), kRange}, k});
  }
}

DrawnPolygon2 ring_of(const Point2& eye, const RoundedPolygon2& polygon, const std::optional<Rational>& range) {
  DrawnPolygon2 result;
  if (polygon.corners.empty()) return result;
  std::vector<Vertex>& ring = result.lines.emplace_back();
  for (std::size_t k = 0; k < polygon.corners.size(); ++k) {
    ring.push_back({polygon.corners[k], k});
    if (range && polygon.corners[k].after == kRange) add_arc(eye, to_double(*range), polygon, k, ring);
  }
  return result;
}

}  // namespace

DrawnPolygon2 drawn_polygon_2(const Point2& eye, const RoundedPolygon2& polygon, const std::optional<Rational>& range) {
  if (polygon.solid != Solids2::kNone) return {};
  if (!polygon.corners.empty() && !polygon.sees_sky()) return ring_of(eye, polygon, range);
  DrawnPolygon2 result;
  result.is_bounded = false;
  const auto& corners = polygon.corners;
  std::size_t open = 0;
  while (open < corners.size() && corners[open].after != kSky) ++open;
  std::vector<Vertex> line;
  for (std::size_t i = 1; i <= corners.size(); ++i) {
    const std::size_t k = (open + i) % corners.size();
    line.push_back({corners[k], k});
    if (corners[k].after != kSky) continue;
    if (line.size() > 1) result.lines.push_back(std::move(line));
    line.clear();
  }
  return result;
}

}  // namespace hottel
