// Which rows of a matrix of view factors are asked for.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/element.h"
#include "geometry/scene_table.h"

namespace hottel {

// A choice of rows, by sides and surfaces.
//
//   (1) the default chooses every row; equal choices choose the same
//   (2) it chooses all elements of a face or none
class RowChoice {
 public:
  RowChoice() = default;
  // Returns the choice that a word makes of the rows of a scene.
  //
  //   (3) "fronts": all but backs
  //   (4) NAME or a pattern: both sides of the surfaces that surfaces_matching() finds; with ":back" at its end only
  //       their backs. Of groups: those that have such a surface
  //
  // Throws UnknownName where no surface matches. COST: linear in the surfaces.
  static RowChoice of(const SceneTable& scene, const std::string& word, Granularity granularity);

  // The fronts of some surfaces. REQUIRES that there are some, and that they ascend.
  static RowChoice fronts_of(std::vector<std::uint32_t> surfaces);

  bool is_all() const { return sides_ == Sides::kBoth && surfaces_.empty(); }
  bool has(const Element& element) const;
  // The elements that are chosen, ascending.
  std::vector<std::uint32_t> labels(const std::vector<Element>& elements) const;

  friend bool operator==(const RowChoice&, const RowChoice&) = default;

 private:
  enum class Sides : unsigned char { kBoth, kFronts, kBacks };

  Sides sides_ = Sides::kBoth;
  std::vector<std::uint32_t> surfaces_;  // ascending; empty: all
};

}  // namespace hottel
