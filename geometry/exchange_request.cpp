#include "geometry/exchange_request.h"

#include <algorithm>
#include <utility>

#include "geometry/exchange_matrix.h"
#include "geometry/name.h"
#include "geometry/scene_names.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

// All surfaces of the groups that these are of.
std::vector<std::uint32_t> with_their_groups(const SceneTable& scene, const std::vector<std::uint32_t>& surfaces) {
  std::vector<char> is_chosen(scene.groups.size(), 0);
  for (const std::uint32_t s : surfaces) is_chosen[scene.surfaces[s].group] = 1;
  std::vector<std::uint32_t> result;
  for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s)
    if (is_chosen[scene.surfaces[s].group] != 0) result.push_back(s);
  return result;
}

}  // namespace

RowChoice RowChoice::of(const SceneTable& scene, const std::string& word, Granularity granularity) {
  RowChoice choice;
  if (word == "fronts") {
    choice.sides_ = Sides::kFronts;
    return choice;
  }
  const SideName side = side_named(word);
  if (side.is_back) choice.sides_ = Sides::kBacks;
  choice.surfaces_ = surfaces_matching(scene, side.name);
  if (granularity == Granularity::kGroup) choice.surfaces_ = with_their_groups(scene, choice.surfaces_);
  return choice;
}

RowChoice RowChoice::fronts_of(std::vector<std::uint32_t> surfaces) {
  RowChoice choice;
  choice.sides_ = Sides::kFronts;
  choice.surfaces_ = std::move(surfaces);
  return choice;
}

bool RowChoice::has(const Element& element) const {
  if (sides_ != Sides::kBoth && element.is_back != (sides_ == Sides::kBacks)) return false;
  return surfaces_.empty() || std::binary_search(surfaces_.begin(), surfaces_.end(), element.surface);
}

std::vector<std::uint32_t> RowChoice::labels(const std::vector<Element>& elements) const {
  std::vector<std::uint32_t> result;
  for (std::uint32_t label = 0; label < elements.size(); ++label)
    if (has(elements[label])) result.push_back(label);
  return result;
}

void require_chosen(const RowChoice& rows, const ExchangeMatrix& matrix, std::uint32_t row) {
  if (!matrix.row(row).empty() || rows.has(matrix.elements()[row])) return;
  throw UsageError(quoted_name(matrix.name(row)) +
                   " has a row, but it was not chosen: nothing is known of its factors");
}

void require_all(const RowChoice& rows) {
  if (!rows.is_all()) throw UsageError("radiosities need the view factors of all rows, and only some were chosen");
}

}  // namespace hottel
