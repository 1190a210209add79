// What is worth telling about the contacts of surfaces.
#pragma once

#include "geometry/plane/check/contacts.h"
#include "geometry/plane/check/finding.h"

namespace hottel {

// Kinds: conflicting-claims (error), duplicate, overlap, nothing-left, t-junction, crossing.
//
//   (1) conflicting-claims is told iff Arrangement2 refuses the scene for one
//   (2) each face with a material that owns nothing is told of once: as nothing-left, in an overlap where its front
//       makes no claim on a solid, or by solid_findings
//   (3) nothing is told of contacts in a solid, nor of what a solid holds (FaceCover2 (3)) with its border
Findings2 contact_findings(const Scene2& scene, const Contacts2& contacts);

}  // namespace hottel
