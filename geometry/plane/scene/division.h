// Surfaces divided into elements.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/element.h"
#include "geometry/plane/scene/scene.h"

namespace hottel {

// Divides every surface into n equal parts. REQUIRES n > 0.
void divide_into(Scene2& scene, std::uint32_t n);

// Divides every surface into the least number of equal parts that are no longer than h. Exact. Returns nothing; or the
// first surface that asks for more than `most` parts: then it and those after it stay as they are.
// REQUIRES h > 0.
std::optional<std::uint32_t> divide_by_length(Scene2& scene, const Rational& h, std::uint32_t most);

// Returns where each element begins and ends, x0, y0, x1, y1, rounded; for faces and their equal parts, in order.
std::vector<std::array<double, 4>> element_ends(const Scene2& scene, const std::vector<Element>& elements);

}  // namespace hottel
