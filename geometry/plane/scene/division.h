// Surfaces divided into elements.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/element.h"
#include "geometry/plane/scene/scene.h"

namespace hottel {

// Divides every surface into n equal parts. Throws ContractViolation unless n > 0.
void divide_into(Scene2& scene, std::uint32_t n);

// Divides every surface into the least number of equal parts that are no longer than h. Exact: a surface of length 3 h
// has 3 parts. Returns nothing; or the first surface that asks for more than `most` parts: then it and those after it
// stay as they are.
// Throws ContractViolation unless h > 0.
std::optional<std::uint32_t> divide_by_length(Scene2& scene, const Rational& h, std::uint32_t most);

// Returns the point where part k of an edge in so many equal parts begins; k == parts: where the last one ends. Exact.
Point2 part_begin(const Edge2& edge, std::uint32_t k, std::uint32_t parts);

// Returns where each element begins and ends, in the order of the elements: x0, y0, x1, y1 in scene coordinates, each
// rounded to the nearest double. Elements of backs, too, run from the first to the second point of the surface.
// REQUIRES: faces and their equal parts; of a group it is the first surface alone.
std::vector<std::array<double, 4>> element_ends(const Scene2& scene, const std::vector<Element>& elements);

}  // namespace hottel
