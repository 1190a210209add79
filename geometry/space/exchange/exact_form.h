// Direct exchange areas of faces in space in closed form, where one is known.
#pragma once

#include <optional>
#include <string>

#include "geometry/face.h"
#include "geometry/space/unobstructed/rectangle_form.h"

namespace hottel {

struct PreparedScene3;

// S of two faces as a finite sum, in squares of the unit of the scene; or why there is none, as the end of a sentence
// ("something hides a part of one from the other").
struct ExactForm3 {
  std::optional<ArcSum3> exchange;
  std::string why_not{};
};

// Returns S of a pair in closed form.
//
//   (1) there is one where S is 0, and where nothing hides any part and both faces are whole rectangles with sides of
//       rational length, parallel or at right angles with sides along each other (rectangle_exchange)
//   (2) no other pair has one here: of two polygons in any other position it takes dilogarithms (Schröder, Hanrahan
//       1993), and of what is partly hidden none is known
//
// COST: that of measuring the pair coarsely.
ExactForm3 exact_form_3(const PreparedScene3& prepared, const Face& from, const Face& to);

// Returns the area of a face whose polygon is a rectangle with sides of rational length, whole; nothing of others.
std::optional<Rational> rational_area(const PreparedScene3& prepared, const Face& face);

}  // namespace hottel
