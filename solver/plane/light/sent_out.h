// What the elements of a scene and its sky send out, and the light of what a point sees of them.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/plane/prepared/element_table.h"
#include "solver/plane/light/light_row.h"
#include "solver/radiosity/radiosity.h"

namespace hottel {

// Radiosity by column of a row of light (LightColumns2), per channel.              [unit: that of radiosity]
//
//   (1) black backs send out nothing, whatever is given for them
class SentOut2 {
 public:
  // by_element: channels values for each of table.elements(), in their order (that of ExchangeMatrix::elements()).
  // sky: one value per channel. is_closed: the scene promises to be closed, so that whoever sees no face with a
  // material is outside of it. Throws ContractViolation unless there is at least one channel, and as many values.
  SentOut2(const ElementTable2& table, std::span<const double> by_element, std::span<const double> sky,
           bool is_closed = false);

  std::uint32_t channels() const { return channels_; }
  double of(std::uint32_t column, std::uint32_t channel) const {
    return values_[std::size_t{column} * stride_ + channel];
  }

  // Writes the light of a row: the sum of fraction times radiosity, per channel.
  //
  //   (2) not below the smallest and not above the largest radiosity that is seen: exactly B where everything seen
  //       sends out B, exactly 0 where only what is black is seen
  //   (3) NaN in every channel where the row is in a solid or outside a closed scene, and only there
  //   (4) the same bits whether the row lists what is black or not
  // The real number lies between the two of (2), so that keeping to them brings no error.
  // REQUIRES: finite radiosities; a row of the same table; result has one place per channel. COST: about 1 ns an entry.
  void light(const LightRow2& row, std::span<double> result) const;

 private:
  template <std::size_t kChannels>
  std::array<double, kChannels> light_of(const LightRow2& row, std::size_t channel) const;
  template <std::size_t kChannels>
  void keep_within(const LightRow2& row, std::size_t channel, std::array<double, kChannels>& sum) const;

  bool is_outside(const LightRow2& row) const;

  static constexpr std::uint32_t kPadded = 4;  // places for two to four channels: as many as wide registers hold
  std::uint32_t channels_, stride_;
  std::vector<double> values_;          // by column and channel
  std::vector<bool> is_with_material_;  // by column; of a closed scene
};

// What SentOut2 and FaceRadiosity2 want of a solution: radiosities element-major, channels inside; the sky's emission
// by channel, as the nearest doubles. REQUIRES at least one channel, at most three.
std::vector<double> radiosity_by_element_2(const RadiositySolution& solution);
std::vector<double> sky_by_channel_2(const Spectrum& sky_emission, std::size_t channels);

// Of a solution of a matrix of the table's elements, and the scene's sky and promise.
SentOut2 sent_out_2(const ElementTable2& table, const RadiositySolution& solution, const SceneTable& scene);

}  // namespace hottel
