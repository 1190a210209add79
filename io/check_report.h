// What was found in a scene, as JSON and as text for people.
#pragma once

#include <cstddef>
#include <string>

#include "geometry/check/finding.h"

namespace hottel {

// Returns {"findings":[{"severity","kind","surfaces":[names],"at":[x,y],"line","message","suggestion"}]} and a final
// newline. Coordinates are the nearest doubles; "at" and "line" are null where there is no place.
std::string check_json(const Scene2& scene, const Findings& findings);

// Returns one paragraph a finding and a closing count. Of one kind at most `most` are shown, the rest is counted.
inline constexpr std::size_t kMostOfAKind = 20;
std::string check_text(const Scene2& scene, const Findings& findings, std::size_t most = kMostOfAKind);

}  // namespace hottel
