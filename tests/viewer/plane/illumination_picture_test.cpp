#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <numeric>
#include <random>

#include "geometry/plane/scene/scene_builder.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"
#include "tests/viewer/plane/drawn_scenes.h"
#include "viewer/picture/colour_map.h"
#include "viewer/picture/palette.h"
#include "viewer/picture/plane/illumination_painter.h"
#include "viewer/picture/plane/light_pixels.h"

namespace hottel::illumination_picture_test {
namespace {

using testing::StartsWith;
using Kind = RecordingCanvas::Kind;

IlluminationGrid2 grid_of(Grid2 cells, std::vector<double> values, std::uint32_t channels = 1) {
  return {std::move(cells), channels, std::move(values)};
}

IlluminationGrid2 random_grid(Grid2 cells, std::uint32_t channels) {
  std::mt19937 random(7);
  IlluminationGrid2 grid{cells, channels, {}};
  for (std::size_t k = 0; k < std::size_t{cells.nx} * cells.ny * channels; ++k)
    grid.values.push_back(static_cast<double>(random() % 1000));
  return grid;
}

std::vector<double> all_pixels(const LightPixels2& pixels, const IlluminationGrid2& grid) {
  std::vector<double> all;
  for (std::uint32_t iy = 0; iy < grid.grid.ny; ++iy) {
    const std::vector<double> row = pixels.row_of_cells(iy);
    all.insert(all.end(), row.begin(), row.end());
  }
  EXPECT_EQ(all.size(), std::size_t{pixels.width()} * pixels.height() * grid.channels);
  return all;
}

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

RecordingCanvas drawn(const Scene2& scene, const IlluminationGrid2& grid, const IlluminationPicture2& picture = {}) {
  const PreparedScene2 prepared = prepare(scene);
  const IlluminationPainter2 painter(prepared, grid, picture);
  RecordingCanvas canvas(painter.width(), painter.height());
  painter.draw(canvas);
  return canvas;
}

// By the winding number.
bool is_inside(const std::vector<Pixel>& polygon, Pixel p) {
  int winding = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Pixel &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    if ((a.y > p.y) == (b.y > p.y)) continue;
    if (a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y) > p.x) winding += a.y < b.y ? 1 : -1;
  }
  return winding != 0;
}

double linear(const Colour& colour) { return linear_from_srgb(colour.g); }

TEST(LightPixels2, IntegrateToTheGrid) {
  for (const std::uint32_t per_cell : {1u, 2u, 5u}) {
    const IlluminationGrid2 grid = random_grid({{0, 0}, {1, 1}, 7, 5}, 3);
    const LightPixels2 pixels(grid, per_cell, per_cell + 1, nullptr);
    const std::vector<double> all = all_pixels(pixels, grid);
    for (std::uint32_t c = 0; c < 3; ++c) {
      double before = 0, after = 0;
      for (std::size_t k = c; k < grid.values.size(); k += 3) before += grid.values[k];
      for (std::size_t k = c; k < all.size(); k += 3) after += all[k];
      EXPECT_NEAR(after / (per_cell * (per_cell + 1)), before, 1e-9 * before);
    }
  }
}

TEST(LightPixels2, EachCellCountsAsMuchAsItsAreaAwayFromWalls) {
  const Scene2 room = furnished_room();
  const Grid2 cells{{0, 0}, {4, 3}, 40, 30};
  const auto spread = [&](std::uint32_t ix, std::uint32_t iy) {
    IlluminationGrid2 one = grid_of(cells, std::vector<double>(1200, 0.0));
    one.values[iy * 40 + ix] = 1;
    return sum(all_pixels(LightPixels2(one, 4, 4, &room), one)) / 16;
  };
  EXPECT_NEAR(spread(30, 25), 1, 1e-12);
  EXPECT_NEAR(spread(15, 5), 1, 1e-12);
  EXPECT_NEAR(spread(5, 20), 1, 1e-12);
}

TEST(LightPixels2, AreTheCellsWhereThereIsOnePixelForEach) {
  const IlluminationGrid2 grid = random_grid({{0, 0}, {2, 1}, 20, 10}, 2);
  EXPECT_EQ(all_pixels(LightPixels2(grid, 1, 1, nullptr), grid), grid.values);
}

