#include "geometry/scene/scene_2.h"

namespace hottel {

std::optional<std::uint32_t> Scene2::find(const std::string& name) const {
  for (std::size_t i = 0; i < surfaces.size(); ++i)
    if (surfaces[i].name == name) return static_cast<std::uint32_t>(i);
  return std::nullopt;
}

}  // namespace hottel
