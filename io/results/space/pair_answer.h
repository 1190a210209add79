// What two faces in space see of each other, as JSON and as text for people.
#pragma once

#include <string>

#include "geometry/space/exchange/pair_report.h"
#include "io/results/visibility_answer.h"

namespace hottel {

struct Scene3;

// What a pair exchanges, what it would exchange with everything else taken away, the part of it that is visible, areas
// and factors, each with proven bounds; how the pair was settled; and the stretches along which something is seen, with
// their pieces. The text has no stretches. from, to: what the faces were called.
//
//   (1) the sky has neither area nor factor: null
//   (2) roles of stretches: "source", an edge of `from` or `to`; "foot", where something stands on one of them or
//       pierces it; "outline", an edge of what is between
// form: S in closed form, in squares of the unit of the scene, where one is known; else empty: "exact" is null.
VisibilityAnswer pair_answer(const Scene3& scene, const std::string& from, const std::string& to,
                             const PairReport3& report, const std::string& form);

}  // namespace hottel
