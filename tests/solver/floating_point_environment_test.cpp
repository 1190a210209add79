// A caller who rounds upward gets what every other caller gets.
#include <gtest/gtest.h>

#include <cfenv>

#include "geometry/exchange/exchange_2.h"
#include "io/scene_json.h"
#include "solver/illumination/illumination_grid_2.h"
#include "solver/system/radiosity.h"

namespace hottel {
namespace {

struct Everything {
  std::vector<double> factors, radiosities, light;
};

Everything everything(const Scene2& scene) {
  Everything result;
  const PreparedScene2 prepared = prepare(scene);
  const ExchangeMatrix matrix = exact_exchange(prepared);
  for (std::uint32_t i = 0; i < matrix.size(); ++i)
    for (const FactorEntry& entry : matrix.row(i)) {
      result.factors.push_back(entry.factor.value);
      result.factors.push_back(entry.visibility);
    }
  const RadiositySolution solution = solve_radiosity(matrix, scene.materials, scene.sky_emission);
  for (const ChannelSolution& channel : solution.channels)
    for (const ElementRadiosity& element : channel.elements)
      for (const double value : {element.radiosity, element.lower, element.upper, element.irradiance})
        result.radiosities.push_back(value);
  const Labels2 labels(scene, prepared.arrangement, prepared.division, Per::kFace);
  const auto channels = static_cast<std::uint32_t>(solution.channels.size());
  result.light = illuminate_points(prepared, default_grid(scene, 24),
                                   FaceRadiosity2(prepared.arrangement, labels, radiosity_by_element(solution),
                                                  sky_by_channel(scene.sky_emission, channels)))
                     .values;
  return result;
}

TEST(FloatingPointEnvironment, OfTheCallerChangesNothing) {
  const Scene2 scene = read_scene_2(std::string(HOTTEL_SOURCE_DIR) + "/scenes/showcase/apartment.json");
  const Everything nearest = everything(scene);
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
    const Everything other = everything(scene);
    const int left = std::fegetround();
    std::fesetround(FE_TONEAREST);
    EXPECT_EQ(left, mode);
    EXPECT_TRUE(other.factors == nearest.factors);
    EXPECT_TRUE(other.radiosities == nearest.radiosities);
    EXPECT_TRUE(other.light == nearest.light);
  }
}

}  // namespace
}  // namespace hottel
