// Pictures of gathered light: against a point for every pixel, along edges of rooms, and what is refused.
#include "viewer/picture/space/gathered_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "benchmarks/reports/space/gathered_check.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"
#include "kernel/support/parallel.h"
#include "solver/space/light/illumination_grid.h"
#include "solver/space/simulation/simulation.h"
#include "viewer/picture/space/gathered_source.h"
#include "viewer/picture/space/render_picture.h"

namespace hottel::gathered_view_test {
namespace {

Simulation3 solved(const std::string& file, std::uint32_t elements) {
  Scene3 scene = read_scene_3(std::string(HOTTEL_SOURCE_DIR) + "/scenes/" + file);
  if (elements > 0)
    for (Surface& surface : scene.surfaces) surface.elements = elements;
  return Simulation3(std::move(scene), {.factors = {.granularity = Granularity::kElement, .tolerance = 1e-4}});
}

// A solved scene with all that its gathered light is made of.
struct Ready {
  explicit Ready(const Simulation3& simulation)
      : solution(simulation.radiosities()),
        prepared(simulation.prepared()),
        paint(light_paint_3(prepared->scene, *solution)),
        source(*prepared, Granularity::kElement, *solution, light_responses_3(*solution), *simulation.light_shares()) {}

  GatheredScene3 scene() const { return source.scene(paint); }

