// What a camera sees, kept to be drawn quickly.
#include "viewer/picture/space/seen_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "geometry/space/exchange/prepared_scene.h"
#include "io/scene/scene_json.h"
#include "solver/space/simulation/simulation.h"
#include "viewer/picture/space/camera_view.h"

namespace hottel {
namespace {

class SeenPicture : public testing::Test {
 protected:
  SeenPicture()
      : simulation(scene(), {.factors = {.granularity = Granularity::kElement}}),
        prepared(*simulation.prepared()),
        table(prepared.scene, prepared.arrangement(), prepared.blockers(), Granularity::kElement),
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
}  // namespace hottel
