#include "geometry/plane/check/near_misses.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include "geometry/plane/arrangement/overlay.h"
#include "geometry/plane/arrangement/point_index.h"
#include "geometry/plane/check/point_neighbours.h"
#include "geometry/plane/scene/closest_point.h"
#include "geometry/plane/scene/patches.h"

namespace hottel {
namespace {

class NearMissFinder {
 public:
  explicit NearMissFinder(const Scene2& scene) {
    PointIndex2 index;
    for (const auto& [from, to] : scene.edges) segments_.push_back({index.insert(from), index.insert(to)});
    points_ = index.points();
    vertices_ = Vertices2(points_, points_.size());
    ending_.resize(points_.size());
    for (std::uint32_t s = 0; s < segments_.size(); ++s) {
      ending_[segments_[s].a.index()].push_back(s);
      ending_[segments_[s].b.index()].push_back(s);
    }
  }

  std::vector<NearMiss2> find() {
    const std::vector<std::vector<std::uint32_t>> near = surfaces_near_points();
    std::set<std::pair<VertexId, VertexId>> told;
    std::vector<NearMiss2> result;
    for (const VertexId v : IdRange<VertexId>(points_.size())) {
      const auto nearest = nearest_target(v, near[v.index()]);
      if (!nearest || !is_near(v, *nearest)) continue;
      const auto end = end_of(*nearest);
      if (end && !told.insert(std::minmax(v, *end)).second) continue;
      const bool sticks_out = std::any_of(ending_[v.index()].begin(), ending_[v.index()].end(),
                                          [&](auto s) { return cross(s, nearest->surface); });
      result.push_back({point(v), ending_[v.index()], nearest->surface, nearest->closest.at, end.has_value(),
                        sticks_out, nearest->closest.squared});
    }
    return result;
  }

 private:
  struct Target {
    std::uint32_t surface;
    ClosestPoint2 closest;
  };

  Point2 point(VertexId v) const { return points_[v.index()]; }

  std::optional<VertexId> end_of(const Target& to) const {
    if (to.closest.end < 0) return std::nullopt;
    return to.closest.end == 0 ? segments_[to.surface].a : segments_[to.surface].b;
  }

  double length(std::uint32_t s) const {
    const auto &p = vertices_.approximate(segments_[s].a), &q = vertices_.approximate(segments_[s].b);
    return std::hypot(q.x - p.x, q.y - p.y);
  }

  Rational squared_length(std::uint32_t s) const {
    return squared_distance(point(segments_[s].a), point(segments_[s].b));
  }

  // Surfaces that may be near enough to each end point; those that end there left out.
  std::vector<std::vector<std::uint32_t>> surfaces_near_points() const {
    std::vector<double> reach;
    for (const auto& ending : ending_) {
      double shortest_length = std::numeric_limits<double>::infinity();
      for (const std::uint32_t s : ending) shortest_length = std::min(shortest_length, length(s));
      reach.push_back((shortest_length + 4 * vertices_.approximation_error()) / kNearPart);
    }
    auto near = segments_near_vertices(vertices_, segments_, reach);
    for (const VertexId v : IdRange<VertexId>(near.size()))
      std::erase_if(near[v.index()], [&](std::uint32_t s) { return segments_[s].a == v || segments_[s].b == v; });
    return near;
  }

  // The nearest surface that does not meet v, unless one as near as that is joined to one that does.
  std::optional<Target> nearest_target(VertexId v, const std::vector<std::uint32_t>& candidates) const {
    std::vector<Target> nearest;  // all at the same distance
    std::vector<std::uint32_t> meeting = ending_[v.index()];
    double least_upper = std::numeric_limits<double>::infinity();  // of the distances of those that do not meet v
    for (const std::uint32_t s : candidates)
      if (const DistanceBounds2 d = distance_bounds(vertices_, segments_[s], v); d.lower > 0)
        least_upper = std::min(least_upper, d.upper);
    for (const std::uint32_t s : candidates) {
      if (distance_bounds(vertices_, segments_[s], v).lower > least_upper) continue;
      if (is_on(segments_[s], v)) {
        meeting.push_back(s);
        continue;
      }
      ClosestPoint2 closest = closest_point(point(segments_[s].a), point(segments_[s].b), point(v));
      if (!nearest.empty() && closest.squared > nearest.front().closest.squared) continue;
      if (!nearest.empty() && closest.squared < nearest.front().closest.squared) nearest.clear();
      nearest.push_back({s, std::move(closest)});
    }
    if (nearest.empty()) return std::nullopt;
    for (const Target& to : nearest)
      for (const std::uint32_t s : meeting)
        if (are_joined(v, s, to.surface)) return std::nullopt;
    return nearest.front();
  }

  // Surface s, which meets v, meets t too: no gap between v and t then, but an angle, unless s ends at v beyond t.
  bool are_joined(VertexId v, std::uint32_t s, std::uint32_t t) const {
    const Segment2 &a = segments_[s], &b = segments_[t];
    if (cross(s, t)) return a.a != v && a.b != v;
    return is_on(a, b.a) || is_on(a, b.b) || is_on(b, a.a) || is_on(b, a.b);
  }

  bool is_on(const Segment2& s, VertexId v) const {
    return v == s.a || v == s.b || (vertices_.orientation(s.a, s.b, v) == 0 && vertices_.is_between(s.a, s.b, v));
  }

  bool is_near(VertexId v, const Target& to) const {
    Rational least = squared_length(to.surface);
    const auto look_at = [&](VertexId end) {
      for (const std::uint32_t s : ending_[end.index()]) least = std::min(least, squared_length(s));
    };
    look_at(v);
    if (const auto end = end_of(to)) look_at(*end);
    return to.closest.squared * kNearPart * kNearPart < least;
  }

  bool cross(std::uint32_t s, std::uint32_t t) const {
    const Segment2 &a = segments_[s], &b = segments_[t];
    return vertices_.orientation(a.a, a.b, b.a) * vertices_.orientation(a.a, a.b, b.b) < 0 &&
           vertices_.orientation(b.a, b.b, a.a) * vertices_.orientation(b.a, b.b, a.b) < 0;
  }

  std::vector<Segment2> segments_;
  std::vector<Point2> points_;
  Vertices2 vertices_;
  std::vector<std::vector<std::uint32_t>> ending_;  // surfaces by end point
};

}  // namespace

std::vector<NearMiss2> find_near_misses(const Scene2& scene) {
  if (const std::optional<BareScene2> bare = without_patches(scene)) {
    std::vector<NearMiss2> found = find_near_misses(bare->scene);
    for (NearMiss2& miss : found) {
      for (std::uint32_t& s : miss.surfaces) s = bare->surface_of[s];
      miss.target = bare->surface_of[miss.target];
    }
    return found;
  }
  return NearMissFinder(scene).find();
}

}  // namespace hottel
