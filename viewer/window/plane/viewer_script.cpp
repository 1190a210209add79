#include "viewer/window/plane/viewer_script.h"

#include <fmt/format.h>

#include "io/results/factor_files.h"
#include "io/results/grid_file.h"
#include "io/results/npy.h"
#include "io/results/radiosity_files.h"
#include "solver/plane/methods/computed_factors.h"
#include "viewer/window/written_hash.h"

namespace hottel {

std::string result_hashes(const LiveState2& state) {
  const bool has_name = state.scene && !state.scene->grids.empty();
  const std::string array = grid_file("illumination.npy", has_name ? state.scene->grids.front().name : "");
  if (!state.light || state.depth != LiveDepth2::kFull) return fmt::format("factors.csv - radiosity.csv - {} -", array);
  SimulationRequest2 request = state.simulation->request();
  request.granularity = Granularity::kFace;
  request.wants_visibility = true;
  const auto factors = state.simulation->with_request(request).factors();
  const Scene2& scene = *state.scene;
  const IlluminationGrid2& light = state.light->grid;
  const std::size_t shape[3] = {light.grid.ny, light.grid.nx, light.channels};
  return fmt::format("factors.csv {} radiosity.csv {} {} {}", written_hash([&](const Sink& sink) {
                       write_factors_csv({scene, factors->matrix, Granularity::kFace, {}, {}}, sink);
                     }),
                     written_hash([&](const Sink& sink) {
                       write_radiosity_csv(scene, state.factors->matrix, *state.radiosities, sink);
                     }),
                     array, written_hash([&](const Sink& sink) { write_npy(shape, light.values, sink); }));
}

}  // namespace hottel
