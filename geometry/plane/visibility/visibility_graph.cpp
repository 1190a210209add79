#include "geometry/plane/visibility/visibility_graph.h"

#include <algorithm>
#include <limits>

#include "geometry/plane/visibility/view.h"
#include "kernel/rounding.h"
#include "kernel/support/interrupt.h"
#include "kernel/support/parallel.h"

namespace hottel {
namespace {

constexpr std::size_t kBatch = 4096;  // vertices whose pairs are held at a time

// Distances between vertices in scene coordinates.
class Distances {
 public:
  explicit Distances(const Vertices2& vertices)
      : vertices_(vertices), unit_(vertices.fixed_unit() * vertices.scale()) {}

  double between(VertexId v, VertexId w) const {
    const FixedLength2 length = vertices_.distance(v, w);
    if (const auto rounded =
            round_scaled(FixedSum{length.value, length.is_exact ? 0 : vertices_.length_error()}, unit_))
      return rounded->number.value;
    RootSum exact, one;
    exact.add(vertices_.scale(), vertices_.squared_distance(v, w));
    one.add(1, 1);
    return round_quotient(exact, one).number.value;
  }

 private:
  const Vertices2& vertices_;
  FixedScale unit_;
};

class PairFinder {
 public:
  explicit PairFinder(const PreparedScene2& prepared)
      : arrangement_(prepared.arrangement),
        vertices_(arrangement_.vertices()),
        distances_(vertices_),
        ordered_(graph_vertices(prepared)),
        number_(ordered_.size()) {
    for (std::uint32_t k = 0; k < ordered_.size(); ++k) number_[ordered_[k].id.index()] = k;
  }

  std::size_t size() const { return ordered_.size(); }

  // The pairs of vertex number v with those above it, ascending.
  void find(std::size_t v, View2& view, std::vector<VisiblePair2>& pairs) const {
    const VertexId id = ordered_[v].id;
    look_around(vertices_, arrangement_.triangulation(), id, view);
    for (const View2::Seen& seen : view.seen) {
      const std::uint32_t w = number_[seen.vertex.index()];
      if (v < w && is_outside_solids(seen))
        pairs.push_back({static_cast<std::uint32_t>(v), w, seen.left, distances_.between(id, seen.vertex)});
    }
    std::sort(pairs.begin(), pairs.end(), [](const VisiblePair2& p, const VisiblePair2& q) { return p.w < q.w; });
  }

 private:
  // What is seen beside a free segment tells the region that it runs in.
  bool is_outside_solids(const View2::Seen& seen) const {
    if (seen.left != kNoPiece) return !is_covered(seen.left) || !is_covered(seen.right);
    return !is_covered(seen.behind);
  }
  bool is_covered(PieceSideId side) const { return side != kSky && arrangement_.is_covered(side); }

  const Arrangement2& arrangement_;
  const Vertices2& vertices_;
  Distances distances_;
  std::vector<GraphVertex2> ordered_;  // by number
  std::vector<std::uint32_t> number_;  // by id
};

}  // namespace

std::vector<GraphVertex2> graph_vertices(const PreparedScene2& prepared) {
  const Arrangement2& arrangement = prepared.arrangement;
  std::vector<bool> is_end(arrangement.vertices().size(), false);
  std::vector<GraphVertex2> result;
  for (std::uint32_t surface = 0; surface < prepared.scene.surfaces.size(); ++surface)
    for (const VertexId v : {arrangement.segment(surface).a, arrangement.segment(surface).b})
      if (!is_end[v.index()]) {
        is_end[v.index()] = true;
        result.push_back({v, surface, false});
      }
  // Crossings: the first surface through each.
  constexpr std::uint32_t kUnknown = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> first(result.size() < is_end.size() ? is_end.size() : 0, kUnknown);
  if (first.empty()) return result;
  for (std::size_t piece = 0; piece < arrangement.pieces().size(); ++piece)
    for (const VertexId v : {arrangement.pieces()[piece].a, arrangement.pieces()[piece].b})
      if (!is_end[v.index()]) first[v.index()] = std::min(first[v.index()], arrangement.sources(piece).front().surface);
  for (const VertexId v : arrangement.vertices().ids())
    if (!is_end[v.index()]) result.push_back({v, first[v.index()], true});
  return result;
}

void visibility_graph(const PreparedScene2& prepared, const std::function<void(std::span<const VisiblePair2>)>& sink,
                      const std::function<void(double)>& progress) {
  const PairFinder finder(prepared);
  const std::size_t n = finder.size();
  std::vector<std::vector<VisiblePair2>> by_vertex(std::min(n, kBatch));
  std::vector<VisiblePair2> all;
  for (std::size_t first = 0; first < n; first += kBatch) {
    const std::size_t count = std::min(kBatch, n - first);
    parallel_ranges(count, 16, [&](std::size_t begin, std::size_t end) {
      View2 view;
      for (std::size_t k = begin; k < end; ++k) {
        throw_if_interrupted();
        by_vertex[k].clear();
        finder.find(first + k, view, by_vertex[k]);
      }
    });
    all.clear();
    for (std::size_t k = 0; k < count; ++k) all.insert(all.end(), by_vertex[k].begin(), by_vertex[k].end());
    sink(all);
    if (progress) progress(static_cast<double>(first + count) / static_cast<double>(n));
  }
}

}  // namespace hottel
