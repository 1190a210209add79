#include "geometry/space/exchange/stretch_hull.h"

#include <algorithm>
#include <cmath>

namespace hottel {
namespace {

// Distances are off by far less than this part of the largest coordinate.
constexpr double kSlack = 1e-10;
// Planes through points that are nearly on one line are not used.
constexpr double kThin = 1e-4;

}  // namespace

StretchHull3::StretchHull3(const PairBodies3& bodies) : bodies_(bodies) {
  double largest = 0;
  for (std::uint32_t point = 0; point < bodies.points.size(); ++point) {
    const Direction3& p = places_.emplace_back(bodies.place(point));
    largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  }
  slack_ = kSlack * largest;
}

void StretchHull3::take(const Stretch3& stretch, double low, double high, std::uint32_t patch) {
  const long shift = bodies_.shift();
  const auto place = [&](const IntegerVector& p) {
    return Direction3{rounded_quotient(p.x, stretch.weight, shift), rounded_quotient(p.y, stretch.weight, shift),
                      rounded_quotient(p.z, stretch.weight, shift)};
  };
  const Direction3 from = place(stretch.from), way = place(stretch.way);
  hull_.assign({from + low * way, from + high * way});
  for (const std::uint32_t corner : bodies_.bodies[patch].corners) hull_.push_back(places_[corner]);
  planes_.clear();
  for (std::size_t k = 2; k < hull_.size(); ++k) {
    const Direction3 &a = hull_[k], &b = hull_[k + 1 == hull_.size() ? 2 : k + 1];
    add_plane(a, b, hull_[0]);
    add_plane(a, b, hull_[1]);
    add_plane(hull_[0], hull_[1], a);
  }
}

void StretchHull3::add_plane(const Direction3& a, const Direction3& b, const Direction3& c) {
  Direction3 normal = cross(b - a, c - a);
  const double size = length(normal);
  if (!(size > kThin * length(b - a) * length(c - a))) return;
  normal = (1 / size) * normal;
  const double offset = -dot(normal, a);
  double least = 0, most = 0;
  for (const Direction3& p : hull_) {
    const double value = dot(normal, p) + offset;
    least = std::min(least, value);
    most = std::max(most, value);
  }
  // A little outside, so that all of the hull is on one side.
  if (least >= -slack_)
    planes_.push_back({normal, offset + 2 * slack_});
  else if (most <= slack_)
    planes_.push_back({-normal, -offset + 2 * slack_});
}

bool StretchHull3::hides_nothing(std::uint32_t body) const {
  const PairBodies3::Body& b = bodies_.bodies[body];
  const auto is_outside = [&](const Plane& plane) {
    return std::all_of(b.corners.begin(), b.corners.end(),
                       [&](std::uint32_t corner) { return dot(plane.normal, places_[corner]) + plane.offset < 0; });
  };
  if (std::any_of(planes_.begin(), planes_.end(), is_outside)) return true;
  const Direction3 normal{b.normal.x / b.normal.size, b.normal.y / b.normal.size, b.normal.z / b.normal.size};
  const double offset = dot(normal, places_[b.corners.front()]);
  double least = 0, most = 0;
  for (std::size_t k = 0; k < hull_.size(); ++k) {
    const double value = dot(normal, hull_[k]) - offset;
    least = k == 0 ? value : std::min(least, value);
    most = k == 0 ? value : std::max(most, value);
  }
  return least > 4 * slack_ || most < -4 * slack_;
}

}  // namespace hottel
