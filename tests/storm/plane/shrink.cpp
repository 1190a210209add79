#include "tests/storm/plane/shrink.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace hottel::storm {

namespace {

using Point = std::pair<mpq_class, mpq_class>;

bool is_chain(const Edges& edges, const std::vector<std::size_t>& group) {
  for (std::size_t k = 0; k + 1 < group.size(); ++k)
    if (edges[group[k]].bx != edges[group[k + 1]].ax || edges[group[k]].by != edges[group[k + 1]].ay) return false;
  return true;
}

// Has it no edge of length zero and no torn polyline, and is it not refused?
bool is_valid(const Edges& edges) {
  for (const oracle::InputSegment& edge : edges)
    if (edge.ax == edge.bx && edge.ay == edge.by) return false;
  for (const std::vector<std::size_t>& group : oracle::groups_of(edges))
    if (!is_chain(edges, group)) return false;
  return !oracle::split(edges).is_refused();
}

// The edges without those of a group.
Edges without(const Edges& edges, const std::vector<std::size_t>& group) {
  Edges fewer = edges;
  const auto first = fewer.begin() + static_cast<std::ptrdiff_t>(group.front());
  fewer.erase(first, first + static_cast<std::ptrdiff_t>(group.size()));
  return fewer;
}

// The edges without one of a polyline: the next begins where it began, or it was the last of an open one.
Edges without_corner(const Edges& edges, const std::vector<std::size_t>& group, std::size_t at) {
  Edges fewer = edges;
  if (at + 1 < group.size() || oracle::is_closed(edges, group)) {
    oracle::InputSegment& next = fewer[group[(at + 1) % group.size()]];
    next.ax = edges[group[at]].ax;
    next.ay = edges[group[at]].ay;
  }
  fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(group[at]));
  return fewer;
}

// All that can be done to a scene to have less of it, the coarsest first.
std::vector<Edges> simpler(const Edges& edges) {
  std::vector<Edges> result;
  const oracle::Groups groups = oracle::groups_of(edges);
  if (groups.size() > 1)
    for (const std::vector<std::size_t>& group : groups) result.push_back(without(edges, group));
  for (const std::vector<std::size_t>& group : groups) {
    Edges said = edges, tied = edges;
    for (const std::size_t k : group) {
      said[k].behind = oracle::Behind::kNothingSaid;
      tied[k].group = oracle::kAlone;
    }
    if (edges[group.front()].group != oracle::kAlone) result.push_back(tied);
    if (edges[group.front()].behind != oracle::Behind::kNothingSaid) result.push_back(said);
    if (group.size() > 1)
      for (std::size_t at = 0; at < group.size(); ++at) result.push_back(without_corner(edges, group, at));
  }
  return result;
}

Edges with_fewer(Edges edges, const std::function<bool(const Edges&)>& fails) {
  for (;;) {
    const std::vector<Edges> candidates = simpler(edges);
    const auto fewer = std::find_if(candidates.begin(), candidates.end(),
                                    [&](const Edges& some) { return is_valid(some) && fails(some); });
    if (fewer == candidates.end()) return edges;
    edges = *fewer;
  }
}

// The points to try for one, each with a smaller sum of coordinates.
std::vector<Point> nearer(const Point& p) {
  std::vector<Point> result;
  for (const Point& q :
       {Point(0, 0), Point(0, p.second), Point(p.first, 0), Point(p.first - 1, p.second), Point(p.first, p.second - 1)})
    if (q.first >= 0 && q.second >= 0 && q.first + q.second < p.first + p.second) result.push_back(q);
  return result;
}

// The edges with end number `end` (even: from, odd: to) in q, and with it all ends of its polyline, or of all edges,
// that are where it is.
Edges with_end_at(Edges edges, std::size_t end, const Point& q, bool all) {
  const auto coordinates = [&](std::size_t k) {
    oracle::InputSegment& edge = edges[k / 2];
    return k % 2 == 0 ? std::pair(&edge.ax, &edge.ay) : std::pair(&edge.bx, &edge.by);
  };
  const auto at = coordinates(end);
  const Point p{*at.first, *at.second};
  for (std::size_t k = 0; k < 2 * edges.size(); ++k) {
    const auto [x, y] = coordinates(k);
    const bool is_tied = all || (edges[k / 2].group != oracle::kAlone && edges[k / 2].group == edges[end / 2].group);
    if (k != end && !(is_tied && *x == p.first && *y == p.second)) continue;
    *x = q.first;
    *y = q.second;
  }
  return edges;
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
