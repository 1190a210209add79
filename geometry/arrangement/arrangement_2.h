// The scene as pieces that meet in end points only, each side with its owner.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/arrangement/claims_2.h"
#include "geometry/arrangement/overlay_2.h"
#include "geometry/arrangement/triangulation_2.h"
#include "geometry/scene/scene_2.h"

namespace hottel {

// How many equal parts each surface is cut into.
using Division = std::vector<std::uint32_t>;

// The scene after overlay: every piece side belongs to exactly one side of one surface.
//
//   (1) each side of a piece takes the claims made on it: a front claims for its material, a back only when it has
//       one; no claim: the black back of the first listed surface there; one: that face; several with equal material:
//       the first listed surface
//   (2) pieces, vertices and owners do not depend on how the pieces were found
class Arrangement2 {
 public:
  // Throws InputError naming both surfaces, the side and the piece when claims with different materials meet.
  Arrangement2(const Scene2& scene, const Division& division);

  const Vertices2& vertices() const { return overlay_.vertices; }
  const std::vector<Segment2>& pieces() const { return overlay_.pieces; }
  const Triangulation2& triangulation() const { return triangulation_; }
  const FacePart& owner(PieceSideId side) const { return owner_[static_cast<std::size_t>(side)]; }
  std::size_t side_count() const { return owner_.size(); }

  // Input segments that cover a piece, in the order of the scene.
  std::vector<PieceSource2> sources(std::size_t piece) const;

 private:
  void assign_owners(const Scene2& scene);

  Overlay2 overlay_;
  std::vector<Segment2> segments_;      // input of the overlay
  std::vector<FacePart> segment_part_;  // surface and part of each
  std::vector<FacePart> owner_;         // by piece side
  Triangulation2 triangulation_;
};

}  // namespace hottel
