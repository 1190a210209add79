#include "solver/plane/light/face_radiosity.h"

#include <map>

#include "kernel/support/failure.h"

namespace hottel {

FaceRadiosity2::FaceRadiosity2(const Arrangement2& arrangement, const ElementTable2& table,
                               std::span<const double> by_element, std::span<const double> sky)
    : channels_(static_cast<std::uint32_t>(sky.size())) {
  HOTTEL_REQUIRE(channels_ > 0);
  HOTTEL_REQUIRE(by_element.size() == std::size_t{table.count()} * channels_);
  std::map<std::vector<double>, std::uint32_t> known;
  const auto shade_of = [&](std::vector<double> value) {
    const auto [place, is_new] = known.try_emplace(std::move(value), static_cast<std::uint32_t>(known.size()));
    if (is_new) values_.insert(values_.end(), place->first.begin(), place->first.end());
    return place->second;
  };
  const std::vector<double> black(channels_, 0.0);
  shade_of(black);

  std::vector<std::uint32_t> of_label;
  for (std::uint32_t label = 0; label < table.count(); ++label) {
    const auto value = by_element.subspan(std::size_t{label} * channels_, channels_);
    const bool is_black = !table.elements()[label].material;
    of_label.push_back(shade_of(is_black ? black : std::vector<double>(value.begin(), value.end())));
  }
  of_label.push_back(shade_of({sky.begin(), sky.end()}));
  covered_ = static_cast<std::uint32_t>(known.size());
  of_label.push_back(covered_);
  values_.insert(values_.end(), black.begin(), black.end());
  shade_.resize(arrangement.side_count() + 1);
  shade_[place_after_sky(kSky)] = of_label[table.sky()];
  for (const PieceSideId side : arrangement.sides()) shade_[place_after_sky(side)] = of_label[table.of(side)];
}

}  // namespace hottel
