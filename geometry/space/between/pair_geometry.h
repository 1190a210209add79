// The polygons of a pair. Internal to geometry/space/exchange.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "geometry/space/arrangement/occluders.h"
#include "geometry/space/arrangement/patch.h"
#include "geometry/space/between/known_patch.h"
#include "geometry/space/between/vertex_numbers.h"
#include "geometry/space/hiding/convex_bodies.h"
#include "geometry/space/visibility/direction.h"

namespace hottel {

// Two patches, and the surfaces that may stand between them, as bodies with numbers of their own: 0 and 1 are the
// patches, then what is between, then what is between only as a part of a solid. Their corners are points, each once;
// those of a cone of the sky are far, and have the weight 0.
//
//   (1) normals point to the front. All is in front of a cone of the sky, which has none
//   (2) two bodies that share an edge share its two points: exactly equal points are one, but for corners of patches
//       that lie on surfaces other than their own without being corners there
struct PairGeometry3 {
  struct Point {
    const IntegerVector* numerator;  // integer form times weight: of the vertices, or of a patch
    const Integer* denominator;      // the weight
    BoundedVector approximate;       // the numerator times 2^-(shift() + spare)
    double approximate_weight = 1;   // the weight times 2^-spare
    long spare = 0;                  // by how many bits the weight is longer than a double

    const IntegerVector& exact() const { return *numerator; }
    const Integer& weight() const { return *denominator; }
    // Whether it is a direction: of a cone of the sky.
    bool is_far() const { return sgn(*denominator) == 0; }
  };
  struct Body {
    std::vector<std::uint32_t> corners;  // counter-clockwise, seen from the front
    const IntegerVector* normal_numbers;
    BoundedVector normal;
    std::uint32_t surface;

    const IntegerVector& exact_normal() const { return *normal_numbers; }
  };
  // How two bodies lie: of the corners of one, whether there are some in front of the plane of the other, and behind.
  struct Side {
    bool has_front = false, has_behind = false;
    bool straddles() const { return has_front && has_behind; }
  };

  // A convex body (ConvexBodies3) of which several surfaces may stand between: from outside it hides as one.
  struct Solid {
    static constexpr std::uint32_t kNone = 0xffffffff;
    // An edge of one face or of two: numbers of faces, and which of their sides it is.
    struct Edge {
      std::array<std::uint32_t, 2> face{kNone, kNone}, side{0, 0};
    };
    const ConvexBody3* exact;
    std::vector<std::uint32_t> faces;  // bodies: all its surfaces
    std::vector<signed char> outward;  // +1 where the front of a face looks out, else -1
    std::vector<Edge> edges;
    std::array<bool, 2> may_hide{true, true};  // whether it is nearer than all of a patch
  };

  std::vector<Point> points;
  std::vector<Body> bodies;
  std::vector<Solid> solids;
  bool hides_joined = false;                          // whether what hangs together hides as one too (JoinedBodies3)
  std::array<Side, 2> patch_sides;                    // of patch 0 beside the plane of patch 1, and the other way round
  std::vector<std::array<Side, 2>> of_body{{}, {}};   // body k beside the planes of the patches
  std::vector<std::array<Side, 2>> of_patch{{}, {}};  // the patches beside the plane of body k

  // Takes two patches: sets points, bodies and patch_sides. REQUIRES: occluders and patches, known ones too, outlive
  // this.
  PairGeometry3(const Occluders3& occluders, const KnownPatch3& i, const KnownPatch3& j);
  PairGeometry3(const Occluders3& occluders, const Patch3& i, const Patch3& j);
  PairGeometry3(const PairGeometry3&) = delete;  // bodies point to what is kept here
  PairGeometry3& operator=(const PairGeometry3&) = delete;

  // Adds a surface; `of_body` and `of_patch` are set for it. Returns its number.
  std::uint32_t add(const Occluders3& occluders, std::uint32_t surface);
  // The same where it is in front of both patches, and between their planes. Else only its points are added: false.
  bool add_between(const Occluders3& occluders, std::uint32_t surface);
  // Takes the last one away.
  void drop_last();
  // Adds a convex body of which some surfaces are among the bodies; the others come after all that may stand between.
  // REQUIRES: no surface is added after it, and none of it is that of a patch.
  void add_solid(const Occluders3& occluders, const ConvexBody3& body);
  // Bodies before that, from 2 on, may stand between the patches by themselves.
  std::uint32_t end_of_between() const { return solids.empty() ? count() : end_of_between_; }
  std::uint32_t count() const { return static_cast<std::uint32_t>(bodies.size()); }
  const Vertices3& vertices() const { return *vertices_; }
  // The patches.
  const KnownPatch3& known(std::uint32_t patch) const { return *known_[patch]; }
  // The doubles of points are multiplied with 2^-shift(), and where weights are long with 2^-spare besides.
  long shift() const { return shift_; }
  // Where a point is, in the unit of these doubles, however long its numbers are; of a far one its direction.
  Direction3 place(std::uint32_t point) const;
  bool is_far(std::uint32_t body) const { return points[bodies[body].corners.front()].is_far(); }

  // Where a point lies of the plane of a body: +1 before its front, -1 behind, 0 on it. Of a far one: where the
  // direction goes.
  int side(std::uint32_t point, std::uint32_t body) const;
  // The sign of the determinant of the ways from p to q, r and s. REQUIRES: p is not far.
  int orientation(std::uint32_t p, std::uint32_t q, std::uint32_t r, std::uint32_t s) const;
  // The same for one p, q, r and many s.
  struct Plane {
    std::uint32_t p, q, r;
    BoundedVector normal;
  };
  int orientation(const Plane& plane, std::uint32_t s) const { return orientation(plane, s, way(plane.p, s)); }
  // The same where the way from p to s is known.
  int orientation(const Plane& plane, std::uint32_t s, const BoundedVector& way_to_s) const;
  // Sets the ways from a point that is not far to others, times both weights. The normal of a plane is the product of
  // those from p to q and to r.
  void set_ways(std::uint32_t p, std::span<const std::uint32_t> others, std::vector<BoundedVector>& ways) const;

 private:
  struct OwnPatches {
    KnownPatch3 i, j;
  };
  PairGeometry3(const Occluders3& occluders, std::unique_ptr<const OwnPatches> own);
  std::uint32_t add_point(const IntegerVector& exact, const Integer& weight, const BoundedVector& approximate,
                          double approximate_weight, long spare = 0);
  std::uint32_t vertex(const Occluders3& occluders, VertexId3 v);
  void add_patch(const Occluders3& occluders, const KnownPatch3& known);
  std::uint32_t begin_body(const Occluders3& occluders, std::uint32_t surface);
  Side side_of_body(std::uint32_t body, std::uint32_t other) const;
  BoundedVector way(std::uint32_t p, std::uint32_t q) const;
  IntegerVector exact_way(std::uint32_t p, std::uint32_t q) const;

  const Vertices3* vertices_;
  std::array<const KnownPatch3*, 2> known_;
  VertexNumbers3 vertex_numbers_;          // of points
  std::unique_ptr<const OwnPatches> own_;  // null where known ones were given
  std::uint32_t end_of_between_ = 0;
  long shift_ = 0;
};

}  // namespace hottel
