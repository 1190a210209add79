// What faces of a scene in space see from one of their points: a cheap stand-in for view factors in large scenes.
#pragma once

#include <cstddef>

#include "geometry/exchange_matrix.h"
#include "geometry/space/prepared/prepared_scene.h"

namespace hottel {

// Returns view factors from a point in the middle of faces with a material, by faces as exact_exchange has them.
//
//   (1) at most `most` faces have entries: every k-th of those with an area, for the least k
//   (2) what such a face has an entry for is seen from a part of it; the sky only where its factor is above
//       kCertainSky3, more than maps may be off. Others may be seen too, from elsewhere on it
// COST: a map (map_from) a face.
inline constexpr double kCertainSky3 = 1e-11;
ExchangeMatrix middle_views(const PreparedScene3& prepared, std::size_t most);

}  // namespace hottel
