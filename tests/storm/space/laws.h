// What must hold of a pair of polygons of space, whatever stands between them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/comparison/space/pair_scene.h"
#include "tests/oracle/space/pair_rays.h"
#include "tests/storm/space/lattice_scene.h"

namespace hottel::storm {

// A scene under test, with the measure of polygons 0 and 1.
class Subject3 {
 public:
  // `chance` is what laws draw from: an order, a place to cut.
  Subject3(Polygons3 polygons, std::uint64_t chance);

  const Polygons3& polygons() const { return polygons_; }
  std::uint64_t chance() const { return chance_; }
  const oracle::PairScene3& scene() const { return scene_; }
  const Patch3& i() const { return i_; }
  const Patch3& j() const { return j_; }
  const PairResult3& measure() const { return measure_; }
  double area() const { return area_; }  // of the smaller one
  // What is asked for where the smaller area is this: 1e-12, or as far as doubles go.
  double tolerance(double area) const;
  double slack() const { return tolerance(area_) * area_; }
  double unobstructed() const { return unobstructed_; }

 private:
  Polygons3 polygons_;
  std::uint64_t chance_;
  oracle::PairScene3 scene_;
  Patch3 i_, j_;
  double area_, square_;
  PairResult3 measure_;
  double unobstructed_;
};

// A law, with how to tell where it is broken.
struct Law3 {
  const char* name;
  std::string (*broken)(const Subject3& subject);  // what is wrong, or nothing
  unsigned every;  // tried in one of so many scenes; prime to 5, by which scenes are nudged
};

// The laws, in order. Measures are asked for within A = 1e-12 of the smaller area, or as far as doubles go where that
// is too much for them; two that are the same are compared within 2 A, and their bounds have a number in common.
//
//   answer          the pair has no problem; residual and error are within their bounds, bounds enclose the measure,
//                   0 <= S <= S0, hidden is 0 exactly
//   whole           S = S0 within A where nothing is hidden; else S is below S0, and by more than rounding where all is
//                   on the lattice
//   origin          S is the same for other origins of moments
//   reversal        S is the same from j to i, and with both patches exchanged
//   along edges     S and its verdicts are the same where also what is clear is settled along edges
//   loose           S asked for within 1e-9 and 1e-6 is within its stated error; is_whole and S = 0 are the same
//   proven          bounds proven within 1e-7 and 1e-10, from i to j, and from j to i about another origin, hold S
//   stated          bounds proven within 1e-9 hold S, give or take the error that its rules state, rounding included,
//                   and are as narrow as that but where doubles do not go as far as 1e-12
//   rays            S is within six standard errors of what rays find; they find nothing where S = 0, and nothing held
//                   up where all is seen
//   quadrature      S is what quadrature over points of i and over points of j find, within their errors, where they
//                   agree; of small scenes
//   translation     all doubles are the same for x + 2^53 + 1, y - 2^60 + 7, z + 1/3
//   scaling         all doubles are the same for 2^20 x, and for 3/7 x but for the unit
//   axes            S is the same for the axes in other order, and reflected
//   rotation        S is the same in a frame turned by angles of 3-4-5 and 5-12-13, and by others of many digits
//   order           S is the same for others in another order, that begin elsewhere and face the other way
//   cut             S is the same where one between is cut in two through its corners or sides
//   fewer           S is not smaller without one between
//   nudge           where corners between move by 2^-8 to 2^-67, S changes by no more than their sides can sweep over,
//                   and is the same from j to i
//   elements        the measures of the quarters of i sum to S; and of j
//   quarters        the measures of all quarters of i to all quarters of j sum to S
//   closure         the measures of i to all sides of all polygons and to the sky, near or far, sum to its area
const std::vector<Law3>& laws_3();

}  // namespace hottel::storm
