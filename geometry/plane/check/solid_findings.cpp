#include "geometry/plane/check/solid_findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>

#include "geometry/gray_temperature.h"
#include "geometry/name.h"
#include "geometry/plane/check/wording.h"

namespace hottel {
namespace {

std::vector<std::uint32_t> surfaces_of(const Scene2& scene, std::uint32_t group) {
  std::vector<std::uint32_t> surfaces;
  for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s)
    if (scene.surfaces[s].group == group) surfaces.push_back(s);
  return surfaces;
}

bool emits(const Scene2& scene, std::uint32_t material) { return !scene.materials[material].emission.is_zero(); }

bool emits(const Scene2& scene, const Surface& surface) {
  return emits(scene, surface.material) || (surface.back && emits(scene, *surface.back));
}

// Whether a surface of the group has the temperature of a material, on either side.
bool is_as_warm(const Scene2& scene, std::uint32_t group, std::uint32_t material) {
  const std::optional<Rational> own = gray_temperature(scene.materials[material]);
  if (!own) return false;
  const std::vector<std::uint32_t> surfaces = surfaces_of(scene, group);
  return std::any_of(surfaces.begin(), surfaces.end(), [&](std::uint32_t s) {
    const Surface& surface = scene.surfaces[s];
    return gray_temperature(scene.materials[surface.material]) == own ||
           (surface.back && gray_temperature(scene.materials[*surface.back]) == own);
  });
}

Finding2 filled_room(const Scene2& scene, std::uint32_t solid, const std::vector<std::uint32_t>& held) {
  std::vector<std::uint32_t> surfaces = surfaces_of(scene, solid);
  const std::size_t own = surfaces.size();
  std::vector<std::string> names, lost;
  for (const std::uint32_t group : held) {
    names.push_back(scene.groups[group].name);
    const std::vector<std::uint32_t> of_group = surfaces_of(scene, group);
    if (std::any_of(of_group.begin(), of_group.end(), [&](auto s) { return emits(scene, scene.surfaces[s]); }))
      lost.push_back(names.back());
    surfaces.insert(surfaces.end(), of_group.begin(), of_group.end());
  }
  const std::string name = quoted_name(scene.groups[solid].name);
  const bool is_stated = scene.groups[solid].behind == Behind::kSolid;
  return {Severity::kWarning,
          "filled-room",
          surfaces,
          middle(scene.edges[surfaces[own > 0 ? 0 : own]]),
          fmt::format("{} is solid, and {} {} in its interior, where nothing is seen{}: was a room meant?", name,
                      listed_names(names), names.size() == 1 ? "is" : "are",
                      lost.empty() ? "" : "; the light of " + listed_names(lost) + " is lost"),
          is_stated ? "take its \"behind\": \"solid\" away where a room was meant, else what is inside it"
                    : "where a room was meant, list its points the other way round (clockwise); else take away what is "
                      "inside it, or say \"behind\": \"open\""};
}

}  // namespace

Findings2 solid_findings(const Scene2& scene, const FaceCover2& cover) {
  Findings2 findings;
  std::map<std::uint32_t, std::vector<std::uint32_t>> held;
  for (std::uint32_t group = 0; group < cover.holder.size(); ++group)
    if (cover.holder[group] != Solids2::kNone) held[cover.holder[group]].push_back(group);
  for (const auto& [solid, groups] : held) findings.push_back(filled_room(scene, solid, groups));
  for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s) {
    const Surface& surface = scene.surfaces[s];
    if (cover.holder[surface.group] != Solids2::kNone) continue;
    for (const bool is_back : {false, true}) {
      const std::uint32_t face = Face{s, is_back}.number();
      if ((is_back && !surface.back) || cover.has_area[face] != 0 || cover.covered_by[face] == Solids2::kNone) continue;
      const std::uint32_t material = is_back ? *surface.back : surface.material;
      const bool is_lost = emits(scene, material) && !is_as_warm(scene, cover.covered_by[face], material);
      findings.push_back(
          {is_lost ? Severity::kWarning : Severity::kNote,
           "covered",
           {s},
           middle(scene.edges[s]),
           fmt::format("the {} of {} looks into the solid {} all along: it has no rows and takes no part in the "
                       "exchange of light{}",
                       is_back ? "back" : "front", quoted_name(surface.name),
                       quoted_name(scene.groups[cover.covered_by[face]].name), is_lost ? ", though it emits" : ""),
           is_lost ? "move it out of the solid, or say \"behind\": \"open\" of what should be none"
                   : "nothing to do where that is meant, as between two boxes side by side"});
    }
  }
  return findings;
}

}  // namespace hottel
