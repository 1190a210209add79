// What must hold of a scene, whatever touches what.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/plane/exchange/exchange.h"
#include "tests/storm/plane/numbers.h"

namespace hottel::storm {

// A scene under test, with what is computed of it once.
class Subject {
 public:
  // `chance` is what laws draw from: a permutation, a place to cut.
  Subject(const Edges& edges, std::uint64_t chance);

  const Edges& edges() const { return edges_; }
  std::uint64_t chance() const { return chance_; }
  const ExchangeMatrix& matrix() const { return matrix_; }
  const ExchangeReport& report() const { return report_; }
  const Numbers& numbers() const { return numbers_; }

 private:
  Edges edges_;
  std::uint64_t chance_;
  ExchangeReport report_;
  ExchangeMatrix matrix_;
  Numbers numbers_;
};

// A law, with how to tell where it is broken.
struct Law {
  const char* name;
  std::string (*broken)(const Subject& subject);  // what is wrong, or nothing
  unsigned every;  // tried in one of so many scenes; prime to 3 and 5, by which walls and lattices are drawn
};

// The laws, in order.
//
//   closure       sum over j of 2 S(i, j) = 2 A_i as an identity of integers, in every row
//   range         0 < F <= 1, 0 < Vis <= 1, rows of doubles sum to 1 within rounding
//   symmetry      S(i, j) and Vis(i, j) are S(j, i) and Vis(j, i) of the edges in reverse order, bit for bit, where
//                 each pair is computed the other way round
//   translation   all doubles are the same for x + 2^53 + 1, y - 2^60 + 7
//   scaling       all doubles are the same for 2^20 x
//   rotation      by 90 degrees
//   reflection    about the y axis, edges listed from the other end
//   reversal      each edge with two materials listed from the other end: fronts and backs change places
//   permutation   in another order: between faces that overlap no other edge nothing changes
//   splitting     an edge cut in its middle: S of its parts adds up to S, as exact sums
//   many digits   all doubles are the same under a similarity with numbers of 30 to 120 digits; under an affine map
//                 with such numbers the same pairs see each other, and the same wholly
//   elements      S of elements adds up to S of faces, as exact sums, and their doubles as far as they are rounded
//   convex room   the hull of the ends, its walls divided: all doubles are the same without a look at occlusion, for
//                 faces and elements, with few digits and many
//   radiosity     the true radiosities, to 100 digits, lie within their bounds
//   brute force   every pair is the same exact sum, every double the nearest one, as the oracle has it; Vis too
//   owners        of the scene and of one with other materials and other things behind: refused by both for the same
//                 reason, or every side of every piece has the same owner or looks into a solid, as the oracle has it
//   groups        rows of groups close to the last bit, 0 < F <= 1, 0 < Vis <= 1; a pair of groups sees each other iff
//                 some of their faces do; groups of one edge have the doubles of their faces; all doubles are the same
//                 for x + 2^53 + 1, y - 2^60 + 7
//   cut by hand   the scene with every surface replaced by those parts of its sides that it owns and no solid covers,
//                 one edge for each side of each piece: all doubles of faces are those of the groups of these edges
//   brute force, elements    the same of scenes whose edges are divided
//   brute force, groups      the same of groups; and of what exchanges nothing but would alone
//   repair        of the scene, its ends nudged or not: check finds no more in the repaired one than before, and to
//                 repair that once more changes nothing
const std::vector<Law>& laws();

}  // namespace hottel::storm
