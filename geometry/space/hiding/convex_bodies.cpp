#include "geometry/space/hiding/convex_bodies.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace hottel {
namespace {

// What hangs together by edges.
class Components {
 public:
  explicit Components(const Blockers3& blockers) : first_(blockers.size()), of_edge_(blockers.edge_count()) {
    std::iota(first_.begin(), first_.end(), 0u);
    for (std::uint32_t s = 0; s < blockers.size(); ++s)
      for (const DirectedEdge3& side : blockers.edges(s)) of_edge_[side.edge.index()].push_back(s);
    for (const std::vector<std::uint32_t>& surfaces : of_edge_)
      for (const std::uint32_t s : surfaces) join(surfaces.front(), s);
  }

  // Each ascending, in the order of their first surfaces.
  std::vector<std::vector<std::uint32_t>> take() {
    std::vector<std::vector<std::uint32_t>> all(first_.size());
    for (std::uint32_t s = 0; s < first_.size(); ++s) all[first(s)].push_back(s);
    std::erase_if(all, [](const auto& component) { return component.empty(); });
    return all;
  }
  const std::vector<std::uint32_t>& of_edge(EdgeId3 edge) const { return of_edge_[edge.index()]; }

 private:
  std::uint32_t first(std::uint32_t s) {
    while (first_[s] != s) s = first_[s] = first_[first_[s]];
    return s;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    const std::uint32_t of_a = first(a), of_b = first(b);
    first_[std::max(of_a, of_b)] = std::min(of_a, of_b);
  }

  std::vector<std::uint32_t> first_;
  std::vector<std::vector<std::uint32_t>> of_edge_;
};

// On which sides of a plane points lie.
struct Sides {
  bool has_positive = false, has_negative = false;
  void add(int sign) {
    has_positive |= sign > 0;
    has_negative |= sign < 0;
  }
  // +1 or -1 where all are on one side, and some are off the plane; else 0.
  int only() const { return has_positive == has_negative ? 0 : has_positive ? 1 : -1; }
};

class BodyFinder {
 public:
  BodyFinder(const Blockers3& blockers, const Components& components)
      : blockers_(blockers), vertices_(blockers.vertices()), components_(components) {}

  std::optional<ConvexBody3> find(std::vector<std::uint32_t> surfaces) const {
    if (surfaces.size() < 3 || surfaces.size() > ConvexBodies3::kMostSurfaces) return std::nullopt;
    ConvexBody3 body;
    body.surfaces = std::move(surfaces);
    for (const std::uint32_t s : body.surfaces)
      body.corners.insert(body.corners.end(), blockers_.outline(s).begin(), blockers_.outline(s).end());
    std::ranges::sort(body.corners);
    body.corners.erase(std::unique(body.corners.begin(), body.corners.end()), body.corners.end());
    if (!find_lid(body) || !find_planes(body)) return std::nullopt;
    return body;
  }

 private:
  // False where an edge has three surfaces, or edges of one surface are not all in a plane beside the body.
  bool find_lid(ConvexBody3& body) const {
    std::vector<VertexId3> border;
    for (const std::uint32_t s : body.surfaces)
      for (const DirectedEdge3& side : blockers_.edges(s)) {
        const std::size_t count = components_.of_edge(side.edge).size();
        if (count > 2) return false;
        const Blockers3::Edge& edge = blockers_.edge(side.edge);
        if (count == 1) border.insert(border.end(), {edge.from, edge.to});
      }
    if (border.empty()) return true;
    const IntegerVector& origin = vertices_.exact(border[0]);
    const IntegerVector way = difference(vertices_.exact(border[1]), origin);
    for (const VertexId3 v : border) {
      IntegerVector normal = cross(way, difference(vertices_.exact(v), origin));
      if (is_zero(normal)) continue;
      BodyPlane3 lid{border[0], primitive(normal)};
      const int side = sides_of(lid, body.corners).only();
      const Sides of_border = sides_of(lid, border);
      if (side == 0 || of_border.has_positive || of_border.has_negative) return false;
      if (side > 0) lid.outward = opposite(lid.outward);
      body.lid = std::move(lid);
      return true;
    }
    return false;
  }

  // False where a surface has corners of the body on both sides, or on none.
  bool find_planes(ConvexBody3& body) const {
    for (const std::uint32_t s : body.surfaces) {
      if (body.lid && is_in(*body.lid, s)) {
        body.plane_of.push_back(ConvexBody3::kNone);
        continue;
      }
      Sides sides;
      for (const VertexId3 v : body.corners) {
        SignTier tier;
        sides.add(blockers_.side_of(v, s, tier));
        if (sides.has_positive && sides.has_negative) return false;
      }
      if (sides.only() == 0) return false;
      const IntegerVector& normal = blockers_.exact_normal(s);
      body.plane_of.push_back(static_cast<std::uint32_t>(body.planes.size()));
      body.planes.push_back({blockers_.outline(s).front(), sides.only() > 0 ? opposite(normal) : normal});
    }
    return !body.planes.empty();
  }

  bool is_in(const BodyPlane3& plane, std::uint32_t surface) const {
    const Sides sides = sides_of(plane, blockers_.outline(surface));
    return !sides.has_positive && !sides.has_negative;
  }

  template <class Corners>
  Sides sides_of(const BodyPlane3& plane, const Corners& corners) const {
    Sides sides;
    for (const VertexId3 v : corners)
      sides.add(dot_sign(plane.outward, difference(vertices_.exact(v), vertices_.exact(plane.at))));
    return sides;
  }

  const Blockers3& blockers_;
  const Vertices3& vertices_;
  const Components& components_;
};

}  // namespace

ConvexBodies3::ConvexBodies3(const Blockers3& blockers) : body_of_(blockers.size(), ConvexBody3::kNone) {
  Components components(blockers);
  const BodyFinder finder(blockers, components);
  for (std::vector<std::uint32_t>& surfaces : components.take()) {
    std::optional<ConvexBody3> body = finder.find(std::move(surfaces));
    if (!body) continue;
    for (const std::uint32_t s : body->surfaces) body_of_[s] = static_cast<std::uint32_t>(bodies_.size());
    bodies_.push_back(std::move(*body));
  }
}

}  // namespace hottel
