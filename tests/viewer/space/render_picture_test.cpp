// Pictures of what a camera sees: shapes that partition the picture, the colours of the pixels, bands, the scale.
#include "viewer/picture/space/render_picture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "io/scene/scene_json.h"
#include "solver/space/simulation/simulation.h"
#include "viewer/picture/cairo_canvas.h"
#include "viewer/picture/colour_map.h"
#include "viewer/picture/palette.h"
#include "viewer/picture/recording_canvas.h"
#include "viewer/picture/seamless_fill.h"

namespace hottel::render_picture_test {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;
using Kind = RecordingCanvas::Kind;

TEST(GrownPolygon, HoldsTheSquaresAroundItsCorners) {
  const PixelPolygon grown = grown_polygon(PixelPolygon{{0, 0}, {4, 0}, {0, 4}}, 0.5);
  // A square of 5 less a corner: its sides are parallel to those of the triangle.
  EXPECT_EQ(grown.size(), 5u);
  EXPECT_NEAR(pixel_area_doubled_3(grown) / 2, 25 - 8, 1e-14);
  EXPECT_NEAR(pixel_area_doubled_3(grown_polygon(PixelPolygon{{1, 1}, {1, 1}, {1, 1}}, 0.5)), 2, 1e-15);
}

Simulation3 solved(const std::string& name, std::uint32_t elements = 1) {
  Scene3 scene = read_scene_3(std::string(HOTTEL_SOURCE_DIR) + "/scenes/space/" + name);
  for (Surface& surface : scene.surfaces) surface.elements = elements;
  return Simulation3(
      std::move(scene),
      {.factors = {.granularity = elements > 1 ? Granularity::kElement : Granularity::kFace, .tolerance = 1e-6}});
}

RenderedView3 view_of(const Simulation3& simulation, RenderOptions3 options) {
  return RenderedView3(*simulation.prepared(), simulation.request().factors.granularity, *simulation.radiosities(),
                       std::move(options));
}

ShownValues shown(const Simulation3& simulation, const std::string& word) {
  return shown_values(shown_by(word), simulation.scene(), simulation.factors()->matrix, *simulation.radiosities());
}

bool is_in(const Pixel& p, const std::vector<Pixel>& polygon, double margin) {
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Pixel &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    const double long_way = std::hypot(b.x - a.x, b.y - a.y);
    if (long_way > 0 && ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)) / long_way < margin) return false;
  }
  return true;
}

// Fills of stripes: all that is seen but the sky.
std::vector<RecordingCanvas::Call> shapes_of(const RenderedView3& view) {
  RecordingCanvas canvas(view.width(), view.height());
  view.draw(canvas);
  return canvas.calls(Mark::kStripe, Kind::kFill);
}

double area_of(const std::vector<RecordingCanvas::Call>& shapes) {
  double area = 0;
  for (const auto& shape : shapes) {
    EXPECT_GT(pixel_area_doubled_3(shape.points), 0);
    area += pixel_area_doubled_3(shape.points) / 2;
  }
  return area;
}

// Shapes that overlap nowhere and fill the picture: hidden lines are gone, not painted over.
TEST(RenderedView3, ShapesPartitionThePicture) {
  const Simulation3 simulation = solved("two_boxes.json", 2);
  for (const Shading shading : {Shading::kFlat, Shading::kSmooth}) {
    const RenderedView3 view = view_of(simulation, {.wanted_width = 200, .shading = shading});
    const std::vector<RecordingCanvas::Call> shapes = shapes_of(view);
    EXPECT_NEAR(area_of(shapes), view.width() * view.height(), 1e-3);
    for (double y = 3.3; y < view.height(); y += 7.7)
      for (double x = 2.9; x < view.width(); x += 6.1) {
        int count = 0;
        for (const auto& shape : shapes) count += is_in({x, y}, shape.points, 0) ? 1 : 0;
        EXPECT_EQ(count, 1) << x << ' ' << y;
      }
  }
}

