#include "geometry/space/arrangement/arrangement.h"

#include <algorithm>
#include <functional>
#include <map>
#include <numeric>
#include <utility>

#include "geometry/name.h"
#include "geometry/number.h"
#include "geometry/space/arrangement/coplanar_clusters.h"
#include "geometry/space/arrangement/side_claims.h"
#include "geometry/space/scene/facet_scene.h"
#include "geometry/space/scene/plane_triangulation.h"
#include "kernel/decimal.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

using Flat = std::vector<FlatPoint3>;
using Cover = Piece3::Cover;

// A piece, and the surfaces that have all of its place.
struct MadePiece {
  Piece3 piece;
  std::vector<std::uint32_t> sources;
};

// The pieces of a cluster of polygons of one plane.
class ClusterPieces {
 public:
  ClusterPieces(const Scene3& scene, const PatchBases& patches, const Solids3& solids, const CoplanarCluster3& cluster)
      : scene_(scene), patches_(patches), solids_(solids), cluster_(cluster), frame_(cluster.frame) {}

  std::vector<MadePiece> make() {
    const bool is_near_solid = !solids_.is_empty() && find_cuts();
    if (cluster_.members.size() == 1 && cuts_.empty())
      make_single(is_near_solid);
    else
      make_by_overlay(is_near_solid);
    return std::move(made_);
  }

 private:
  using Member = CoplanarCluster3::Member;

  // A part of the plane in which all is the same.
  struct Cell {
    std::vector<PlaceSource3> sources;
    bool is_covered_up = false, is_covered_down = false;
    std::size_t label = 0;
  };
  // Cells with one owner of each side that matters.
  struct Label {
    std::uint32_t surface;
    Face up, down;
    std::vector<char> is_in;  // by triangle
  };

  // Returns whether some solid is near.
  bool find_cuts() {
    bool is_near = false;
    for (const Member& member : cluster_.members) {
      ClosedMesh3::Box box;
      for (const Point3& p : scene_.polygons[member.surface].points) box.include(p);
      const bool is_met = std::any_of(solids_.meshes().begin(), solids_.meshes().end(), [&](const ClosedMesh3& mesh) {
        return mesh.kind != ClosedMesh3::Kind::kTangled && mesh.box.meets(box);
      });
      if (!is_met) continue;
      is_near = true;
      for (const Flat& part : member.parts) solids_.append_cuts(frame_, part, box, cuts_);
    }
    return is_near;
  }

  bool is_covered(const FlatPoint3& at, bool is_up) const { return solids_.behind({&frame_, at, is_up}).has_value(); }

  Polygon3 to_polygon(const Flat& flat, bool is_front_up) const {
    Polygon3 polygon;
    for (const FlatPoint3& p : flat) polygon.points.push_back(frame_.point(p));
    if (!is_front_up) std::reverse(polygon.points.begin(), polygon.points.end());
    return polygon;
  }

  // The pieces of a polygon that keeps all of its place.
  std::vector<Piece3> whole_pieces(const Member& member) const {
    std::vector<Piece3> pieces;
    const auto add = [&](Polygon3 polygon, bool is_whole) {
      pieces.push_back({std::move(polygon),
                        member.surface,
                        is_whole,
                        {Piece3::Side{{member.surface, false}}, Piece3::Side{{member.surface, true}}}});
    };
    if (member.is_convex)
      add(scene_.polygons[member.surface], true);
    else
      for (const Flat& part : member.parts) add(to_polygon(part, member.is_front_up), false);
    return pieces;
  }

  void make_single(bool is_near_solid) {
    const Member& member = cluster_.members.front();
    refuse_misplaced_masks({{member.surface, member.is_front_up}},
                           [&] { return scene_.polygons[member.surface].points.front(); });
    for (Piece3& piece : whole_pieces(member)) {
      if (is_near_solid) {
        const FlatPoint3 at = solids_.inner_point(frame_, frame_.outline(piece.polygon.points));
        for (const bool is_back : {false, true})
          if (is_covered(at, member.is_front_up != is_back)) piece.sides[is_back ? 1 : 0].cover = Cover::kCovered;
      }
      made_.push_back({std::move(piece), {member.surface}});
    }
  }

  void make_by_overlay(bool is_near_solid) {
    std::vector<FlatSegment3> segments = std::move(cuts_);
    for (const Member& member : cluster_.members) member.region.append_sides(segments);
    const PlaneTriangulation3 triangulation(segments);
    find_cells(triangulation, is_near_solid);
    for (const Label& label : labels_) make_pieces(triangulation, label);
  }

