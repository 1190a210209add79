#include "geometry/plane/check/gap_findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "geometry/name.h"
#include "geometry/plane/check/contacts.h"
#include "geometry/plane/check/wording.h"
#include "geometry/plane/exchange/exchange.h"
#include "geometry/plane/prepared/prepared_scene.h"

namespace hottel {
namespace {

// The face that loses the largest part of its light into a gap.
struct Leak {
  std::string face;
  double factor = 0;
};

// Puts a black surface across a gap, after the surfaces of the scene.
void fill_gap(const NearMiss2& miss, Scene2& scene) {
  Surface surface;
  surface.name = "gap";
  surface.material = static_cast<std::uint32_t>(scene.materials.size() - 1);
  surface.back = surface.material;
  surface.group = static_cast<std::uint32_t>(scene.groups.size());
  scene.groups.emplace_back("gap");
  scene.add(std::move(surface), {miss.tip, miss.foot});
}

Scene2 with_gaps_filled(Scene2 scene, const std::vector<NearMiss2>& near_misses, const std::vector<std::size_t>& gaps) {
  scene.materials.push_back({"gap", {}, {}});
  for (const std::size_t k : gaps) fill_gap(near_misses[k], scene);
  return scene;
}

// Leaves out gaps that a surface lies along, in part: a side has one owner.
void leave_out_covered(const Scene2& own, const std::vector<NearMiss2>& near_misses, std::vector<std::size_t>& gaps) {
  std::vector<char> is_covered(gaps.size(), 0);
  for (const Overlap2& overlap : find_contacts(with_gaps_filled(own, near_misses, gaps)).overlaps) {
    const auto is_own = [&own](const PieceSource2& source) { return source.surface < own.surfaces.size(); };
    if (std::none_of(overlap.covering.begin(), overlap.covering.end(), is_own)) continue;
    for (const PieceSource2& source : overlap.covering)
      if (!is_own(source)) is_covered[source.surface - own.surfaces.size()] = 1;
  }
  std::vector<std::size_t> open;
  for (std::size_t gap = 0; gap < gaps.size(); ++gap)
    if (!is_covered[gap]) open.push_back(gaps[gap]);
  gaps = std::move(open);
}

// By near miss; nothing where there is no gap, or no face with a material loses light there. Throws InputError where
// the gaps that are filled make a "behind" impossible.
std::vector<std::optional<Leak>> leaks(const Scene2& own, const std::vector<NearMiss2>& near_misses) {
  std::vector<std::size_t> miss_of_gap;
  for (std::size_t k = 0; k < near_misses.size(); ++k)
    if (!near_misses[k].sticks_out) miss_of_gap.push_back(k);
  if (!miss_of_gap.empty()) leave_out_covered(own, near_misses, miss_of_gap);
  std::vector<std::optional<Leak>> result(near_misses.size());
  if (miss_of_gap.empty()) return result;
  const ExchangeMatrix matrix = exact_exchange(prepare(with_gaps_filled(own, near_misses, miss_of_gap)),
                                               {.granularity = Granularity::kFace, .wants_visibility = false});
  for (std::uint32_t gap = 0; gap < matrix.size(); ++gap) {
    const std::uint32_t surface = matrix.elements()[gap].surface;
    if (surface < own.surfaces.size() || !matrix.has_row(gap)) continue;
    std::optional<Leak>& leak = result[miss_of_gap[surface - own.surfaces.size()]];
    for (const FactorEntry& entry : matrix.row(gap)) {
      if (entry.to == matrix.sky() || matrix.elements()[entry.to].surface >= own.surfaces.size() ||
          !matrix.has_row(entry.to))
        continue;
      const double factor = matrix.factor(entry.to, gap).value;
      if (!leak || factor > leak->factor) leak = {matrix.elements()[entry.to].name, factor};
    }
  }
  return result;
}

Finding2 tell(const Scene2& scene, const NearMiss2& miss, const std::optional<Leak>& leak) {
  std::vector<std::uint32_t> surfaces = miss.surfaces;
  surfaces.push_back(miss.target);
  const std::string ends =
      fmt::format("{} of {}", miss.surfaces.size() == 1 ? "the end" : "the corner", names_text(scene, miss.surfaces));
  const std::string target = quoted_name(scene.surfaces[miss.target].name);
  const std::string distance = length_text(miss.squared_distance);
  if (miss.sticks_out)
    return {Severity::kWarning,
            "overshoot",
            surfaces,
            miss.tip,
            fmt::format("{} sticks {} out of {}: a stub that casts a shadow of its own", ends, distance, target),
            fmt::format("end it on {} at {}", target, place_text(miss.foot))};
  std::string text = fmt::format("{} is {} from {} of {}, {}", ends, distance,
                                 miss.is_at_end ? "the end" : "the nearest point", target, place_text(miss.foot));
  if (leak && leak->factor > 0)
    text += fmt::format(": through the gap goes F = {} of the light of {}", shortest(leak->factor),
                        quoted_name(leak->face));
  return {Severity::kWarning,
          "near-miss",
          surfaces,
          miss.tip,
          text,
          fmt::format("if they should touch, give both the same point{}",
                      miss.is_at_end ? "" : ", or let it end exactly on the edge: a coordinate may be a fraction")};
}

}  // namespace

Findings2 gap_findings(const Scene2& scene, const std::vector<NearMiss2>& near_misses, bool with_factors) {
  std::vector<std::optional<Leak>> leak(near_misses.size());
  try {
    if (with_factors) leak = leaks(scene, near_misses);
  } catch (const InputError&) {  // told without
  }
  Findings2 findings;
  for (std::size_t k = 0; k < near_misses.size(); ++k) findings.push_back(tell(scene, near_misses[k], leak[k]));
  return findings;
}

}  // namespace hottel