  std::shared_ptr<const RadiositySolution> solution;
  std::shared_ptr<const PreparedScene3> prepared;
  ElementPaint3 paint;
  GatheredSource3 source;
};

// A lamp that shines, spots and a sun: some pixels of all, and some of those with borders, against full sampling.
// Numbers are told but where a shadow has its border: direct light is sampled too coarsely there.
TEST(GatheredView3, IsFullSamplingWithinHalfAStepAsARule) {
  struct Case {
    const char* file;
    std::uint32_t elements;  // 0: those of the file
  };
  for (const Case& one :
       {Case{"space/two_boxes.json", 3}, Case{"lights/stage.json", 0}, Case{"heat/satellite_in_sun.json", 0}}) {
    const Simulation3 simulation = solved(one.file, one.elements);
    const GatheredCheck3 check = check_gathered_3(simulation, {.width = 80, .pixels = 150, .borders = 100});
    EXPECT_GE(check.pixels.size(), 200u);
    double sum = 0;
    std::size_t over = 0, on_borders = 0, parts_over = 0;
    for (const GatheredPixel3& pixel : check.pixels) {
      sum += pixel.steps;
      over += pixel.steps > 0.5 && !pixel.borders.has_shadow ? 1 : 0;
      parts_over += pixel.part > 0.004 && !pixel.borders.any() ? 1 : 0;
      on_borders += pixel.borders.any() ? 1 : 0;
      EXPECT_LT(pixel.steps, 4) << one.file << ' ' << pixel.x << ' ' << pixel.y;
    }
    const auto all = static_cast<double>(check.pixels.size());
    EXPECT_GE(on_borders, 80u) << one.file;
    EXPECT_LT(sum, 0.15 * all) << one.file;
    EXPECT_LT(static_cast<double>(over), 0.03 * all) << one.file;
    EXPECT_LT(static_cast<double>(parts_over), 0.03 * all) << one.file;
  }
}

// The squares fill the picture, the middle first, and are its pixels.
TEST(GatheredView3, ComesInSquares) {
  const Ready ready(solved("space/cube.json", 2));
  const Camera3 camera = camera_of_scene(*ready.prepared, 150);
  const auto steps = [](std::span<const double> a, std::span<const double> b) { return std::fabs(a[0] - b[0]); };
  const PixelValues3 whole = gathered_view_3(ready.scene(), camera, steps, 0.01).pixels;
  std::size_t filled = 0;
  std::vector<std::array<std::uint32_t, 2>> places;
  gathered_tiles_3(ready.scene(), camera, steps, 0.01, [&](const PixelTile3& tile) {
    places.push_back({tile.left, tile.top});
    for (std::uint32_t y = 0; y < tile.pixels.height; ++y)
      for (std::uint32_t x = 0; x < tile.pixels.width; ++x, ++filled)
        EXPECT_NEAR(tile.pixels.at(x, y)[0], whole.at(tile.left + x, tile.top + y)[0], 1e-5);
  });
  EXPECT_EQ(filled, std::size_t{camera.width} * camera.height);
  EXPECT_EQ(places.front(), (std::array{64u, camera.height > 64 ? 64u : 0u}));
}

TEST(GatheredView3, DoesNotDependOnThreads) {
  const Ready ready(solved("space/cube.json", 2));
  const Camera3 camera = camera_of_scene(*ready.prepared, 40);
  const auto view = [&] {
    return gathered_view_3(
        ready.scene(), camera,
        [](std::span<const double> a, std::span<const double> b) { return std::fabs(a[0] - b[0]); }, 0.01);
  };
  const Gathering3 by_all = view();
  const ThreadLimit one(1);
  EXPECT_EQ(view().pixels.values, by_all.pixels.values);
}

// How much light bends from one point to the next of many along a line, at most, as a part of itself: where it jumps,
// by the jump.
double largest_bend(const GatheredLight3& light, const Face& side, const Point3& from, const Point3& to) {
  constexpr int kParts = 300;
  std::vector<double> values, here(light.channels());
  for (int k = 1; k < kParts; ++k) {
    const Rational t(k, kParts);
    light.irradiance({from.x + t * (to.x - from.x), from.y + t * (to.y - from.y), from.z + t * (to.z - from.z)}, side,
                     here);
    values.push_back(here[0]);
  }
  double most = 0;
  for (std::size_t k = 2; k < values.size(); ++k)
    most = std::max(most, std::fabs(values[k] - 2 * values[k - 1] + values[k - 2]) / values[k - 1]);
  return most;
}

// Along the foot of a wall, a ten-thousandth of its height above the floor, whose elements would make steps there. A
// step of 256 is about a hundredth of the light.
TEST(GatheredView3, HasNoStepsAlongEdges) {
  const Simulation3 simulation = solved("space/cornell_box.json", 4);
  const Ready ready(simulation);
  const GatheredLight3 with_steps(*ready.prepared, Granularity::kElement, *ready.solution);
  const auto& surfaces = simulation.scene().surfaces;
  const auto back = std::ranges::find(surfaces, "back", &Surface::name) - surfaces.begin();
  ASSERT_LT(back, static_cast<std::ptrdiff_t>(surfaces.size()));
  const std::uint32_t piece = simulation.prepared()->arrangement().pieces_on(static_cast<std::uint32_t>(back))[0];
  const Rational above(5588, 100'000), depth(5592, 10);
  const Point3 from{Rational(20), above, depth}, to{Rational(520), above, depth};
  EXPECT_GT(largest_bend(with_steps, {piece, false}, from, to), 0.1);
  EXPECT_LT(largest_bend(ready.source.light(), {piece, false}, from, to), 0.008);
}

TEST(GatheredView3, ShowsNumbersOfPoints) {
  const Simulation3 simulation = solved("space/cube.json", 1);
  const auto solution = simulation.radiosities();
  const ElementRadiosity& element = solution->channels[0].elements[0];
  std::vector<double> irradiance;
  for (const ChannelSolution& channel : solution->channels) irradiance.push_back(channel.elements[0].irradiance);
  const auto mean = [&](double ElementRadiosity::*of) {
    double sum = 0;
    for (const ChannelSolution& channel : solution->channels) sum += channel.elements[0].*of;
    return sum / static_cast<double>(irradiance.size());
  };
  double value = 0;
  responses_3(shown_by("irradiance"), *solution).value(0, irradiance, std::span(&value, 1));
  EXPECT_DOUBLE_EQ(value, mean(&ElementRadiosity::irradiance));
  responses_3(shown_by("radiosity"), *solution).value(0, irradiance, std::span(&value, 1));
  EXPECT_NEAR(value, mean(&ElementRadiosity::radiosity), 1e-12 * element.radiosity);
  responses_3(shown_by("net"), *solution).value(0, irradiance, std::span(&value, 1));
  EXPECT_NEAR(value, mean(&ElementRadiosity::radiosity) - mean(&ElementRadiosity::irradiance), 1e-12);
  EXPECT_THROW(responses_3(shown_by("sky"), *solution), UsageError);
}

TEST(GatheredView3, IsOfPixels) {
  const Simulation3 simulation = solved("space/cube.json", 1);
  const RenderedView3 view(*simulation.prepared(), Granularity::kElement, *simulation.radiosities(),
                           {.wanted_width = 40, .shading = Shading::kGathered});
  EXPECT_FALSE(view.file(PictureFormat::kPng).empty());
  EXPECT_THROW(view.file(PictureFormat::kSvg), UsageError);
}

}  // namespace
}  // namespace hottel::gathered_view_test