// A pixel within one shape has its colour; smooth: that of its band.
TEST(RenderedView3, ShapesHaveTheColoursOfThePixels) {
  const Simulation3 simulation = solved("two_boxes.json", 2);
  for (const Shading shading : {Shading::kFlat, Shading::kSmooth}) {
    const RenderedView3 view = view_of(simulation, {.wanted_width = 160, .shading = shading});
    const std::vector<RecordingCanvas::Call> shapes = shapes_of(view);
    Camera3 camera = *simulation.scene().camera;
    camera.height = view.height();
    camera.width = view.width();
    const std::shared_ptr<const ElementTable3> its = simulation.prepared()->elements(Granularity::kElement);
    const ElementTable3& table = *its;
    const ElementPaint3 paint = light_paint_3(simulation.scene(), *simulation.radiosities());
    const SmoothMesh3 mesh(*simulation.prepared(), table);
    const PixelValues3 pixels =
        camera_view_3({*simulation.prepared(), table, paint, shading == Shading::kSmooth ? &mesh : nullptr}, camera);
    const ToneCurve tone(kUsualTone3, 1, pixels.values, pixels.channels);
    // In narrow triangles a band is more than one step wide, and in red or blue a step of luminance is several.
    const double slack = shading == Shading::kFlat ? 1.0 / 255 : 8.0 / 128;
    int compared = 0;
    double off = 0;
    for (std::uint32_t y = 0; y < camera.height; y += 3)
      for (std::uint32_t x = 0; x < camera.width; x += 3)
        for (const auto& shape : shapes) {
          if (!is_in({x + 0.5, y + 0.5}, shape.points, 0.75)) continue;
          const Colour expected = tone(pixels.at(x, y));
          ++compared;
          off += std::fabs(shape.colour.r - expected.r) + std::fabs(shape.colour.g - expected.g);
          EXPECT_NEAR(shape.colour.r, expected.r, slack);
          EXPECT_NEAR(shape.colour.g, expected.g, slack);
          EXPECT_NEAR(shape.colour.b, expected.b, slack);
        }
    EXPECT_GT(compared, 300);
    EXPECT_LT(off / (2 * compared), 1.0 / 128);
  }
}

// What lies below shapes is larger than they are, and cut off where the sky begins.
TEST(RenderedView3, NothingShinesThroughBetweenShapes) {
  const Simulation3 simulation = solved("cube.json", 2);
  const RenderedView3 view = view_of(simulation, {.wanted_width = 100});
  RecordingCanvas canvas(view.width(), view.height());
  view.draw(canvas);
  const auto below = canvas.calls(Mark::kPaper, Kind::kFill), shapes = canvas.calls(Mark::kStripe, Kind::kFill);
  ASSERT_EQ(below.size(), shapes.size());
  for (std::size_t k = 0; k < shapes.size(); ++k) {
    EXPECT_EQ(below[k].colour, shapes[k].colour);
    EXPECT_FALSE(below[k].clip.empty());
    EXPECT_TRUE(shapes[k].clip.empty());
    for (const Pixel& corner : shapes[k].points) EXPECT_TRUE(is_in(corner, below[k].points, 0.49));
  }
}

// Drawn by cairo, the shapes are the picture of the pixels.
TEST(RenderedView3, ShapesLookLikeThePixels) {
  const Simulation3 simulation = solved("two_boxes.json");
  const RenderedView3 view = view_of(simulation, {.wanted_width = 120, .shown = shown(simulation, "irradiance")});
  Raster drawn(view.width(), view.height());
  CairoCanvas canvas(drawn);
  view.draw(canvas);
  canvas.finish();
  const std::shared_ptr<const ElementTable3> its = simulation.prepared()->elements(Granularity::kFace);
  const ElementTable3& table = *its;
  Camera3 camera = *simulation.scene().camera;
  const auto pixel_height = static_cast<std::uint32_t>(std::round(camera.height * 120.0 / camera.width));
  camera.width = 120;
  camera.height = pixel_height;
  const ElementPaint3 paint = scale_paint_3(shown(simulation, "irradiance"));
  const PixelValues3 pixels = camera_view_3({*simulation.prepared(), table, paint}, camera);
  int same = 0;
  for (std::uint32_t y = 0; y < camera.height; ++y)
    for (std::uint32_t x = 0; x < camera.width; ++x) {
      const std::uint32_t pixel = drawn.pixels[std::size_t{y} * drawn.width + x];
      const auto near = [&](int shift, double linear) {
        return std::abs(static_cast<int>(pixel >> shift & 255) - static_cast<int>(srgb_level(linear))) <= 1;
      };
      const auto value = pixels.at(x, y);
      same += near(16, value[0]) && near(8, value[1]) && near(0, value[2]) ? 1 : 0;
    }
  // All but borders, where cairo mixes colours as they are encoded.
  EXPECT_GT(same, 0.85 * camera.width * camera.height);
}

