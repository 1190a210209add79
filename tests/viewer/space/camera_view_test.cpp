// What a camera sees of the light of a scene: areas of polygons in pixels, hidden surfaces, elements, the sky.
#include "viewer/picture/space/camera_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "geometry/space/prepared/prepared_scene.h"
#include "geometry/space/visibility/visibility_map.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"
#include "solver/space/simulation/simulation.h"
#include "viewer/picture/space/render_picture.h"

namespace hottel::camera_view_test {
namespace {

using Polygon = std::vector<Pixel>;

PixelValues3 blank(std::uint32_t width, std::uint32_t height) {
  PixelValues3 pixels{width, height, 1, {}};
  pixels.values.assign(std::size_t{width} * height, 0);
  return pixels;
}

double sum(const PixelValues3& pixels) {
  double result = 0;
  for (const double value : pixels.values) result += value;
  return result;
}

// The part of a pixel in a convex polygon that goes around counter-clockwise, by many points.
double sampled(const Polygon& polygon, std::uint32_t x, std::uint32_t y) {
  constexpr int kSide = 100;
  int inside = 0;
  for (int i = 0; i < kSide; ++i)
    for (int j = 0; j < kSide; ++j) {
      const double px = x + (i + 0.5) / kSide, py = y + (j + 0.5) / kSide;
      bool is_in = true;
      for (std::size_t k = 0; k < polygon.size() && is_in; ++k) {
        const Pixel &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
        is_in = (b.x - a.x) * (py - a.y) - (b.y - a.y) * (px - a.x) >= 0;
      }
      inside += is_in;
    }
  return static_cast<double>(inside) / (kSide * kSide);
}

TEST(AddPolygon, CoversEachPixelByItsArea) {
  std::mt19937_64 random(7);
  for (int round = 0; round < 40; ++round) {
    // Points of an ellipse in order: convex. It may reach out of the picture.
    const auto number = [&](double low, double high) {
      return low + (high - low) * static_cast<double>(random() % 10000) / 10000;
    };
    const double x = number(-2, 14), y = number(-2, 10), a = number(0.1, 6), b = number(0.1, 6);
    std::vector<double> angles;
    for (int k = 0; k < 3 + round % 5; ++k) angles.push_back(number(0, 6.28));
    std::sort(angles.begin(), angles.end());
    Polygon polygon;
    for (const double angle : angles) polygon.push_back({x + a * std::cos(angle), y + b * std::sin(angle)});
    PixelValues3 pixels = blank(12, 8);
    const double one[] = {1};
    add_polygon(polygon, one, pixels);
    for (std::uint32_t py = 0; py < 8; ++py)
      for (std::uint32_t px = 0; px < 12; ++px)
        EXPECT_NEAR(pixels.at(px, py)[0], sampled(polygon, px, py), 0.02) << round << ": " << px << ' ' << py;
    std::reverse(polygon.begin(), polygon.end());
    PixelValues3 other = blank(12, 8);
    add_polygon(polygon, one, other);
    EXPECT_NEAR(sum(other), sum(pixels), 1e-12) << round;
  }
}

TEST(AddPolygon, WholePixelsAndThinStripesCountAsTheyAre) {
  PixelValues3 pixels = blank(4, 3);
  const double two[] = {2};
  add_polygon(Polygon{{0, 0}, {4, 0}, {4, 3}, {0, 3}}, two, pixels);
  for (const double value : pixels.values) EXPECT_EQ(value, 2);
  pixels = blank(4, 3);
  add_polygon(Polygon{{1.25, -5}, {1.5, -5}, {1.5, 9}, {1.25, 9}}, two, pixels);
  for (std::uint32_t y = 0; y < 3; ++y)
    for (std::uint32_t x = 0; x < 4; ++x) EXPECT_NEAR(pixels.at(x, y)[0], x == 1 ? 0.5 : 0, 1e-15);
  pixels = blank(4, 3);
  add_polygon(Polygon{{9, 9}, {10, 9}, {9, 10}}, two, pixels);
  EXPECT_EQ(sum(pixels), 0);
}

Simulation3 simulation_of(Scene3 scene, Granularity granularity = Granularity::kFace) {
  return Simulation3(std::move(scene), {.factors = {.granularity = granularity}});
}

PixelValues3 view(const Simulation3& simulation, const Camera3& camera) {
  return camera_view_3(*simulation.prepared(), simulation.request().factors.granularity, *simulation.radiosities(),
                       camera);
}

// A plate of side 2 at distance 4, before a sky; straight ahead.
constexpr const char* kPlate = R"({"hottel": 1, "dimension": 3, "sky": {"emission": 0.5},
  "materials": {"m": {"reflectivity": 0, "emission": 3}}, "polygons": [
  {"name": "plate", "points": [[-1,4,-1],[1,4,-1],[1,4,1],[-1,4,1]], "material": "m"}]})";

