// The least of a scene that still fails.
#pragma once

#include <functional>

#include "tests/storm/plane/numbers.h"

namespace hottel::storm {

// Leaves out groups, corners of polylines, what is said to be behind them, and the ties between the edges of a
// polyline; then moves all of the scene, one end, or all ends that are in one point, to points of the lattice nearer to
// the origin, and begins anew, as long as what is left still fails. Polylines that remain follow each other as before,
// closed ones stay closed, and what was not refused is not then.
// REQUIRES fails(edges), coordinates >= 0.
Edges shrunk(Edges edges, const std::function<bool(const Edges&)>& fails);

}  // namespace hottel::storm
