// The light of a point light, a spot light or a sun where it arrives first, before it is reflected.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "geometry/face.h"
#include "geometry/space/point.h"
#include "geometry/space/visibility/beam.h"
#include "geometry/space/visibility/exact_visibility_map.h"
#include "geometry/space/visibility/visibility_finder.h"

namespace hottel {

struct PreparedScene3;

// A convex part of a side of a piece that has a free way from a light, beam or not: the border of its shadows.
struct LitPart3 {
  // kAll: within the beam; kPart: the border of the beam, a cone with its top in the light, cuts it
  enum class Beam : unsigned char { kAll, kPart };

  Face side;                    // of a piece of the arrangement
  Face face;                    // whose it is
  std::vector<Point3> corners;  // exact; counter-clockwise seen from the light
  Beam beam = Beam::kAll;
};

// A light in a scene, to be asked for what arrives at points. Values are for the power 1; multiply by P.
//
//   (1) mean_irradiance(x) is I / (4 r^2) where the segment from the light to x is free (VisibilityFinder3) and in the
//       beam, its border included; else 0. What is free and what is in the beam is decided exactly; the value is off
//       by a few ulps, and n ulps more for a falloff n.                                       [unit: 1 / area]
//   (2) irradiance(x, m) is I cos(m, to the light) / r^2 there, and 0 on the side that looks away. The polygon on which
//       x lies does not hide it; at edges where polygons meet, what one of them leaves free is free
//   (3) lit_parts() are the parts of faces with a free way from the light that the beam meets: they share no area, and
//       the irradiance is smooth on each but for the border of the beam. Borders of shadows are their edges
//   (4) a light in a solid lights nothing. At the light itself the values are infinite
//   (5) of a sun values are for the irradiance 1 of what faces it: mean_irradiance(x) is 1/4 where no surface stops the
//       ray to x, irradiance(x, m) the cosine there, and all lit parts are within the beam
//
// For several threads at once. REQUIRES that the scene outlives this, and a beam without a problem.
// COST: that of an exact map, and of a finder of points in it; then some microseconds a point.
class DirectLight3 {
 public:
  DirectLight3(const PreparedScene3& prepared, const Point3& position, const Beam3& beam);
  // A sun, by the direction of its rays, which is not zero.
  DirectLight3(const PreparedScene3& prepared, const Vector3& sun);

  const ExactVisibilityMap3& map() const { return map_; }
  const BeamPower3& beam() const { return beam_; }
  bool is_in_solid() const { return is_in_solid_; }

  double mean_irradiance(const Point3& point) const;
  double irradiance(const Point3& point, const Vector3& normal) const;
  std::vector<LitPart3> lit_parts() const;

 private:
  double intensity_to(const Point3& point) const;  // 0 where it is not seen

  const PreparedScene3& prepared_;
  ExactVisibilityMap3 map_;
  VisibilityFinder3 finder_;
  BeamPower3 beam_;
  std::optional<Vector3> sun_;
  bool is_in_solid_ = false;
};

}  // namespace hottel
