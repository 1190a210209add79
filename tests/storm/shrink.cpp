#include "tests/storm/shrink.h"

#include <array>
#include <optional>
#include <utility>

namespace hottel::storm {

namespace {

using Point = std::pair<mpq_class, mpq_class>;

Edges with_fewer(Edges edges, const std::function<bool(const Edges&)>& fails) {
  for (std::size_t k = 0; k < edges.size() && edges.size() > 1;) {
    Edges fewer = edges;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(k));
    if (fails(fewer)) {
      edges = std::move(fewer);
      k = 0;
    } else {
      ++k;
    }
  }
  return edges;
}

// The points to try for one, each with a smaller sum of coordinates.
std::vector<Point> nearer(const Point& p) {
  std::vector<Point> result;
  for (const Point& q :
       {Point(0, 0), Point(0, p.second), Point(p.first, 0), Point(p.first - 1, p.second), Point(p.first, p.second - 1)})
    if (q.first >= 0 && q.second >= 0 && q.first + q.second < p.first + p.second) result.push_back(q);
  return result;
}

// The edges with end number `end` (even: from, odd: to) in q, or with all ends that are where it is.
Edges with_end_at(Edges edges, std::size_t end, const Point& q, bool all) {
  const auto coordinates = [&](std::size_t k) {
    oracle::InputSegment& edge = edges[k / 2];
    return k % 2 == 0 ? std::pair(&edge.ax, &edge.ay) : std::pair(&edge.bx, &edge.by);
  };
  const auto at = coordinates(end);
  const Point p{*at.first, *at.second};
  for (std::size_t k = 0; k < 2 * edges.size(); ++k) {
    const auto [x, y] = coordinates(k);
    if (k != end && !(all && *x == p.first && *y == p.second)) continue;
    *x = q.first;
    *y = q.second;
  }
  return edges;
}

bool is_valid(const Edges& edges) {
  for (const oracle::InputSegment& edge : edges)
    if (edge.ax == edge.bx && edge.ay == edge.by) return false;
  return oracle::split(edges).conflicts.empty();
}

// All of it moved by one, or one end, or nothing when neither can be.
std::optional<Edges> with_smaller_numbers(const Edges& edges, const std::function<bool(const Edges&)>& fails) {
  for (const Point& step : {Point(1, 0), Point(0, 1)}) {
    bool is_on_lattice = true;
    Edges nearer_all = moved(edges, [&](mpq_class& x, mpq_class& y) {
      x -= step.first;
      y -= step.second;
      is_on_lattice = is_on_lattice && x >= 0 && y >= 0;
    });
    if (is_on_lattice && fails(nearer_all)) return nearer_all;
  }
  for (std::size_t end = 0; end < 2 * edges.size(); ++end) {
    const oracle::InputSegment& edge = edges[end / 2];
    const Point p = end % 2 == 0 ? Point(edge.ax, edge.ay) : Point(edge.bx, edge.by);
    for (const Point& q : nearer(p))
      for (const bool all : {true, false}) {
        Edges smaller = with_end_at(edges, end, q, all);
        if (is_valid(smaller) && fails(smaller)) return smaller;
      }
  }
  return std::nullopt;
}

}  // namespace

Edges shrunk(Edges edges, const std::function<bool(const Edges&)>& fails) {
  for (;;) {
    edges = with_fewer(std::move(edges), fails);
    std::optional<Edges> smaller = with_smaller_numbers(edges, fails);
    if (!smaller) return edges;
    edges = std::move(*smaller);
  }
}

}  // namespace hottel::storm
