// Where the power of a point light or a spot light goes first, and what a sun lights.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/space/point.h"
#include "geometry/space/visibility/beam.h"
#include "kernel/enclosure.h"

namespace hottel {

class ElementTable3;
class ExactVisibilityMap3;
struct PreparedScene3;

// A part of the power of a light: the real number is within the bounds, and the value is the double nearest to it or a
// neighbour of that.
struct LightShare3 {
  double value = 0;
  Enclosure bounds{0, 0};
  friend bool operator==(const LightShare3&, const LightShare3&) = default;
};

// The parts of the power of a light that first meet the elements of a scene.
//
//   (1) the light that falls on an element is P * elements[label].value: D = that / area of the element. Labels are
//       those of the table; black backs are elements too
//   (2) bounds are proven, and at most some 2^-50 of the share wide; shares are never negative. 0 and its bounds are
//       exact where no light comes: beyond the beam, hidden, in the plane of the face, behind its back. Of the sky they
//       are from 0 to 2^-90 where it is not seen
//   (3) the real numbers sum to 1, over all elements, the sky and what is lost; the bounds of their sum hold it
//   (4) shares do not depend on translation, nor on the unit of length, nor on threads
//
// `lost` is 1 where the light is in a solid, and 0 else; but where it is on the border of one it is what goes into it.
struct LightShares3 {
  std::vector<LightShare3> elements;
  LightShare3 sky, lost;
  bool is_in_solid = false;
};

// Returns the shares of a beam from a point. A polygon in whose plane the light is gets none.
//
// REQUIRES the table of the prepared scene, by any granularity, and a beam without a problem (beam_problem).
// Throws Interrupted when asked to stop.
// COST: that of a map of the point; then for each fragment of it, and each element in it, that of BeamPower3::share.
LightShares3 light_shares(const PreparedScene3& prepared, const ElementTable3& table, const Point3& position,
                          const Beam3& beam);

// The same where the map of the point is known.
LightShares3 light_shares(const PreparedScene3& prepared, const ElementTable3& table, const ExactVisibilityMap3& map,
                          const BeamPower3& beam);

// Returns the area of what a sun lights of each element, across its rays, within bounds: irradiance times area is what
// falls on it. Labels are those of the table.                                                  [scene unit squared]
//
//   (1) bounds are proven, and at most some 2^-50 of the area wide; {0, 0} exactly where no ray arrives: hidden, along
//       the rays, turned away
//
// REQUIRES the table of the prepared scene, and the map of a sun. Throws Interrupted when asked to stop.
// COST: for each fragment of the map, and each element in it, a determinant of integers a corner.
std::vector<Enclosure> sunlit_areas(const PreparedScene3& prepared, const ElementTable3& table,
                                    const ExactVisibilityMap3& map);

}  // namespace hottel
