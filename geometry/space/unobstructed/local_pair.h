// Two patches in coordinates of their own, each without what is behind the other.
#pragma once

#include <array>
#include <span>
#include <utility>
#include <vector>

#include "geometry/space/arrangement/patch.h"
#include "kernel/determinant.h"

namespace hottel {

// a - b. REQUIRES: integers below 2^52, where the error is 0.
BoundedVector bounded_difference_3(const BoundedVector& a, const BoundedVector& b);

// Two patches, ordered, near to the origin.
//
//   (1) pairs (i, j) and (j, i) are the same
//   (2) all coordinates are relative to a point of the pair, and within the precision of doubles they are the same for
//       any translation; they are in units of 2^shift() / weight() of integer form
//   (3) face_each_other(): each of both has a part before the other one; outlines are those parts, exactly
//
// REQUIRES: patches as Patch3 says, that outlive this.
// COST: half a microsecond where all differences of coordinates are below 2^52; a few more where they are not, or where
// a patch has to be cut.
class LocalPair3 {
 public:
  LocalPair3(const Patch3& i, const Patch3& j);

  // A corner of a part, and the edge that begins there.
  struct Corner {
    static constexpr int kCut = -1;

    BoundedVector position;
    int corner = kCut;  // of the patch; kCut: where its outline meets the plane of the other one
    int edge = kCut;    // on the side of the patch that begins at this corner; kCut: along the plane of the other one
    // Where it is a cut, exactly, before the origin is taken away.
    IntegerVector numerator;
    Integer denominator;
  };

  bool face_each_other() const { return face_each_other_; }
  // REQUIRES: they face each other. `side` is 0 or 1.
  const std::vector<Corner>& outline(int side) const { return sides_[side].outline; }
  // Is a corner of a part not where its double is?
  bool has_inexact_cut() const { return has_inexact_cut_; }

  long shift() const { return shift_; }
  const Integer& weight() const { return weight_; }
  // The largest difference of two coordinates.
  double extent() const { return extent_; }

  // All corners of a patch, whether or not they are in front of the other one.
  const std::vector<BoundedVector>& corners(int side) const { return sides_[side].local; }
  // Its normal, of some length, to its front.
  const BoundedVector& normal(int side) const { return sides_[side].normal; }

  // A corner exactly, relative to the origin: the vector over the number, times 2^-shift().
  std::pair<IntegerVector, Integer> exact_position(int side, const Corner& corner) const;
  // Are all coordinates of corners integers below 2^52?
  bool is_small() const { return is_small_; }
  // Are they integers below 2^62, times a power of two?
  bool is_long() const { return is_long_; }

  // Edge k of part 0 and edge m of part 1: are they parallel? Exact.
  bool are_parallel(std::size_t k, std::size_t m) const;
  // Corner k of part 0 and corner m of part 1: are they the same point? Exact.
  bool are_same(std::size_t k, std::size_t m) const;
  // Does corner k of a part lie on edge m of the other one, between its ends? Exact.
  bool is_on(int side, std::size_t k, std::size_t m) const;

 private:
  struct Side {
    std::span<const IntegerVector> exact;  // in units of 1 / weight()
    std::vector<IntegerVector> scaled;     // owns them where the patch has another weight
    std::vector<BoundedVector> local;
    BoundedVector normal;
    std::vector<int> signs;  // of its corners at the plane of the other one
    std::vector<Corner> outline;
    bool is_cut = false;
  };

  void make_small();
  void make_large();
  long move_to_origin(std::array<std::vector<IntegerVector>, 2>& moved);
  void find_extent();
  bool has_front(int side);
  void cut(int side);
  Corner cut_corner(int side, std::size_t from, std::size_t to, const IntegerVector& normal) const;
  IntegerVector exact_normal(int side) const;
  // A corner before the origin is taken away: the vector over the number.
  const IntegerVector& numerator(int side, const Corner& corner) const;
  static Integer denominator(const Corner& corner) { return corner.corner == Corner::kCut ? corner.denominator : 1; }
  // A positive multiple of corner a of one side less corner b of a side.
  IntegerVector exact_difference(int side_a, const Corner& a, int side_b, const Corner& b) const;
  IntegerVector direction(int side, const Corner& corner) const;

  std::array<Side, 2> sides_;
  IntegerVector origin_;
  Integer weight_;
  long shift_ = 0;
  double extent_ = 0;
  bool is_small_ = false, is_long_ = false, face_each_other_ = false, has_inexact_cut_ = false;
};

}  // namespace hottel
