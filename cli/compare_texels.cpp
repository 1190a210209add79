#include "cli/compare_texels.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <utility>

#include "geometry/scene_names.h"
#include "io/results/space/light_region.h"
#include "kernel/support/counted.h"
#include "viewer/picture/grid_error_picture.h"
#include "viewer/picture/shown_values.h"
#include "viewer/picture/space/texels.h"

namespace hottel {
namespace {

// NAME and FILE of an option: the longest NAME that is one of the scene. No name: all of it is a file.
std::pair<std::string, std::string> parts_of(const std::string& option, const Scene3& scene) {
  std::error_code ignored;
  if (std::filesystem::exists(option, ignored)) return {"", option};
  const auto is_face = [&](const std::string& name) {
    try {
      return face_of(scene, name), true;
    } catch (const UsageError&) {
      return false;
    }
  };
  for (auto end = option.rfind('='); end != std::string::npos && end > 0; end = option.rfind('=', end - 1))
    if (is_face(option.substr(0, end))) return {option.substr(0, end), option.substr(end + 1)};
  const auto first = option.find('=');
  return first == std::string::npos ? std::pair("", option)
                                    : std::pair(option.substr(0, first), option.substr(first + 1));
}

void require_cells(const ExternalGrid& grid) {
  if (std::max(grid.nx, grid.ny) > kMaxGridCells3)
    throw InputError({grid.file, 0}, fmt::format("has {} x {} texels, where a face has up to {} along a side", grid.nx,
                                                 grid.ny, kMaxGridCells3));
}

void require_place(const TexelFacts& facts, const std::string& name, const Grid3& grid) {
  if (facts.region && !are_sides_of(*facts.region, grid))
    throw InputError({facts.file, 0}, "says that the texels lie elsewhere than those of '" + name + "'",
                     {"\"origin\" is the first corner of the polygon, \"u\" goes to its second, \"v\" to its last"});
}

// The face that FILE.json names: what is wrong with it is wrong with the file.
template <class Work>
auto naming_facts(const TexelFacts& facts, const Work& work) {
  try {
    return work();
  } catch (const UsageError& error) {
    throw InputError({facts.file, 0}, std::string("is of a face that cannot be compared: ") + error.what());
  }
}

Responses3 responses_of(const ExternalTexels& texels, const std::string& quantity, const RadiositySolution& solution) {
  const std::vector<std::string>& names = solution.channel_names;
  if (texels.values.has_channels && quantity == "radiosity") return light_responses_3(solution);
  if (texels.values.has_channels && quantity == "irradiance") return irradiance_responses_3(solution);
  if (texels.values.has_channels)
    throw InputError({texels.facts.file, 0}, "says that texels have '" + quantity +
                                                 "' by channel: radiosity and irradiance can be compared so");
  if (const auto shown = shown_called(quantity, names)) return responses_3(*shown, solution);
  if (quantity == "radiosity" || quantity == "irradiance") return responses_3(shown_by(quantity), solution);
  throw InputError({texels.facts.file, 0},
                   "says that texels have '" + quantity + "': radiosity, irradiance and net flux can be compared");
}

void require_channels(const ExternalGrid& grid, std::size_t channels) {
  if (grid.channels == channels) return;
  throw InputError({grid.file, 0}, fmt::format("has {} a texel, and the light of the scene {}",
                                               counted(grid.channels, "value"), channels));
}

std::vector<std::string> channel_names(const ExternalTexels& texels, const RadiositySolution& solution) {
  if (!texels.values.has_channels) return {"all"};
  std::vector<std::string> names = solution.channel_names;
  names.resize(texels.values.channels);
  return names;
}

}  // namespace

TexelFile texel_file(const std::string& option, const Scene3& scene) {
  const auto parts = parts_of(option, scene);
  if (!parts.first.empty()) face_of(scene, parts.first);
  TexelFile result{read_external_texels(parts.second), {}, parts.first, {}};
  const ExternalGrid& values = result.read.values;
  const TexelFacts& facts = result.read.facts;
  require_cells(values);
  const auto find = [&] {
    result.face = face_of(scene, result.name);
    result.grid = texel_grid_3(scene, result.face, values.nx, values.ny);
  };
  if (result.name.empty() && !facts.face)
    throw UsageError("--texels takes NAME=FILE where no " + parts.second + ".json says of which face the texels are");
  if (result.name.empty()) {
    result.name = *facts.face;
    naming_facts(facts, find);
  } else {
    find();
  }
  require_place(facts, result.name, result.grid);
  return result;
}

ComparedTexels judge_texels(const TexelFile& file, const MethodComparison3& comparison, double beyond,
                            const std::function<void(double)>& progress) {
  const RadiositySolution& solution = comparison.required_solution();
  const ExternalGrid& external = file.read.values;
  const std::string quantity = file.read.facts.quantity.value_or("radiosity");
  Responses3 responses = responses_of(file.read, quantity, solution);
  require_channels(external, responses.channels);
  const GatheredSource3 source(comparison.prepared(), Granularity::kElement, solution, std::move(responses),
                               comparison.lights());
  const IlluminationGrid3 light = texels_3(comparison.prepared(), source, file.face, file.grid, progress);
  const GridValues found{external.ny, external.nx, external.channels, external.values},
      exact{external.ny, external.nx, external.channels, light.values};
  const GridRegion3 region = region_of(file.grid);
  JudgedTexels judged{external.file,
                      file.name,
                      quantity,
                      channel_names(file.read, solution),
                      grid_errors(found, exact, beyond, external.digits),
                      {region.origin, region.u, region.v, external.nx, external.ny, true},
                      beyond,
                      grid_reading(found, exact)};
  for (const GridErrors& each : judged.errors)
    if (each.cells == 0)
      throw InputError({external.file, 0}, "has no finite value where " + file.name + " has light: none to compare");
  std::string picture = grid_error_picture(found, exact, external.file, judged.place, quantity);
  return {std::move(judged), std::move(picture)};
}

}  // namespace hottel
