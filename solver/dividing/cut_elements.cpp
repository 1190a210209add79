#include "solver/dividing/cut_elements.h"

#include <algorithm>
#include <set>

#include "kernel/support/failure.h"

namespace hottel {
namespace {

bool holds(const Element& element, const Element& part) {
  if (element.surface != part.surface || element.is_back != part.is_back) return false;
  return !element.is_part() || (element.part == part.part && element.path.holds(part.path));
}

}  // namespace

std::vector<SurfaceTrees> trees_with_parts(const SceneTable& scene, std::span<const Element> elements,
                                           std::span<const SampledElement> chosen, const ElementParts& parts) {
  std::vector<SurfaceTrees> trees;
  for (const Surface& surface : scene.surfaces) trees.push_back(surface.trees);
  std::vector<bool> is_chosen(elements.size(), false);
  std::set<std::uint32_t> faces;
  for (const SampledElement& sample : chosen) {
    const Element& element = elements[sample.element];
    is_chosen[sample.element] = true;
    if (!faces.insert(Face{element.surface, element.is_back}.number()).second) continue;
    (element.is_back ? trees[element.surface].back : trees[element.surface].front).clear();
  }
  for (std::uint32_t i = 0; i < elements.size(); ++i) {
    const Element& element = elements[i];
    if (!faces.contains(Face{element.surface, element.is_back}.number())) continue;
    std::vector<TreeNode>& leaves = element.is_back ? trees[element.surface].back : trees[element.surface].front;
    if (is_chosen[i])
      std::ranges::copy(parts(element), std::back_inserter(leaves));
    else
      leaves.push_back(element.node());
  }
  return trees;
}

std::vector<std::uint32_t> elements_around(std::span<const Element> parts, std::span<const Element> elements) {
  std::vector<std::uint32_t> result;
  std::uint32_t i = 0;
  for (const Element& part : parts) {
    while (i < elements.size() && !holds(elements[i], part)) ++i;
    HOTTEL_REQUIRE(i < elements.size());
    result.push_back(i);
  }
  return result;
}

}  // namespace hottel
