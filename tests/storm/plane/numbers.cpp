#include "tests/storm/plane/numbers.h"

#include <fmt/core.h>

#include "geometry/plane/exchange/exchange.h"
#include "tests/comparison/plane/engine_comparison.h"

namespace hottel::storm {

Numbers numbers_of(const ExchangeMatrix& matrix, const Relabelling& label) {
  Numbers result;
  for (std::uint32_t i = 0; i < matrix.size(); ++i)
    for (const FactorEntry& entry : matrix.row(i))
      result[{label(i), entry.to == matrix.sky() ? entry.to : label(entry.to)}] = {entry.factor.value,
                                                                                   entry.factor.side, entry.visibility};
  return result;
}

Numbers numbers_of(const Edges& edges, const Relabelling& label) {
  return numbers_of(exact_exchange(prepare(oracle::to_scene(edges))), label);
}

std::string difference(const Numbers& before, const Numbers& after) {
  std::string wrong;
  const auto look = [&](const Numbers& these, const Numbers& those, const char* which) {
    for (const auto& [pair, number] : these) {
      const auto place = those.find(pair);
      if (place == those.end() || place->second != number)
        wrong += fmt::format("F({}, {}) = {:.17g} {}\n", pair.first, pair.second, std::get<0>(number), which);
    }
  };
  look(before, after, "before");
  look(after, before, "after");
  return wrong;
}

Reordered reordered(const Edges& edges, const oracle::Groups& order) {
  Reordered result;
  for (const std::vector<std::size_t>& group : order)
    for (const std::size_t k : group) {
      result.edges.push_back(edges[k]);
      result.original.push_back(static_cast<std::uint32_t>(k));
    }
  return result;
}

Edges moved(Edges edges, const std::function<void(mpq_class& x, mpq_class& y)>& move) {
  for (oracle::InputSegment& edge : edges) {
    move(edge.ax, edge.ay);
    move(edge.bx, edge.by);
  }
  return edges;
}

}  // namespace hottel::storm
