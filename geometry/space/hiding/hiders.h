// What hides whole patches from each other at once. Internal to geometry/space.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "geometry/space/arrangement/occluders.h"
#include "geometry/space/arrangement/patch.h"
#include "geometry/space/hiding/convex_bodies.h"
#include "geometry/space/visibility/direction.h"

namespace hottel {

// A patch in doubles of Vertices3, each off by at most 2^-50 of the largest coordinate. `patch` must outlive it.
struct PlacedPatch3 {
  const Patch3* patch;
  std::vector<Direction3> corners;
  Direction3 normal;     // the unit normal of its front
  double size = 0;       // the largest coordinate
  bool is_told = false;  // else its numbers are beyond doubles, and nothing is proven of it
};

// Convex bodies, and surfaces that belong to none, as what hides.
//
// Two patches are hidden from each other where every line from the front of one to the front of the other meets a
// surface between its ends: all but lines that together have no measure.
//
// How it is proven. The points that an open convex set hides from a point are convex, together with the set. So if all
// lines from corners of a convex patch to corners of another one meet it, all lines between both patches do. Where
// a body does not hide both patches as they are, the longer one is halved, and so on; the search ends where the line
// between two middles is free. That lines meet the inside of a body is told by a place on each of them that is deeper
// in it than doubles may be off. From there a body hides
//   - if both patches are on the inner side of the lid, and one of them is outside one of the other planes: then lines
//     come in through a surface, even where they pass the lid's plane before they meet the body. The lid bounds nothing
//   - or if each patch is outside some plane, the lid's among them: then lines come in and go out, and not both through
//     the lid
//   - and at once, without any doubles, if one patch is within the body, looking in, and the other one outside a plane.
// A surface of no body hides where one patch is before it and the other one behind, and lines of corners pass within
// it; of what is never first, those that touch its border may be among them, by exact signs.
//
//   (1) what it says is hidden is: a proof. What it does not may be hidden too
//   (2) whether is_never_first(i, k) depends on i and the surfaces alone. All surfaces that are never first from i may
//       be left out together: what a line from i meets first stays
//
// For several threads at once. COST: some microseconds a question.
class Hiders3 {
 public:
  static constexpr int kMostQuestions = 1000;

  // REQUIRES: the occluders outlive this, and no two of them share an area of one plane.
  explicit Hiders3(const Occluders3& occluders);
  ~Hiders3();

  PlacedPatch3 placed(const Patch3& patch) const;

  // Whether it is proven that the front of one patch and the front of the other one are hidden from each other.
  // `most`: so many pairs of parts of the patches are asked about. COST: a microsecond each.
  bool hide(const PlacedPatch3& i, const PlacedPatch3& j, int most = kMostQuestions) const;
  // Whether it is proven that all lines from the front of a patch that meet a surface, on whichever side, meet another
  // one before, but for lines that together have no measure. REQUIRES: it is not the surface of the patch.
  bool is_never_first(const PlacedPatch3& i, std::uint32_t surface) const;

  const ConvexBodies3& bodies() const { return bodies_; }

 private:
  class Proof;
  struct Body;
  struct Flat;
  struct Tree;

  const Occluders3& occluders_;
  ConvexBodies3 bodies_;
  std::unique_ptr<const Tree> tree_;
};

// The surfaces that are never first from one patch, each asked once. For one thread at a time.
class FirstMet3 {
 public:
  FirstMet3(const Hiders3& hiders, const Patch3& patch, std::size_t surfaces);
  FirstMet3(const FirstMet3&) = delete;  // `placed` points to the patch
  FirstMet3& operator=(const FirstMet3&) = delete;

  const Hiders3& hiders() const { return hiders_; }
  const Patch3& patch() const { return patch_; }
  const PlacedPatch3& placed() const { return placed_; }
  // False of the surface of the patch.
  bool is_never_first(std::uint32_t surface);

 private:
  enum class Known : unsigned char { kNothing, kMayBeFirst, kNeverFirst };

  const Hiders3& hiders_;
  const Patch3 patch_;
  const PlacedPatch3 placed_;
  std::vector<Known> known_;
};

}  // namespace hottel
