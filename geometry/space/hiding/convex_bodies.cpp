#include "geometry/space/hiding/convex_bodies.h"

#include <algorithm>
#include <utility>

#include "geometry/space/arrangement/edge_components.h"

namespace hottel {
namespace {

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
  BodyFinder(const Occluders3& occluders, const EdgeComponents3& components)
      : occluders_(occluders), vertices_(occluders.vertices()), components_(components) {}

  std::optional<ConvexBody3> find(const std::vector<std::uint32_t>& surfaces) const {
    if (surfaces.size() < 3 || surfaces.size() > ConvexBodies3::kMostSurfaces) return std::nullopt;
    ConvexBody3 body;
    body.surfaces = surfaces;
    for (const std::uint32_t s : body.surfaces)
      body.corners.insert(body.corners.end(), occluders_.outline(s).begin(), occluders_.outline(s).end());
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
      for (const DirectedEdge3& side : occluders_.edges(s)) {
        const std::size_t count = components_.of_edge(side.edge).size();
        if (count > 2) return false;
        const Occluders3::Edge& edge = occluders_.edge(side.edge);
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
        sides.add(occluders_.side_of(v, s, tier));
        if (sides.has_positive && sides.has_negative) return false;
      }
      if (sides.only() == 0) return false;
      const IntegerVector& normal = occluders_.exact_normal(s);
      body.plane_of.push_back(static_cast<std::uint32_t>(body.planes.size()));
      body.planes.push_back({occluders_.outline(s).front(), sides.only() > 0 ? opposite(normal) : normal});
    }
    return !body.planes.empty();
  }

  bool is_in(const BodyPlane3& plane, std::uint32_t surface) const {
    const Sides sides = sides_of(plane, occluders_.outline(surface));
    return !sides.has_positive && !sides.has_negative;
  }

  template <class Corners>
  Sides sides_of(const BodyPlane3& plane, const Corners& corners) const {
    Sides sides;
    for (const VertexId3 v : corners)
      sides.add(dot_sign(plane.outward, difference(vertices_.exact(v), vertices_.exact(plane.at))));
    return sides;
  }

  const Occluders3& occluders_;
  const Vertices3& vertices_;
  const EdgeComponents3& components_;
};

}  // namespace

ConvexBodies3::ConvexBodies3(const Occluders3& occluders) : body_of_(occluders.size(), ConvexBody3::kNone) {
  const EdgeComponents3 components(occluders);
  const BodyFinder finder(occluders, components);
  for (const std::vector<std::uint32_t>& surfaces : components.all()) {
    std::optional<ConvexBody3> body = finder.find(surfaces);
    if (!body) continue;
    for (const std::uint32_t s : body->surfaces) body_of_[s] = static_cast<std::uint32_t>(bodies_.size());
    bodies_.push_back(std::move(*body));
  }
}

}  // namespace hottel