TEST(LightPixels2, DoNotLeakThroughWalls) {
  for (const Rational& wall : {Rational(2), Rational(19, 10), Rational(5, 2), Rational(13, 5)}) {
    DrawnScene scene;
    scene.edge({wall, -1}, {wall, 5});
    IlluminationGrid2 grid = grid_of({{0, 0}, {4, 4}, 4, 4}, std::vector<double>(16, 0.0));
    for (std::uint32_t iy = 0; iy < 4; ++iy)
      for (std::uint32_t ix = 0; ix < 4; ++ix) {
        const Rational centre(2 * ix + 1, 2);
        grid.values[4 * iy + ix] = centre < wall ? 1 : centre > wall ? 0 : 0.5;
      }
    const LightPixels2 pixels(grid, 20, 20, &scene.scene);
    const std::vector<double> all = all_pixels(pixels, grid);
    for (std::size_t k = 0; k < all.size(); ++k) {
      const double x = (static_cast<double>(k % 80) + 0.5) / 20;
      EXPECT_EQ(all[k], x < to_double(wall) ? 1 : 0) << to_double(wall) << " " << x;
    }
  }
}

// (4): among black walls all light comes straight from the lights, and each pixel has that of its own centre.
TEST(LightPixels2, HaveTheLightOfLightsAtTheirOwnCentres) {
  SceneBuilder2 builder;
  builder.add_material("black", {});
  builder.add_polyline("room", {{0, 0}, {0, 3}, {4, 3}, {4, 0}}, "black", {.closed = true});
  builder.add_polyline("pillar", {{2, 1}, {"5/2", 1}, {"5/2", 2}, {2, 2}}, "black", {.closed = true});
  Scene2 scene = builder.build();
  Light spot{.name = "spot", .type = LightType::kSpot, .focus = 40, .power = {}};
  spot.power = Spectrum::scalar(3);
  scene.add_light(spot, {.position = {Rational(1, 2), Rational(7, 5)}, .direction = {1, 0}, .path = {}});
  const PreparedScene2 prepared = prepare(scene);
  const Grid2 cells{{0, 0}, {4, 3}, 8, 6}, fine{{0, 0}, {4, 3}, 40, 24};
  const auto dark = [](const Grid2& of) { return grid_of(of, std::vector<double>(std::size_t{of.nx} * of.ny, 0.0)); };
  const IlluminationGrid2 light = with_lights(prepared, dark(cells));
  const std::vector<double> pixels = all_pixels(LightPixels2(prepared, light, 5, 4), light);
  EXPECT_EQ(pixels, with_lights(prepared, dark(fine)).values);
  const auto is_dark = [](double value) { return value == 0; };
  EXPECT_GT(std::ranges::count_if(pixels, is_dark), 100);  // beside the beam, and in the shadow
  EXPECT_GT(std::ranges::count_if(pixels, std::not_fn(is_dark)), 100);
  EXPECT_EQ(without_lights(prepared, light).values, dark(cells).values);
}

TEST(LightPixels2, AreThoseOfTheSceneAsWallsWithoutLights) {
  const Scene2 scene = read_scene_2(std::string(HOTTEL_SOURCE_DIR) + "/scenes/showcase/apartment.json");
  const PreparedScene2 prepared = prepare(scene);
  const IlluminationGrid2 grid = random_grid(grid_over(scene, 40, 30), 3);
  EXPECT_EQ(all_pixels(LightPixels2(prepared, grid, 3, 2), grid), all_pixels(LightPixels2(grid, 3, 2, &scene), grid));
}

TEST(LightPixels2, PassOverCellsInSolids) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const IlluminationGrid2 grid = grid_of({{0, 0}, {4, 1}, 4, 1}, {3, nan, nan, 5});
  const std::vector<double> all = all_pixels(LightPixels2(grid, 4, 1, nullptr), grid);
  for (std::size_t k = 0; k < 6; ++k) EXPECT_EQ(all[k], 3) << k;
  for (std::size_t k = 6; k < 10; ++k) EXPECT_TRUE(std::isnan(all[k])) << k;
  for (std::size_t k = 10; k < 16; ++k) EXPECT_EQ(all[k], 5) << k;
}

