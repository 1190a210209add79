#include "geometry/plane/exchange/convex_sums.h"

#include <utility>

#include "kernel/support/failure.h"

namespace hottel {
namespace {

// The pieces of a convex room in the order of its outline, which starts at a corner. Side k begins at vertex k and lies
// on wall wall(k).
class Outline {
 public:
  struct Length {
    Int128 value;
    std::uint32_t inexact;
  };

  Outline(const Arrangement2& arrangement, const ElementTable2& table)
      : vertices_(arrangement.vertices()), sides_of_(table.count()) {
    const std::vector<Segment2>& pieces = arrangement.pieces();
    std::vector<VertexId> next_of(vertices_.size(), VertexId::none());
    const auto next = [&next_of](VertexId v) -> VertexId& { return next_of[v.index()]; };
    std::vector<std::uint32_t> label_from(vertices_.size());
    for (const PieceSideId side : arrangement.sides()) {
      const std::uint32_t label = table.of(side);
      if (label >= table.count() || !table.elements()[label].material) continue;
      const auto [a, b] = arrangement.turned_piece(side);
      HOTTEL_REQUIRE(next(a).is_none());
      next(a) = b;
      label_from[a.index()] = label;
    }
    const auto ends_at_corner = [&](VertexId a) { return vertices_.orientation(a, next(a), next(next(a))) != 0; };
    VertexId a = pieces.front().a;
    while (!ends_at_corner(a)) a = next(a);
    Length at{0, 0};
    std::uint32_t wall = 0;
    for (std::uint32_t k = 0; k < pieces.size(); ++k) {
      a = next(a);
      const FixedLength2 length = vertices_.distance(a, next(a));
      vertex_.push_back(a);
      wall_.push_back(wall);
      sides_of_[label_from[a.index()]].push_back(k);
      at_.push_back(at);
      at = {at.value + length.value, at.inexact + !length.is_exact};
      wall += ends_at_corner(a);
    }
    at_.push_back(at);
  }

  const std::vector<std::uint32_t>& sides_of(std::uint32_t label) const { return sides_of_[label]; }
  std::uint32_t wall(std::uint32_t side) const { return wall_[side]; }
  std::uint32_t end(std::uint32_t side) const { return side + 1 == wall_.size() ? 0 : side + 1; }

  // From vertex k to vertex l of the outline.
  Length between(std::uint32_t k, std::uint32_t l) const {
    if (k > l) std::swap(k, l);
    if (k == l) return {0, 0};
    if (wall_[k] == wall_[l - 1]) return along(k, l);
    if (k == 0 && wall_[l] == wall_.back()) return along(l, static_cast<std::uint32_t>(wall_.size()));
    const FixedLength2 length = vertices_.distance(vertex_[k], vertex_[l]);
    return {length.value, !length.is_exact};
  }

 private:
  Length along(std::uint32_t k, std::uint32_t l) const {
    return {at_[l].value - at_[k].value, at_[l].inexact - at_[k].inexact};
  }

  const Vertices2& vertices_;
  std::vector<VertexId> vertex_;
  std::vector<std::uint32_t> wall_;
  std::vector<Length> at_;  // from the first corner along the outline
  std::vector<std::vector<std::uint32_t>> sides_of_;
};

}  // namespace

PairSums2 sum_convex_pairs(const Arrangement2& arrangement, const ElementTable2& table) {
  const Outline outline(arrangement, table);
  std::vector<std::vector<PairSum2>> parts(1);
  for (std::uint32_t i = 0; i < table.count(); ++i)
    for (std::uint32_t j = i; j < table.count(); ++j) {
      if (!table.has_row(i) && !table.has_row(j)) continue;
      PairSum2 pair{.key = pair_key(i, j)};
      const auto add = [&](std::uint32_t u, std::uint32_t v, int sign) {
        const Outline::Length length = outline.between(u, v);
        pair.value += sign > 0 ? length.value : -length.value;
        pair.inexact += length.inexact;
      };
      for (const std::uint32_t f : outline.sides_of(i))
        for (const std::uint32_t g : outline.sides_of(j)) {
          if (outline.wall(f) == outline.wall(g)) continue;
          add(f, g, 1);
          add(outline.end(f), outline.end(g), 1);
          add(f, outline.end(g), -1);
          add(outline.end(f), g, -1);
        }
      if (pair.value != 0 || pair.inexact != 0) parts.front().push_back(pair);
    }
  return {std::move(parts), table.count()};
}

}  // namespace hottel
