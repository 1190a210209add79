// What is printed of a scene, and where two scenes differ in it.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "tests/oracle/plane/split.h"

namespace hottel::storm {

using Edges = std::vector<oracle::InputSegment>;

// Everything printed of a scene, down to the last bit: factor, its side, visibility. Labels of faces: 2 k the front of
// edge k, 2 k + 1 its back; last the sky.
using Numbers = std::map<std::pair<std::uint32_t, std::uint32_t>, std::tuple<double, int, double>>;
using Relabelling = std::function<std::uint32_t(std::uint32_t)>;  // of all but the sky

Numbers numbers_of(
    const ExchangeMatrix& matrix, const Relabelling& label = [](std::uint32_t i) { return i; });
Numbers numbers_of(
    const Edges& edges, const Relabelling& label = [](std::uint32_t i) { return i; });

// The pairs with other numbers, one a line; nothing where all are the same.
std::string difference(const Numbers& before, const Numbers& after);

// The same edges in another order: of each the number that it had. Polylines stay together.
struct Reordered {
  Edges edges;
  std::vector<std::uint32_t> original;

  std::uint32_t label(std::uint32_t i) const { return 2 * original[i / 2] + i % 2; }
};
Reordered reordered(const Edges& edges, const oracle::Groups& order);

// All points moved.
Edges moved(Edges edges, const std::function<void(mpq_class& x, mpq_class& y)>& move);

}  // namespace hottel::storm
