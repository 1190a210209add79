// What "behind": "solid" would do for a back without a material.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "geometry/plane/arrangement/free_regions.h"
#include "geometry/plane/prepared/prepared_scene.h"

namespace hottel {

// The regions that would become solid, and what light would lose by it.
struct BehindRemedy2 {
  std::vector<std::uint32_t> free_regions;  // ascending
  std::vector<Face> swallows;               // faces with a material that would be covered wholly, ascending
  bool emits = false;                       // some face with a material that looks into the regions does
};

// Remedies for the black backs of a scene.
//
//   (1) a back has one iff the scene is accepted with "behind": "solid" for its group, and the solid would cover all
//       of the back
//   (2) backs whose groups would make the same regions solid have the same remedy, one object
//
// REQUIRES: the scene and its regions outlive it. of() keeps what it found: only one thread may call it at a time.
// COST: linear in the sides of pieces; then linear in those around the regions, once for each set of regions.
class BehindRemedies2 {
 public:
  // REQUIRES the regions of the scene's arrangement.
  BehindRemedies2(const PreparedScene2& prepared, const FreeRegions2& free_regions);

  // The remedy for the back of a surface; nothing where there is none. Valid as long as this object.
  const BehindRemedy2* of(std::uint32_t surface);

  // Returns whether all of a face looks into some regions (ascending).
  bool is_within(const Face& face, const std::vector<std::uint32_t>& free_regions) const;

 private:
  BehindRemedy2 remedy(const std::vector<std::uint32_t>& free_regions) const;

  const PreparedScene2& prepared_;
  const FreeRegions2& free_regions_;
  std::vector<std::vector<std::uint32_t>> regions_;        // by group
  std::vector<std::vector<std::uint32_t>> cells_of_face_;  // by Face::number(), ascending: where it owns a side
  std::map<std::vector<std::uint32_t>, BehindRemedy2> known_;
};

}  // namespace hottel
