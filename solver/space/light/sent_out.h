// What faces in space send out, as points see it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/element.h"
#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "geometry/space/visibility/direction.h"
#include "geometry/space/visibility/point_map.h"
#include "solver/radiosity/radiosity_solution.h"

namespace hottel {

// The radiosities of elements on the sides of pieces, to be summed over what points see.
//
//   (1) what is seen is decided exactly, from the exact point (PointMap3); angles are in doubles. Of a face that is
//       divided each element counts by its angle
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
  struct Part {
    std::uint32_t label;
    std::vector<Direction3> corners;  // in scene coordinates
  };
  struct Side {
    bool is_divided = false;  // its parts are of several elements
    std::vector<Part> parts;
    bool is_covered = false;  // but for these, it looks into solids; none where all of it does
    std::vector<std::vector<Direction3>> free{};
  };

  bool is_in_solids(const PointMap3& map, const Point3& eye) const;
  template <class FractionOf, class Measure>
  void sum(const PointMap3& map, const Point3& eye, const FractionOf& fraction_of, const Measure& measure,
           std::span<double> result) const;
  template <class Measure>
  void add_free(const std::vector<Direction3>& cone, const Side& side, const Direction3& eye, const Measure& measure,
                std::span<double> result) const;
  void add(std::uint32_t label, double fraction, std::span<double> result) const;
  template <class Measure>
  void add_divided(const std::vector<Direction3>& cone, double fraction, const Side& side, const Direction3& eye,
                   const Measure& measure, std::span<double> result) const;

  const PreparedScene3& prepared_;
  const ElementTable3& table_;
  const RadiositySolution& solution_;
  std::vector<Side> parts_;  // by side of a piece
  std::vector<double> sky_;
};

}  // namespace hottel
