#include "tests/storm/plane/lattice_scene.h"

#include <algorithm>
#include <numeric>
#include <random>

#include "tests/oracle/plane/random_scene.h"
#include "tests/storm/plane/lattice_polylines.h"

namespace hottel::storm {

namespace {

// Edges beyond the first three: a lattice with more points has room for more, but the oracles' time grows as the cube.
constexpr int kMostMore = 12;

struct Point {
  long x, y;
};

// All points of the lattice on the line of an edge.
std::vector<Point> points_on_line_of(const LatticeEdge& e, int k) {
  const long steps = std::gcd(e.bx - e.ax, e.by - e.ay), dx = (e.bx - e.ax) / steps, dy = (e.by - e.ay) / steps;
  const auto is_on_lattice = [k](const Point& p) { return p.x >= 0 && p.x <= k && p.y >= 0 && p.y <= k; };
  Point p{e.ax, e.ay};
  while (is_on_lattice({p.x - dx, p.y - dy})) p = {p.x - dx, p.y - dy};
  std::vector<Point> points;
  for (; is_on_lattice(p); p = {p.x + dx, p.y + dy}) points.push_back(p);
  return points;
}

// Lets groups say nothing of what is behind them where that would be refused.
void settle_behind(std::vector<oracle::InputSegment>& edges, const oracle::Cut& cut) {
  const oracle::Groups groups = oracle::groups_of(edges);
  const auto silence = [&](std::size_t group) {
    for (const std::size_t k : groups[group]) edges[k].behind = oracle::Behind::kNothingSaid;
  };
  const auto says = [](const oracle::InputSegment& edge) { return edge.behind != oracle::Behind::kNothingSaid; };
  while (std::any_of(edges.begin(), edges.end(), says)) {
    const oracle::Split split = oracle::split(edges, cut);
    for (const std::size_t group : split.unbounded) silence(group);
    for (const auto& [solid, open] : split.contradictions) silence(open);
    if (split.unbounded.empty() && split.contradictions.empty()) return;
  }
}

}  // namespace

LatticeScene lattice_scene(std::uint64_t number, int k) {
  std::mt19937_64 random(number * 1009 + static_cast<std::uint64_t>(k));
  const auto below = [&](int count) { return static_cast<long>(random() % static_cast<std::uint64_t>(count)); };
  const auto index_in = [&](const auto& list) {
    return static_cast<std::size_t>(below(static_cast<int>(list.size())));
  };
  // Of its own, so that scenes without polylines are what they were before there were any.
  std::mt19937_64 polyline_random(number * 7919 + static_cast<std::uint64_t>(k));
  const bool has_polylines = polyline_random() % 2 == 0;
  LatticeScene scene;
  scene.number = number;
  scene.k = k;
  if (number % 3 == 0) scene.lattice = {{0, 0, 0, k}, {0, k, k, k}, {k, k, k, 0}, {k, 0, 0, 0}};
  std::size_t more = 3 + static_cast<std::size_t>(below(std::min(2 * k, kMostMore) + 1));
  if (has_polylines) more /= 3;
  const std::size_t count = scene.lattice.size() + more;
  while (scene.lattice.size() < count) {
    std::vector<Point> points;  // to draw from, where not from all: one edge in eight lies on the line of another
    if (!scene.lattice.empty() && below(8) == 0) points = points_on_line_of(scene.lattice[index_in(scene.lattice)], k);
    const auto draw = [&] { return points.empty() ? Point{below(k + 1), below(k + 1)} : points[index_in(points)]; };
    const Point from = draw();
    Point to = draw();
    while (to.x == from.x && to.y == from.y) to = draw();
    scene.lattice.push_back({from.x, from.y, to.x, to.y});
  }
  for (const LatticeEdge& edge : scene.lattice)
    scene.edges.push_back(
        {edge.ax, edge.ay, edge.bx, edge.by, static_cast<int>(below(3)), static_cast<int>(below(4)) - 1});
  if (has_polylines) add_polylines(polyline_random, k, scene.lattice, scene.edges);
  const oracle::Cut cut = oracle::cut(scene.edges);
  settle_behind(scene.edges, cut);
  scene.split = oracle::settle_conflicts(scene.edges, cut);
  return scene;
}

}  // namespace hottel::storm
