// Which column of a row of light each side of each piece belongs to.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/plane/prepared/element_table.h"

namespace hottel {

// The columns of rows of light (light_row.h): the elements of a table in their order, then the sky.
//
//   (1) every side has the column of the element that owns it, unless it looks into a solid: then it has none
//   (2) an element without a material is black: it sends out nothing
// COST: linear in the sides of pieces.
class LightColumns2 {
 public:
  LightColumns2(const Arrangement2& arrangement, const ElementTable2& table);

  std::uint32_t sky() const { return sky_; }
  std::uint32_t count() const { return sky_ + 1; }

  // A column, and in the same number whether it is black, as it is looked up for each step around a point.
  class Code {
   public:
    std::uint32_t column() const { return bits_ & ~kBlack; }  // REQUIRES: not covered
    bool is_black() const { return (bits_ & kBlack) != 0; }   // or covered
    bool is_covered() const { return bits_ == kCovered; }
    friend bool operator==(const Code&, const Code&) = default;

   private:
    friend class LightColumns2;
    static constexpr std::uint32_t kBlack = 0x80000000, kCovered = 0xffffffff;
    std::uint32_t bits_ = kCovered;
  };
  // Of a side, or of kSky. REQUIRES: not kNoPiece.
  Code of(PieceSideId side) const { return of_side_[place_after_sky(side)]; }

 private:
  std::uint32_t sky_;
  std::vector<Code> of_side_;  // by place_after_sky
};

}  // namespace hottel
