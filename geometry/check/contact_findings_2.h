// What is worth telling about the contacts of surfaces.
#pragma once

#include "geometry/check/contacts_2.h"
#include "geometry/check/finding.h"

namespace hottel {

// Kinds: conflicting-claims (error), duplicate, overlap, nothing-left, t-junction, crossing.
Findings contact_findings(const Scene2& scene, const Contacts2& contacts);

}  // namespace hottel
