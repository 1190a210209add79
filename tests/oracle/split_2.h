// Arbitrary segments cut where they meet, and the claims on each piece settled: all pairs, over rationals.
#pragma once

#include <gmpxx.h>

#include <vector>

#include "tests/oracle/brute_force_2.h"

namespace hottel::oracle {

// An edge as a scene lists it. Materials are compared by number; none (a black back that claims nothing) is -1.
// REQUIRES: a != b.
struct InputSegment {
  mpq_class ax, ay, bx, by;
  int front_material = 0;  // of the right side of a -> b
  int back_material = -1;
};

inline int front_label(std::size_t edge) { return static_cast<int>(2 * edge); }
inline int back_label(std::size_t edge) { return static_cast<int>(2 * edge + 1); }

// Two faces with different materials that claim the same side of one piece.
struct Conflict {
  int first, second;  // labels; the first is listed earlier
  mpq_class ax, ay, bx, by;
};

struct Split {
  std::vector<Segment> pieces;      // disjoint interiors; labels front_label, back_label of the owning face
  std::vector<Conflict> conflicts;  // for each such side: its first claimant with the first that disagrees
};

// Cuts the edges at crossings, T-junctions and the ends of overlaps, and gives each side of each piece to one face:
// with claims, to the first listed claimant; without, to the face of the first listed edge there (black). COST: O(n^2)
// intersections, O(k log k) for k pieces.
Split split(const std::vector<InputSegment>& edges);

}  // namespace hottel::oracle
