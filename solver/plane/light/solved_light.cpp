#include "solver/plane/light/solved_light.h"

#include "kernel/support/failure.h"
#include "solver/plane/light/average_illumination.h"

namespace hottel {

SolvedLight2 illuminate(std::string_view way, const PreparedScene2& prepared, const Grid2& grid,
                        Granularity granularity, const RadiositySolution& solution,
                        const std::function<void(double)>& progress) {
  const auto channels = static_cast<std::uint32_t>(solution.channels.size());
  const std::vector<double> by_element = radiosity_by_element_2(solution);
  const std::vector<double> sky = sky_by_channel_2(prepared.scene.sky_emission, channels);
  const ElementTable2 table(prepared.scene, prepared.arrangement, prepared.division, granularity);
  if (way == "inverse-square")
    return {illuminate_inverse_square(prepared, grid, table, by_element, channels, progress)};
  if (way == "point") return {illuminate_points(prepared, grid, table, SentOut2(table, by_element, sky), progress)};
  HOTTEL_REQUIRE(way == "average");
  const FaceRadiosity2 faces(prepared.arrangement, table, by_element, sky);
  AverageIllumination2 averages = illuminate_averages(prepared, grid, faces, progress);
  return {std::move(averages.grid), averages.max_error};
}

}  // namespace hottel
