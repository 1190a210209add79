// What points and faces see, as JSON and as text for people.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/plane/exchange/closed_forms.h"
#include "geometry/plane/visibility/critical_points.h"
#include "geometry/plane/visibility/point_view.h"
#include "io/results/visibility_answer.h"
#include "solver/plane/simulation/queries.h"

namespace hottel {

// What a point sees: the visibility polygon, the angles, and the mean irradiance. In a solid: which, and nothing else;
// on the border of solids the directions into them are told apart, as fractions of the full turn.
// light: nothing from within a solid.
VisibilityAnswer point_answer(const PreparedScene2& prepared, const PointView2& sight,
                              const std::optional<PointLight2>& light);

// The view factors from the point t of a face, each as a double and in closed form. name: what the face was called.
// t: 0 at the first end of the edge, 1 at the second.
VisibilityAnswer face_point_answer(const PreparedScene2& prepared, const std::string& name, const Face& face,
                                   const Rational& t, const std::vector<FaceFactor2>& factors);

// What two faces, of which one may be the sky (no face), see of each other.
struct PairSight2 {
  std::string from, to;  // what they were called
  std::optional<Face> face_from, face_to;
  ExactPair2 pair;
  std::vector<CriticalPoint2> critical;  // of `from` with respect to `to`; none of the sky
  std::string unit{};                    // of lengths, as closed forms have them (SceneTable::unit)
};
// What they exchange, what they would exchange with everything else taken away, the part of it that is visible, both
// areas and both factors, and the critical points. Decimals of lengths are in metres where the unit is known
// (metres_of), closed forms in the unit. The sky has neither area nor factor: null.
VisibilityAnswer pair_answer(const PairSight2& sight);

}  // namespace hottel
