#include "solver/radiosity/scene_radiosities.h"

#include <optional>
#include <string>
#include <utility>

#include "kernel/support/failure.h"
#include "kernel/support/naming_file.h"
#include "solver/radiosity/a_priori_bounds.h"
#include "solver/radiosity/matrix_checks.h"

namespace hottel {
namespace {

// At the line of the surface, where there is one.
[[noreturn]] void refuse(const BeyondDoubles& beyond, const SceneTable& scene, const ExchangeMatrix& matrix) {
  const FileLine at = beyond.element ? place_of(scene, scene.surfaces[matrix.elements()[*beyond.element].surface])
                                     : FileLine{scene.file};
  const std::string place = at.file + (at.line > 0 ? ":" + std::to_string(at.line) : "");
  throw RequestError(place.empty() ? beyond.text : place + ": " + beyond.text);
}

}  // namespace

RadiositySolution scene_radiosities(const RadiositySolver& system, const SceneTable& scene,
                                    std::span<const LightShares> lights, std::vector<std::string> notes,
                                    const std::function<void(double)>& progress) {
  const ExchangeMatrix& matrix = system.matrix();
  std::optional<BeyondDoubles> beyond;
  RadiositySolution result = naming_file(scene.file, [&] {
    const RadiositySources sources = sources_of(matrix, scene, lights);
    for (std::string& note : lost_light_notes(scene.lights, lights)) notes.push_back(std::move(note));
    RadiositySolution solution = system.solve(sources, progress);
    if (const auto place = solution.seconds.find("radiosity"); place != solution.seconds.end())
      place->second += system.seconds();
    beyond = beyond_doubles(matrix, scene.sky_emission, solution);
    if (beyond) return solution;
    if (matrix.guarantee() == Guarantee::kEnclosed) {
      notes.push_back("the bounds hold for all factors within their enclosures that sum to 1");
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
  if (beyond) refuse(*beyond, scene, matrix);
  return result;
}

}  // namespace hottel
