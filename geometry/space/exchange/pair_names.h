// Pairs of elements as messages name them. Internal to geometry/space/exchange.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "geometry/element.h"
#include "geometry/name.h"

namespace hottel {

inline constexpr std::size_t kNamedPairs = 3;  // in messages

// Returns "'a' and 'b'" for two elements; the number after the last element is the sky.
inline std::string pair_text(const std::vector<Element>& elements, std::uint32_t i, std::uint32_t j) {
  return quoted_name(elements[i].name) + " and " + (j == elements.size() ? "the sky" : quoted_name(elements[j].name));
}

}  // namespace hottel
