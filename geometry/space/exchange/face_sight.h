// Which faces at least one point of a face sees.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "geometry/face.h"

namespace hottel {

struct PreparedScene3;

// The tolerance, of the smaller area, for whoever asks only what is seen: that does not depend on it.
inline constexpr double kCoarseTolerance = 0.1;

// Throws RequestError where nothing of a face is free: it lies in solids, or others have all of its place.
void require_free(const PreparedScene3& prepared, const Face& face);

// How a face, or the sky, is seen from another face.
struct SeenFace3 {
  std::optional<Face> face;  // nothing: the sky
  bool is_seen = false;      // at least one point of one sees more than a point of the other
  bool is_whole = false;     // nothing hides any part of one from any part of the other
  friend bool operator==(const SeenFace3&, const SeenFace3&) = default;
};

// Returns how two faces see each other, or a face and the sky (nothing).
//
//   (1) exact, by signs: is_seen iff S is not 0; is_whole iff S = S0
//   (2) nothing of what solids or other faces cover sees or is seen
//
// Throws RequestError, naming both, where it cannot be decided. COST: that of measuring the pair coarsely.
SeenFace3 sight_between(const PreparedScene3& prepared, const Face& from, const std::optional<Face>& to);

// Returns those that are seen from a face, black backs too, in the order of faces, the sky last.
// progress: fraction done, from any thread; may throw to stop. Throws as sight_between. COST: parallel.
std::vector<SeenFace3> faces_seen_by(const PreparedScene3& prepared, const Face& face,
                                     const std::function<void(double)>& progress = {});

}  // namespace hottel
