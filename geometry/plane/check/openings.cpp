#include "geometry/plane/check/openings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>

#include "geometry/plane/scene/closest_point.h"

namespace hottel {
namespace {

constexpr std::uint32_t kNoPocket = 0xffffffff;

// A place to pass, between a vertex and an edge (or its end), and how wide it is, about.
struct Gap {
  VertexId tip, a, b;  // from the tip to the segment a-b, or to a when a == b
  double width = std::numeric_limits<double>::infinity();
};

// Triangles that share the narrowest place on their way out.
struct Pocket {
  std::uint32_t parent;
  HalfEdgeId door;  // where it is entered: half-edge of the first triangle in it
  Gap gap;
  double walls = 0;  // length of the pieces in it and in the pockets within it
  bool has_other_ways = false;
  bool is_narrowed = false;  // a pocket within it has a narrower door, and at least half of the walls
  std::uint32_t opening = kNoPocket;
};

// The way out that is widest at its narrowest place, for all triangles at once: flooding from infinity, widest first.
class Flood {
 public:
  explicit Flood(const Arrangement2& arrangement)
      : vertices_(arrangement.vertices()),
        triangulation_(arrangement.triangulation()),
        pocket_of_(triangulation_.triangle_count(), kNoPocket) {
    for (const HalfEdgeId h : triangulation_.half_edges())
      if (triangulation_.is_bare_hull(h)) arrive({length(h), h, kNoPocket, along(h)});
    while (!waiting_.empty()) {
      const Arrival next = waiting_.top();
      waiting_.pop();
      if (pocket(triangle_of(next.entry)) == kNoPocket) enter(next);
    }
    for (std::size_t p = pockets_.size(); p-- > 0;)
      if (pockets_[p].parent != kNoPocket) pockets_[pockets_[p].parent].walls += pockets_[p].walls;
    for (const Pocket& pocket : pockets_)
      if (pocket.parent != kNoPocket && 2 * pocket.walls >= pockets_[pocket.parent].walls)
        pockets_[pocket.parent].is_narrowed = true;
    for (const HalfEdgeId h : triangulation_.half_edges()) find_other_ways(h);
  }

  std::vector<Pocket>& pockets() { return pockets_; }
  std::uint32_t pocket(TriangleId triangle) const { return pocket_of_[triangle.index()]; }

 private:
  struct Arrival {
    double width;
    HalfEdgeId entry;
    std::uint32_t pocket;  // the one the way comes from; kNoPocket: infinity
    Gap gap;               // the narrowest place, if it is new
    bool operator<(const Arrival& other) const {
      return width != other.width ? width < other.width : entry > other.entry;
    }
  };

  VertexId origin(HalfEdgeId h) const { return triangulation_.origin(h); }
  VertexId target(HalfEdgeId h) const { return triangulation_.target(h); }

  double length(HalfEdgeId h) const {
    const auto &p = vertices_.approximate(origin(h)), &q = vertices_.approximate(target(h));
    return std::hypot(q.x - p.x, q.y - p.y);
  }
  Gap along(HalfEdgeId h) const { return {origin(h), target(h), target(h), length(h)}; }

  // What one passes between when one goes round corner `tip` of a triangle whose opposite side is a piece.
  Gap past(HalfEdgeId piece) const {
    const VertexId tip = triangulation_.corner(piece), a = origin(piece), b = target(piece);
    const auto &t = vertices_.approximate(tip), &p = vertices_.approximate(a), &q = vertices_.approximate(b);
    const double dx = q.x - p.x, dy = q.y - p.y, along = dx * (t.x - p.x) + dy * (t.y - p.y);
    if (along <= 0 || along >= dx * dx + dy * dy) return {tip, a, b};  // the edges of the triangle are narrower
    return {tip, a, b, std::fabs(dx * (t.y - p.y) - dy * (t.x - p.x)) / std::hypot(dx, dy)};
  }