TEST(LightPixels2, StayBetweenTheValuesAroundThem) {
  const Scene2 room = furnished_room();
  const IlluminationGrid2 even = grid_of({{-1, -1}, {5, 4}, 17, 13}, std::vector<double>(221, 0.3));
  for (const double value : all_pixels(LightPixels2(even, 5, 5, &room), even)) EXPECT_DOUBLE_EQ(value, 0.3);
  const IlluminationGrid2 grid = random_grid({{-1, -1}, {5, 4}, 17, 13}, 1);
  const auto [least, largest] = std::minmax_element(grid.values.begin(), grid.values.end());
  for (const double value : all_pixels(LightPixels2(grid, 3, 5, &room), grid)) {
    EXPECT_GE(value, *least);
    EXPECT_LE(value, *largest * (1 + 1e-12));
  }
}

TEST(ToneCurve, LinearIsTheTransferOfSrgb) {
  const std::vector<double> values{0.1, 0.5, 7};
  const ToneCurve tone(Tone::kLinear, 2, values, 3);
  EXPECT_EQ(tone.scale(), 2);
  const Colour shown = tone(std::array{0.1, 0.25, 7.0});
  EXPECT_DOUBLE_EQ(shown.r, 1.055 * std::pow(0.2, 1 / 2.4) - 0.055);
  EXPECT_DOUBLE_EQ(shown.g, 1.055 * std::pow(0.5, 1 / 2.4) - 0.055);
  EXPECT_NEAR(shown.b, 1, 1e-12);
  EXPECT_DOUBLE_EQ(tone(std::array{0.001, 0.001, 0.001}).r, 12.92 * 0.002);
}

TEST(ToneCurve, MaxShowsTheLargestValueAsOne) {
  const std::vector<double> values{0, 4, 2, 8};
  const ToneCurve tone(Tone::kMax, 1, values, 1);
  EXPECT_EQ(tone.scale(), 0.125);
  EXPECT_NEAR(linear(tone(std::array{8.0})), 1, 1e-12);
  EXPECT_NEAR(linear(tone(std::array{2.0})), 0.25, 1e-12);
}

TEST(ToneCurve, ReinhardAndLogAreTheirFormulas) {
  const std::vector<double> values{0, 1, 4, 16};  // geometric mean of the lit ones: 4
  const ToneCurve reinhard(Tone::kReinhard, 2, values, 1);
  EXPECT_NEAR(reinhard.scale(), 0.25 * 2 / 4, 1e-15);
  const double y = 4 * reinhard.scale(), white = 16 * reinhard.scale();
  EXPECT_NEAR(linear(reinhard(std::array{4.0})), y * (1 + y / white / white) / (1 + y), 1e-12);
  const ToneCurve log(Tone::kLog, 1, values, 1);
  EXPECT_NEAR(log.scale(), 0.5, 1e-15);
  EXPECT_NEAR(linear(log(std::array{4.0})), std::log1p(2) / std::log1p(8), 1e-12);
  for (const ToneCurve& tone : {reinhard, log}) EXPECT_NEAR(linear(tone(std::array{16.0})), 1, 1e-12);
}

TEST(ToneCurve, BrighterIsNotDarkerAndZeroIsBlack) {
  const std::vector<double> values{0, 0.01, 3, 50};
  for (const Tone tone : {Tone::kLinear, Tone::kReinhard, Tone::kLog, Tone::kMax}) {
    const ToneCurve curve(tone, 0.7, values, 1);
    EXPECT_EQ(curve(std::array{0.0}), Colour{});
    double last = 0;
    for (double value = 0; value < 200; value = value * 1.1 + 0.01) {
      const double shown = curve(std::array{value}).r;
      EXPECT_GE(shown, last);
      EXPECT_LE(shown, 1);
      last = shown;
    }
  }
}

