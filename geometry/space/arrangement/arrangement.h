// The scene as convex pieces that share no area, each side with its owner.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/face.h"
#include "geometry/space/arrangement/solids.h"
#include "geometry/space/scene/scene.h"

namespace hottel {

// A convex polygon that hides what is behind it; its front is that of its surface.
struct Piece3 {
  // kFree:    no part of the side looks into a solid
  // kPartly:  some does: `free` is the rest
  // kCovered: all of it does: it belongs to no face
  enum class Cover : unsigned char { kFree, kPartly, kCovered };
  struct Side {
    Face owner;
    Cover cover = Cover::kFree;
    std::vector<Polygon3> free = {};  // of kPartly: convex, fronts as the piece's
  };

  Polygon3 polygon;
  std::uint32_t surface = 0;  // the first listed one there, of those that have it
  bool is_whole = false;      // it is the polygon of that surface, as listed
  std::array<Side, 2> sides;  // front, back

  const Side& side(bool is_back) const { return sides[is_back ? 1 : 0]; }
};

struct PieceSide3 {
  std::uint32_t piece;
  bool is_back;
};

// The scene with its polygons cut into convex pieces, overlaps settled by claims, and solids.
//
//   (1) no two pieces share an area of one plane; together they cover what the polygons cover
//   (2) each side of a place takes the claims made on it there: a front claims for its material, a back only when it
//       has one. None: the black back of the first listed surface; one: that face; several with materials that act
//       alike: the first listed
//   (3) sides that look into a solid are covered: they belong to no face and stay opaque. Where a face with a material
//       looks into a solid and lies on a front of it, that front makes no claim: the other side is of what lies on it
//   (4) a polygon that is convex, loses nothing to others and is nowhere covered is one piece; so is one of which only
//       parts are covered: these are told beside it, for what is within a solid exchanges nothing with what is outside
//   (5) pieces are in the order of their surfaces. Where is_plain(), piece s is polygon s and nothing is covered
//   (6) exact, whatever the coordinates
//   (7) a nearly plane polygon is its facets: pieces are in the planes of these
//   (8) where a mask lies on its base the fronts of both make no claim: they have no side of a piece there
//   (9) a patch wins over what it lies on, the innermost first: that makes no claim where the patch does. A patch has a
//       back only with a material; else what it lies on keeps its own there (PatchBases)
//
// Throws InputError naming both surfaces, the side and a point of the place where claims for different materials meet;
// the mask, its base and a point where it is not within that, or beside another mask.
// SEE: docs/design/space/arrangement.md.
// COST: n log n, some 20 microseconds a polygon; a triangulation of each cluster of polygons that overlap, and of each
// that a solid cuts.
class Arrangement3 {
 public:
  // REQUIRES: a valid scene (validate). It need not outlive this.
  explicit Arrangement3(const Scene3& scene);

  const std::vector<Piece3>& pieces() const { return pieces_; }
  std::vector<Polygon3> polygons() const;  // of all pieces
  const Solids3& solids() const { return solids_; }
  bool is_plain() const { return is_plain_; }

  // The sides of pieces that a face has, covered ones too; pieces ascend.
  std::span<const PieceSide3> sides(const Face& face) const {
    return {sides_.data() + begin_[face.number()], sides_.data() + begin_[face.number() + 1]};
  }
  // The pieces that lie on a surface, ascending: those of its faces, and of what has its place.
  std::span<const std::uint32_t> pieces_on(std::uint32_t surface) const { return on_surface_[surface]; }
  // What is seen where a side of a piece is met: covered sides are told by their owner too.
  const Face& owner(std::uint32_t piece, bool is_back) const { return pieces_[piece].side(is_back).owner; }

 private:
  void index(std::size_t surfaces, std::vector<std::vector<std::uint32_t>> sources);

  std::vector<Piece3> pieces_;
  Solids3 solids_;
  bool is_plain_ = true;
  std::vector<PieceSide3> sides_;   // by face
  std::vector<std::size_t> begin_;  // of a face in sides_
  std::vector<std::vector<std::uint32_t>> on_surface_;
};

}  // namespace hottel
