// The map of a point with its planes and corners as integers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "geometry/face.h"
#include "geometry/space/arrangement/occluders.h"
#include "geometry/space/arrangement/patch.h"
#include "geometry/space/point.h"
#include "geometry/space/predicates/sun_frame.h"
#include "geometry/space/visibility/visibility_map.h"

namespace hottel {

// A convex cone of directions with inner points, less than a half space, exactly: where inward[k] . w > 0 for all k.
//
//   (1) at least three sides, in order, counter-clockwise seen against the directions; corner k is a positive multiple
//       of inward[k - 1] x inward[k], and edge k goes along side k from corner k to the next one
struct ExactCone3 {
  std::vector<IntegerVector> inward, corners;

  // Where a direction lies: kOnEdge and kAtCorner with the edge, or with the one that begins at the corner.
  enum class Place : unsigned char { kOutside, kInside, kOnEdge, kAtCorner };
  struct Located {
    Place place = Place::kOutside;
    std::size_t side = 0;
  };
  Located locate(const IntegerVector& direction) const;  // REQUIRES a direction that is not zero
};

// Returns what two cones have in common, or nothing where that has no inner direction.
// COST: an integer product for each side of one and corner of the other.
std::optional<ExactCone3> common_cone(const ExactCone3& cone, const ExactCone3& other);

// What is seen from a point, or from a sun (SunFrame3), for questions that need more than doubles.
//
//   (1) fragments are those of map_from(): cone(k) is that of map().fragments[k]; map().fragments[k].face is a side of
//       a polygon of the occluders
//   (2) corners_on_face(k) are where the rays to the corners of a fragment meet its face, exactly
//   (3) nothing depends on the unit of length, but for corners_on_face()
//
// For several threads at once. REQUIRES that the occluders outlive this.
// COST: that of map_from(), and some ten microseconds a fragment.
class ExactVisibilityMap3 {
 public:
  ExactVisibilityMap3(const Occluders3& occluders, const Point3& eye);
  // What a sun sees, by the direction of its rays, which is not zero. Cones are of directions of SunFrame3.
  static ExactVisibilityMap3 of_sun(const Occluders3& occluders, const Vector3& direction);

  const Occluders3& occluders() const { return occluders_; }
  // REQUIRES no sun.
  const Point3& eye() const { return eye_; }
  // Of a sun; else null.
  const SunFrame3* sun() const { return sun_.get(); }
  const VisibilityMap3& map() const { return map_; }
  std::size_t size() const { return cones_.size(); }
  const ExactCone3& cone(std::size_t fragment) const { return cones_[fragment]; }
  std::vector<Point3> corners_on_face(std::size_t fragment) const;

  // The vector from the eye to a point, times a positive rational: coprime integers; zero for the eye. Of a sun it
  // stands for the ray through the point.
  IntegerVector toward(const Point3& point) const;

  // The cone of a convex patch that lies on a polygon in whose plane the eye is not, nor the rays of the sun.
  ExactCone3 cone_of(const Patch3& patch) const;
  // The same of a convex polygon in such a plane, by its corners in order, in either sense.
  ExactCone3 cone_of(const std::vector<Point3>& corners) const;

  // Where a point lies of the plane of a polygon that is seen: +1 on the side of the eye, -1 beyond, 0 on it.
  int nearness(const Point3& point, std::uint32_t polygon) const;

 private:
  explicit ExactVisibilityMap3(const Occluders3& occluders) : occluders_(occluders) {}
  template <class NormalOf>
  void make_cones(NormalOf normal_of);

  const Occluders3& occluders_;
  std::shared_ptr<const SunFrame3> sun_;
  Point3 eye_;
  IntegerVector numerator_;  // the eye in integer form = numerator / denominator
  Integer denominator_ = 1;
  VisibilityMap3 map_;
  std::vector<ExactCone3> cones_;
};

}  // namespace hottel
