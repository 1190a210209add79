// What is worth telling about rooms: the bounded cells of free space.
#pragma once

#include "geometry/check/cells_2.h"
#include "geometry/check/finding.h"
#include "geometry/exchange/exchange_2.h"

namespace hottel {

// Kinds: inside-out, black-inside, isolated-cell.
//
//   inside-out      every wall of a room turns its black back to surfaces that stand in the room; or a closed polyline
//                   that stands in a room turns its black backs to the room and its fronts to an inside without light
//   black-inside    some wall of a room with surfaces of its own does
//   isolated-cell   a room that exchanges light with no other, when there are several
Findings cell_findings(const PreparedScene2& prepared, const Cells2& cells);

}  // namespace hottel
