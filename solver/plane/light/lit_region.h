// Which points of the plane a light reaches, and how bright it makes them.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "geometry/light.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "geometry/plane/visibility/point_location.h"
#include "geometry/plane/visibility/sun_view.h"
#include "geometry/plane/visibility/view.h"
#include "solver/plane/light/beam.h"

namespace hottel {

// The visibility polygon of a light, to be asked for many points.
//
//   (1) exact: a point is reached iff the open segment to it meets no edge, or one of its two infinitesimal parallel
//       shifts does not: borders of shadows are lit, and so is what the light shines on
//   (2) a light in a solid reaches nothing
//
// REQUIRES that the scene outlives it. COST: a view; then some 10 ns for each halving of what is seen.
class LitRegion2 {
 public:
  LitRegion2(const PreparedScene2& prepared, const PointLocation2& location, const Light& light,
             const LightPlace2& place);
  LitRegion2(const LitRegion2&) = delete;
  LitRegion2& operator=(const LitRegion2&) = delete;

  // REQUIRES an eye of the vertices of the scene.
  bool reaches(const Eye2& point) const;
  // The direct mean irradiance over the power of the light: I / (pi r P), I the intensity towards the point in the
  // beam, r the distance in scene units; 0 where it is not reached, infinite at the light.     [1 / scene unit]
  double irradiance(const Eye2& point) const;
  // The same where the way to the point is known: both coordinates in integer form, each rounded correctly.
  double irradiance(const Eye2& point, double way_x, double way_y) const;

  // Where the light is, in integer form.
  const Eye2& eye() const { return eye_; }

 private:
  bool is_behind(std::size_t step, const Eye2& point) const;
  std::size_t step_towards(const Eye2& point, bool& is_on_ray) const;

  const PreparedScene2& prepared_;
  Eye2 eye_;
  View2 view_;
  Beam2 beam_;
  double scale_;                // scene units of a unit of integer form
  std::size_t first_half_ = 0;  // steps that begin within half a turn after the first
  bool is_in_solid_ = false;
  bool is_beyond_ = false;  // so far away that doubles have nothing of its light at points that they have
};

// All lights of a scene: lamps, which have a place, and suns. Where a ray of a sun reaches a point (SunView2), what it
// adds there is its irradiance over pi.
class LitRegions2 {
 public:
  explicit LitRegions2(const PreparedScene2& prepared);

  bool is_empty() const { return regions_.empty() && suns_.empty(); }
  // Of lamps.
  std::size_t count() const { return regions_.size(); }
  const Eye2& eye(std::size_t lamp) const { return regions_[lamp]->eye(); }
  // Adds the direct mean irradiance at a point to `result`, one place a channel; NaN stays.
  void add(const Eye2& point, std::span<double> result) const;
  // The same where the ways from the lamps to the point are known, as LitRegion2::irradiance takes them; one a lamp.
  void add(const Eye2& point, std::span<const double> ways_x, std::span<const double> ways_y,
           std::span<double> result) const;
  // Adds the direct irradiance of a small area at a point whose front has this unit normal: pi cos times the mean
  // irradiance of each light, I cos / r of a lamp; nothing from behind.
  void add_facing(const Eye2& point, const std::array<double, 2>& normal, std::span<double> result) const;

 private:
  using Power = std::array<double, 3>;
  struct Sun {
    SunView2 view;
    Power irradiance;
  };
  static void add(const Power& power, double share, std::span<double> result);
  void add_suns(const Eye2& point, std::span<double> result) const;

  std::vector<std::unique_ptr<LitRegion2>> regions_;
  std::vector<Power> power_;  // of regions
  std::vector<Sun> suns_;
};

}  // namespace hottel
