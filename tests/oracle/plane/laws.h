// What holds of the direct exchange areas of every scene, and short ways to ask for them in tests.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "tests/oracle/plane/brute_force.h"
#include "tests/oracle/plane/split.h"

namespace hottel::oracle {

using ExactMeasures = std::map<ElementPair, ExactSum>;

// Returns M(f,g), in either order: zero when the pair is missing.
ExactSum measure(const ExactMeasures& measures, int f, int g);
ExactMeasures measures_of(const std::vector<InputSegment>& edges);  // after splitting

// The square [0, size]^2, fronts inside. Label of front k: kRoomLeft, ...
std::vector<InputSegment> room(const mpq_class& size);
inline constexpr int kRoomLeft = 0, kRoomTop = 2, kRoomRight = 4, kRoomBottom = 6;

// The laws. Each returns what is wrong, or nothing.
//
//   integer closure: over the terms of one gap the signs in each label's row cancel, but +2 stays for a label along it
//   closure:         sum over g of M(f,g) is twice the length of f, as exact sums
//   positivity:      M > 0 for all pairs that are there
//   sweep:           M agrees with the line sweep, to `tolerance` in units of the scene
std::string broken_integer_closure(const std::vector<Segment>& pieces);
std::string broken_closure(const std::vector<Segment>& pieces);
std::string broken_positivity(const std::vector<Segment>& pieces);
std::string broken_sweep(const std::vector<Segment>& pieces, double tolerance = 1e-11);

}  // namespace hottel::oracle
