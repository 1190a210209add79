// What maps do not say.
#pragma once

#include "kernel/rational.h"

namespace hottel {

// The material of all that names none, and the reflectivity of all materials: a map says neither.
inline constexpr const char* kMapMaterial = "white";
inline const Rational kMapReflectivity{1, 2};

// On which side of its outline a polygon is seen from.
enum class MapSide2 : unsigned char { kInside, kOutside };

}  // namespace hottel
