#include "geometry/plane/arrangement/arrangement.h"

#include <algorithm>

#include "geometry/plane/arrangement/free_regions.h"
#include "geometry/plane/arrangement/hilbert_order.h"
#include "geometry/plane/arrangement/point_index.h"
#include "geometry/plane/scene/division.h"
#include "geometry/plane/scene/patches.h"
#include "kernel/exact_double.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

// Numbers the ends of the edges along a Hilbert curve, so that vertices near in space are near in memory, and says
// which numbers each edge has got.
std::vector<Segment2> number_in_space(const std::vector<Edge2>& edges, PointIndex2& index) {
  std::vector<Vertices2::Approximate> approximate;
  approximate.reserve(2 * edges.size());
  for (const Edge2& edge : edges)
    for (const Point2* p : {&edge.from, &edge.to})
      approximate.push_back({truncated_double(p->x), truncated_double(p->y)});
  index.reserve(approximate.size());
  std::vector<Segment2> segments(edges.size(), {VertexId(0), VertexId(0)});
  for (const std::size_t i : hilbert_order(approximate)) {
    const Edge2& edge = edges[i / 2];
    if (i % 2 == 0)
      segments[i / 2].a = index.insert(edge.from);
    else
      segments[i / 2].b = index.insert(edge.to);
  }
  return segments;
}

std::string exact_text(const Point2& p) { return "(" + to_string(p.x) + ", " + to_string(p.y) + ")"; }

}  // namespace

Arrangement2::Arrangement2(const Scene2& scene, const Division2& division, Conflicts2 conflicts) : patches_(scene) {
  HOTTEL_REQUIRE(division.size() == scene.surfaces.size());
  PointIndex2 index;
  segments_ = number_in_space(scene.edges, index);
  typed_points_ = index.points().size();
  segment_part_.reserve(segments_.size());
  for (std::uint32_t s = 0; s < segments_.size(); ++s) segment_part_.push_back({{s, false}, 0});
  overlay_ = overlay(index.points(), segments_);
  overlay_.set_total_length();
  triangulation_ = Triangulation2(overlay_.vertices, overlay_.pieces);
  find_solids(scene);
  assign_owners(scene, conflicts);
  if (is_cut(division)) *this = cut_into(scene, division);
}

// The vertices along each surface, from its first point to its last one.
void Arrangement2::add_segments(const std::vector<std::vector<VertexId>>& ends) {
  for (std::uint32_t s = 0; s < ends.size(); ++s)
    for (std::uint32_t k = 0; k + 1 < ends[s].size(); ++k) {
      segments_.push_back({ends[s][k], ends[s][k + 1]});
      segment_part_.push_back({{s, false}, k});
    }
}

namespace {

// The vertices where surfaces are cut, and their ends.
class SurfaceMarks {
 public:
  SurfaceMarks(const Vertices2& vertices, const std::vector<std::vector<VertexId>>& marks)
      : vertices_(vertices), marks_(marks) {}

  // Appends the marks of a surface strictly inside a piece on it, in the order of the piece.
  void append_inside(std::uint32_t surface, const Segment2& piece, bool is_reversed,
                     std::vector<VertexId>& inside) const {
    const auto& marks = marks_[surface];
    const VertexId first = is_reversed ? piece.b : piece.a, last = is_reversed ? piece.a : piece.b;
    const std::size_t begin = after(surface, first);
    std::size_t end = begin;
    while (end + 1 < marks.size() && marks[end] != last && is_before(surface, marks[end], last)) ++end;
    const std::size_t old = inside.size();
    inside.insert(inside.end(), marks.begin() + static_cast<std::ptrdiff_t>(begin),
                  marks.begin() + static_cast<std::ptrdiff_t>(end));
    if (is_reversed) std::reverse(inside.begin() + static_cast<std::ptrdiff_t>(old), inside.end());
  }

  // Which part of a surface begins at a vertex on it, or holds it.
  std::uint32_t part_from(std::uint32_t surface, VertexId v) const {
    return static_cast<std::uint32_t>(after(surface, v) - 1);
  }

 private:
  bool is_before(std::uint32_t surface, VertexId v, VertexId w) const {
    const auto& marks = marks_[surface];
    return v != w && vertices_.precedes(v, w) == vertices_.precedes(marks.front(), marks.back());
  }
  // The first mark beyond a vertex of the surface.
  std::size_t after(std::uint32_t surface, VertexId v) const {
    const auto& marks = marks_[surface];
    return static_cast<std::size_t>(
        std::ranges::partition_point(marks, [&](VertexId mark) { return !is_before(surface, v, mark); }) -
        marks.begin());
  }

