#include "geometry/plane/exchange/exact_sums.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <numeric>
#include <unordered_map>

#include "geometry/plane/exchange/gap_terms.h"
#include "geometry/plane/exchange/swept_vertices.h"
#include "geometry/plane/exchange/term_sums.h"
#include "kernel/support/parallel.h"

namespace hottel {
namespace {

struct FoundTerm {
  std::size_t pair;
  VertexId v, w;
  int sign;
};

// A box along the line from one label to the other that holds both: every corner of their region of line space is a
// pair of vertices inside it. Widened by far more than the rounding of its making.
class Corridor {
 public:
  Corridor(const Vertices2& vertices, const ElementTable2& table, const ElementPair& pair) {
    double x[2] = {0, 0}, y[2] = {0, 0};
    const std::uint32_t label[2] = {pair.first, pair.second};
    for (int k = 0; k < 2; ++k) {
      for (const Segment2& run : table.runs(label[k])) {
        x[k] += vertices.approximate(run.a).x + vertices.approximate(run.b).x;
        y[k] += vertices.approximate(run.a).y + vertices.approximate(run.b).y;
      }
      const auto ends = 2.0 * static_cast<double>(table.runs(label[k]).size());
      x[k] /= ends;
      y[k] /= ends;
    }
    ux_ = x[1] - x[0];
    uy_ = y[1] - y[0];
    const double norm = std::hypot(ux_, uy_);
    if (norm > 0) {
      ux_ /= norm;
      uy_ /= norm;
    } else {
      ux_ = 1;
      uy_ = 0;
    }
    for (const std::uint32_t l : label)
      for (const Segment2& run : table.runs(l)) {
        include(vertices.approximate(run.a));
        include(vertices.approximate(run.b));
      }
    const double slack = 1e-9 * (t1_ - t0_ + s1_ - s0_ + std::fabs(t0_) + std::fabs(s0_) + 1);
    t0_ -= slack;
    t1_ += slack;
    s0_ -= slack;
    s1_ += slack;
  }

  bool contains(const Vertices2::Approximate& p) const {
    const double t = p.x * ux_ + p.y * uy_, s = p.y * ux_ - p.x * uy_;
    return t >= t0_ && t <= t1_ && s >= s0_ && s <= s1_;
  }

 private:
  void include(const Vertices2::Approximate& p) {
    const double t = p.x * ux_ + p.y * uy_, s = p.y * ux_ - p.x * uy_;
    t0_ = std::min(t0_, t);
    t1_ = std::max(t1_, t);
    s0_ = std::min(s0_, s);
    s1_ = std::max(s1_, s);
  }

  double ux_, uy_;
  double t0_ = std::numeric_limits<double>::infinity(), t1_ = -t0_, s0_ = t0_, s1_ = -t0_;
};

std::vector<VertexId> vertices_between(const Arrangement2& arrangement, const ElementTable2& table,
                                       const std::vector<ElementPair>& pairs) {
  const Vertices2& vertices = arrangement.vertices();
  const std::size_t n = vertices.size();
  std::vector<VertexId> result;
  const bool everywhere =
      static_cast<double>(n) * static_cast<double>(pairs.size()) > 2e8 ||
      std::any_of(pairs.begin(), pairs.end(), [&](const ElementPair& pair) {
        return pair.second == table.sky() || table.runs(pair.first).empty() || table.runs(pair.second).empty();
      });
  if (everywhere) return swept_vertices(arrangement, table);
  std::vector<Corridor> corridors;
  for (const ElementPair& pair : pairs) corridors.emplace_back(vertices, table, pair);
  std::vector<char> is_between(n, 0);
  parallel_for(n, [&](std::size_t k) {
    const auto v = VertexId(k);
    for (const Corridor& corridor : corridors)
      if (corridor.contains(vertices.approximate(v))) {
        is_between[k] = 1;
        break;
      }
  });
  for (const VertexId v : vertices.ids())
    if (is_between[v.index()]) result.push_back(v);
  return result;
}

}  // namespace

std::vector<RootSum> exact_sums(const Arrangement2& arrangement, const ElementTable2& table,
                                const std::vector<ElementPair>& pairs) {
  const Vertices2& vertices = arrangement.vertices();
  std::unordered_map<std::uint64_t, std::size_t> number;
  for (std::size_t k = 0; k < pairs.size(); ++k) number.emplace(pair_key(pairs[k].first, pairs[k].second), k);

  const std::vector<VertexId> between = vertices_between(arrangement, table, pairs);
  std::vector<FoundTerm> terms;
  std::mutex together;
  parallel_ranges(between.size(), 1, [&](std::size_t begin, std::size_t end) {
    View2 view;
    std::vector<FoundTerm> found;
    for (std::size_t k = begin; k < end; ++k) {
      look_around(vertices, arrangement.triangulation(), between[k], view);
      for_each_gap(vertices, between[k], view, true, [&](const Gap2& gap) {
        for_each_term(gap, table, [&](std::uint32_t i, std::uint32_t j, int sign) {
          if (const auto place = number.find(pair_key(i, j)); place != number.end())
            found.push_back({place->second, gap.v, gap.w, i == j ? 2 * sign : sign});
        });
      });
    }
    const std::lock_guard lock(together);
    terms.insert(terms.end(), found.begin(), found.end());
  });
  std::sort(terms.begin(), terms.end(), [](const FoundTerm& a, const FoundTerm& b) {
    return a.pair != b.pair ? a.pair < b.pair : a.v != b.v ? a.v < b.v : a.w < b.w;
  });
  std::vector<std::size_t> begin(pairs.size() + 1, terms.size());
  for (std::size_t t = terms.size(); t-- > 0;) begin[terms[t].pair] = t;
  for (std::size_t k = pairs.size(); k-- > 0;) begin[k] = std::min(begin[k], begin[k + 1]);

  std::vector<RootSum> sums(pairs.size());
  parallel_for(pairs.size(), [&](std::size_t k) {
    for (std::size_t t = begin[k]; t < begin[k + 1]; ++t)
      sums[k].add(terms[t].sign, vertices.squared_distance(terms[t].v, terms[t].w));
  });
  for (std::size_t k = 0; k < pairs.size(); ++k)  // pairs that were asked for more than once
    if (const std::size_t first = number.at(pair_key(pairs[k].first, pairs[k].second)); first != k)
      sums[k] = sums[first];
  return sums;
}

}  // namespace hottel
