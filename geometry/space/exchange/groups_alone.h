// What elements of several patches exchange when everything else is taken away.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "geometry/space/arrangement/surface_boxes.h"
#include "geometry/space/exchange/pair_shares.h"
#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"

namespace hottel {

// S0 of pairs of elements: their S in a scene that keeps only the pieces on their own surfaces, opaque on both sides
// and without what is covered. Of a group the scene keeps all members, of an element its whole polygon. A single convex
// polygon hides nothing of itself; several may.
//
// REQUIRES: the scene and the table outlive this.
// For several threads at once.
class GroupsAlone3 {
 public:
  GroupsAlone3(const PreparedScene3& prepared, const ElementTable3& table, double tolerance);

  // Returns true only where nothing but their own pieces hides any part of i from j: S = S0, proven.
  // COST: some 10 microseconds for each pair of members; where others may stand between, a pair is measured among
  // these.
  bool is_undisturbed(std::uint32_t i, std::uint32_t j) const;

  // S0, in the unit of the scene's PairIntegrator3: value, estimated error and proven bounds.
  struct Measure {
    double value = 0, error = 0;
    Enclosure bounds{0, 0};
  };

  // Throws RequestError where a pair of members cannot be measured. COST: that of each pair of members.
  Measure measure(std::uint32_t i, std::uint32_t j) const;

 private:
  using Part = ElementTable3::Part;

  // All pieces on the surfaces of both, ascending.
  std::vector<std::uint32_t> pieces_of(std::uint32_t i, std::uint32_t j) const;
  bool is_undisturbed(const Part& a, const Part& b, std::span<const std::uint32_t> own) const;
  [[noreturn]] void refuse(std::uint32_t i, std::uint32_t j, const std::string& problem) const;
  template <class Visit>
  bool for_each_facing(std::uint32_t i, std::uint32_t j, const Visit& visit) const;

  const PreparedScene3& prepared_;
  const ElementTable3& table_;
  const SurfaceBoxes3 boxes_;
  const PairShares3 shares_;
  std::vector<std::vector<std::uint32_t>> members_;  // surfaces by group
};

}  // namespace hottel
