// Points along a face at which what is seen of another face changes.
#pragma once

#include <optional>
#include <vector>

#include "geometry/face.h"
#include "geometry/plane/point.h"

namespace hottel {

class Arrangement2;
struct PreparedScene2;
struct Scene2;

// A point of a face on a line that touches two vertices, beyond which the other face appears,
// disappears or changes its neighbour.
struct CriticalPoint2 {
  Rational t;            // position on the surface, 0 at its first point, 1 at its second
  Point2 point;          // scene coordinates
  Point2 near, far;      // the two vertices, the nearer one first; near == point in a contact
  bool is_jump = false;  // D0: something touches the face here; otherwise D1, a kink
};

// Returns the critical points of face a with respect to b, another face or the sky (no face), by ascending t.
//
//   (1) exact: 0 <= t <= 1, and `point` is at t of the way along the surface of a
//   (2) is_jump iff near == point
//   (3) several lines may pass through one point; each is listed once with its (near, far)
//   (4) lines along the surface of a give none, nor do its own end points as the nearer vertex
//
// COST: one sweep about every vertex.
std::vector<CriticalPoint2> critical_points(const Arrangement2& arrangement, const Scene2& scene, const Face& a,
                                            const std::optional<Face>& b);
// The same of a prepared scene. Throws ContractViolation where a face is none of it.
std::vector<CriticalPoint2> critical_points(const PreparedScene2& prepared, const Face& a,
                                            const std::optional<Face>& b);

}  // namespace hottel
