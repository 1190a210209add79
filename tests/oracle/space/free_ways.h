// Whether the way from a point past one that moves along an edge, on either side of it, leads to a polygon.
#pragma once

#include <optional>
#include <vector>

#include "tests/oracle/space/border_edges.h"
#include "tests/oracle/space/real_of_digits.h"

namespace hottel::oracle {

// Polygons as numbers, and what is true of them and an edge f for all points of f, exactly.
template <class Real>
struct RoundedPolygon {
  std::vector<VectorOf<Real>> points;
  VectorOf<Real> normal;
  bool holds_f = false;            // f is in its plane
  bool is_level = false;           // its plane is that of polygon 0
  bool is_parallel = false;        // or parallel to it
  bool is_with_target = false;     // its plane is that of polygon 1
  std::vector<char> is_side_on_f;  // of each side: x, a point of f and the side are in one plane for all x
};

template <class Real>
class FreeWays {
 public:
  // What is nearer to 0 than `least`, beside numbers of the size of 1, is in doubt. All polygons in coordinates of that
  // size.
  FreeWays(const std::vector<PlanePolygon>& polygons, const SpaceSegment& f, Real least);

  // For a point x of the plane of polygon 0 and q of f, neither on any of the lines of PlaneLines nor an event: 1 where
  // the way from x past q, infinitely little to the side of (q - x) x f, leads to the front of polygon 1 with nothing
  // between, less the same on the other side. Nothing where that is in doubt.
  std::optional<int> sides(const VectorOf<Real>& x, const VectorOf<Real>& q) const;

 private:
  struct Way {
    VectorOf<Real> x, w, aside;  // from x towards w + epsilon aside
  };
  int sign(const Real& value) const;
  bool passes(const RoundedPolygon<Real>& polygon, const Way& way, int side) const;
  bool is_before(const RoundedPolygon<Real>& polygon, const Way& way) const;
  bool is_free(const Way& way) const;

  std::vector<RoundedPolygon<Real>> polygons_;
  VectorOf<Real> f_;
  bool is_f_level_;
  Real least_;
  mutable bool is_in_doubt_ = false;
};

extern template class FreeWays<double>;
extern template class FreeWays<RealOf<70>>;
extern template class FreeWays<RealOf<150>>;

}  // namespace hottel::oracle
