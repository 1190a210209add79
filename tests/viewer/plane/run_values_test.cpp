// Values along the faces of a plan: means at inner points, rims, covered parts, constants.
#include "viewer/picture/plane/run_values.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <random>
#include <tuple>
#include <vector>

#include "tests/viewer/plane/drawn_scenes.h"
#include "viewer/picture/colour_map.h"
#include "viewer/picture/plane/scene_painter.h"

namespace hottel::run_values_test {
namespace {

const Frame2 kFrame(Point2{0, 0}, Point2{4, 3}, 400, 300);

// Edge 0 with elements at 0, 1/2, 3/4, 1 of its length 4.
Scene2 divided_edge() {
  DrawnScene drawn;
  drawn.edge({0, 0}, {4, 0});
  drawn.scene.surfaces[0].elements = 2;
  drawn.scene.surfaces[0].trees.front = {{0, {}}, {1, TreePath(std::array{0})}, {1, TreePath(std::array{1})}};
  return drawn.scene;
}

// The values of the runs of a scene, in the order of elements.
std::vector<std::optional<RunValue2>> values_of(const Scene2& scene, const std::vector<std::optional<double>>& values,
                                                Shading shading) {
  const PreparedScene2 prepared = prepare(scene, Divided2::kYes);
  return run_values_2(FaceRuns2(prepared, kFrame, Granularity::kElement), values, shading);
}

TEST(RunValues2, InnerPointsHaveMeansByLengthsAndEndsTheirOwn) {
  const std::vector<std::optional<double>> values{1, 4, 8};
  const auto smooth = values_of(divided_edge(), values, Shading::kSmooth);
  ASSERT_EQ(smooth.size(), 4u);  // and a back, which has none
  EXPECT_FALSE(smooth[3]);
  EXPECT_EQ(*smooth[0], (RunValue2{1, 1, (2 * 1 + 4) / 3.0}));
  EXPECT_EQ(*smooth[1], (RunValue2{(2 * 1 + 4) / 3.0, 4, 6}));
  EXPECT_EQ(*smooth[2], (RunValue2{6, 8, 8}));
  const auto flat = values_of(divided_edge(), values, Shading::kFlat);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(*flat[k], (RunValue2{*values[k], *values[k], *values[k]}));
  const auto parents = values_of(divided_edge(), values, Shading::kParents);
  EXPECT_EQ(*parents[0], (RunValue2{1, 1, (2 * 1 + 6) / 3.0}));
  EXPECT_EQ(*parents[1], (RunValue2{(2 * 1 + 6) / 3.0, 6, 6}));
  EXPECT_EQ(*parents[2], (RunValue2{6, 6, 6}));
}

TEST(RunValues2, AreLinearBetweenTheirPlaces) {
  const RunValue2 value{1, 3, 2};
  for (const auto& [share, expected] : {std::pair{0.0, 1.0}, {0.25, 2.0}, {0.5, 3.0}, {0.75, 2.5}, {1.0, 2.0}})
    EXPECT_EQ(value.at(share), expected);
}

TEST(RunValues2, NothingIsTakenOfWhatHasNoValue) {
  const auto smooth =
      values_of(divided_edge(), {1, std::nullopt, std::numeric_limits<double>::quiet_NaN()}, Shading::kSmooth);
  EXPECT_EQ(*smooth[0], (RunValue2{1, 1, 1}));
  EXPECT_FALSE(smooth[1] || smooth[2]);
}

// A front and a back, and the faces of a corner, share points and no values.
TEST(RunValues2, FacesStayApart) {
  DrawnScene drawn;
  drawn.edge({0, 0}, {2, 0}, 0, 0);
  drawn.edge({2, 0}, {4, 0}, 0, 0);
  for (Surface& surface : drawn.scene.surfaces) surface.elements = 2;
  const auto smooth = values_of(drawn.scene, {1, 2, 3, 4, 5, 6, 7, 8}, Shading::kSmooth);
  ASSERT_EQ(smooth.size(), 8u);
  for (std::size_t k = 0; k < 8; k += 2) {  // of each face: own value at its ends, their mean between
    const double first = static_cast<double>(k) + 1;
    for (const std::size_t run : {k, k + 1}) {
      const double own = first + static_cast<double>(run - k);
      EXPECT_EQ(smooth[run]->middle, own);
      EXPECT_EQ(std::minmax(smooth[run]->from, smooth[run]->to), std::minmax(own, first + 0.5));
    }
  }
}

// (2), (3), over random trees.
TEST(RunValues2, NothingJumpsAndNothingLeavesTheRange) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(0.1, 10);
  for (int round = 0; round < 20; ++round) {
    Scene2 scene = furnished_room();
    for (Surface& surface : scene.surfaces) {
      const std::function<void(const TreePath&)> grow = [&](const TreePath& path) {
        if (path.depth() == 5 || random() % 3 == 0) return surface.trees.front.push_back({0, path});
        for (int digit = 0; digit < 2; ++digit) grow(path.child(digit));
      };
      grow({});
    }
    const PreparedScene2 prepared = prepare(scene, Divided2::kYes);
    const FaceRuns2 runs(prepared, kFrame, Granularity::kElement);
    std::vector<std::optional<double>> values;
    for (std::size_t k = 0; k < runs.elements().size(); ++k) values.emplace_back(any(random));
    const auto smooth = run_values_2(runs, values, Shading::kSmooth);
    std::map<std::tuple<std::uint32_t, bool, std::uint32_t>, std::vector<std::pair<double, double>>> at;  // value, own
    for (std::uint32_t run = 0; run < smooth.size(); ++run) {
      const auto place = [&](std::uint32_t corner) {
        return std::tuple(runs.face(run).surface, runs.face(run).is_back, corner);
      };
      at[place(runs.corners().from[run])].emplace_back(smooth[run]->from, smooth[run]->middle);
      at[place(runs.corners().to[run])].emplace_back(smooth[run]->to, smooth[run]->middle);
    }
    std::size_t inner = 0;
    for (const auto& [place, ends] : at) {
      ASSERT_LE(ends.size(), 2u);
      if (ends.size() == 1) {
        EXPECT_EQ(ends[0].first, ends[0].second) << "an end has its element's value";
        continue;
      }
      ++inner;
      EXPECT_EQ(ends[0].first, ends[1].first) << "the jump is 0";
      EXPECT_GE(ends[0].first, std::min(ends[0].second, ends[1].second));
      EXPECT_LE(ends[0].first, std::max(ends[0].second, ends[1].second));
    }
    EXPECT_GT(inner, 0u);
    const std::vector<std::optional<double>> equal(values.size(), 0.7 / 3);
    for (const auto& value : run_values_2(runs, equal, Shading::kSmooth))
      EXPECT_EQ(*value, (RunValue2{0.7 / 3, 0.7 / 3, 0.7 / 3}));
  }
}

// The stripe is one, and its colours run along it.
TEST(ScenePicture2, BlendedStripesRunBetweenTheColoursOfTheirValues) {
  const Scene2 scene = divided_edge();
  const PreparedScene2 prepared = prepare(scene, Divided2::kYes);
  ScenePicture2 picture;
  picture.colouring =
      FaceColouring2{.elements = {0.0, 0.5, 0.5}, .shading = Shading::kSmooth, .scale = {0, 1}, .title = ""};
  const ScenePicturePainter2 painter(prepared, picture);
  RecordingCanvas canvas(painter.width(), painter.height());
  painter.draw(canvas);
  const auto stripes = canvas.calls(Mark::kStripe);
  ASSERT_EQ(stripes.size(), 3u);
  const double mean = (2 * 0 + 0.5) / 3;
  EXPECT_EQ(stripes[0].stops.front(), (ColourStop{0, map_colour(0)}));
  EXPECT_EQ(stripes[0].stops.back(), (ColourStop{1, map_colour(mean)}));
  EXPECT_EQ(stripes[1].stops.front(), (ColourStop{0, map_colour(mean)}));
  EXPECT_EQ(stripes[1].stops.back(), (ColourStop{1, map_colour(0.5)}));
  EXPECT_TRUE(stripes[2].stops.empty());
  EXPECT_EQ(stripes[2].colour, map_colour(0.5));
}

}  // namespace
}  // namespace hottel::run_values_test