TEST(ToneCurve, CompressionKeepsTheHueWhileItFits) {
  const std::vector<double> values{0.2, 0.1, 0.1, 3, 2, 1};
  const ToneCurve tone(Tone::kReinhard, 1, values, 3);
  const Colour shown = tone(std::array{0.2, 0.1, 0.05});
  EXPECT_NEAR(linear_from_srgb(shown.r) / linear_from_srgb(shown.g), 2, 1e-9);
  EXPECT_NEAR(linear_from_srgb(shown.g) / linear_from_srgb(shown.b), 2, 1e-9);
  const Colour bright = tone(std::array{0.0, 0.0, 40.0});  // blue alone cannot be that bright
  EXPECT_NEAR(bright.b, 1, 1e-12);
  EXPECT_NEAR(bright.r, bright.g, 1e-12);
  EXPECT_GT(bright.r, 0.3);
}

TEST(ToneCurve, DarknessIsBlackUnderEveryCurve) {
  const std::vector<double> values(12, 0.0);
  for (const Tone tone : {Tone::kLinear, Tone::kReinhard, Tone::kLog, Tone::kMax})
    EXPECT_EQ(ToneCurve(tone, 1, values, 3)(std::array{0.0, 0.0, 0.0}), Colour{});
  EXPECT_EQ(tone_of("log"), Tone::kLog);
  EXPECT_EQ(tone_of("gamma"), std::nullopt);
}

TEST(IlluminationPicture2, HasTheLargestYOnTop) {
  DrawnScene far;
  far.edge({100, 100}, {101, 100});
  const IlluminationGrid2 grid = grid_of({{0, 0}, {2, 2}, 2, 2}, {1, 2, 3, 4});  // 4: right, above
  const RecordingCanvas canvas = drawn(far.scene, grid, {.tone = Tone::kMax, .wanted_side = 2});
  const auto images = canvas.calls(Mark::kLight);
  ASSERT_EQ(images.size(), 1u);
  const Raster& image = images[0].image;
  ASSERT_EQ(image.width, 2u);
  ASSERT_EQ(image.height, 2u);
  const std::array light{0.75, 1.0, 0.25, 0.5};
  for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(image.pixels[k], 0xFF000000u | srgb_level(light[k]) * 0x010101u) << k;
}

TEST(IlluminationPicture2, HasWholePixelsForEachCell) {
  const PreparedScene2 room = prepare(furnished_room());
  const auto size = [&](std::uint32_t nx, std::uint32_t ny, std::uint32_t wanted) {
    const IlluminationGrid2 grid = grid_of({{0, 0}, {4, 3}, nx, ny}, std::vector<double>(std::size_t{nx} * ny, 1.0));
    const IlluminationPainter2 painter(room, grid, {.wanted_side = wanted});
    return std::pair(painter.width(), painter.height());
  };
  EXPECT_EQ(size(256, 192, 1400), (std::pair{1280u, 960u}));
  EXPECT_EQ(size(256, 192, 10), (std::pair{256u, 192u}));
  EXPECT_EQ(size(4, 6, 400), (std::pair{400u, 300u}));
  EXPECT_EQ(size(1, 1, 1000), (std::pair{1000u, 750u}));
  EXPECT_EQ(size(5000, 1, 1400), (std::pair{5000u, 1050u}));
}

TEST(IlluminationPicture2, ShowsSolidsOverTheLightAndEdgesOnTop) {
  const Scene2 room = furnished_room();
  const IlluminationGrid2 grid = grid_of({{0, 0}, {4, 3}, 40, 30}, std::vector<double>(1200, 1.0));
  const RecordingCanvas canvas = drawn(room, grid);
  std::vector<Mark> order;
  for (const auto& call : canvas.calls())
    if (order.empty() || order.back() != call.mark) order.push_back(call.mark);
  EXPECT_THAT(order, testing::ElementsAre(Mark::kLight, Mark::kSolid, Mark::kHatch, Mark::kEdge, Mark::kEmitter));
  EXPECT_EQ(canvas.count(Mark::kEdge), room.surfaces.size());
  EXPECT_EQ(canvas.count(Mark::kEmitter), 1u);
  const auto window = canvas.calls(Mark::kEmitter)[0].points;
  EXPECT_NEAR(window[0].y, canvas.height(), 1e-9);  // at y = 0
  EXPECT_NEAR(window[0].x, canvas.width() * 0.75, 1e-9);
}

