// What lights send straight to parts of elements.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/element.h"
#include "geometry/scene_table.h"
#include "solver/radiosity/direct_light.h"

namespace hottel {

// The direct irradiances of elements in doubles: the middles of what is known of them.
class DirectParts {
 public:
  // shares: of each light of the scene, to these elements. Throws RequestError where that is too much for doubles.
  DirectParts(const SceneTable& scene, std::vector<Element> elements, std::span<const LightShares> shares);

  double of(std::uint32_t element, std::size_t channel) const {
    return values_.empty() ? 0 : values_[3 * std::size_t{element} + channel];
  }

 private:
  std::vector<double> values_;  // by element and channel; empty: no light
};

}  // namespace hottel
