// The light of a solution at points.
#pragma once

#include <vector>

#include "geometry/plane/prepared/prepared_scene.h"
#include "geometry/plane/visibility/point_location.h"
#include "solver/plane/light/light_columns.h"
#include "solver/plane/light/lit_region.h"
#include "solver/plane/light/sent_out.h"

namespace hottel {

// The mean irradiance at as many points as one likes, from one solution and the scene's lights (lit_region.h): how
// bright the surroundings of a point are, averaged over all directions. Of the solution it is (1/2 pi) times the
// integral over all directions of the radiosity seen there, per channel: the row of the point (LightRowFinder2, which
// says what it is on edges and vertices) times what is sent out (SentOut2::light). [unit: that of radiosity]
//
//   (1) at() of a point is what at() of its view is, bit for bit
//   (2) NaN, in every channel, exactly in solids, in the interior of their union, and where the scene is closed and no
//       face with a material is seen (LightRow2::is_nowhere)
//   (3) what is seen is decided exactly; the angles are computed in doubles, each good to about 2^-50 turns times the
//       ratio of the scene's extent to the distance of the vertex
//   (4) of the solution exactly B where everything seen sends out B; never below the least nor above the largest
//       radiosity seen
//   (5) of the solution exactly 0 where nothing but black backs and a dark sky is seen
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
