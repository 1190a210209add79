// Fields of pixels that tests of contours are made of.
#pragma once

#include <cstdint>

#include "viewer/picture/contours.h"

namespace hottel::pixel_fields {

// The field whose pixels have the value of their centres.
template <class Value>
PixelField field(std::uint32_t width, std::uint32_t height, const Value& value) {
  PixelField result{width, height, {}, {}};
  for (std::uint32_t y = 0; y < height; ++y)
    for (std::uint32_t x = 0; x < width; ++x) result.values.push_back(static_cast<float>(value(x + 0.5, y + 0.5)));
  return result;
}

}  // namespace hottel::pixel_fields
