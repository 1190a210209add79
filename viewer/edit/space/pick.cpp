#include "viewer/edit/space/pick.h"

#include <algorithm>
#include <cmath>

#include "kernel/exact_double.h"

namespace hottel {
namespace {

constexpr double kNearBall = 1e-9;  // of sizes and distances, that a ray may be off in doubles

Point3 exact_point(const Direction3& d) { return {exact_value(d.x), exact_value(d.y), exact_value(d.z)}; }

bool is_in(const Polygon3& polygon, const Point3& place) {
  if (!polygon.is_nearly_plane) return contains_in_plane(polygon, doubled_area(polygon), place);
  return false;
}

// A ray, exactly.
struct ExactRay {
  Point3 eye;
  Vector3 way;

  Point3 at(const Rational& t) const { return {eye.x + t * way.x, eye.y + t * way.y, eye.z + t * way.z}; }
};

// How far along the ray it meets a plane polygon, in units of its way; nothing where it does not, or is in its plane.
std::optional<Rational> met(const ExactRay& ray, const Polygon3& polygon, const Vector3& normal) {
  const Rational slope = dot(normal, ray.way);
  if (slope == 0) return std::nullopt;
  const Rational t = dot(normal, polygon.points.front() - ray.eye) / slope;
  if (t <= 0 || !is_in(polygon, ray.at(t))) return std::nullopt;
  return t;
}

}  // namespace

ScenePick3::ScenePick3(const Scene3& scene) : scene_(&scene) {
  for (const Polygon3& polygon : scene.polygons) {
    Ball ball;
    for (const Point3& p : polygon.points)
      ball.middle = ball.middle + (1.0 / static_cast<double>(polygon.points.size())) * place_of(p);
    for (const Point3& p : polygon.points) ball.radius = std::max(ball.radius, length(place_of(p) - ball.middle));
    balls_.push_back(ball);
  }
}

std::optional<Pick3> ScenePick3::at(const Pointer3& pointer, const std::vector<bool>& is_left_out) const {
  const Direction3 way = pointer.way_to(pointer.at), along = unit(way);
  const Point3 eye = exact_point(pointer.eye);
  const Point3 end = exact_point(way);
  const ExactRay ray{eye, {end.x, end.y, end.z}};
  std::optional<Pick3> first;
  std::optional<Rational> nearest;
  for (std::uint32_t s = 0; s < scene_->polygons.size(); ++s) {
    if (s < is_left_out.size() && is_left_out[s]) continue;
    const Ball& ball = balls_[s];
    const Direction3 to = ball.middle - pointer.eye;
    const double beside = length(to - dot(to, along) * along);
    if (beside > ball.radius + kNearBall * (ball.radius + length(to))) continue;
    for (const Polygon3& facet : facets_of(scene_->polygons[s])) {
      const Vector3 normal = doubled_area(facet);
      const std::optional<Rational> t = met(ray, facet, normal);
      if (!t || (nearest && *t > *nearest)) continue;
      const bool is_back = dot(normal, ray.way) > 0;
      const bool is_first = !nearest || *t < *nearest || scene_->surfaces[s].on ||
                            (!is_back && first->face.is_back && !scene_->surfaces[first->face.surface].on);
      if (!is_first) continue;
      nearest = t;
      first = Pick3{{s, is_back}, ray.at(*t)};
    }
  }
  return first;
}

std::optional<Point3> corner_at(const Scene3& scene, const std::vector<std::uint32_t>& surfaces,
                                const Pointer3& pointer) {
  std::optional<Point3> nearest;
  double least = pointer.reach, least_depth = HUGE_VAL;
  for (const std::uint32_t s : surfaces)
    for (const Point3& corner : corners_of(scene.polygons[s])) {
      const Direction3 place = place_of(corner);
      const double depth = pointer.depth(place);
      if (!(depth > 0)) continue;
      const Pixel at = pointer.seen(place);
      const double away = std::hypot(at.x - pointer.at.x, at.y - pointer.at.y) / pointer.pixel;
      if (away > least || (away == least && nearest && depth >= least_depth)) continue;
      nearest = corner;
      least = away;
      least_depth = depth;
    }
  return nearest;
}

}  // namespace hottel
