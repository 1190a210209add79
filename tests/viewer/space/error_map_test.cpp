// Where methods are wrong in space, as values of elements.
#include "viewer/picture/space/error_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "io/external/space/external_matrix.h"
#include "io/scene/scene_json.h"

namespace hottel::error_map_test {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

const MethodComparison3& comparison() {
  static const MethodComparison3 made(
      Simulation3(read_scene_3(std::string(HOTTEL_SOURCE_DIR) + "/scenes/space/two_boxes.json"), {}));
  return made;
}

TEST(ErrorMap3, ValuesAreErrorsOfRadiositiesOverTheLargest) {
  const MethodResult result = comparison().run(*all_methods_3().make("points:1"), 1);
  const ShownValues shown = error_values_3(comparison(), result);
  const RadiositySolution& exact = *comparison().exact_solution();
  double brightest = 0, largest = 0;
  for (const ChannelSolution& channel : exact.channels)
    for (const ElementRadiosity& element : channel.elements) brightest = std::max(brightest, element.radiosity);
  for (std::uint32_t i = 0; i < comparison().exact().size(); ++i) {
    ASSERT_EQ(shown.elements[i].has_value(), comparison().exact().has_row(i));
    if (!shown.elements[i]) continue;
    double error = 0;
    for (std::size_t c = 0; c < exact.channels.size(); ++c)
      error = std::max(error, std::fabs(result.solution->channels[c].elements[i].radiosity -
                                        exact.channels[c].elements[i].radiosity));
    EXPECT_DOUBLE_EQ(*shown.elements[i], error / brightest);
    largest = std::max(largest, *shown.elements[i]);
  }
  EXPECT_EQ(shown.scale.upper, largest);
  EXPECT_NEAR(largest, *result.max_radiosity_error, 1e-15);
  EXPECT_THAT(shown.title, StartsWith("points:1: "));
  EXPECT_THAT(error_map_3(comparison(), result, PictureFormat::kSvg), HasSubstr("<svg"));
}

TEST(ErrorMap3, AMethodWithoutRadiositiesHasNoValues) {
  MethodResult result = comparison().run(*all_methods_3().make("center"), 1);
  result.solution.reset();
  const ShownValues shown = error_values_3(comparison(), result);
  EXPECT_TRUE(std::ranges::none_of(shown.elements, [](const auto& value) { return value.has_value(); }));
  EXPECT_THAT(shown.title, HasSubstr("no radiosities to compare"));
  EXPECT_THAT(error_map_3(comparison(), result, PictureFormat::kPng), StartsWith("\x89PNG"));
}

}  // namespace
}  // namespace hottel::error_map_test
