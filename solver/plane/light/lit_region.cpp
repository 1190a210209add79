#include "solver/plane/light/lit_region.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "geometry/plane/predicates/eye_line.h"
#include "geometry/plane/scene/moving_lights.h"
#include "geometry/plane/visibility/solid_around.h"
#include "geometry/unit_of_length.h"

namespace hottel {
namespace {

// Whether a coordinate is beyond 2^1124: farther from all doubles than the largest of them is from 0.
bool is_beyond_doubles(const Rational& x) { return std::isinf(to_double(x / Rational(mpz_class(1) << 100))); }

}  // namespace

LitRegion2::LitRegion2(const PreparedScene2& prepared, const PointLocation2& location, const Light& light,
                       const LightPlace2& place)
    : prepared_(prepared),
      eye_(prepared.arrangement.vertices(), prepared.arrangement.vertices().from_scene(place.position)),
      beam_(light, place),
      scale_(to_double(prepared.arrangement.vertices().scale())) {
  const Point2 from = eye_.exact();
  const Rational& unit = prepared.arrangement.vertices().scale();
  is_beyond_ = std::isnormal(scale_) && (is_beyond_doubles(unit * from.x) || is_beyond_doubles(unit * from.y));
  location.look_around(eye_, view_);
  is_in_solid_ = solid_around(prepared.arrangement, view_) != Solids2::kNone;
  const auto& seen = view_.seen;
  while (first_half_ < seen.size() &&
         (first_half_ == 0 || eye_.orientation(seen[0].vertex, seen[first_half_].vertex) > 0))
    ++first_half_;
}

// The step whose directions, its first and not its last, hold that of a point, which is not the eye. is_on_ray: it is
// its first. REQUIRES two steps or more.
std::size_t LitRegion2::step_towards(const Eye2& point, bool& is_on_ray) const {
  const auto& seen = view_.seen;
  const EyeLine2 line(eye_, point);
  // -1 where the direction of a vertex is before that of the point, less than half a turn; 0 on its line
  const auto turn = [&](std::size_t k) { return line.side(seen[k].vertex); };
  const auto is_along = [&](std::size_t k) {
    const Point2 v = prepared_.arrangement.vertices().exact(seen[k].vertex), at = eye_.exact(), to = point.exact();
    return (v.x - at.x) * (to.x - at.x) + (v.y - at.y) * (to.y - at.y) > 0;
  };
  const int first = turn(0);
  const bool is_in_first_half = first < 0 || (first == 0 && is_along(0));
  // Vertices of one half are less than half a turn from each other, and from the point: among them the last that is
  // not after it.
  std::size_t low = is_in_first_half ? 0 : first_half_, high = is_in_first_half ? first_half_ : seen.size();
  while (low < high) {
    const std::size_t middle = low + (high - low) / 2;
    if (turn(middle) <= 0)
      low = middle + 1;
    else
      high = middle;
  }
  const std::size_t step = low - 1;
  is_on_ray = turn(step) == 0 && is_along(step);
  return step;
}

// Whether a point in the directions of a step is hidden by what is seen there.
bool LitRegion2::is_behind(std::size_t step, const Eye2& point) const {
  const PieceSideId side = view_.seen[step].behind;
  if (side == kSky) return false;
  const Segment2& piece = prepared_.arrangement.piece(side);
  return point.orientation(piece.a, piece.b) * eye_.orientation(piece.a, piece.b) < 0;
}

bool LitRegion2::reaches(const Eye2& point) const {
  if (is_in_solid_) return false;
  const std::size_t m = view_.seen.size();
  if (m < 2 || (point.x() == eye_.x() && point.y() == eye_.y() && point.exact() == eye_.exact())) return true;
  bool is_on_ray = false;
  const std::size_t step = step_towards(point, is_on_ray);
  return !is_behind(step, point) || (is_on_ray && !is_behind(step == 0 ? m - 1 : step - 1, point));
}

double LitRegion2::irradiance(const Eye2& point) const {
  const Point2 from = eye_.exact(), to = point.exact();
  return irradiance(point, to_double(to.x - from.x), to_double(to.y - from.y));
}

double LitRegion2::irradiance(const Eye2& point, double way_x, double way_y) const {
  if (way_x == 0 && way_y == 0 && point.exact() == eye_.exact())
    return is_in_solid_ ? 0 : std::numeric_limits<double>::infinity();
  if (is_beyond_ && std::isfinite(point.x() * scale_) && std::isfinite(point.y() * scale_)) return 0;
  double scale = scale_;
  if (!std::isfinite(way_x) || !std::isfinite(way_y) || !std::isnormal(scale)) {
    // Doubles cannot tell it in the unit of integer form.
    const Rational& unit = prepared_.arrangement.vertices().scale();
    const Point2 from = eye_.exact(), to = point.exact();
    way_x = to_double(unit * (to.x - from.x));
    way_y = to_double(unit * (to.y - from.y));
    scale = 1;
  }
  const double intensity = beam_.intensity(way_x, way_y, [&] {
    const Point2 from = eye_.exact(), to = point.exact();
    return Point2{to.x - from.x, to.y - from.y};
  });
  if (intensity == 0 || !reaches(point)) return 0;
  return intensity / (std::numbers::pi * scale * std::hypot(way_x, way_y));
}

LitRegions2::LitRegions2(const PreparedScene2& prepared) {
  const Scene2& scene = prepared.scene;
  if (scene.lights.empty()) return;
  const PointLocation2 location(prepared.arrangement.vertices(), prepared.arrangement.triangulation());
  for (std::size_t k = 0; k < scene.lights.size(); ++k) {
    const Power power = power_by_typed_distance_2(scene, scene.lights[k]);
    if (scene.lights[k].is_sun()) {
      suns_.push_back({SunView2(prepared.arrangement, turned_direction(scene.light_places[k])), power});
      continue;
    }
    regions_.push_back(std::make_unique<LitRegion2>(prepared, location, scene.lights[k], scene.light_places[k]));
    power_.push_back(power);
  }
}

void LitRegions2::add(const Power& power, double share, std::span<double> result) {
  if (share == 0) return;
  for (std::size_t c = 0; c < result.size(); ++c)
    if (power[c] > 0) result[c] += share * power[c];
}

void LitRegions2::add_suns(const Eye2& point, std::span<double> result) const {
  for (const Sun& sun : suns_)
    if (sun.view.reaches(point)) add(sun.irradiance, std::numbers::inv_pi, result);
}

void LitRegions2::add(const Eye2& point, std::span<double> result) const {
  for (std::size_t k = 0; k < regions_.size(); ++k) add(power_[k], regions_[k]->irradiance(point), result);
  add_suns(point, result);
}

void LitRegions2::add(const Eye2& point, std::span<const double> ways_x, std::span<const double> ways_y,
                      std::span<double> result) const {
  for (std::size_t k = 0; k < regions_.size(); ++k)
    add(power_[k], regions_[k]->irradiance(point, ways_x[k], ways_y[k]), result);
  add_suns(point, result);
}

void LitRegions2::add_facing(const Eye2& point, const std::array<double, 2>& normal, std::span<double> result) const {
  // Of light that travels along a way.
  const auto pi_cosine = [&normal](double way_x, double way_y) {
    const double length = std::hypot(way_x, way_y);
    const double cosine = length > 0 ? -(way_x * normal[0] + way_y * normal[1]) / length : 1;
    return cosine > 0 ? std::numbers::pi * cosine : 0;
  };
  for (std::size_t k = 0; k < regions_.size(); ++k) {
    const Point2 from = regions_[k]->eye().exact(), to = point.exact();
    const double way_x = to_double(to.x - from.x), way_y = to_double(to.y - from.y);
    if (const double facing = pi_cosine(way_x, way_y); facing > 0)
      add(power_[k], facing * regions_[k]->irradiance(point, way_x, way_y), result);
  }
  for (const Sun& sun : suns_) {
    const double facing = pi_cosine(to_double(sun.view.direction().x), to_double(sun.view.direction().y));
    if (facing > 0 && sun.view.reaches(point)) add(sun.irradiance, facing * std::numbers::inv_pi, result);
  }
}

}  // namespace hottel
