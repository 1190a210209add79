// Which faces could exchange light if nothing else were there.
#pragma once

#include "geometry/space/arrangement/occluders.h"
#include "geometry/space/prepared/element_table.h"

namespace hottel {

// Returns whether each of two patches has a part before the front of the other: exactly then S0 > 0. Decided by signs.
//
//   (1) never where both are of one surface
//   (2) REQUIRES: neither is of the sky
// COST: some 50 ns where the surfaces tell it, a few microseconds else.
bool face_each_other(const Occluders3& occluders, const ElementTable3::Part& i, const ElementTable3::Part& j);

// The same of the whole faces that the patches are parts of: where these do not face each other, no parts of them do.
bool surfaces_face_each_other(const Occluders3& occluders, const ElementTable3::Part& i, const ElementTable3::Part& j);

}  // namespace hottel