TEST(RenderedView3, AScaleHasItsBarUnitAndRangeBelow) {
  const Simulation3 simulation = solved("cube.json");
  const ShownValues values = shown(simulation, "irradiance");
  const RenderedView3 view = view_of(simulation, {.wanted_width = 500, .shown = values});
  EXPECT_EQ(view.width(), 500u);
  EXPECT_GT(view.height(), 500u);
  EXPECT_EQ(view.scale(), 1);
  RecordingCanvas canvas(view.width(), view.height());
  view.draw(canvas);
  EXPECT_TRUE(canvas.wrote(values.title));
  EXPECT_THAT(values.title, StartsWith("irradiance [W/m²]: "));
  const auto bars = canvas.calls(Mark::kLegend, Kind::kImage);
  ASSERT_EQ(bars.size(), 1u);
  EXPECT_GT(bars[0].points[0].y, 500);
  EXPECT_LT(bars[0].points[1].y, view.height());
  // Every face of the cube that is seen has the colour of its value.
  for (const auto& shape : canvas.calls(Mark::kStripe, Kind::kFill))
    EXPECT_TRUE(std::any_of(values.elements.begin(), values.elements.end(), [&](const std::optional<double>& value) {
      const Colour colour = map_colour(values.scale.position(value.value_or(0)));
      return value && std::fabs(colour.r - shape.colour.r) < 2e-3 && std::fabs(colour.g - shape.colour.g) < 2e-3 &&
             std::fabs(colour.b - shape.colour.b) < 2e-3;
    }));
}

// Colours of a scale are averaged as light: half of a pixel in one and half in another colour is their mean.
TEST(CameraView3, PixelsIntegrateWhatElementsShow) {
  const PreparedScene3 prepared = prepare(parse_scene_3(
      R"({"hottel": 1, "dimension": 3, "materials": {"m": {"reflectivity": 0.5}}, "polygons": [
      {"name": "plate", "points": [[-1,4,-1],[1,4,-1],[1,4,1],[-1,4,1]], "material": "m", "elements": 2}]})",
      "plate.json"));
  const ElementTable3& table = *prepared.elements(Granularity::kElement);
  ElementPaint3 paint{.channels = 1,
                      .values = std::vector<double>(table.count(), 0),
                      .scale = ColourScale{-1, 3},
                      .unknown = {9, 9, 9},
                      .black = {0, 0, 0},
                      .sky = {0, 0, 0}};
  const double values[] = {-1, 0.5, 3, std::numeric_limits<double>::quiet_NaN()};
  std::copy(std::begin(values), std::end(values), paint.values.begin());
  Camera3 camera;
  camera.eye = {0, 0, 0};
  camera.target = {0, 1, 0};
  camera.field_of_view = 90;
  camera.width = camera.height = 36;  // the plate takes 9 x 9 pixels
  const PixelValues3 pixels = camera_view_3({prepared, table, paint}, camera);
  double expected[3] = {9, 9, 9}, sum[3] = {0, 0, 0};
  for (const double value : {-1.0, 0.5, 3.0}) {
    const Colour colour = map_colour(paint.scale->position(value));
    expected[0] += linear_from_srgb(colour.r);
    expected[1] += linear_from_srgb(colour.g);
    expected[2] += linear_from_srgb(colour.b);
  }
  for (std::size_t k = 0; k < pixels.values.size(); ++k) sum[k % 3] += pixels.values[k];
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(sum[c], expected[c] * 81 / 4, 1e-10);
}

TEST(RenderedView3, FilesAreOfTheirKindAndTheSameEveryTime) {
  const Simulation3 simulation = solved("cube.json");
  const RenderedView3 view = view_of(simulation, {.wanted_width = 200});
  EXPECT_THAT(view.file(PictureFormat::kPng), StartsWith("\x89PNG"));
  const std::string svg = view.file(PictureFormat::kSvg), pdf = view.file(PictureFormat::kPdf);
  EXPECT_THAT(svg, StartsWith("<?xml"));
  EXPECT_THAT(svg, Not(HasSubstr("<image")));  // shapes, not pixels
  EXPECT_THAT(pdf, StartsWith("%PDF"));
  EXPECT_EQ(view.file(PictureFormat::kSvg), svg);
  EXPECT_EQ(view.file(PictureFormat::kPdf), pdf);
}

}  // namespace
}  // namespace hottel::render_picture_test
