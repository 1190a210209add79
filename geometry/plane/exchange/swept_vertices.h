// The vertices about which a sweep finds the terms of some rows.
#pragma once

#include <vector>

#include "geometry/plane/arrangement/arrangement.h"
#include "geometry/plane/prepared/element_table.h"

namespace hottel {

// Returns vertices about which the sweep for the rows of a table is made, in the order of
// Triangulation2::sweep_order().
//
//   (1) every gap that adds a term (for_each_term) starts and ends at one of them
//   (2) where few elements have a row they are the ends of pieces of these, and the vertices that see a part of one
//   (3) the same arrangement and rows always give the same ones
//
// Why few suffice: what v sees of a piece is bounded by two vertices that it sees. Each of these is an end of the
// piece, or it sees a part of it too, from nearer to the line of the piece. So gaps that have the piece at one end lead
// from v to an end of the piece. COST: where few have a row a view about each of them, parallel, and a mark for each
// vertex.
std::vector<VertexId> swept_vertices(const Arrangement2& arrangement, const ElementTable2& table);

}  // namespace hottel
