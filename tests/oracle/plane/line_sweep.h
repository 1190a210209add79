// The direct exchange areas of a plane scene by integration over all lines: a second oracle, which knows nothing of
// vertices that see each other or of strings.
#pragma once

#include <map>
#include <vector>

#include "tests/oracle/plane/brute_force.h"

namespace hottel::oracle {

// Returns M(f,g) as exchange_measures does, with absolute error about 1e-12 times the size of the scene. Pairs that no
// sampled line joins are missing.
//
// In one direction the lines are a row of strips between the projections of consecutive vertices; in a strip the order
// of hits is constant, and each pair of neighbours in it gets the width. Between directions in which two vertices
// coincide the strips stay the same and their widths are sines, which Gauss points integrate to rounding.
// COST: O(V^2) intervals of direction times O(V n log n).
std::map<ElementPair, double> line_sweep(const std::vector<Segment>& segments);

}  // namespace hottel::oracle