  const Vertices2& vertices_;
  const std::vector<std::vector<VertexId>>& marks_;  // the ends of the surface among them
};

}  // namespace

Arrangement2 Arrangement2::cut_into(const Scene2& scene, const Division2& division) const {
  HOTTEL_REQUIRE(division.size() == scene.surfaces.size() && segments_.size() == scene.surfaces.size());
  Arrangement2 result;
  result.patches_ = patches_;
  PointIndex2 index;
  for (const VertexId v : vertices().ids()) index.insert(vertices().to_scene(vertices().exact(v)));
  std::vector<std::vector<VertexId>> marks;
  std::vector<std::uint32_t> first_segment;
  std::uint32_t segments = 0;
  for (std::uint32_t s = 0; s < division.size(); ++s) {
    std::vector<VertexId>& of_surface = marks.emplace_back();
    of_surface.push_back(segments_[s].a);
    for (const Rational& t : division[s].at) of_surface.push_back(index.insert(point_at(scene.edges[s], t)));
    of_surface.push_back(segments_[s].b);
    first_segment.push_back(segments);
    segments += static_cast<std::uint32_t>(of_surface.size()) - 1;
  }
  result.typed_points_ = typed_points_;
  result.overlay_.vertices = Vertices2(index.points(), typed_points_);
  result.add_segments(marks);
  const SurfaceMarks on_surfaces(result.vertices(), marks);
  result.overlay_.source_begin.push_back(0);
  std::vector<std::uint32_t> whole;  // by piece: that of this arrangement which it is a part of
  for (std::uint32_t p = 0; p < pieces().size(); ++p) {
    const std::vector<PieceSource2> covering = sources(p);
    std::vector<VertexId> ends{pieces()[p].a};
    for (const PieceSource2& source : covering)
      on_surfaces.append_inside(source.surface, pieces()[p], source.is_reversed, ends);
    ends.push_back(pieces()[p].b);
    if (covering.size() > 1) {
      const bool ascends = result.vertices().precedes(ends.front(), ends.back());
      std::ranges::sort(ends,
                        [&](VertexId v, VertexId w) { return v != w && result.vertices().precedes(v, w) == ascends; });
      ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    }
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
      const Segment2 part{ends[k], ends[k + 1]};
      const auto part_of = [&](const PieceSource2& source) {
        return on_surfaces.part_from(source.surface, source.is_reversed ? part.b : part.a);
      };
      result.overlay_.pieces.push_back(part);
      for (const PieceSource2& source : covering)
        result.overlay_.source_list.push_back(first_segment[source.surface] + part_of(source));
      result.overlay_.source_begin.push_back(static_cast<std::uint32_t>(result.overlay_.source_list.size()));
      for (const PieceSideId side : sides_of(p)) {
        FacePart2 owner = owner_[side.index()];
        const auto source = std::ranges::find(covering, owner.surface, &PieceSource2::surface);
        if (source != covering.end()) owner.part = part_of(*source);
        result.owner_.push_back(owner);
      }
      whole.push_back(p);
    }
  }
  result.overlay_.set_total_length();
  result.solids_ = solids_.cut_into(whole);
  result.triangulation_ = Triangulation2(result.vertices(), result.pieces());
  return result;
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
  const bool lies_on_solid = is_covered(behind) && has_material_on(scene, patches_, covering, !right, is_silent);
  return owner_of_side(scene, patches_, covering, right, lies_on_solid ? is_silent : SilentGroups2());
}

void Arrangement2::refuse_conflict(const Scene2& scene, PieceSideId side, const SideOwner2& claims) const {
  const auto& [owner, rival] = claims;
  const Surface &first = scene.surfaces[owner.face.surface], &other = scene.surfaces[rival->face.surface];
  const Segment2& p = piece(side);
  throw InputError({scene.file, other.line},
                   "'" + first.name + "' (" + (owner.face.is_back ? "back" : "front") + ") and '" + other.name + "' (" +
                       (rival->face.is_back ? "back" : "front") +
                       ") claim the same side with different materials along " +
                       exact_text(vertices().to_scene(vertices().exact(p.a))) + " to " +
                       exact_text(vertices().to_scene(vertices().exact(p.b))),
                   {"materials '" + owner.material->name + "' and '" + rival->material->name + "', on the " +
                        (is_right(side) ? "right" : "left") + " of that piece",
                    "give both the same material, or take one of the surfaces away",
                    shorter_patch_hint(scene, owner.face, rival->face)});
}

Arrangement2 Arrangement2::restricted_to(const std::vector<std::uint32_t>& kept) const {
  Arrangement2 result;
  result.patches_ = patches_;
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
