// The light of a solution at points.
#pragma once

#include <vector>

#include "geometry/plane/prepared/prepared_scene.h"
#include "geometry/plane/visibility/point_location.h"
#include "solver/plane/light/light_columns.h"
#include "solver/plane/light/lit_region.h"
#include "solver/plane/light/sent_out.h"

namespace hottel {

// The mean irradiance at as many points as one likes, from one solution (mean_irradiance.h) and the scene's lights
// (lit_region.h).
//
//   (1) at() of a point is what at() of its view is, bit for bit
//   (2) NaN in solids and outside a closed scene (LightRow2::is_nowhere), in every channel
// REQUIRES the solution of a matrix of the scene of that granularity. Any number of threads may ask at once.
class PointLights2 {
 public:
  PointLights2(std::shared_ptr<const PreparedScene2> prepared, Granularity granularity,
               const RadiositySolution& solution);

  const std::vector<std::string>& channel_names() const { return channel_names_; }
  const PreparedScene2& prepared() const { return *prepared_; }
  // What it is summed of.
  const LightColumns2& columns() const { return columns_; }
  const SentOut2& sent_out() const { return sent_out_; }
  const LitRegions2& lit() const { return *lit_; }
  // By channel. REQUIRES the location and the view of the eye. COST: one arc tangent for each element seen.
  std::vector<double> at(const Eye2& eye, const Location2& location, const View2& view) const;
  // The same of a point in scene coordinates, which is looked around from. REQUIRES the location in this scene.
  std::vector<double> at(const PointLocation2& location, const Point2& point) const;

 private:
  PointLights2(std::shared_ptr<const PreparedScene2> prepared, const ElementTable2& table,
               const RadiositySolution& solution);

  std::shared_ptr<const PreparedScene2> prepared_;
  std::vector<std::string> channel_names_;
  LightColumns2 columns_;
  SentOut2 sent_out_;
  std::shared_ptr<const LitRegions2> lit_;
};

}  // namespace hottel
