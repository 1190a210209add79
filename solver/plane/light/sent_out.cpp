#include "solver/plane/light/sent_out.h"

#include <algorithm>
#include <array>
#include <limits>

#include "kernel/doubles.h"
#include "kernel/support/failure.h"

namespace hottel {

SentOut2::SentOut2(const ElementTable2& table, std::span<const double> by_element, std::span<const double> sky,
                   bool is_closed)
    : channels_(static_cast<std::uint32_t>(sky.size())),
      stride_(channels_ > 1 && channels_ < kPadded ? kPadded : channels_) {
  HOTTEL_REQUIRE(channels_ > 0 && by_element.size() == std::size_t{table.count()} * channels_);
  values_.assign((std::size_t{table.count()} + 1) * stride_, 0.0);
  const auto place = [this](std::uint32_t column) {
    return values_.begin() + static_cast<std::ptrdiff_t>(std::size_t{column} * stride_);
  };
  for (std::uint32_t label = 0; label < table.count(); ++label)
    if (table.elements()[label].material)
      std::ranges::copy(by_element.subspan(std::size_t{label} * channels_, channels_), place(label));
  std::ranges::copy(sky, place(table.sky()));
  if (!is_closed) return;
  for (const Element& element : table.elements()) is_with_material_.push_back(element.material.has_value());
  is_with_material_.push_back(false);  // the sky
}

// Whether the scene is closed, and the row has no face with a material.
bool SentOut2::is_outside(const LightRow2& row) const {
  return !is_with_material_.empty() &&
         std::ranges::none_of(row.columns, [this](std::uint32_t column) { return is_with_material_[column]; });
}

constexpr std::size_t kLookedAt = 4;  // entries, before it is asked whether they are enough

// Sums are between the least and the largest that is seen if they are so for those that are looked at first.
template <std::size_t kChannels>
void SentOut2::keep_within(const LightRow2& row, std::size_t channel, std::array<double, kChannels>& sum) const {
  std::array<double, kChannels> least, most;
  least.fill(row.sees_black ? 0 : kInfinity);
  most.fill(row.sees_black ? 0 : -kInfinity);
  for (std::size_t begin = 0; begin < row.columns.size(); begin += kLookedAt) {
    for (const std::uint32_t column : row.columns.subspan(begin, std::min(kLookedAt, row.columns.size() - begin))) {
      const double* value = values_.data() + std::size_t{column} * stride_ + channel;
      for (std::size_t c = 0; c < kChannels; ++c) {
        least[c] = std::min(least[c], value[c]);
        most[c] = std::max(most[c], value[c]);
      }
    }
    bool are_within = true;
    for (std::size_t c = 0; c < kChannels; ++c) are_within = are_within && least[c] <= sum[c] && sum[c] <= most[c];
    if (are_within) return;
  }
  for (std::size_t c = 0; c < kChannels; ++c) sum[c] = std::clamp(sum[c], least[c], most[c]);
}

template <std::size_t kChannels>
std::array<double, kChannels> SentOut2::light_of(const LightRow2& row, std::size_t channel) const {
  std::array<double, kChannels> sum{};
  for (std::size_t k = 0; k < row.columns.size(); ++k) {
    const double* value = values_.data() + std::size_t{row.columns[k]} * stride_ + channel;
    const double fraction = row.fractions[k];
    for (std::size_t c = 0; c < kChannels; ++c) sum[c] += fraction * value[c];
  }
  keep_within(row, channel, sum);
  return sum;
}

void SentOut2::light(const LightRow2& row, std::span<double> result) const {
  if (row.is_in_solid || is_outside(row)) {
    std::ranges::fill(result, std::numeric_limits<double>::quiet_NaN());
  } else if (stride_ == kPadded) {
    std::copy_n(light_of<kPadded>(row, 0).begin(), channels_, result.begin());
  } else {
    for (std::uint32_t channel = 0; channel < channels_; ++channel) result[channel] = light_of<1>(row, channel)[0];
  }
}

std::vector<double> radiosity_by_element_2(const RadiositySolution& solution) {
  std::vector<double> result;
  for (std::size_t i = 0; i < solution.channels.front().elements.size(); ++i)
    for (const ChannelSolution& channel : solution.channels) result.push_back(channel.elements[i].radiosity);
  return result;
}

std::vector<double> sky_by_channel_2(const Spectrum& sky_emission, std::size_t channels) {
  std::vector<double> result;
  for (std::size_t c = 0; c < channels; ++c) result.push_back(to_double(sky_emission.value[c]));
  return result;
}

SentOut2 sent_out_2(const ElementTable2& table, const RadiositySolution& solution, const SceneTable& scene) {
  return {table, radiosity_by_element_2(solution), sky_by_channel_2(scene.sky_emission, solution.channels.size()),
          scene.closed};
}

}  // namespace hottel