Camera3 ahead(std::uint32_t width, std::uint32_t height) {
  Camera3 camera;
  camera.eye = {0, 0, 0};
  camera.target = {0, 1, 0};
  camera.field_of_view = 90;
  camera.width = width;
  camera.height = height;
  return camera;
}

TEST(CameraView3, APlateBeforeTheSkyHasTheAreaThatItHas) {
  const Simulation3 simulation = simulation_of(parse_scene_3(kPlate, "plate.json"));
  // 90 degrees of 36 pixels: at distance 4 a length of 8; the plate takes 9 pixels across, from 13.5 to 22.5.
  const PixelValues3 pixels = view(simulation, ahead(40, 36));
  EXPECT_NEAR(sum(pixels), 81 * 3 + (40 * 36 - 81) * 0.5, 1e-10);
  EXPECT_NEAR(pixels.at(20, 18)[0], 3, 1e-14);
  EXPECT_NEAR(pixels.at(2, 2)[0], 0.5, 1e-14);
  EXPECT_NEAR(pixels.at(20, 13)[0], (3 + 0.5) / 2, 1e-13);
  // From behind it is black.
  Camera3 behind = ahead(40, 36);
  behind.eye = {0, 8, 0};
  behind.target = {0, 0, 0};
  EXPECT_NEAR(sum(view(simulation, behind)), (40 * 36 - 81) * 0.5, 1e-10);
}

TEST(CameraView3, FourPixelsOfTwiceThePictureAreOne) {
  const Simulation3 simulation =
      simulation_of(read_scene_3(std::string(HOTTEL_SOURCE_DIR) + "/scenes/space/two_boxes.json"));
  Camera3 camera = *simulation.scene().camera;
  camera.width = 60;
  camera.height = 45;
  const PixelValues3 once = view(simulation, camera);
  camera.width = 120;
  camera.height = 90;
  const PixelValues3 twice = view(simulation, camera);
  ASSERT_EQ(once.channels, 3u);
  for (std::uint32_t y = 0; y < 45; ++y)
    for (std::uint32_t x = 0; x < 60; ++x)
      for (std::size_t c = 0; c < 3; ++c) {
        const double four = twice.at(2 * x, 2 * y)[c] + twice.at(2 * x + 1, 2 * y)[c] + twice.at(2 * x, 2 * y + 1)[c] +
                            twice.at(2 * x + 1, 2 * y + 1)[c];
        EXPECT_NEAR(once.at(x, y)[c], four / 4, 1e-12 * (1 + four)) << x << ' ' << y;
      }
}

// In a closed room every pixel is some radiosity, or between some: the mean over parts that fill it.
TEST(CameraView3, NothingShinesThroughAClosedRoom) {
  Scene3 scene = read_scene_3(std::string(HOTTEL_SOURCE_DIR) + "/scenes/space/cube.json");
  for (Material& material : scene.materials) {
    material.reflectivity = Spectrum::scalar(Rational(1, 2));
    material.emission = Spectrum::scalar(1);
  }
  for (const std::uint32_t elements : {1u, 3u}) {
    for (Surface& surface : scene.surfaces) surface.elements = elements;
    const Simulation3 simulation = simulation_of(scene, elements > 1 ? Granularity::kElement : Granularity::kFace);
    Camera3 camera = *scene.camera;
    camera.width = camera.height = 50;
    const PixelValues3 pixels = view(simulation, camera);
    for (const double value : pixels.values) EXPECT_NEAR(value, 2, 1e-11);
  }
}

// A pixel that is all of one face has the radiosity of what a ray through its middle meets.
TEST(CameraView3, PixelsShowWhatRaysMeet) {
  const Simulation3 simulation =
      simulation_of(read_scene_3(std::string(HOTTEL_SOURCE_DIR) + "/scenes/space/room_boxes.json"));
  Camera3 camera = default_camera_3(*simulation.prepared());
  camera.width = 32;
  camera.height = 24;
  const PixelValues3 pixels = view(simulation, camera);
  const auto solution = simulation.radiosities();
  const auto factors = simulation.factors();
  std::vector<double> known{0};
  for (std::uint32_t i = 0; i < factors->matrix.size(); ++i)
    if (factors->matrix.has_row(i)) known.push_back(solution->channels[0].elements[i].radiosity);
  int uniform = 0;
  for (std::uint32_t y = 0; y < 24; ++y)
    for (std::uint32_t x = 0; x < 32; ++x)
      uniform += std::any_of(known.begin(), known.end(), [&](double radiosity) {
        return std::fabs(radiosity - pixels.at(x, y)[0]) <= 1e-12 * (1 + radiosity);
      });
  EXPECT_GT(uniform, 32 * 24 / 2);
}

