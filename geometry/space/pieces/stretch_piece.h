// A part of a stretch along which what is seen is bounded by the same arcs. Internal to geometry/space/exchange.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/space/moving/moving_planes.h"
#include "geometry/space/pieces/arc_end.h"
#include "geometry/space/pieces/arc_sum.h"

namespace hottel {

// A part of a stretch along which what is seen is bounded by the same arcs.
//
//   (1) Lambda, the integral of sign times direction over what is seen, is half the sum over arcs of their angle times
//       the unit normal of their plane: analytic in t
//   (2) no arcs: nothing is seen
//   (3) where all corners are close to each other Lambda is summed of differences of their directions: it loses digits
//       with its size, not with the square of it
//   (4) the arcs take most of its memory. They may be given up, and made again of the signature (StretchMapper3)
struct StretchPiece3 {
  using Arc = SeenArc3;
  double low = 0, high = 0, base = 0;           // of t; base: where it was looked
  std::vector<ArcEnd3> signature;               // sorted
  std::vector<unsigned char> packed_signature;  // where arcs were given up: then the signature is empty
  std::vector<MovingVector3> planes, corners;
  std::vector<Arc> arcs;

  // Where a vector that Lambda is made of is nearly zero: at t = `at`, or close to at +- i `width`.
  struct NearZero {
    double at, width;
  };
  std::vector<NearZero> near_zeros;

  // What it takes of memory beside itself, in bytes.
  std::size_t bytes() const;
  // Gives arcs, planes, corners and zeros back, and packs the signature.
  void give_up_arcs();
  void unpack_signature();

  // Sets `turn` of all arcs; returns those of which doubles do not tell it.
  std::vector<std::uint32_t> find_turns();

  // True iff one of these is so close to the interval that rules of few points might not see what it does.
  bool is_steep(double from, double to) const;

  // Lambda at t = from + offset (sum_of_arcs). `rounding`, where it is not null, is raised to what doubles may have
  // lost, at most.
  Direction3 lambda(double from, double offset, double* rounding = nullptr) const;
};

// StretchPiece3::is_steep.
bool is_any_near(const std::vector<StretchPiece3::NearZero>& near_zeros, double from, double to);

}  // namespace hottel
