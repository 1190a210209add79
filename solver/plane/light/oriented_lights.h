// The light of a solution on small areas at points of the plane.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "geometry/plane/point.h"
#include "geometry/plane/visibility/point_location.h"
#include "solver/plane/light/illumination_grid.h"
#include "solver/plane/light/point_lights.h"
#include "solver/radiosity/oriented_light.h"

namespace hottel {

// What arrives at as many points as one likes, from one solution and the scene's lights.
//
//   (1) what is seen is decided exactly, from the exact point; angles are in doubles: factors to some 1e-15, absolutely
//   (2) the mean irradiance is that of PointLights2 at this point, bit for bit
//   (3) factors of all that is seen, and of the sky, sum to 1. On an edge or vertex an area sees both sides, as a point
//       does; what looks into a solid is black
//
// REQUIRES the solution of a matrix of the scene of that granularity. Any number of threads may ask at once.
class OrientedLights2 {
 public:
  OrientedLights2(std::shared_ptr<const PreparedScene2> prepared, Granularity granularity,
                  const RadiositySolution& solution);

  // In scene coordinates. normal: not zero, of any length. COST: that of looking around.
  OrientedLight at(const Point2& point, const Point2& normal) const;

 private:
  void see(const Eye2& eye, const View2& view, const std::array<double, 2>& normal, OrientedLight& light) const;

  PointLights2 around_;
  PointLocation2 location_;
};

// Returns what the centres of cells get of all directions, as OrientedLight tells it of none in particular: in place of
// `irradiance` the mean irradiance, in place of `sky_view_factor` the fraction of all directions that lead to the sky.
// `light`: the mean irradiance there (illuminate_points, with lights). REQUIRES the scene's. COST: that of
// illuminate_points.
std::vector<OrientedLight> lights_around_cells(const PreparedScene2& prepared, const IlluminationGrid2& light,
                                               const std::function<void(double)>& progress = {});

}  // namespace hottel
