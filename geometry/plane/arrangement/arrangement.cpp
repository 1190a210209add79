#include "geometry/plane/arrangement/arrangement.h"

#include "geometry/plane/arrangement/free_regions.h"
#include "geometry/plane/arrangement/hilbert_order.h"
#include "geometry/plane/arrangement/point_index.h"
#include "geometry/plane/scene/division.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

// The points numbered along a Hilbert curve, so that vertices near in space are near in memory.
PointIndex2 number_in_space(const std::vector<Point2>& points) {
  std::vector<Vertices2::Approximate> approximate;
  approximate.reserve(points.size());
  for (const Point2& p : points) approximate.push_back({p.x.get_d(), p.y.get_d()});
  PointIndex2 index;
  for (const std::size_t i : hilbert_order(approximate)) index.insert(points[i]);
  return index;
}

std::string text(const Point2& p) { return "(" + to_string(p.x) + ", " + to_string(p.y) + ")"; }

}  // namespace

Arrangement2::Arrangement2(const Scene2& scene, const Division2& division, Conflicts2 conflicts) {
  HOTTEL_REQUIRE(division.size() == scene.surfaces.size());
  std::vector<Point2> points;
  for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s) {
    const Edge2& edge = scene.edges[s];
    const std::uint32_t parts = division[s];
    HOTTEL_REQUIRE(parts > 0);
    points.push_back(edge.from);
    for (std::uint32_t k = 1; k < parts; ++k) points.push_back(part_begin(edge, k, parts));
    points.push_back(edge.to);
  }
  PointIndex2 index = number_in_space(points);
  std::size_t next = 0;
  for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s) {
    for (std::uint32_t k = 0; k < division[s]; ++k) {
      segments_.push_back({index.insert(points[next + k]), index.insert(points[next + k + 1])});
      segment_part_.push_back({{s, false}, k});
    }
    next += division[s] + 1;
  }
  overlay_ = overlay(index.points(), segments_);
  overlay_.set_total_length();
  triangulation_ = Triangulation2(overlay_.vertices, overlay_.pieces);
  find_solids(scene);
  assign_owners(scene, conflicts);
}

std::vector<PieceSource2> Arrangement2::sources(std::size_t piece) const {
  const Segment2& p = overlay_.pieces[piece];
  const bool ascends = vertices().precedes(p.a, p.b);
  std::vector<PieceSource2> result;
  for (const std::uint32_t s : overlay_.sources(piece))
    result.push_back({segment_part_[s].surface, segment_part_[s].part,
                      vertices().precedes(segments_[s].a, segments_[s].b) != ascends});
  return result;
}

void Arrangement2::find_solids(const Scene2& scene) {
  const std::vector<ClosedGroup2> closed = closed_groups(scene);
  if (!may_have_solids(scene, closed)) return;
  const FreeRegions2 regions(triangulation_, 2 * pieces().size());
  solids_ = Solids2({scene, overlay_, regions, closed, [this](std::size_t piece) { return sources(piece); }});
}

std::vector<std::vector<std::uint32_t>> Arrangement2::regions_behind(const Scene2& scene,
                                                                     const FreeRegions2& regions) const {
  const std::vector<ClosedGroup2> closed = closed_groups(scene);
  return hottel::regions_behind(
      {scene, overlay_, regions, closed, [this](std::size_t piece) { return sources(piece); }});
}

void Arrangement2::assign_owners(const Scene2& scene, Conflicts2 conflicts) {
  owner_.resize(2 * pieces().size());
  for (std::size_t piece = 0; piece < pieces().size(); ++piece) {
    const std::vector<PieceSource2> covering = sources(piece);
    for (const PieceSideId side : sides_of(piece)) {
      if (is_covered(side)) continue;
      const SideOwner2 claimed = claims(scene, side, covering);
      if (claimed.rival && conflicts == Conflicts2::kRefused) refuse_conflict(scene, side, claimed);
      owner_[side.index()] = claimed.owner.face;
    }
  }
}

SideOwner2 Arrangement2::claims(const Scene2& scene, PieceSideId side) const {
  HOTTEL_REQUIRE(!is_covered(side));
  return claims(scene, side, sources(piece_of(side)));
}

SideOwner2 Arrangement2::claims(const Scene2& scene, PieceSideId side,
                                const std::vector<PieceSource2>& covering) const {
  const bool right = is_right(side);
  const PieceSideId behind = opposite(side);
  const SilentGroups2 is_silent = [&](std::uint32_t group) { return solids_.is_inside_of(behind, group); };
  const bool lies_on_solid = is_covered(behind) && has_material_on(scene, covering, !right);
  return owner_of_side(scene, covering, right, lies_on_solid ? is_silent : SilentGroups2());
}

void Arrangement2::refuse_conflict(const Scene2& scene, PieceSideId side, const SideOwner2& claims) const {
  const auto& [owner, rival] = claims;
  const Surface &first = scene.surfaces[owner.face.surface], &other = scene.surfaces[rival->face.surface];
  const Segment2& p = piece(side);
  throw InputError(
      {scene.file, other.line},
      "'" + first.name + "' (" + (owner.face.is_back ? "back" : "front") + ") and '" + other.name + "' (" +
          (rival->face.is_back ? "back" : "front") + ") claim the same side with different materials along " +
          text(vertices().to_scene(vertices().exact(p.a))) + " to " + text(vertices().to_scene(vertices().exact(p.b))),
      {"materials '" + owner.material->name + "' and '" + rival->material->name + "', on the " +
           (is_right(side) ? "right" : "left") + " of that piece",
       "give both the same material, or take one of the surfaces away"});
}

Arrangement2 Arrangement2::restricted_to(const std::vector<std::uint32_t>& kept) const {
  Arrangement2 result;
  PointIndex2 index;
  const auto id_of = [&](VertexId v) { return index.insert(vertices().to_scene(vertices().exact(v))); };
  result.overlay_.source_begin.push_back(0);
  for (const std::uint32_t piece : kept) {
    result.overlay_.pieces.push_back({id_of(pieces()[piece].a), id_of(pieces()[piece].b)});
    result.overlay_.source_begin.push_back(0);
    for (const PieceSideId side : sides_of(piece)) result.owner_.push_back(owner_[side.index()]);
  }
  result.overlay_.vertices = Vertices2(index.points(), index.points().size());
  result.overlay_.set_total_length();
  result.solids_ = solids_.restricted_to(kept);
  result.triangulation_ = Triangulation2(result.vertices(), result.pieces());
  return result;
}

}  // namespace hottel