  void find_cells(const PlaneTriangulation3& triangulation, bool is_near_solid) {
    const auto& triangles = triangulation.triangles();
    constexpr std::uint32_t kNone = PlaneTriangulation3::kNone;
    cell_of_.assign(triangles.size(), kNone);
    std::vector<char> is_seen(triangles.size(), 0);
    std::vector<std::uint32_t> open, found;
    for (std::uint32_t first = 0; first < triangles.size(); ++first) {
      if (is_seen[first] != 0) continue;
      found.clear();
      open.assign(1, first);
      is_seen[first] = 1;
      while (!open.empty()) {
        const std::uint32_t triangle = open.back();
        open.pop_back();
        found.push_back(triangle);
        for (std::size_t side = 0; side < 3; ++side) {
          const std::uint32_t beyond = triangles[triangle].neighbours[side];
          if (triangles[triangle].is_border[side] || beyond == kNone || is_seen[beyond] != 0) continue;
          is_seen[beyond] = 1;
          open.push_back(beyond);
        }
      }
      const FlatPoint3 at =
          is_near_solid ? solids_.inner_point(frame_, triangulation.corners_of(first)) : triangulation.centre(first);
      Cell cell;
      for (const Member& member : cluster_.members)
        if (member.region.contains(at)) cell.sources.push_back({member.surface, member.is_front_up});
      if (cell.sources.empty()) continue;
      refuse_misplaced_masks(cell.sources, [&] { return frame_.point(at); });
      if (is_near_solid) {
        cell.is_covered_up = is_covered(at, true);
        cell.is_covered_down = is_covered(at, false);
      }
      cell.label = label_of(cell, at, triangles.size());
      for (const std::uint32_t triangle : found) {
        cell_of_[triangle] = static_cast<std::uint32_t>(cells_.size());
        labels_[cell.label].is_in[triangle] = 1;
      }
      cells_.push_back(std::move(cell));
    }
  }

  // Settles the claims on a cell.
  std::size_t label_of(const Cell& cell, const FlatPoint3& at, std::size_t triangles) {
    const Face up = owner(cell, true, at), down = owner(cell, false, at);
    // What is covered is nobody's: a polygon that is not asked to give up anything else stays whole.
    for (const PlaceSource3& source : cell.sources) {
      const Face own_up{source.surface, !source.is_front_up}, own_down{source.surface, source.is_front_up};
      if ((cell.is_covered_up || up == own_up) && (cell.is_covered_down || down == own_down))
        return label(source.surface, own_up, own_down, triangles);
    }
    return label(cell.sources.front().surface, up, down, triangles);
  }

  std::size_t label(std::uint32_t surface, const Face& up, const Face& down, std::size_t triangles) {
    const auto [place, is_new] = label_numbers_.try_emplace({up, down}, labels_.size());
    if (is_new) labels_.push_back({surface, up, down, std::vector<char>(triangles, 0)});
    labels_[place->second].surface = std::min(labels_[place->second].surface, surface);
    return place->second;
  }

  Face owner(const Cell& cell, bool is_up, const FlatPoint3& at) const {
    const bool is_covered = is_up ? cell.is_covered_up : cell.is_covered_down;
    const bool is_behind_covered = is_up ? cell.is_covered_down : cell.is_covered_up;
    const auto is_behind = [&](std::uint32_t group) {
      const ClosedMesh3* mesh = solids_.mesh_of(group);
      return mesh != nullptr && solids_.is_behind({&frame_, at, !is_up}, *mesh);
    };
    const bool lies_on_solid = is_behind_covered && has_material_on(scene_, patches_, cell.sources, !is_up, is_behind);
    const SideOwner3 side = owner_of_side(scene_, patches_, cell.sources, is_up,
                                          [&](std::uint32_t group) { return lies_on_solid && is_behind(group); });
    if (side.rival && !is_covered) refuse(side, frame_.point(at));
    return side.owner;
  }

  [[noreturn]] void refuse(const SideOwner3& side, const Point3& at) const {
    const auto told = [this](const Face& face) {
      return quoted_name(scene_.surfaces[face.surface].name) + " (" + (face.is_back ? "back" : "front") + ")";
    };
    const auto material = [this](const Face& face) {
      return quoted_name(scene_.materials[*scene_.surfaces[face.surface].material_of(face.is_back)].name);
    };
    const auto area = [this](const Face& face) -> Rational {
      const Vector3 normal = doubled_area(scene_.polygons[face.surface]);
      return dot(normal, normal);
    };
    const bool is_owner_smaller = area(side.owner) < area(*side.rival);
    throw InputError(
        place_of(scene_, scene_.surfaces[side.rival->surface]),
        told(side.owner) + " and " + told(*side.rival) +
            " claim the same side with different materials: they overlap around " + place_text(at),
        {"materials " + material(side.owner) + " and " + material(*side.rival),
         "give both the same material, or take one of the surfaces away",
         is_owner_smaller ? patch_hint(scene_, side.owner, *side.rival) : patch_hint(scene_, *side.rival, side.owner)});
  }