TEST(IlluminationPicture2, RoomsInSolidsAreLit) {
  DrawnScene scene;
  scene.closed({{0, 0}, {4, 0}, {4, 4}, {0, 4}});  // a block, fronts outside
  scene.closed({{1, 1}, {1, 3}, {3, 3}, {3, 1}});  // a room in it
  const IlluminationGrid2 grid = grid_of({{-1, -1}, {5, 5}, 6, 6}, std::vector<double>(36, 1.0));
  const RecordingCanvas canvas = drawn(scene.scene, grid);
  EXPECT_EQ(canvas.count(Mark::kLight), 1u);
  ASSERT_EQ(canvas.count(Mark::kSolid), 1u);
  const std::vector<Pixel> solid = canvas.calls(Mark::kSolid)[0].points;
  const double cell = canvas.width() / 6;
  EXPECT_FALSE(is_inside(solid, {0.5 * cell, 0.5 * cell}));
  EXPECT_TRUE(is_inside(solid, {1.5 * cell, 1.5 * cell}));
  EXPECT_FALSE(is_inside(solid, {2.6 * cell, 3.3 * cell}));
}

TEST(IlluminationPicture2, SolidIsWhatIsSolidInTheArrangement) {
  DrawnScene scene;
  scene.closed({{0, 0}, {0, 3}, {4, 3}, {4, 0}});
  scene.closed({{1, 1}, {2, 1}, {2, 2}, {1, 2}});  // fronts outward, but open
  scene.scene.groups.back().behind = Behind::kOpen;
  scene.edge({3, 3}, {3, 2}, 1);  // a lamp in the corner, drawn as two sides
  scene.edge({3, 2}, {4, 2}, 1);
  scene.scene.groups.pop_back();
  scene.scene.groups.back().behind = Behind::kSolid;
  scene.scene.surfaces.back().group -= 1;
  const IlluminationGrid2 grid = grid_of({{0, 0}, {4, 3}, 4, 3}, std::vector<double>(12, 1.0));
  const RecordingCanvas canvas = drawn(scene.scene, grid);
  ASSERT_EQ(canvas.count(Mark::kSolid), 1u);
  const std::vector<Pixel> solid = canvas.calls(Mark::kSolid)[0].points;
  const double cell = canvas.width() / 4;
  EXPECT_TRUE(is_inside(solid, {3.5 * cell, 0.5 * cell}));
  EXPECT_FALSE(is_inside(solid, {1.5 * cell, 1.5 * cell}));
  EXPECT_EQ(canvas.count(Mark::kEmitter), 2u);
}

TEST(IlluminationPicture2, PlacesWithoutAValueAreGreyAndDoNotCount) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const IlluminationGrid2 grid = grid_of({{0, 0}, {3, 1}, 3, 1}, {1, nan, nan});
  const IlluminationGrid2 lit = grid_of({{0, 0}, {1, 1}, 1, 1}, {1});
  for (const Tone tone : {Tone::kLinear, Tone::kMax, Tone::kReinhard, Tone::kLog}) {
    const RecordingCanvas canvas = drawn(Scene2{}, grid, {.tone = tone, .wanted_side = 3});
    const Raster image = canvas.calls(Mark::kLight)[0].image;
    ASSERT_EQ(image.pixels.size(), 3u);
    EXPECT_EQ(image.pixels[0],
              drawn(Scene2{}, lit, {.tone = tone, .wanted_side = 1}).calls(Mark::kLight)[0].image.pixels[0]);
    EXPECT_EQ(image.pixels[2], pixel_of(palette::kUnlitSolid));
  }
}

