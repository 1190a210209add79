#include "geometry/scene_table.h"

#include <algorithm>
#include <string_view>
#include <unordered_map>

#include "geometry/name.h"
#include "geometry/number.h"
#include "kernel/support/failure.h"

namespace hottel {

std::optional<std::uint32_t> SceneTable::find(const std::string& name) const {
  for (std::size_t i = 0; i < surfaces.size(); ++i)
    if (surfaces[i].name == name) return static_cast<std::uint32_t>(i);
  return std::nullopt;
}

void settle_two_sided(SceneTable& table) {
  for (Surface& surface : table.surfaces)
    if (!surface.is_obstruction && !surface.back && table.materials[surface.material].is_two_sided)
      surface.back = surface.material;
}

std::string_view unit_problem(std::string_view unit) {
  if (unit.empty()) return "must not be empty";
  if (has_control_character(unit)) return "must not contain a control character";
  if (unit.size() > kMaxUnitLength) return "must not be longer than 16 bytes";
  return "";
}

std::string length_unit(const SceneTable& table) { return table.unit.empty() ? "m" : table.unit; }

namespace {

// In its range, in lowest terms, and of one value where it says so.
std::string_view problem_of(const Spectrum& spectrum, SpectrumKind kind) {
  for (const Rational& value : spectrum.value)
    if (!is_in_lowest_terms(value)) return "is not in lowest terms (mpq_class::canonicalize)";
  if (spectrum.is_scalar && (spectrum.value[1] != spectrum.value[0] || spectrum.value[2] != spectrum.value[0]))
    return "is a scalar of more than one value";
  return spectrum_problem(spectrum, kind);
}

void require_given_flux(const SceneTable& table, const std::string& owner, const Material& material) {
  const auto refuse = [&](const char* text) { throw InputError({table.file, 0}, owner + text); };
  if (!(0 < *material.emissivity && *material.emissivity <= 1)) refuse("emissivity must be above 0 and at most 1");
  if (!is_in_lowest_terms(*material.emissivity) || !is_in_lowest_terms(material.thermal(material.emission)))
    refuse("emissivity or flux is not in lowest terms (mpq_class::canonicalize)");
  const auto& value = material.emission.value;
  if (value[1] != value[2] || (!material.has_bands && value[0] != value[1])) refuse("flux is not of one value");
  if (material.has_bands && value[kSolarBand] < 0) refuse("solar: emission must not be negative");
}

void validate_spectra(const SceneTable& table) {
  const auto require = [&](const std::string& subject, const Spectrum& spectrum, SpectrumKind kind) {
    if (const auto problem = problem_of(spectrum, kind); !problem.empty())
      throw InputError({table.file, 0}, subject + " " + std::string(problem));
  };
  for (const Material& material : table.materials) {
    const std::string owner = "material " + quoted_name(material.name) + ": ";
    require(owner + "reflectivity", material.reflectivity, SpectrumKind::kFraction);
    if (material.has_given_flux())
      require_given_flux(table, owner, material);
    else
      require(owner + "emission", material.emission, SpectrumKind::kQuantity);
  }
  require("sky: emission", table.sky_emission, SpectrumKind::kQuantity);
  for (const Material& material : table.materials)
    if (material.has_bands != table.has_bands)
      throw InputError({table.file, 0}, "material " + quoted_name(material.name) + " has other bands than the scene");
}

void validate_lights(const SceneTable& table) {
  std::unordered_map<std::string_view, int> first;
  for (const Light& light : table.lights) {
    if (const auto problem = light_problem(light); !problem.empty())
      throw InputError({table.file, light.line}, "light " + quoted_name(light.name) + " " + problem);
    if (const auto [other, is_new] = first.emplace(light.name, light.line); !is_new)
      throw InputError({table.file, light.line},
                       "two lights have the name " + quoted_name(light.name) +
                           (other->second > 0 ? ", the other one in line " + std::to_string(other->second) : ""));
  }
}

}  // namespace

FileLine place_of(const SceneTable& table, const Surface& surface) {
  const MeshPlace& in_mesh = surface.in_mesh;
  HOTTEL_REQUIRE(in_mesh.file <= table.sources.size());
  if (in_mesh.file == 0) return {table.file, surface.line};
  return {table.sources[in_mesh.file - 1], in_mesh.line};
}

void validate_table(const SceneTable& table) {
  validate_spectra(table);
  validate_lights(table);
  if (const auto problem = table.unit.empty() ? "" : unit_problem(table.unit); !problem.empty())
    throw InputError({table.file, 0}, "unit " + std::string(problem));
  std::unordered_map<std::string_view, const Surface*> first;
  first.reserve(table.surfaces.size());
  for (const Surface& surface : table.surfaces) {
    const auto refuse = [&](const std::string& text) { throw InputError({table.file, surface.line}, text); };
    if (const auto problem = name_problem(surface.name); !problem.empty())
      refuse("the name " + quoted_name(surface.name) + " " + std::string(problem));
    if (const auto [other, is_new] = first.emplace(surface.name, &surface); !is_new) {
      const int line = other->second->line;
      refuse("two surfaces have the name " + quoted_name(surface.name) +
             (line > 0 ? ", the other one in line " + std::to_string(line) : ""));
    }
    if (surface.is_obstruction && surface.back)
      refuse("surface " + quoted_name(surface.name) + " is an obstruction: its back has no material");
    const auto is_undefined = [&](const std::optional<std::uint32_t>& material) {
      return material && *material >= table.materials.size();
    };
    if (is_undefined(surface.material_of(false)) || is_undefined(surface.material_of(true)))
      refuse("surface " + quoted_name(surface.name) + " has a material that is not defined");
    if (surface.group >= table.groups.size())
      refuse("surface " + quoted_name(surface.name) + " has a group that is not defined");
    if (surface.elements < 1 || surface.elements > kMaxElements)
      refuse("surface " + quoted_name(surface.name) + " has " + std::to_string(surface.elements) +
             " elements; it may have 1 to " + std::to_string(kMaxElements));
  }
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
