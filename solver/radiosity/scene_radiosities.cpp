#include "solver/radiosity/scene_radiosities.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/name.h"
#include "kernel/support/failure.h"
#include "kernel/support/with_file_context.h"
#include "solver/radiosity/a_priori_bounds.h"
#include "solver/radiosity/element_temperatures.h"
#include "solver/radiosity/matrix_checks.h"

namespace hottel {
namespace {

// At the line of the surface, where there is one.
[[noreturn]] void refuse(const std::string& text, std::optional<std::uint32_t> element, const SceneTable& scene,
                         const ExchangeMatrix& matrix) {
  const FileLine at =
      element ? place_of(scene, scene.surfaces[matrix.elements()[*element].surface]) : FileLine{scene.file};
  const std::string place = at.text();
  throw RequestError(place.empty() ? text : place + ": " + text);
}

// In two bands, of materials that say nothing of the solar one.
std::optional<std::string> black_in_solar_note(const ExchangeMatrix& matrix, const std::vector<Material>& materials) {
  std::vector<char> is_used(materials.size(), 0);
  for (std::uint32_t i = 0; i < matrix.size(); ++i)
    if (matrix.has_row(i)) is_used[*matrix.elements()[i].material] = 1;
  std::string names;
  for (std::size_t m = 0; m < materials.size(); ++m)
    if (is_used[m] && materials[m].has_bands && !materials[m].says_solar)
      names += (names.empty() ? "" : ", ") + quoted_name(materials[m].name);
  if (names.empty()) return std::nullopt;
  return "black in the solar band, of which they say nothing: " + names;
}

}  // namespace

RadiositySolution scene_radiosities(const RadiositySolver& system, const SceneTable& scene,
                                    std::span<const LightShares> lights, std::vector<std::string> notes,
                                    const std::function<void(double)>& progress) {
  const ExchangeMatrix& matrix = system.matrix();
  std::optional<BeyondDoubles> beyond;
  RadiositySolution result = with_file_context(scene.file, [&] {
    const RadiositySources sources = sources_of(matrix, scene, lights);
    for (std::string& note : lost_light_notes(matrix, scene.lights, lights)) notes.push_back(std::move(note));
    if (const auto note = black_in_solar_note(matrix, scene.materials)) notes.push_back(*note);
    beyond = below_doubles(matrix, scene.materials);
    if (beyond) return RadiositySolution{};
    RadiositySolution solution = system.solve(sources, progress);
    if (const auto place = solution.seconds.find("radiosity"); place != solution.seconds.end())
      place->second += system.seconds();
    beyond = beyond_doubles(matrix, scene.sky_emission, solution);
    if (!beyond) beyond = temperature_beyond_doubles(matrix, scene.materials, solution);
    if (beyond) return solution;
    if (matrix.guarantee() == Guarantee::kEnclosed) {
      notes.push_back(
          "the bounds of radiosities hold for all true factors that lie within their bounds and sum to 1 in each row");
      set_a_priori_bounds(matrix, reflectivities_of(scene.materials), sources, solution);
    }
    if (solution.guarantee == Guarantee::kEstimated)
      notes.push_back(
          "view factors are estimates: the bounds are those of the radiosities of these factors, and say "
          "nothing of the scene");
    if (const auto note = estimated_light_note(scene.lights, lights)) {
      notes.push_back(*note);
      solution.guarantee = Guarantee::kEstimated;
    }
    solution.notes.insert(solution.notes.begin(), notes.begin(), notes.end());
    return solution;
  });
  if (beyond) refuse(beyond->text, beyond->element, scene, matrix);
  if (const auto i = first_without_emissivity(matrix, scene.materials, result))
    refuse(text_without_emissivity(matrix.elements()[*i], scene.materials), *i, scene, matrix);
  if (const auto cold = coldest_below_zero(matrix, scene.materials, result))
    refuse(text_of(*cold, matrix, scene.materials), cold->element, scene, matrix);
  return result;
}

}  // namespace hottel
