// The light of a solution on small areas at points of space.
#pragma once

#include <functional>
#include <vector>

#include "geometry/element.h"
#include "geometry/space/point.h"
#include "geometry/space/scene/scene.h"
#include "solver/radiosity/oriented_light.h"
#include "solver/radiosity/radiosity_solution.h"
#include "solver/space/light/illumination_grid.h"
#include "solver/space/light/scene_lights.h"
#include "solver/space/light/sent_out.h"

namespace hottel {

// What arrives at as many points as one likes, from one solution (SentOut3) and the scene's lights (SceneLights3).
//
//   (1) what is seen is decided exactly, from the exact point; angles are in doubles. A point does not depend on others
//   (2) the mean irradiance is that of illuminate_points at this point, bit for bit
//   (3) on a face whose normal is the given one the area sees what the face sees there; a face that it lies on edge-on,
//       and one behind it, it does not see
//
// REQUIRES the solution of the scene's matrix by that granularity, and that both outlive it. For several threads at
// once. COST: two maps a point.
class OrientedLights3 {
 public:
  OrientedLights3(const PreparedScene3& prepared, Granularity granularity, const RadiositySolution& solution);

  // normal: not zero, of any length.
  OrientedLight at(const Point3& point, const Vector3& normal) const;

 private:
  const PreparedScene3& prepared_;
  std::size_t channels_;
  SentOut3 sent_out_;
  SceneLights3 lights_;
};

// Returns the light at the centre of each cell of a planar grid, in the order of IlluminationGrid3, on areas whose
// fronts look along u x v: OrientedLights3::at, bit for bit.
//
// progress: fraction done; may throw to stop. REQUIRES what OrientedLights3 does. COST: parallel.
std::vector<OrientedLight> oriented_lights_on_grid(const PreparedScene3& prepared, Granularity granularity,
                                                   const RadiositySolution& solution, const Grid3& grid,
                                                   const std::function<void(double)>& progress = {});

// Returns the light at the centre of each cell as far as it is the same whatever way areas look: the mean irradiance.
// The rest is NaN. It is what there is in a volume, which has no u x v.
std::vector<OrientedLight> lights_around(const IlluminationGrid3& light);

}  // namespace hottel