TEST(CameraView3, AnEyeInASolidIsRefused) {
  const Simulation3 simulation = simulation_of(parse_scene_3(
      R"({"hottel": 1, "dimension": 3, "materials": {"m": {"reflectivity": 0.5}}, "polygons": [
        {"name": "a", "group": "t", "points": [[0,0,0],[0,1,0],[1,0,0]], "material": "m"},
        {"name": "b", "group": "t", "points": [[0,0,0],[1,0,0],[0,0,1]], "material": "m"},
        {"name": "c", "group": "t", "points": [[0,0,0],[0,0,1],[0,1,0]], "material": "m"},
        {"name": "d", "group": "t", "points": [[1,0,0],[0,1,0],[0,0,1]], "material": "m"}]})",
      "solid.json"));
  Camera3 camera = ahead(8, 8);
  camera.eye = {Rational(1, 8), Rational(1, 8), Rational(1, 8)};
  EXPECT_THROW(view(simulation, camera), RequestError);
  const Camera3 chosen = default_camera_3(*simulation.prepared());
  EXPECT_EQ(camera_problem(chosen), "");
  EXPECT_GT(sum(view(simulation, chosen)), -1);
}

// A box from corner to corner, its faces as the front of a room or of a solid.
std::string box(const std::string& name, const std::array<double, 6>& b, bool is_room) {
  std::string text;
  constexpr int kFaces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (int face = 0; face < 6; ++face) {
    text += ", {\"name\": \"" + name + std::to_string(face) + "\", \"group\": \"" + name + "\", \"points\": [";
    for (int k = 0; k < 4; ++k) {
      const int corner = kFaces[face][is_room ? 3 - k : k];
      const auto at = [&](int axis) {
        return std::to_string(b[static_cast<std::size_t>(axis + (corner >> axis & 1) * 3)]);
      };
      text += (k == 0 ? "[" : ", [") + at(0) + ", " + at(1) + ", " + at(2) + "]";
    }
    text += "], \"material\": \"m\"}";
  }
  return text;
}

// What stands in the middle of a room, or hides its middle, keeps no camera out of the room.
TEST(CameraView3, ACameraIsChosenWhereThereIsLight) {
  const std::string room = box("room", {0, 0, 0, 6, 6, 6}, true);
  for (const std::string& inside :
       {box("pillar", {2.7, 2.7, 0, 3.3, 3.3, 6}, false),  // a solid
        box("screen", {1, 1, 1, 5, 5, 5}, false),          // a large one
        std::string(R"(, {"name": "L", "points": [[1,1,3], [5,1,3], [5,5,3], [4,5,3], )"
                    R"([4,2,3], [1,2,3]], "material": "m", "back": "m"})"),  // of two pieces
        box("inside", {2, 2, 2, 4, 4, 4}, true)}) {                          // a room in the room, of one side
    const Simulation3 simulation = simulation_of(parse_scene_3(
        R"({"hottel": 1, "dimension": 3, "materials": {"m": {"reflectivity": 0.5, "emission": 1}}, "polygons": [)" +
            (room + inside).substr(2) + "]}",
        "room.json"));
    Camera3 camera = default_camera_3(*simulation.prepared());
    for (const Rational& at : {camera.eye.x, camera.eye.y, camera.eye.z}) {
      EXPECT_GT(at, 0);
      EXPECT_LT(at, 6);
    }
    camera.width = camera.height = 24;
    int lit = 0;
    for (const double value : view(simulation, camera).values) lit += value > 0.5;
    EXPECT_GT(lit, 24 * 24 / 2) << inside;
  }
}

TEST(RenderPicture3, IsAPngOfTheSizeAskedFor) {
  const Simulation3 simulation = simulation_of(parse_scene_3(kPlate, "plate.json"));
  const RenderedPicture3 picture =
      render_picture_3(*simulation.prepared(), Granularity::kFace, *simulation.radiosities(),
                       {.tone = Tone::kMax, .exposure = 1, .wanted_width = 400});
  ASSERT_TRUE(picture.bytes.starts_with("\x89PNG"));
  EXPECT_EQ(static_cast<unsigned char>(picture.bytes[18]) * 256 + static_cast<unsigned char>(picture.bytes[19]), 400);
  EXPECT_EQ(static_cast<unsigned char>(picture.bytes[22]) * 256 + static_cast<unsigned char>(picture.bytes[23]), 300);
  EXPECT_NEAR(picture.scale, 1.0 / 3, 1e-14);
}

}  // namespace
}  // namespace hottel::camera_view_test
