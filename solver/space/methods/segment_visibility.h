// Which points of a scene in space see each other.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/space/arrangement/occluders.h"
#include "geometry/space/vectors/local_vector.h"

namespace hottel {

// A point on a polygon, in the doubles of Vertices3 (integer form times 2^-shift).
struct SurfacePoint3 {
  LocalVector3<double> at;
  std::uint32_t surface;  // of Occluders3: it hides nothing from its own point
};

// Which points of a scene see each other.
//
//   (1) decided without rounding, for points as their doubles say and corners as doubles hold them: corners of which
//       doubles hold all, as a rule
//   (2) a segment that meets an edge, a corner or lies in a plane is seen where one parallel to it, moved by
//       (e, e^2, e^3) with an infinitesimal e, is: so nothing slips through between polygons that share an edge
//   (3) see_each_other(p, q) == see_each_other(q, p)
//
// For several threads at once. COST: some hundred ns a segment where boxes of polygons do not overlap much.
class SegmentVisibility3 {
 public:
  // REQUIRES: the occluders outlive this. COST: linear.
  explicit SegmentVisibility3(const Occluders3& occluders);

  bool see_each_other(const SurfacePoint3& p, const SurfacePoint3& q) const;
  // Whether nothing is met in a direction of length 1.
  bool sees_sky(const SurfacePoint3& p, const LocalVector3<double>& direction) const;

  // The diagonal of the box of all vertices.
  double diagonal() const { return diagonal_; }

 private:
  struct Box {
    std::array<double, 3> low, high;
  };
  bool is_free(const LocalVector3<double>& p, const LocalVector3<double>& q, std::uint32_t own,
               std::uint32_t other) const;
  bool hides(std::uint32_t surface, const LocalVector3<double>& p, const LocalVector3<double>& q) const;

  const Occluders3& occluders_;
  std::vector<LocalVector3<double>> corners_;  // by vertex
  std::vector<Box> boxes_;                     // by node
  double diagonal_ = 0;
};

}  // namespace hottel
