// What each side of each piece of a scene sends out, as one looks it up; equal ones are one shade.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/plane/arrangement/arrangement.h"
#include "geometry/plane/prepared/element_table.h"

namespace hottel {

// Radiosity by piece side, per channel, and the emission of the sky.              [unit: that of radiosity]
//
//   (1) a side sends out what the element that owns it sends out; a black back or what looks into a solid nothing
//   (2) two sides have the same shade exactly when they send out the same in every channel; shade 0 is black. What
//       looks into a solid has a shade of its own
class FaceRadiosity2 {
 public:
  // by_element: channels values for each of labels.elements(), in their order (that of ExchangeMatrix::elements());
  // those of black backs are not looked at. sky: one value per channel.
  // REQUIRES at least one channel, and as many values; throws ContractViolation otherwise.
  FaceRadiosity2(const Arrangement2& arrangement, const ElementTable2& table, std::span<const double> by_element,
                 std::span<const double> sky);

  std::uint32_t channels() const { return channels_; }
  bool is_covered(PieceSideId side) const { return shade(side) == covered_; }            // does it look into a solid?
  std::uint32_t shade(PieceSideId side) const { return shade_[place_after_sky(side)]; }  // kSky too
  // What a shade, or a side of a piece, sends out in each channel.
  std::span<const double> of_shade(std::uint32_t shade) const {
    return {values_.data() + std::size_t{shade} * channels_, channels_};
  }
  std::span<const double> of(PieceSideId side) const { return of_shade(shade(side)); }

 private:
  std::uint32_t channels_, covered_;
  std::vector<std::uint32_t> shade_;  // by place_after_sky
  std::vector<double> values_;        // by shade and channel
};

}  // namespace hottel
