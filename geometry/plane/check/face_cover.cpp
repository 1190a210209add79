#include "geometry/plane/check/face_cover.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "geometry/name.h"
#include "geometry/plane/scene/closest_point.h"
#include "geometry/scene_names.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

// The first group with a solid on a side of a piece on which it has no surface.
std::uint32_t holder_of(const Scene2& scene, const Solids2& solids, std::size_t piece,
                        const std::vector<PieceSource2>& covering) {
  std::uint32_t holder = Solids2::kNone;
  for (const PieceSideId side : sides_of(piece)) {
    const std::uint32_t maker = solids.maker(side);
    if (std::none_of(covering.begin(), covering.end(),
                     [&](const PieceSource2& source) { return scene.surfaces[source.surface].group == maker; }))
      holder = std::min(holder, maker);
  }
  return holder;
}

// A group whose surface lies on the border of a solid of another group from within.
bool lies_within(const Scene2& scene, const Solids2& solids, std::size_t piece, std::uint32_t group,
                 const std::vector<PieceSource2>& covering) {
  return std::any_of(covering.begin(), covering.end(), [&](const PieceSource2& source) {
    const std::uint32_t other = scene.surfaces[source.surface].group;
    return other != group &&
           (solids.is_inside_of(left_side(piece), other) || solids.is_inside_of(right_side(piece), other));
  });
}

}  // namespace

FaceCover2::FaceCover2(const Scene2& scene, const Arrangement2& arrangement)
    : has_area(2 * scene.surfaces.size(), 0),
      covered_by(2 * scene.surfaces.size(), Solids2::kNone),
      holder(scene.groups.size(), Solids2::kNone) {
  const Solids2& solids = arrangement.solids();
  std::vector<char> is_free(scene.groups.size(), 0);
  for (std::size_t piece = 0; 2 * piece < arrangement.side_count(); ++piece) {
    const std::vector<PieceSource2> covering = arrangement.sources(piece);
    for (const PieceSideId side : sides_of(piece)) {
      if (!solids.is_covered(side)) {
        const SideOwner2 claims = arrangement.claims(scene, side);
        has_area[claims.owner.face.number()] = 1;
        if (claims.rival) has_area[claims.rival->face.number()] = 1;
        continue;
      }
      for (const PieceSource2& source : covering) {
        const Face face{source.surface, source.is_reversed == is_right(side)};
        std::uint32_t& group = covered_by[face.number()];
        group = std::min(group, solids.maker(side));
      }
    }
    const bool is_inside = solids.is_covered(left_side(piece)) && solids.is_covered(right_side(piece));
    for (const PieceSource2& source : covering) {
      const std::uint32_t group = scene.surfaces[source.surface].group;
      if (!is_inside && !lies_within(scene, solids, piece, group, covering)) is_free[group] = 1;
    }
    if (!is_inside) continue;
    const std::uint32_t held_by = holder_of(scene, solids, piece, covering);
    for (const PieceSource2& source : covering) {
      const std::uint32_t group = scene.surfaces[source.surface].group;
      if (held_by != group) holder[group] = std::min(holder[group], held_by);
    }
  }
  for (std::uint32_t group = 0; group < holder.size(); ++group)
    if (is_free[group] != 0) holder[group] = Solids2::kNone;
}

namespace {

// The side of a piece that a face has, or would have, at a place: just after it, at its end just before it.
std::optional<PieceSideId> side_at(const PreparedScene2& prepared, const Face& face, const Rational& t) {
  const Arrangement2& arrangement = prepared.arrangement;
  const Edge2& edge = prepared.scene.edges[face.surface];
  const auto place = [&](VertexId v) {
    return position_on(edge, arrangement.vertices().to_scene(arrangement.vertices().exact(v)));
  };
  for (std::size_t piece = 0; piece < arrangement.pieces().size(); ++piece)
    for (const PieceSource2& source : arrangement.sources(piece)) {
      if (source.surface != face.surface) continue;
      const Rational a = place(arrangement.pieces()[piece].a), b = place(arrangement.pieces()[piece].b);
      const Rational &low = std::min(a, b), &high = std::max(a, b);
      if (t < low || t > high || (t == high && t < 1)) continue;
      const bool right = source.is_reversed == face.is_back;
      return right ? right_side(piece) : left_side(piece);
    }
  return std::nullopt;
}

// "scene.json:4: the front of 'floor'"
std::string face_text(const Scene2& scene, const Face& face) {
  const Surface& surface = scene.surfaces[face.surface];
  return fmt::format("{}:{}: the {} of {}", scene.file, surface.line, face.is_back ? "back" : "front",
                     quoted_name(surface.name));
}

}  // namespace

void require_free(const PreparedScene2& prepared, const Face& face) {
  if (prepared.arrangement.solids().is_empty()) return;
  const FaceCover2 cover(prepared.scene, prepared.arrangement);
  const std::uint32_t place = face.number();
  if (cover.has_area[place] == 0 && cover.covered_by[place] != Solids2::kNone)
    throw RequestError(fmt::format("{} looks into {} all along: it has no area and exchanges nothing",
                                   face_text(prepared.scene, face),
                                   solid_text(prepared.scene, cover.covered_by[place])));
}

void require_free_at(const PreparedScene2& prepared, const Face& face, const Rational& t) {
  const std::optional<PieceSideId> side = side_at(prepared, face, t);
  if (!side) return;
  const auto refuse = [&](const std::string& what) {
    throw RequestError(
        fmt::format("{} {} at t = {}: nothing is seen there", face_text(prepared.scene, face), what, to_string(t)));
  };
  const Arrangement2& arrangement = prepared.arrangement;
  if (const std::uint32_t solid = arrangement.solids().maker(*side); solid != Solids2::kNone)
    refuse("looks into " + solid_text(prepared.scene, solid));
  const std::uint32_t owner = arrangement.owner(*side).surface;
  if (owner != face.surface && arrangement.patches().is_patch(owner))
    refuse("gives way to the patch " + quoted_name(prepared.scene.surfaces[owner].name));
}

}  // namespace hottel
