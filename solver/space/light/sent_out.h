// What faces in space send out, as points see it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/element.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "solver/radiosity/radiosity_solution.h"
#include "solver/space/light/seen_elements.h"

namespace hottel {

// The radiosities of elements on the sides of pieces, to be summed over what points see.
//
//   (1) what is seen is decided exactly, from the exact point (VisibilityMap3); angles are in doubles. Of a face that
//       is divided each element counts by its angle
//   (2) directions to the sky carry its emission; black sides are 0, and so is what is seen through a solid on whose
//       border a point is. Direct light of lights is not part of it
//
// REQUIRES that what it is made of outlives it, and the solution of the scene's matrix by that granularity. COST: that
// of a map a point, and for each face that is seen and divided the product of its fragments and elements. For several
// threads at once.
class SentOut3 {
 public:
  SentOut3(const PreparedScene3& prepared, Granularity granularity, const RadiositySolution& solution);

  // Writes the mean over all directions, by channel; nothing outside a closed scene, where no face with a material is
  // seen, and where several solids meet around the point.
  void mean(const Point3& eye, std::span<double> result) const;
  // Writes the irradiance of a small area at the point, its front to the normal (not zero, of any length). Returns its
  // view factor to the sky.
  double irradiance(const Point3& eye, const Vector3& normal, std::span<double> result) const;

 private:
  SeenElements3::Take adding_to(std::span<double> result) const;

  SeenElements3 seen_;
  const RadiositySolution& solution_;
  std::vector<double> sky_;
};

}  // namespace hottel
