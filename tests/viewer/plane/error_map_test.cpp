// The map of errors: what it colours, and by what.

#include "viewer/picture/plane/error_map.h"

#include <gtest/gtest.h>

#include "io/scene/scene_json.h"
#include "solver/plane/methods/method_catalogue.h"
#include "viewer/picture/colour_map.h"
#include "viewer/picture/plane/scene_painter.h"

namespace hottel::error_map_test {
namespace {

PreparedScene2 lit_square(const char* emission) {
  return prepare(parse_scene_2(std::string(R"({"hottel":1,"dimension":2,"materials":{"lamp":{"emission":)") + emission +
                                   R"(},"white":{"reflectivity":0.5}},
    "edges":[{"name":"lamp","points":[[1,0],[0,0]],"material":"lamp"}],
    "polylines":[{"name":"wall","points":[[0,0],[0,1],[1,1],[1,0]],"material":"white"}]})",
                               "square"),
                 Divided2::kYes);
}

TEST(ErrorMap, ColoursFacesByTheirErrorOverTheLargestRadiosity) {
  const PreparedScene2 prepared = lit_square("4");
  const MethodComparison2 comparison{Simulation2(prepared.scene)};
  const MethodResult result = comparison.run(*methods_2().make("gauss:1"), 1);
  const ScenePicture2 picture = error_map_picture_2(comparison, result);
  ASSERT_TRUE(picture.colouring);
  ASSERT_TRUE(picture.pixels);
  EXPECT_EQ(picture.colouring->front[0], 0) << "a lamp that reflects nothing sends out what it emits";
  double largest = 0;
  for (std::uint32_t i = 0; i < comparison.exact().size(); ++i) {
    if (!comparison.exact().has_row(i)) continue;
    const double exact = comparison.exact_solution()->channels[0].elements[i].radiosity;
    const double found = result.solution->channels[0].elements[i].radiosity;
    const std::optional<double>& face = picture.colouring->front[comparison.exact().elements()[i].surface];
    EXPECT_DOUBLE_EQ(face.value(), std::abs(found - exact) / 4);
    largest = std::max(largest, *face);
  }
  EXPECT_GT(largest, 0.01);
  EXPECT_DOUBLE_EQ(largest, *result.max_radiosity_error);
  EXPECT_GE(picture.colouring->scale.upper, largest);
  EXPECT_EQ(picture.pixels->image.pixels.size(), std::size_t{256} * 256);
}

TEST(ErrorMap, OfTheExactMethodIsZeroEverywhere) {
  const PreparedScene2 prepared = lit_square("4");
  const MethodComparison2 comparison{Simulation2(prepared.scene)};
  const ScenePicture2 picture = error_map_picture_2(comparison, comparison.run(*methods_2().make("exact"), 1));
  for (const std::uint32_t pixel : picture.pixels->image.pixels) EXPECT_EQ(pixel, pixel_of(map_colour(0)));
}

TEST(ErrorMap, IsThePlanWhereThereIsNoLight) {
  const PreparedScene2 prepared = lit_square("0");
  const MethodComparison2 comparison{Simulation2(prepared.scene)};
  const MethodResult result = comparison.run(*methods_2().make("gauss:1"), 1);
  EXPECT_EQ(result.max_radiosity_error, 0);
  const ScenePicture2 picture = error_map_picture_2(comparison, result);
  EXPECT_FALSE(picture.colouring);
  EXPECT_EQ(picture.sheet.subtitle, "no radiosities to compare");
}

}  // namespace
}  // namespace hottel::error_map_test
