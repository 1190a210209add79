// Furniture of generated scenes. Internal to geometry/space/generate.
#pragma once

#include <cstdint>
#include <string>

#include "geometry/generate/chance.h"
#include "geometry/space/generate/generator_canvas.h"

namespace hottel {

// A place with furniture, in millimetres, and the polygons on it where all are triangles and have bottoms: 28 boxes.
inline constexpr std::int64_t kPlaceWidth = 5000, kPlaceDepth = 4000, kPlaceHeight = 2600;
inline constexpr std::uint64_t kPlaceTriangles = 336;

// Adds a table with two chairs, a shelf and two lamps on the place from `corner`, in groups of their own whose names
// hold the number. They stay within the place and off its border; nothing is at its sides of low and high x where y is
// below 2.5 m, nor at those of low and high y where x is from 3.05 m to 4.05 m.
//
// REQUIRES: the canvas thinks in millimetres.
void furnish(GeneratorCanvas3& canvas, const std::string& number, const Dot3& corner, Chance& chance);

}  // namespace hottel
