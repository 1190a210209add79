// What two labels exchange when everything else is taken away: S0, the measure that Vis compares with.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "kernel/root_sum.h"
#include "kernel/rounding.h"

namespace hottel {

// S0(i, j) is the direct exchange area in the arrangement of which only the pieces on surfaces of i or j are kept: all
// members of a group, the whole edge of an element. They stay opaque on both sides; what neither i nor j owns is
// black, and nothing is given back: neither claims nor what a solid covers.
//
//   (1) two straight edges hide nothing of each other: S0 of faces and elements, and of groups of one edge each, is
//       the sum of Hottel's crossed strings over their runs
//   (2) S(i, j) <= S0(i, j), and S0 is symmetric
//   (3) nothing is kept from one question to the next: any number of threads may ask
class PairsAlone2 {
 public:
  // REQUIRES that both outlive this, and labels by `per`.
  PairsAlone2(const PreparedScene2& prepared, const ElementTable2& table, Granularity granularity);

  // 2 S0(i, j) in fixed point. Nothing where only the exact form knows it: where two runs cross, or members of a group
  // may hide something.
  std::optional<FixedSum> quick(std::uint32_t i, std::uint32_t j) const;

  // S0(i, j) in scene units. COST: four distances a pair of runs; for groups of several edges an arrangement of their
  // pieces and the gaps in it.
  RootSum exact(std::uint32_t i, std::uint32_t j) const;

  // True iff S0(i, j) > 0, decided without lengths where the edges are straight.
  bool is_positive(std::uint32_t i, std::uint32_t j) const;

  // F0(i, j) = S0(i, j) / A_i, correctly rounded; 0 when they do not face each other. REQUIRES a row for i.
  double factor(std::uint32_t i, std::uint32_t j) const;

  // True iff property (1) tells S0 of the two.
  bool are_straight(std::uint32_t i, std::uint32_t j) const { return is_straight(i) && is_straight(j); }

 private:
  std::uint32_t group_of(std::uint32_t label) const {
    return prepared_.scene.surfaces[table_.elements()[label].surface].group;
  }
  bool is_straight(std::uint32_t label) const { return pieces_of_.empty() || size_[group_of(label)] == 1; }
  bool have_facing_runs(std::uint32_t i, std::uint32_t j) const;

  const PreparedScene2& prepared_;
  const ElementTable2& table_;
  std::vector<std::size_t> size_;                      // surfaces by group
  std::vector<std::vector<std::uint32_t>> pieces_of_;  // by group, ascending; empty unless labels are groups
};

}  // namespace hottel