  void arrive(Arrival arrival) {
    if (pocket(triangle_of(arrival.entry)) == kNoPocket) waiting_.push(arrival);
  }

  void enter(const Arrival& arrival) {
    std::uint32_t here = arrival.pocket;
    if (here == kNoPocket || arrival.width < pockets_[here].gap.width) {
      here = static_cast<std::uint32_t>(pockets_.size());
      pockets_.push_back({arrival.pocket, arrival.entry, arrival.gap});
    }
    pocket_of_[triangle_of(arrival.entry).index()] = here;
    const std::array<HalfEdgeId, 2> others{next_half_edge(arrival.entry), previous_half_edge(arrival.entry)};
    for (std::size_t k = 0; k < 2; ++k) {
      const HalfEdgeId exit = others[k], third = others[1 - k];
      if (!triangulation_.is_open(exit)) {
        if (triangulation_.side(exit) != kSky) pockets_[here].walls += length(exit);
        continue;
      }
      Gap narrowest = along(exit);
      if (triangulation_.is_piece(third))
        if (const Gap corner = past(third); corner.width < narrowest.width) narrowest = corner;
      arrive({std::min(pockets_[here].gap.width, narrowest.width), triangulation_.twin(exit), here, narrowest});
    }
  }

  // Marks the pockets that a half-edge leads out of although it is not their door.
  void find_other_ways(HalfEdgeId h) {
    std::uint32_t here = pocket(triangle_of(h));
    if (triangulation_.is_piece(h) || here == kNoPocket) return;
    std::uint32_t beyond = triangulation_.is_open(h) ? pocket(triangle_of(triangulation_.twin(h))) : kNoPocket;
    // Pockets are numbered after those they are in: the larger of two different ones does not hold the other.
    while (here != beyond && here != kNoPocket) {
      if (beyond != kNoPocket && beyond > here) {
        beyond = pockets_[beyond].parent;
        continue;
      }
      if (pockets_[here].door != h) pockets_[here].has_other_ways = true;
      here = pockets_[here].parent;
    }
  }

  const Vertices2& vertices_;
  const Triangulation2& triangulation_;
  std::vector<std::uint32_t> pocket_of_;  // by triangle
  std::vector<Pocket> pockets_;
  std::priority_queue<Arrival> waiting_;
};

Opening2 opening_at(const Vertices2& vertices, const Pocket& pocket) {
  const auto place = [&](VertexId v) { return vertices.to_scene(vertices.exact(v)); };
  const Gap& gap = pocket.gap;
  const Point2 tip = place(gap.tip), a = place(gap.a);
  return {tip, gap.a == gap.b ? a : closest_point(a, place(gap.b), tip).at, gap.width / pocket.walls,
          !pocket.has_other_ways};
}

}  // namespace

Openings2::Openings2(const Arrangement2& arrangement) : of_side_(arrangement.side_count(), kNoPocket) {
  Flood flood(arrangement);
  for (Pocket& pocket : flood.pockets()) {
    if (pocket.parent != kNoPocket) pocket.opening = flood.pockets()[pocket.parent].opening;
    if (pocket.opening != kNoPocket || pocket.is_narrowed || pocket.gap.width >= kOpeningPart * pocket.walls) continue;
    pocket.opening = static_cast<std::uint32_t>(openings_.size());
    openings_.push_back(opening_at(arrangement.vertices(), pocket));
  }
  const Triangulation2& triangulation = arrangement.triangulation();
  for (const HalfEdgeId h : triangulation.half_edges()) {
    const std::uint32_t pocket = flood.pocket(triangle_of(h));
    if (triangulation.is_piece(h) && pocket != kNoPocket)
      of_side_[triangulation.side(h).index()] = flood.pockets()[pocket].opening;
  }
}

std::optional<std::uint32_t> Openings2::behind(PieceSideId side) const {
  const std::uint32_t opening = of_side_[side.index()];
  return opening == kNoPocket ? std::nullopt : std::optional(opening);
}

}  // namespace hottel
