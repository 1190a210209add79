#include "solver/store_key.h"

#include <bit>

#include "geometry/unit_of_length.h"
#include "kernel/version.h"

namespace hottel {
namespace {

// Raised where numbers change within a version: what was kept before is not taken.
constexpr std::uint64_t kRevisionOfNumbers = 3;

}  // namespace

StoreKey::StoreKey(std::string_view kind) {
  add(kind);
  add(kVersion);
  add_count(kRevisionOfNumbers);
}

void StoreKey::add(std::string_view text) {
  text_ += std::to_string(text.size());
  text_ += ':';
  text_ += text;
}

void StoreKey::add_bits(double number) { add_count(std::bit_cast<std::uint64_t>(number)); }

void StoreKey::add_table(const SceneTable& scene) {
  add_count(scene.groups.size());
  for (const Group& group : scene.groups) {
    add(group.name);
    add_count(static_cast<std::uint64_t>(group.behind));
    if (!group.body.empty()) add(group.body);
  }
  // Kept numbers are told by areas, and measures are areas. Scenes in metres have the keys that they had.
  if (const Rational metres = metres_per_unit(scene); metres != 1) {
    add("unit");
    add_number(metres);
  }
  // Only what says "on" changes keys: what was kept of other scenes is taken.
  for (std::size_t s = 0; s < scene.surfaces.size(); ++s) {
    if (!scene.surfaces[s].on) continue;
    const PatchBase& base = scene.bases[*scene.surfaces[s].on];
    add("on");
    add_count(s);
    add(base.name);
    add_count(base.is_back ? 1 : 0);
  }
  add_count(scene.surfaces.size());
  for (const Surface& surface : scene.surfaces) {
    add(surface.name);
    add_count(surface.group);
    add_count(std::uint64_t{surface.is_obstruction} + (surface.material_of(false) ? 2U : 0U) +
              (surface.material_of(true) ? 4U : 0U));
  }
}

void StoreKey::add_elements(const std::vector<std::string>& ids) {
  add_count(ids.size());
  for (const std::string& id : ids) add(id);
}

void StoreKey::add_division(const SceneTable& scene) {
  for (const Surface& surface : scene.surfaces) add_count(surface.elements);
}

}  // namespace hottel