  void refuse_misplaced_masks(const std::vector<PlaceSource3>& sources, const std::function<Point3()>& place) const {
    const std::optional<MisplacedMask3> wrong = misplaced_mask(scene_, patches_, sources);
    if (!wrong) return;
    const auto name = [this](std::uint32_t surface) { return quoted_name(scene_.surfaces[surface].name); };
    const auto [mask, other] = *wrong;
    const std::uint32_t told = other.value_or(mask.surface);
    if (other && patches_.rests_on(told, mask.base))
      throw InputError(place_of(scene_, scene_.surfaces[told]),
                       name(mask.surface) + " masks " + name(mask.base) + " where " + name(told) +
                           " lies on it, around " + place_text(place()),
                       {"a mask sees what it masks alone: move one of the two"});
    throw InputError(place_of(scene_, scene_.surfaces[told]),
                     other ? name(told) + " and " + name(mask.surface) + " mask the same place of " + name(mask.base) +
                                 ", around " + place_text(place())
                           : name(told) + " is not within " + name(mask.base) + ", which it masks: around " +
                                 place_text(place()) + " there is nothing of that");
  }

  void make_pieces(const PlaneTriangulation3& triangulation, const Label& label) {
    const Member& member = cluster_.member(label.surface);
    std::vector<MadePiece> pieces;
    const std::vector<std::uint32_t> sources = common_sources(label);
    if (keeps_all(label, member)) {
      for (Piece3& piece : whole_pieces(member)) pieces.push_back({std::move(piece), sources});
    } else {
      for (const Flat& part : convex_pieces(region_of(triangulation, label.is_in)))
        pieces.push_back({{to_polygon(part, member.is_front_up),
                           label.surface,
                           false,
                           {Piece3::Side{member.is_front_up ? label.up : label.down},
                            Piece3::Side{member.is_front_up ? label.down : label.up}}},
                          sources});
    }
    for (const bool is_back : {false, true}) cover(triangulation, label, member, is_back, pieces);
    for (MadePiece& piece : pieces) made_.push_back(std::move(piece));
  }

  // Whether a polygon has all of its place, and both sides of it.
  bool keeps_all(const Label& label, const Member& member) const {
    if (!(label.up == Face{member.surface, !member.is_front_up} &&
          label.down == Face{member.surface, member.is_front_up}))
      return false;
    for (std::size_t t = 0; t < cell_of_.size(); ++t) {
      if (cell_of_[t] == PlaneTriangulation3::kNone || label.is_in[t] != 0) continue;
      const auto& sources = cells_[cell_of_[t]].sources;
      if (std::any_of(sources.begin(), sources.end(),
                      [&](const PlaceSource3& source) { return source.surface == member.surface; }))
        return false;
    }
    return true;
  }

  std::vector<std::uint32_t> common_sources(const Label& label) const {
    std::vector<std::uint32_t> result;
    bool is_first = true;
    for (const Cell& cell : cells_) {
      if (&labels_[cell.label] != &label) continue;
      std::vector<std::uint32_t> here, both;
      for (const PlaceSource3& source : cell.sources) here.push_back(source.surface);
      std::set_intersection(result.begin(), result.end(), here.begin(), here.end(), std::back_inserter(both));
      result = is_first ? here : both;
      is_first = false;
    }
    return result;
  }

