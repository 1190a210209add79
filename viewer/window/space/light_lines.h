// What a window in space says of a light.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/space/scene/scene.h"

namespace hottel {

// "1, 2.5, 0", in short decimals: as it is typed.
std::string coordinates_text_3(const Point3& p);

// The lines of a panel: its name, where it is, and its values.
std::vector<std::string> light_lines_3(const Scene3& scene, std::uint32_t light);

}  // namespace hottel
