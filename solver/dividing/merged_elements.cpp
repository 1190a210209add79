#include "solver/dividing/merged_elements.h"

#include <fmt/format.h>

#include <map>
#include <utility>

#include "geometry/name.h"
#include "geometry/scene_names.h"

namespace hottel {
namespace {

// Why a face cannot be merged; empty where it can.
std::string problem_of(const SceneTable& scene, const Element& element) {
  const std::string face = quoted_name(face_name(scene, {element.surface, element.is_back}));
  const std::uint32_t by = scene.surfaces[element.surface].elements;
  if (element.path.depth() > 0) return face + " is divided where light ends, into parts of several sizes";
  if (by == 1 || !element.is_part()) return face + " is one element";
  if (by % 2 != 0) return fmt::format("{} is divided by {}, an odd number", face, by);
  return "";
}

}  // namespace

ElementMerging merged_elements(const SceneTable& scene, std::span<const Element> elements,
                               const std::function<CoarsePart(const Element&)>& coarse_part) {
  ElementMerging result;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> label_of;  // of face and part
  std::vector<long double> areas;
  for (const Element& element : elements) {
    const std::string problem = problem_of(scene, element);
    const bool has_row = element.material && element.area.value > 0;
    if (has_row && !problem.empty()) return {.why_none = problem};
    const Face face{element.surface, element.is_back};
    const CoarsePart coarse = problem.empty() ? coarse_part(element) : CoarsePart{element.part, element.parts};
    const auto next = static_cast<std::uint32_t>(result.merged.size());
    // An element of a tree stays by itself: it has no row.
    const auto place = element.path.depth() > 0 ? std::pair(label_of.end(), true)
                                                : label_of.try_emplace({face.number(), coarse.part}, next);
    if (place.second) {
      Element& merged = result.merged.emplace_back(element);
      if (problem.empty()) {
        merged.part = coarse.part;
        merged.parts = coarse.parts;
        merged.name = element_name(face_name(scene, face), coarse.parts, merged.node());
      }
      areas.push_back(0);
    }
    const std::uint32_t label = place.second ? next : place.first->second;
    areas[label] += element.area.value;
    result.of.push_back(label);
  }
  for (std::size_t label = 0; label < areas.size(); ++label)
    result.merged[label].area = {static_cast<double>(areas[label]), 0};
  result.of.push_back(static_cast<std::uint32_t>(result.merged.size()));
  return result;
}

}  // namespace hottel
