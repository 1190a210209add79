// The scene as pieces that meet in end points only, each side with its owner.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/plane/arrangement/claims.h"
#include "geometry/plane/arrangement/overlay.h"
#include "geometry/plane/arrangement/solids.h"
#include "geometry/plane/arrangement/triangulation.h"
#include "geometry/plane/scene/division.h"
#include "geometry/plane/scene/scene.h"
#include "kernel/support/failure.h"

namespace hottel {

// What becomes of two claims for different materials on one side.
enum class Conflicts2 : bool { kRefused, kFirstWins };

// The scene after overlay: every piece side looks into a solid or belongs to exactly one side of one surface.
//
//   (1) each side of a piece takes the claims made on it: a front claims for its material, a back only when it has
//       one; no claim: the black back of the first listed surface there; one: that face; several with equal material:
//       the first listed surface
//   (2) pieces, vertices and owners do not depend on how the pieces were found
//   (3) sides that look into a solid are covered: they belong to no face and stay opaque. Where a face with a material
//       looks into a solid and lies on a front of it, that front makes no claim: the other side is of what lies on it
//   (4) a patch wins over what it lies on, the innermost first: that makes no claim where the patch does. A patch has a
//       back only with a material; else what it lies on keeps its own there (PatchBases)
//   (5) where surfaces are cut decides nothing of this: pieces of an arrangement that is cut are parts of pieces of the
//       one that is not, and their sides belong to the same faces
class Arrangement2 {
 public:
  // Throws InputError naming both surfaces, the side and the piece when claims with different materials meet and are
  // refused, and for a "behind" that cannot be obeyed (Solids2). Throws ContractViolation unless the division says of
  // each surface where it is cut.
  // REQUIRES: a valid scene (validate). It need not outlive this.
  Arrangement2(const Scene2& scene, const Division2& division, Conflicts2 conflicts = Conflicts2::kRefused);

  // This arrangement, of the same scene, with its surfaces cut: the overlay, what is solid and who owns what are taken
  // over. COST: that of a triangulation. Throws ContractViolation where this one is cut already.
  Arrangement2 cut_into(const Scene2& scene, const Division2& division) const;

  const Vertices2& vertices() const { return overlay_.vertices; }
  // How many of them, the first ones, are ends of surfaces as they were typed; crossings and cuts come after.
  std::size_t typed_points() const { return typed_points_; }
  const std::vector<Segment2>& pieces() const { return overlay_.pieces; }
  const Triangulation2& triangulation() const { return triangulation_; }
  const Solids2& solids() const { return solids_; }
  // The piece of a side, and the same turned so that the side is its right one. REQUIRES: a side, not the sky.
  const Segment2& piece(PieceSideId side) const { return pieces()[piece_of(side)]; }
  Segment2 turned_piece(PieceSideId side) const {
    const Segment2& p = piece(side);
    return is_right(side) ? p : Segment2{p.b, p.a};
  }
  bool is_covered(PieceSideId side) const { return solids_.is_covered(side); }
  // The face that has the side, and the part of it. Throws ContractViolation where the side is covered.
  const FacePart2& owner(PieceSideId side) const {
    HOTTEL_REQUIRE(!is_covered(side));
    return owner_[side.index()];
  }
  // Who gets a side, and who else claims it. Throws ContractViolation where the side is covered. REQUIRES: the scene
  // that this was made of, which must outlive the result.
  SideOwner2 claims(const Scene2& scene, PieceSideId side) const;
  // What the patches of the scene lie on.
  const PatchBases& patches() const { return patches_; }
  std::size_t side_count() const { return owner_.size(); }
  IdRange<PieceSideId> sides() const { return IdRange<PieceSideId>(side_count()); }

  // The vertices where an undivided surface begins and ends; of a divided one, where its first part does. REQUIRES that
  // no surface listed before it is divided.
  const Segment2& segment(std::size_t surface) const { return segments_[surface]; }
  // Input segments that cover a piece, in the order of the scene.
  std::vector<PieceSource2> sources(std::size_t piece) const;

  // What "behind": "solid" would make solid, by group (geometry/plane/arrangement/solids.h). REQUIRES the scene and the
  // free regions of this arrangement.
  std::vector<std::vector<std::uint32_t>> regions_behind(const Scene2& scene, const FreeRegions2& regions) const;

  // The arrangement of some pieces (ascending numbers), which keep their order: the others taken away, nothing given
  // back. Owners are as they were, what was covered stays so, and sources are not known. COST: that of a triangulation
  // of these pieces.
  Arrangement2 restricted_to(const std::vector<std::uint32_t>& pieces) const;

 private:
  Arrangement2() = default;
  void add_segments(const std::vector<std::vector<VertexId>>& ends);
  void find_solids(const Scene2& scene);
  void assign_owners(const Scene2& scene, Conflicts2 conflicts);
  SideOwner2 claims(const Scene2& scene, PieceSideId side, const std::vector<PieceSource2>& covering) const;
  [[noreturn]] void refuse_conflict(const Scene2& scene, PieceSideId side, const SideOwner2& claims) const;

  PatchBases patches_;
  Overlay2 overlay_;
  std::size_t typed_points_ = 0;         // ends of surfaces among the vertices, which come first
  std::vector<Segment2> segments_;       // input of the overlay; where surfaces are cut, their parts
  std::vector<FacePart2> segment_part_;  // surface and part of each
  std::vector<FacePart2> owner_;         // by piece side
  Solids2 solids_;
  Triangulation2 triangulation_;
};

}  // namespace hottel
