// hottel visibility in space: what a point sees, and a point of a face, and two faces of each other.
#pragma once

#include <string>

#include "cli/shown_answer.h"

namespace hottel {

class Simulation3;
struct Scene3;

// Answers --at X,Y,Z, or --on NAME --at X,Y,Z, where the point lies on the face, or --on NAME --at S,T in the frame of
// its first point and its two sides there; `on` is empty where it was not given. Throws UsageError for what makes no
// sense, also a point that is not on the face. REQUIRES that the scene outlives the answer.
// With `proves`, each number has proven bounds.
ShownAnswer visibility_in_space(const Scene3& scene, const std::string& at, const std::string& on, bool proves);

// Answers --from A --to B, of which one may be the sky. Throws UnknownName for faces that there are not, RequestError
// where the pair cannot be measured, or, with `proves`, its bounds are not within the tolerance. It has no drawing.
VisibilityAnswer pair_in_space(const Simulation3& simulation, const std::string& from, const std::string& to,
                               bool proves);

}  // namespace hottel
