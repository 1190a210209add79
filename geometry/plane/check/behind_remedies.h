// What "behind": "solid" would do for a back without a material.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "geometry/plane/arrangement/cells.h"
#include "geometry/plane/exchange/exchange.h"

namespace hottel {

// The cells that would become solid, and what light would lose by it.
struct BehindRemedy2 {
  std::vector<std::uint32_t> cells;  // ascending
  std::vector<std::uint32_t>
      swallows;        // faces with a material that would be covered wholly: 2 surface + back, ascending
  bool emits = false;  // some face with a material that looks into the cells does
};

// Remedies for the black backs of a scene.
//
//   (1) a back has one iff the scene is accepted with "behind": "solid" for its group, and all of the back would be
//       covered then
// COST: linear in the sides of pieces; then linear in those around the cells, once for each set of cells.
class BehindRemedies2 {
 public:
  // REQUIRES the cells of the scene's arrangement.
  BehindRemedies2(const PreparedScene2& prepared, const Cells2& cells);

  // The remedy for the back of a surface; nothing where there is none. Valid as long as this object.
  const BehindRemedy2* of(std::uint32_t surface);

  // Returns whether all of a face (2 surface + back) looks into some cells (ascending).
  bool is_within(std::uint32_t face, const std::vector<std::uint32_t>& cells) const;

 private:
  BehindRemedy2 remedy(const std::vector<std::uint32_t>& cells) const;

  const PreparedScene2& prepared_;
  const Cells2& cells_;
  std::vector<std::vector<std::uint32_t>> regions_;        // by group
  std::vector<std::vector<std::uint32_t>> cells_of_face_;  // by 2 surface + back, ascending: where it owns a side
  std::map<std::vector<std::uint32_t>, BehindRemedy2> known_;
};

}  // namespace hottel
