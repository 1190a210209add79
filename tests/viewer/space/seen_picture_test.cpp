// What a camera sees, kept to be drawn quickly.
#include "viewer/picture/space/seen_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <limits>

#include "geometry/space/prepared/prepared_scene.h"
#include "io/scene/scene_json.h"
#include "solver/space/simulation/simulation.h"
#include "viewer/picture/space/camera_view.h"

namespace hottel::seen_picture_test {
namespace {

class SeenPicture : public testing::Test {
 protected:
  SeenPicture()
      : simulation(scene(), {.factors = {.granularity = Granularity::kElement}}),
        prepared(*simulation.prepared()),
        table(prepared.scene, prepared.arrangement(), prepared.occluders(), Granularity::kElement),
        mesh(prepared, table),
        paint(light_paint_3(prepared.scene, *simulation.radiosities())),
        camera(*prepared.scene.camera) {
    camera.width = 160;
    camera.height = 120;
  }
  static Scene3 scene() {
    Scene3 read = read_scene_3(std::string(HOTTEL_SOURCE_DIR) + "/scenes/space/two_boxes.json");
    for (Surface& surface : read.surfaces) surface.elements = 2;
    return read;
  }
  SeenScene3 seen(bool is_smooth) const { return {prepared, table, paint, is_smooth ? &mesh : nullptr}; }

  Simulation3 simulation;
  PreparedScene3 prepared;
  ElementTable3 table;
  SmoothMesh3 mesh;
  ElementPaint3 paint;
  Camera3 camera;
};

// (1)
TEST_F(SeenPicture, IsThePictureOfTheCamera) {
  for (const bool is_smooth : {false, true})
    for (const Tone tone : {Tone::kLog, Tone::kReinhard, Tone::kLinear, Tone::kMax}) {
      const PixelValues3 values = camera_view_3(seen(is_smooth), camera);
      const ToneCurve curve(tone, 1, values.values, values.channels);
      const Raster raster = SeenPicture3(seen(is_smooth), camera).raster(&curve);
      ASSERT_EQ(raster.width, 160u);
      ASSERT_EQ(raster.height, 120u);
      for (std::uint32_t y = 0; y < 120; ++y)
        for (std::uint32_t x = 0; x < 160; ++x) {
          const auto level = curve.levels(values.at(x, y));
          const std::uint32_t pixel = raster.pixels[y * 160 + x];
          for (int c = 0; c < 3; ++c)
            ASSERT_LE(std::abs(static_cast<int>(pixel >> (16 - 8 * c) & 0xFF) - level[static_cast<std::size_t>(c)]), 1);
        }
    }
}

// (2)
TEST_F(SeenPicture, TellsWhatLiesWhere) {
  const SeenPicture3 picture(seen(false), camera);
  const auto face_at = [&](double x, double y) -> std::string {
    const SeenPicture3::Part* part = picture.at({x, y});
    if (part == nullptr || !part->element) return "";
    return prepared.scene.surfaces[table.elements()[*part->element].surface].name;
  };
  EXPECT_EQ(face_at(80, 118), "low.top");
  EXPECT_EQ(face_at(100, 40), "rear");
  EXPECT_EQ(face_at(80, 3), "ceiling");
  EXPECT_EQ(face_at(3, 60), "left");
  EXPECT_EQ(face_at(157, 60), "right");
  EXPECT_EQ(picture.at({-5, 60}), nullptr);
}

// (4)
TEST_F(SeenPicture, ShowsAnotherPaintAsIfMadeOfIt) {
  ElementPaint3 other = paint;
  for (std::size_t k = 0; k < other.values.size(); ++k) other.values[k] *= 1 + 0.1 * static_cast<double>(k % 7);
  other.sky.assign(other.sky.size(), 0.25);
  ElementPaint3 scaled = other;
  scaled.channels = 1;
  scaled.values.resize(scaled.values.size() / other.channels);
  scaled.scale = ColourScale{0, 2, false};
  scaled.unknown = scaled.black = scaled.sky = {0.1, 0.2, 0.3};
  ElementPaint3 scaled_anew = scaled;
  for (double& value : scaled_anew.values) value *= 1.5;
  ElementPaint3 unknown = other;
  std::fill_n(unknown.values.begin(), unknown.channels, std::numeric_limits<double>::quiet_NaN());
  const ToneCurve tone(Tone::kLog, 1, other.values, other.channels);
  for (const bool is_smooth : {false, true}) {
    const SmoothMesh3* mesh_or_none = is_smooth ? &mesh : nullptr;
    const auto made_of = [&](const ElementPaint3& of) {
      return SeenPicture3({prepared, table, of, mesh_or_none}, camera);
    };
    SeenPicture3 picture = made_of(paint);
    ASSERT_TRUE(picture.show(other, mesh_or_none));
    EXPECT_EQ(picture.raster(&tone).pixels, made_of(other).raster(&tone).pixels);
    ASSERT_TRUE(picture.show(paint, mesh_or_none));  // from what it has kept by now
    EXPECT_EQ(picture.raster(&tone).pixels, made_of(paint).raster(&tone).pixels);
    EXPECT_FALSE(picture.show(scaled, mesh_or_none)) << "other channels";
    EXPECT_FALSE(picture.show(unknown, mesh_or_none)) << "no value of an element";
    EXPECT_EQ(picture.raster(&tone).pixels, made_of(paint).raster(&tone).pixels);

    SeenPicture3 on_scale = made_of(scaled);
    ASSERT_TRUE(on_scale.show(scaled_anew, mesh_or_none));
    EXPECT_EQ(on_scale.raster(nullptr).pixels, made_of(scaled_anew).raster(nullptr).pixels);
  }
}

TEST(ToneCurve, NearLevelsAreNear) {
  const std::vector<double> values{1e-9, 1e-3, 0.1, 1, 18, 4000};
  for (const Tone tone : {Tone::kLog, Tone::kReinhard, Tone::kLinear, Tone::kMax}) {
    const ToneCurve curve(tone, 1.3, values, 1);
    for (double light = 0; light < 5000; light = light * 1.01 + 1e-7) {
      const std::array<double, 3> colour{light, 0.3 * light, 0.01 * light};
      const auto near = curve.near_levels(colour), exact = curve.levels(colour);
      for (std::size_t c = 0; c < 3; ++c) ASSERT_LE(std::abs(near[c] - exact[c]), 1) << light;
    }
  }
}

}  // namespace
}  // namespace hottel::seen_picture_test
