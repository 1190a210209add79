#include "viewer/edit/space/snapping.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "kernel/exact_double.h"
#include "viewer/edit/decimals.h"

namespace hottel {
namespace {

constexpr double kAsNear = 1 - 1e-6;  // of the way to a goal, that what hides it is nearer

double pixels_between(const Direction3& place, const Pointer3& pointer) {
  const Pixel at = pointer.seen(place);
  return std::hypot(at.x - pointer.at.x, at.y - pointer.at.y) / pointer.pixel;
}

// The part of a side, 0 to 1, that is nearest to the ray of the mouse.
double nearest_part(const Direction3& from, const Direction3& to, const Pointer3& pointer) {
  const Direction3 ray = unit(pointer.way_to(pointer.at)), along = to - from, way = from - pointer.eye;
  const double a = dot(along, along), b = dot(along, ray);
  const double part = (b * dot(ray, way) - dot(along, way)) / (a - b * b);
  return std::isfinite(part) ? std::clamp(part, 0.0, 1.0) : 0;
}

// The point of a side at a part that is a decimal, as fine as those decimals.
Point3 point_of_side(const Side3& side, double part, int decimals) {
  const Vector3 way = side.to - side.from;
  const Rational longest = std::max<Rational>({abs(way.x), abs(way.y), abs(way.z)});
  const Rational t = rounded_decimal(part, std::max(1, decimals + decades(longest)));
  return {side.from.x + t * way.x, side.from.y + t * way.y, side.from.z + t * way.z};
}

}  // namespace

Snapper3::Snapper3(const Scene3& scene, std::vector<bool> is_moved)
    : scene_(&scene), is_moved_(std::move(is_moved)), pick_(scene) {
  is_moved_.resize(scene.polygons.size());
}

// Whether nothing that stands hides a place.
bool Snapper3::is_seen(const Direction3& place, const Pointer3& pointer) const {
  Pointer3 to = pointer;
  to.at = pointer.seen(place);
  const std::optional<Pick3> first = pick_.at(to, is_moved_);
  return !first || length(place_of(first->place) - pointer.eye) >= kAsNear * length(place - pointer.eye);
}

std::optional<Snap3> Snapper3::corner(const Pointer3& pointer) const {
  std::optional<Snap3> nearest;
  double least = pointer.reach;
  for (std::uint32_t s = 0; s < scene_->polygons.size(); ++s) {
    if (is_moved_[s]) continue;
    for (const Point3& p : corners_of(scene_->polygons[s])) {
      const Direction3 place = place_of(p);
      if (!(pointer.depth(place) > 0)) continue;
      const double away = pixels_between(place, pointer);
      if (away > least || (nearest && away == least) || !is_seen(place, pointer)) continue;
      least = away;
      nearest = Snap3{p, Snap3::To::kVertex, s};
    }
  }
  return nearest;
}

std::optional<Snap3> Snapper3::side(const Pointer3& pointer, int decimals) const {
  std::optional<Snap3> nearest;
  double least = pointer.reach;
  for (std::uint32_t s = 0; s < scene_->polygons.size(); ++s) {
    if (is_moved_[s]) continue;
    for (const Side3& side : sides_of(scene_->polygons[s])) {
      const Direction3 from = place_of(side.from), to = place_of(side.to);
      const double part = nearest_part(from, to, pointer);
      const Direction3 place = from + part * (to - from);
      if (!(pointer.depth(place) > 0)) continue;
      const double away = pixels_between(place, pointer);
      if (away > least || (nearest && away == least) || !is_seen(place, pointer)) continue;
      least = away;
      nearest = Snap3{point_of_side(side, part, decimals), Snap3::To::kEdge, s};
    }
  }
  return nearest;
}

std::optional<std::uint32_t> Snapper3::plane(const Direction3& place, double reach) const {
  std::optional<std::uint32_t> nearest;
  double least = reach;
  for (std::uint32_t s = 0; s < scene_->polygons.size(); ++s) {
    const Polygon3& polygon = scene_->polygons[s];
    if (is_moved_[s] || polygon.is_nearly_plane) continue;
    const Vector3 area = doubled_area(polygon);
    const Direction3 normal = unit({to_double(area.x), to_double(area.y), to_double(area.z)});
    const double off = dot(normal, place - place_of(polygon.points.front()));
    if (!(std::abs(off) <= least) || (nearest && std::abs(off) == least)) continue;
    const Direction3 foot = place - off * normal;
    const Point3 exact{exact_value(foot.x), exact_value(foot.y), exact_value(foot.z)};
    if (!contains_in_plane(polygon, area, exact)) continue;
    least = std::abs(off);
    nearest = s;
  }
  return nearest;
}

Snap3 Snapper3::at(const Pointer3& pointer, const Freedom3& freedom) const {
  const Direction3 place = freedom.at(pointer);
  const int decimals = decimals_at_place(place, pointer);
  for (auto goal : {corner(pointer), side(pointer, decimals)}) {
    if (!goal) continue;
    goal->at = freedom.onto(goal->at);
    return *goal;
  }
  const auto surface = plane(place, pointer.reach * pointer.length_of_pixel(place));
  if (surface) {
    const Polygon3& polygon = scene_->polygons[*surface];
    Freedom3 on_plane = freedom;
    if (on_plane.take(plane_through(polygon.points.front(), doubled_area(polygon))))
      return {on_plane.rounded(place, decimals), Snap3::To::kPlane, surface};
  }
  return {freedom.rounded(place, decimals)};
}

}  // namespace hottel
