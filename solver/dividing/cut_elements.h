// A scene in which some elements are divided once more.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "geometry/element.h"
#include "geometry/scene_table.h"
#include "solver/dividing/sampled_elements.h"

namespace hottel {

// The nodes into which an element is divided, ascending.
using ElementParts = std::function<std::vector<TreeNode>(const Element&)>;

// Returns the trees of the scene's surfaces with the chosen elements divided; faces without one keep theirs.
// elements: all of the scene, as the rows and columns of a matrix stand for them, by faces or elements.
std::vector<SurfaceTrees> trees_with_parts(const SceneTable& scene, std::span<const Element> elements,
                                           std::span<const SampledElement> chosen, const ElementParts& parts);

// Returns for each part the element that it is, or lies in. REQUIRES: the elements of one scene in their order, and
// those of the same scene with some of them divided.
std::vector<std::uint32_t> elements_around(std::span<const Element> parts, std::span<const Element> elements);

}  // namespace hottel
