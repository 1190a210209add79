// What is worth telling about the contacts of surfaces in space, and about their shape.
#pragma once

#include "geometry/space/check/finding.h"
#include "geometry/space/contacts/near_contacts.h"

namespace hottel {

// A polygon is called a needle when its width (squared_width) is below this part of its longest diagonal or side.
inline constexpr int kNeedlePart3 = 1024;

// Kinds: near-contact, overshoot (warnings), needle, t-junction, crossing (notes). A needle is two surfaces that meet
// along an edge in so small an angle that they are near each other beside it.
Findings3 contact_findings(const Scene3& scene, const Contacts3& contacts);

// Kinds: duplicate (a warning; a note where two have their fronts on different sides: a thin wall), needle, not-plane
// (notes).
//
//   (1) duplicates are polygons with the same corners around; each set of them is told once
//   (2) a polygon that is nearly plane is told as not plane: how far its points lie off the plane of three of them
// COST: O(n log n), quadratic in the corners of a polygon.
Findings3 shape_findings(const Scene3& scene);

}  // namespace hottel
