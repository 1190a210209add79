// Surfaces divided into elements.
#pragma once

#include <cstdint>
#include <optional>

#include "geometry/plane/scene/scene.h"

namespace hottel {

// Divides every surface into n equal parts. REQUIRES n > 0.
void divide_into(Scene2& scene, std::uint32_t n);

// Divides every surface into the least number of equal parts that are no longer than h. Exact. Returns nothing; or the
// first surface that asks for more than `most` parts: then it and those after it stay as they are.
// REQUIRES h > 0.
std::optional<std::uint32_t> divide_by_length(Scene2& scene, const Rational& h, std::uint32_t most);

}  // namespace hottel
