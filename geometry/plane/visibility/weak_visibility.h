// What some point of a face sees: weak visibility.
#pragma once

#include <functional>
#include <vector>

#include "geometry/face.h"
#include "geometry/plane/prepared/prepared_scene.h"

namespace hottel {

// A stretch of a surface, from begin to end: 0 at its first point, 1 at its second.
struct Stretch2 {
  Rational begin, end;
  friend bool operator==(const Stretch2&, const Stretch2&) = default;
};

// How much of one face is seen.
struct SeenFace2 {
  Face face;
  std::vector<Stretch2> stretches;  // ascending, with gaps between them
  Rational share;                   // their total, as a fraction of the surface
};

// What at least one point of a face sees.
//
//   (1) exact: but for finitely many points, a point of a face lies in one of its stretches iff it sees more than a
//       single point of the face asked about
//   (2) ends of stretches lie on critical lines, at ends of faces, or where something touches: they are rational
//   (3) faces in the order of the scene, only those of which something is seen; sees_sky iff the sky is seen from some
//       stretch of the face
struct WeakVisibility2 {
  std::vector<SeenFace2> faces;
  bool sees_sky = false;
};

// Returns what some point of a face sees. Throws what progress throws, of the fraction done; Interrupted soon after a
// stop was asked for.
// REQUIRES a face that is not covered wholly.
// COST: one sweep about every vertex, and the view from a point between each two critical points, on all threads.
WeakVisibility2 weak_visibility(const PreparedScene2& prepared, const Face& from,
                                const std::function<void(double)>& progress = {});

}  // namespace hottel
