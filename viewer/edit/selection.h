// The surfaces of a scene that are selected, in either dimension: lists of indices, ascending, each once.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/scene_table.h"

namespace hottel {

using Selection = std::vector<std::uint32_t>;

// Surfaces in any order, each as often as may be, as a selection.
Selection selection_of(Selection surfaces);

// All surfaces of the groups that something is selected of.
Selection whole_groups(const SceneTable& scene, const Selection& selected);

// A selection with others taken into it; where the surface that is touched is of it already, out of it.
Selection toggled(const Selection& selected, std::uint32_t touched, const Selection& others);

// Whether it is furniture: groups of several surfaces, each as a whole.
bool is_furniture(const SceneTable& scene, const Selection& selected);

// What is called in one scene as it is in another, which was selected there.
Selection selection_called_as(const SceneTable& before, const Selection& selected, const SceneTable& now);
std::optional<std::uint32_t> light_called_as(const SceneTable& before, const std::optional<std::uint32_t>& light,
                                             const SceneTable& now);

}  // namespace hottel