  // Sets what is covered of a side of the pieces of a label.
  void cover(const PlaneTriangulation3& triangulation, const Label& label, const Member& member, bool is_back,
             std::vector<MadePiece>& pieces) const {
    const bool is_up = member.is_front_up != is_back;
    std::vector<char> is_free = label.is_in;
    bool has_free = false, has_covered = false;
    for (std::size_t t = 0; t < is_free.size(); ++t) {
      if (is_free[t] == 0) continue;
      const Cell& cell = cells_[cell_of_[t]];
      const bool is_covered = is_up ? cell.is_covered_up : cell.is_covered_down;
      (is_covered ? has_covered : has_free) = true;
      if (is_covered) is_free[t] = 0;
    }
    if (!has_covered) return;
    const auto free = has_free ? convex_pieces(region_of(triangulation, is_free)) : std::vector<Flat>();
    for (MadePiece& made : pieces) {
      const Flat flat = frame_.outline(made.piece.polygon.points);
      Piece3::Side& side = made.piece.sides[is_back ? 1 : 0];
      Rational area;
      for (const Flat& part : free) {
        const Flat common = common_part(part, flat);
        if (common.empty()) continue;
        area += doubled_area(common);
        side.free.push_back(to_polygon(common, member.is_front_up));
      }
      side.cover = side.free.empty() ? Cover::kCovered : area == doubled_area(flat) ? Cover::kFree : Cover::kPartly;
      if (side.cover == Cover::kFree) side.free.clear();
    }
  }

  const Scene3& scene_;
  const PatchBases& patches_;
  const Solids3& solids_;
  const CoplanarCluster3& cluster_;
  const PlaneFrame3& frame_;
  std::vector<FlatSegment3> cuts_;
  std::vector<Cell> cells_;
  std::vector<std::uint32_t> cell_of_;  // by triangle
  std::vector<Label> labels_;
  std::map<std::pair<Face, Face>, std::size_t> label_numbers_;
  std::vector<MadePiece> made_;
};

// Facets become the surfaces that they are of.
void rename(MadePiece& made, const Scene3& scene, const std::vector<std::uint32_t>& surface_of) {
  Piece3& piece = made.piece;
  piece.surface = surface_of[piece.surface];
  piece.is_whole = piece.is_whole && !scene.polygons[piece.surface].is_nearly_plane;
  for (Piece3::Side& side : piece.sides) side.owner.surface = surface_of[side.owner.surface];
  for (std::uint32_t& source : made.sources) source = surface_of[source];
  made.sources.erase(std::unique(made.sources.begin(), made.sources.end()), made.sources.end());
}

}  // namespace

Arrangement3::Arrangement3(const Scene3& scene) : solids_(scene) {
  const std::optional<FacetScene3> facets = facet_scene(scene);
  const Scene3& plane = facets ? facets->scene : scene;
  const PatchBases patches(plane);
  std::vector<MadePiece> made;
  for (const CoplanarCluster3& cluster : coplanar_clusters(plane.polygons))
    for (MadePiece& piece : ClusterPieces(plane, patches, solids_, cluster).make()) made.push_back(std::move(piece));
  if (facets)
    for (MadePiece& piece : made) rename(piece, scene, facets->surface_of);
  std::stable_sort(made.begin(), made.end(),
                   [](const MadePiece& a, const MadePiece& b) { return a.piece.surface < b.piece.surface; });
  std::vector<std::vector<std::uint32_t>> sources;
  for (MadePiece& m : made) {
    const Piece3& p = m.piece;
    is_plain_ = is_plain_ && p.is_whole && p.surface == pieces_.size() && m.sources.size() == 1 &&
                p.sides[0].cover == Cover::kFree && p.sides[1].cover == Cover::kFree;
    pieces_.push_back(std::move(m.piece));
    sources.push_back(std::move(m.sources));
  }
  is_plain_ = is_plain_ && pieces_.size() == scene.polygons.size();
  index(scene.polygons.size(), std::move(sources));
}

void Arrangement3::index(std::size_t surfaces, std::vector<std::vector<std::uint32_t>> sources) {
  std::vector<std::vector<PieceSide3>> of_face(2 * surfaces);
  on_surface_.resize(surfaces);
  for (std::uint32_t p = 0; p < pieces_.size(); ++p) {
    std::vector<std::uint32_t>& on = sources[p];
    for (const bool is_back : {false, true}) {
      const Face& owner = pieces_[p].side(is_back).owner;
      of_face[owner.number()].push_back({p, is_back});
      on.push_back(owner.surface);
    }
    std::sort(on.begin(), on.end());
    on.erase(std::unique(on.begin(), on.end()), on.end());
    for (const std::uint32_t s : on) on_surface_[s].push_back(p);
  }
  begin_.push_back(0);
  for (const auto& sides : of_face) {
    sides_.insert(sides_.end(), sides.begin(), sides.end());
    begin_.push_back(sides_.size());
  }
}

std::vector<Polygon3> Arrangement3::polygons() const {
  std::vector<Polygon3> result;
  result.reserve(pieces_.size());
  for (const Piece3& piece : pieces_) result.push_back(piece.polygon);
  return result;
}

}  // namespace hottel