TEST(IlluminationPicture2, AxesAreAroundTheSamePixels) {
  const IlluminationGrid2 grid = random_grid({{0, 0}, {4, 3}, 16, 12}, 3);
  const RecordingCanvas plain = drawn(furnished_room(), grid, {.wanted_side = 640});
  const RecordingCanvas framed = drawn(furnished_room(), grid, {.wanted_side = 640, .has_axes = true});
  const auto before = plain.calls(Mark::kLight)[0], after = framed.calls(Mark::kLight)[0];
  EXPECT_EQ(before.image.pixels, after.image.pixels);
  EXPECT_EQ(before.points[1], (Pixel{640, 480}));
  const Pixel from = after.points[0], to = after.points[1];
  EXPECT_EQ(to.x - from.x, 640);
  EXPECT_EQ(to.y - from.y, 480);
  EXPECT_TRUE(from.x > 0 && from.x == std::floor(from.x) && from.y > 0 && from.y == std::floor(from.y));
  EXPECT_GT(framed.width(), to.x);
  EXPECT_GT(framed.height(), to.y);
  // The window, which the plan has in the lower side of the room, is where the axes say: 1 to 3.
  const auto window = framed.calls(Mark::kEmitter)[0].points;
  EXPECT_NEAR(std::min(window[0].x, window[1].x), from.x + 160, 1e-9);
  EXPECT_NEAR(std::max(window[0].x, window[1].x), from.x + 480, 1e-9);
  EXPECT_EQ(plain.count(Mark::kAxis), 0u);
  EXPECT_GT(framed.count(Mark::kAxis), 10u);
  EXPECT_GT(framed.count(Mark::kScaleBar), 3u);
}

TEST(IlluminationPicture2, ContoursRunWhereTheLightHasTheirLevelAndEndAtWalls) {
  // Light that grows from left to right, in a field with a screen across it from (1, 1) to (1, 2) of 2 x 3.
  DrawnScene screen;
  screen.edge({Rational(1, 2), Rational(3, 2)}, {Rational(3, 2), Rational(3, 2)});
  IlluminationGrid2 grid{{{0, 0}, {2, 3}, 40, 60}, 1, {}};
  for (int iy = 0; iy < 60; ++iy)
    for (int ix = 0; ix < 40; ++ix) grid.values.push_back(1 + (ix + 0.5) / 40);
  EXPECT_EQ(light_contours_2(grid, 4), (std::vector<double>{1.2, 1.4, 1.6, 1.8}));
  EXPECT_TRUE(light_contours_2(grid, 0).empty());
  const RecordingCanvas canvas = drawn(screen.scene, grid, {.wanted_side = 600, .contours = 4});
  std::size_t lines = 0;
  for (const auto& call : canvas.calls(Mark::kCurve)) {
    if (call.kind != Kind::kStroke) continue;
    ++lines;
    for (const Pixel& p : call.points) {
      EXPECT_NEAR(std::fmod(p.x, 80), std::fmod(p.x, 80) < 40 ? 0 : 80, 0.5) << "a level of 1.2, 1.4, 1.6 or 1.8";
    }
    const bool is_at_screen = call.points[0].x > 105 && call.points[0].x < 295;
    EXPECT_FALSE(is_at_screen && (call.points[0].y < 300) != (call.points[1].y < 300)) << "through the screen";
  }
  EXPECT_EQ(lines, 2 * (2 + 2 * 2)) << "twice each; those at 1.4 and 1.6 in two parts";
  EXPECT_EQ(drawn(screen.scene, grid, {.wanted_side = 600}).count(Mark::kCurve), 0u);
}

TEST(IlluminationPicture2, BecomesAFileOfEitherFormat) {
  const PreparedScene2 room = prepare(furnished_room());
  const IlluminationGrid2 grid = random_grid({{0, 0}, {4, 3}, 16, 12}, 3);
  const IlluminationPicture2 small{.wanted_side = 160};
  EXPECT_THAT(illumination_picture_2(room, grid, small, PictureFormat::kPng).bytes, StartsWith("\x89PNG"));
  EXPECT_THAT(illumination_picture_2(room, grid, small, PictureFormat::kSvg).bytes, StartsWith("<?xml"));
  EXPECT_THAT(illumination_picture_2(prepare(Scene2{}), grid, small, PictureFormat::kPng).bytes, StartsWith("\x89PNG"));
}

TEST(IlluminationPicture2, RefusesGridsWithMoreCellsThanPixels) {
  const IlluminationGrid2 grid =
      grid_of({{0, 0}, {1, 1}, kMaxPictureSide + 1, 1}, std::vector<double>(kMaxPictureSide + 1, 1.0));
  EXPECT_THROW(illumination_picture_2(prepare(furnished_room()), grid, {}, PictureFormat::kPng), UsageError);
}

}  // namespace
}  // namespace hottel::illumination_picture_test
