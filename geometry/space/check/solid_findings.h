// What is worth telling about what solids of space hold.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/space/arrangement/solids.h"
#include "geometry/space/check/finding.h"

namespace hottel {

// Kind: filled-room, a warning: a solid has whole other groups in its interior, where nothing is seen: was a room
// meant? One finding a solid.
struct SolidFindings3 {
  Findings3 findings;
  std::vector<char> is_held;  // by group: all of its corners lie in the interior of a solid
};

// COST: that of Solids3::around for the corners of a scene that has solids.
SolidFindings3 solid_findings(const Scene3& scene, const Solids3& solids);

}  // namespace hottel
