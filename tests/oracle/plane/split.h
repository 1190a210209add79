// Arbitrary segments cut where they meet, what looks into a solid found, and the claims on each piece settled: all
// pairs, over rationals.
#pragma once

#include <gmpxx.h>

#include <vector>

#include "tests/oracle/plane/brute_force.h"
#include "tests/oracle/plane/input_segment.h"
#include "tests/oracle/plane/solids.h"

namespace hottel::oracle {

inline int front_label(std::size_t edge) { return static_cast<int>(2 * edge); }
inline int back_label(std::size_t edge) { return static_cast<int>(2 * edge + 1); }
inline constexpr int kCovered = -2;  // the label of sides that look into a solid

// Two faces with different materials that claim the same side of one piece.
struct Conflict {
  int first, second;  // labels; the first is listed earlier
  mpq_class ax, ay, bx, by;
};

struct Split {
  std::vector<Segment> pieces;            // disjoint interiors; labels front_label, back_label of the owning face
  std::vector<std::vector<Lying>> lying;  // by piece: the edges on it, in the order of the list
  std::vector<Conflict> conflicts;        // for each such side: its first claimant with the first that disagrees
  std::vector<std::size_t> unbounded;     // groups that say what is behind them is solid, and nothing is behind them
  std::set<std::pair<std::size_t, std::size_t>> contradictions;  // groups that say solid and open of one region
  std::size_t silent_fronts = 0;                                 // fronts of solids that make no claim
  bool has_room = false;                                         // a room in a solid

  bool is_refused() const { return !conflicts.empty() || !unbounded.empty() || !contradictions.empty(); }
};

// What of it does not depend on materials, nor on what is said to be behind: edges with other ones may share it.
struct Cut {
  std::vector<Stretch> pieces;
  std::vector<std::vector<Lying>> lying;
  Regions regions;  // none where no group of these edges may make anything solid
};

// Cuts the edges at crossings, T-junctions and the ends of overlaps. COST: O(n^2) intersections, O(k^2) for k pieces.
Cut cut(const std::vector<InputSegment>& edges);

// Each side of each piece is covered where it looks into a solid. Where a face with a material is on a covered side and
// a front of the solid on the other, that front makes no claim. All other sides go to one face: with claims, to the
// first listed claimant; without, to the face of the first listed edge there (black).
Split split(const std::vector<InputSegment>& edges, const Cut& cut);
Split split(const std::vector<InputSegment>& edges);

}  // namespace hottel::oracle
