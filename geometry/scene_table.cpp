#include "geometry/scene_table.h"

#include <algorithm>
#include <string_view>

#include "geometry/name.h"
#include "kernel/support/failure.h"

namespace hottel {

std::optional<std::uint32_t> SceneTable::find(const std::string& name) const {
  for (std::size_t i = 0; i < surfaces.size(); ++i)
    if (surfaces[i].name == name) return static_cast<std::uint32_t>(i);
  return std::nullopt;
}

void settle_two_sided(SceneTable& table) {
  for (Surface& surface : table.surfaces)
    if (!surface.is_obstruction && !surface.on && !surface.back && table.materials[surface.material].is_two_sided)
      surface.back = surface.material;
}

std::string_view unit_problem(std::string_view unit) {
  if (unit.empty()) return "must not be empty";
  if (has_control_character(unit)) return "must not contain a control character";
  if (unit.size() > kMaxUnitLength) return "must not be longer than 16 bytes";
  return "";
}

std::string length_unit(const SceneTable& table) { return table.unit.empty() ? "m" : table.unit; }

FileLine place_of(const SceneTable& table, const Surface& surface) {
  const MeshPlace& in_mesh = surface.in_mesh;
  HOTTEL_REQUIRE(in_mesh.file <= table.sources.size());
  if (in_mesh.file == 0) return {table.file, surface.line};
  return {table.sources[in_mesh.file - 1], in_mesh.line};
}

void settle_bands(SceneTable& table) {
  if (!table.has_bands) return;
  for (Material& material : table.materials) {
    if (material.has_bands) continue;
    const Rational reflectivity = material.reflectivity.value[0], emission = material.emission.value[0];
    material.reflectivity = Spectrum::scalar(reflectivity);
    material.emission = Spectrum();
    set_bands(reflectivity, emission, material);
    material.says_solar = true;
  }
  for (Light& light : table.lights) {
    const auto& power = light.power.value;
    light.power = light.is_thermal ? in_bands(0, power[kThermalBand]) : in_bands(power[kSolarBand], 0);
  }
}

std::vector<std::size_t> group_sizes(const SceneTable& table) {
  std::vector<std::size_t> sizes(table.groups.size());
  for (const Surface& surface : table.surfaces) {
    HOTTEL_REQUIRE(surface.group < sizes.size());
    ++sizes[surface.group];
  }
  return sizes;
}

bool is_divided(const SceneTable& table) { return std::ranges::any_of(table.surfaces, &Surface::is_divided); }

std::vector<std::string> channel_names(const SceneTable& table) {
  if (table.has_bands) return {"solar", "thermal"};
  return channel_count(table) == 1 ? std::vector<std::string>{"all"} : std::vector<std::string>{"r", "g", "b"};
}

int channel_count(const SceneTable& table) {
  if (table.has_bands) return 2;
  const bool is_scalar =
      table.sky_emission.is_scalar &&
      std::all_of(table.materials.begin(), table.materials.end(),
                  [](const Material& m) { return m.reflectivity.is_scalar && m.emission.is_scalar; }) &&
      std::all_of(table.lights.begin(), table.lights.end(), [](const Light& light) { return light.power.is_scalar; });
  return is_scalar ? 1 : 3;
}

}  // namespace hottel
