#include "geometry/space/stretches/stretch_hull.h"

#include <algorithm>
#include <cmath>

#include "geometry/space/stretches/stretch_parts.h"

namespace hottel {
namespace {

// Distances are off by far less than this part of the largest coordinate.
constexpr double kSlack = 1e-10;
// Planes through points that are nearly on one line are not used.
constexpr double kThin = 1e-4;
// Directions over less than so many times the slack are not told.
constexpr double kNear = 1e6;

}  // namespace

StretchHull3::StretchHull3(const PairGeometry3& bodies) : bodies_(bodies) {
  double largest = 0;
  for (std::uint32_t point = 0; point < bodies.points.size(); ++point) {
    const Direction3 p = bodies.place(point);
    const bool is_far = bodies.points[point].is_far();
    places_.push_back({is_far ? unit(p) : p, is_far});
    if (!is_far) largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  }
  slack_ = kSlack * largest;
  far_slack_ = kSlack / 4;  // what is as far from a hull as all that hides is off by less than slack_
}

void StretchHull3::take(const Stretch3& stretch, double low, double high, std::uint32_t patch) {
  const auto [from, to] = ends_in_doubles(stretch, low, high, bodies_.shift());
  hull_.assign({{from}, {to}});
  for (const std::uint32_t corner : bodies_.bodies[patch].corners) hull_.push_back(places_[corner]);
  planes_.clear();
  for (std::size_t k = 2; k < hull_.size(); ++k) {
    const Place &a = hull_[k], &b = hull_[k + 1 == hull_.size() ? 2 : k + 1];
    add_plane(a, b, hull_[0]);
    add_plane(a, b, hull_[1]);
    add_plane(a, hull_[0], hull_[1]);
  }
}

// Beyond the stretch are the points e + s w, s >= 0, with w the way from a point of the patch to e, a point of the
// stretch. They are in front of a plane that is behind both ends if no w points backward, which corners tell.
void StretchHull3::take_lines_from(std::uint32_t patch) {
  const std::vector<std::uint32_t>& corners = bodies_.bodies[patch].corners;
  const double nearest = bodies_.is_far(patch) ? 1 : least_distance(patch);
  if (!bodies_.is_far(patch) && !(nearest > kNear * slack_)) return;  // doubles do not tell directions
  const Direction3 way = hull_[1].at - hull_[0].at;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Place &p = places_[corners[k]], &q = places_[corners[k + 1 == corners.size() ? 0 : k + 1]];
    if (p.is_far) {
      add_beam_plane(cross(p.at, q.at), patch, nearest);
      add_beam_plane(cross(way, p.at), patch, nearest);
      continue;
    }
    add_beam_plane(cross(way, q.at - p.at), patch, nearest);
    add_beam_plane(cross(way, p.at - hull_[0].at), patch, nearest);
    for (const int end : {0, 1}) add_beam_plane(cross(p.at - hull_[end].at, q.at - hull_[end].at), patch, nearest);
  }
}

// At least how far the stretch is from a patch: over its plane, or beyond one of its sides.
double StretchHull3::least_distance(std::uint32_t patch) const {
  const PairGeometry3::Body& body = bodies_.bodies[patch];
  const Direction3 normal = unit({body.normal.x, body.normal.y, body.normal.z});
  const auto least = [&](const Direction3& direction, const Direction3& from) {
    return std::min(dot(direction, hull_[0].at - from), dot(direction, hull_[1].at - from));
  };
  const Direction3& first = places_[body.corners.front()].at;
  double most = std::max(least(normal, first), least(-normal, first));
  for (std::size_t k = 0; k < body.corners.size(); ++k) {
    const Direction3& p = places_[body.corners[k]].at;
    const Direction3 side = places_[body.corners[k + 1 == body.corners.size() ? 0 : k + 1]].at - p;
    if (length(side) > 0) most = std::max(most, least(unit(cross(side, normal)), p));
  }
  return most;
}

void StretchHull3::add_beam_plane(const Direction3& direction, std::uint32_t from, double nearest) {
  const double size = length(direction);
  if (!(size > 0)) return;
  const Direction3 normal = (1 / size) * direction;
  bool is_forward = true, is_backward = true;
  for (const std::uint32_t corner : bodies_.bodies[from].corners)
    for (const int end : {0, 1}) {
      const Place& p = places_[corner];
      const double along = dot(normal, p.is_far ? -p.at : hull_[end].at - p.at);
      is_forward = is_forward && along >= -far_slack_ * nearest;
      is_backward = is_backward && along <= far_slack_ * nearest;
    }
  const double first = dot(normal, hull_[0].at), second = dot(normal, hull_[1].at);
  if (is_forward)
    planes_.push_back({normal, 2 * slack_ - std::min(first, second)});
  else if (is_backward)
    planes_.push_back({-normal, 2 * slack_ + std::max(first, second)});
}

void StretchHull3::add_plane(const Place& a, const Place& b, const Place& c) {
  const auto way = [&c](const Place& p) { return p.is_far ? p.at : p.at - c.at; };
  const Direction3 to_a = way(a), to_b = way(b);
  Direction3 normal = cross(to_a, to_b);
  const double size = length(normal);
  if (!(size > kThin * length(to_a) * length(to_b))) return;
  normal = (1 / size) * normal;
  const Plane plane{normal, -dot(normal, c.at)};
  bool is_above = true, is_below = true;
  for (const Place& p : hull_) {
    const double value = plane.value(p), slack = slack_of(p);
    is_above = is_above && value >= -slack;
    is_below = is_below && value <= slack;
    if (!is_above && !is_below) return;
  }
  // A little outside, so that all of the hull is on one side.
  if (is_above)
    planes_.push_back({normal, plane.offset + 2 * slack_});
  else if (is_below)
    planes_.push_back({-normal, -plane.offset + 2 * slack_});
}

bool StretchHull3::hides_nothing(std::uint32_t body) const {
  const PairGeometry3::Body& b = bodies_.bodies[body];
  const auto is_outside = [&](const Plane& plane) {
    return std::all_of(b.corners.begin(), b.corners.end(),
                       [&](std::uint32_t corner) { return plane.value(places_[corner]) < 0; });
  };
  if (std::any_of(planes_.begin(), planes_.end(), is_outside)) return true;
  const Direction3 normal{b.normal.x / b.normal.size, b.normal.y / b.normal.size, b.normal.z / b.normal.size};
  const Plane plane{normal, -dot(normal, places_[b.corners.front()].at)};
  const auto is_beyond = [&](double side) {
    return std::all_of(hull_.begin(), hull_.end(),
                       [&](const Place& p) { return side * plane.value(p) > 4 * slack_of(p); });
  };
  return is_beyond(1) || is_beyond(-1);
}

}  // namespace hottel
