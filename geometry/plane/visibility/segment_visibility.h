// Whether two points of a scene see each other.
#pragma once

#include "geometry/plane/arrangement/arrangement.h"
#include "geometry/plane/predicates/eye_line.h"
#include "geometry/plane/visibility/view.h"

namespace hottel {

// A point of one side of a straight run of pieces: from it one looks into the open half plane right of run.a -> run.b.
class RunPoint2 {
 public:
  // The point run.a + t (run.b - run.a), exactly.
  // REQUIRES 0 <= t <= 1, pieces on all of the run, and an arrangement that outlives the point.
  // COST: some µs; proportional to the pieces of the run and to the edges at their ends.
  RunPoint2(const Arrangement2& arrangement, const Segment2& run, const Rational& t);

  const Segment2& run() const { return run_; }
  const Eye2& eye() const { return eye_; }

 private:
  friend class SegmentVisibility2;
  void stand_on(const Triangulation2& triangulation, VertexId from, VertexId to);

  Segment2 run_;
  Eye2 eye_;
  HalfEdgeId gate_ = HalfEdgeId::none();  // of the piece the point lies inside of, in the triangle before the front
  bool is_vertex_ = false;
  VertexId vertex_{0};
};

// Segments between points of runs.
//
// The segment from p to q is moved to its left or right, parallel, by an infinitesimal amount, and then begins and ends
// on the lines that carry the runs of p and q. Such a shift is free iff it crosses no piece: one on those two lines is
// no obstacle, nor one along the segment. The points see each other iff each lies strictly before the front of the
// other's run and at least one of the two shifts is free.
//
//   (1) exact, and symmetric in p and q
//   (2) a segment that grazes vertices on one side only is free; one that is touched from both sides is not, be it in
//       one point or in two
//   (3) at an end of a run the pieces of others that stand there block the shift on their side
class SegmentVisibility2 {
 public:
  // REQUIRES: the arrangement outlives this.
  explicit SegmentVisibility2(const Arrangement2& arrangement)
      : vertices_(arrangement.vertices()), triangulation_(arrangement.triangulation()) {}

  // True iff the two points see each other. REQUIRES: points of this arrangement.
  // COST: a few ns for each triangle on the way; the way is walked twice when a vertex lies on it.
  bool see_each_other(const RunPoint2& p, const RunPoint2& q) const;

  // Fills the view from p; from a vertex also with what lies behind the run. If p and q see each other, a side of q's
  // run is in the view from p. COST: about 20 ns for each triangle seen.
  void look_around(const RunPoint2& p, View2& view) const;

 private:
  enum class Shift : signed char { kRight = -1, kLeft = 1 };
  struct Sides;
  bool is_free(const RunPoint2& p, const RunPoint2& q, Sides& sides) const;
  bool passes_all_at(const RunPoint2& end, const Sides& sides) const;

  const Vertices2& vertices_;
  const Triangulation2& triangulation_;
};

}  // namespace hottel
