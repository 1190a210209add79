// Radiosities of scenes/degenerate/: cells that no light reaches or leaves, and reflectivities next to 1.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"
#include "solver/radiosity/radiosity.h"
#include "tests/solver/plane/exact_radiosity.h"

namespace hottel::degenerate_radiosity_test {
namespace {

using namespace testing_radiosity;

Scene2 degenerate(const std::string& stem) {
  return read_scene_2(std::filesystem::path(HOTTEL_SOURCE_DIR) / "scenes" / "degenerate" / (stem + ".json"));
}

const ElementRadiosity& of(const ExactScene& scene, const RadiositySolution& solution, const std::string& name) {
  return solution.channels.at(0).elements.at(scene.matrix().find(name).value());
}

constexpr const char* kCell[] = {"cell left", "cell top", "cell right", "cell bottom"};

TEST(DegenerateRadiosity, OfACellThatNoLightReachesIsExactlyZero) {
  const ExactScene scene(degenerate("box_in_a_box"));
  const RadiositySolution solution = scene.solve();
  for (const std::string name : {"cell left", "cell top", "cell right", "cell bottom", "fin", "fin:back"}) {
    const ElementRadiosity& e = of(scene, solution, name);
    EXPECT_EQ(e.radiosity, 0) << name;
    EXPECT_EQ(e.upper, 0) << name;
  }
  EXPECT_GT(of(scene, solution, "cell left:back").radiosity, 0) << "its outside is lit";
  BoundsCheck check;
  check.add(scene, solution, scene.scene().materials);
  EXPECT_EQ(check.misses, 0u) << check.first_miss;
}

TEST(DegenerateRadiosity, OfADarkCellOfMirrorsIsTheLimitZeroWithANote) {
  const ExactScene scene(degenerate("mirror_cell_dark"));
  const RadiositySolution solution = scene.solve();
  for (const char* name : kCell) EXPECT_EQ(of(scene, solution, name).upper, 0) << name;
  EXPECT_GT(of(scene, solution, "left").radiosity, 0);
  ASSERT_EQ(solution.notes.size(), 1u);
  EXPECT_THAT(solution.notes[0], testing::HasSubstr("cell left"));
  // The limit: nothing is emitted for any reflectivity below 1 either.
  std::vector<Material> materials = scene.scene().materials;
  for (Material& material : materials)
    if (material.name == "mirror") material.reflectivity = Spectrum::scalar(1 - scaled_by_power_of_two(1, -50));
  for (const char* name : kCell) EXPECT_EQ(of(scene, scene.solve(materials), name).upper, 0) << name;
}

TEST(DegenerateRadiosity, OfALitCellOfMirrorsIsRefusedByName) {
  const ExactScene scene(degenerate("mirror_cell_lit"));
  try {
    scene.solve();
    FAIL() << "light that never goes away has no steady state";
  } catch (const RequestError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("cell left"));
  }
}

Scene2 with_reflectivity(Scene2 scene, const Rational& reflectivity, const Rational& emission) {
  for (Material& material : scene.materials) {
    material.reflectivity = Spectrum::scalar(reflectivity);
    material.emission = Spectrum::scalar(emission);
  }
  return scene;
}

TEST(DegenerateRadiosity, OfAFurnaceIsOneForEveryReflectivity) {
  for (int k = 10; k <= 50; k += 10) {
    const Rational loss = scaled_by_power_of_two(1, -k);
    for (const Scene2& room : {degenerate("furnace_of_mirrors"), convex_polygon(7), convex_polygon(40)}) {
      const ExactScene scene(with_reflectivity(room, 1 - loss, loss));
      const RadiositySolution solution = scene.solve();
      for (std::uint32_t i = 0; i < scene.matrix().size(); ++i) {
        if (!scene.matrix().has_row(i)) continue;
        const ElementRadiosity& e = solution.channels[0].elements[i];
        EXPECT_LE(e.lower, 1);
        EXPECT_GE(e.upper, 1);
        EXPECT_LE(e.upper - e.lower, 1e-12) << k;
        EXPECT_NEAR(e.radiosity, 1, 1e-15);
      }
    }
  }
}

TEST(DegenerateRadiosity, KeepsFullRelativeAccuracyAsReflectivityGoesToOne) {
  for (int k = 10; k <= 50; k += 10)
    for (const int sides : {3, 8, 24}) {
      Scene2 room = convex_polygon(sides);
      for (Material& material : room.materials)
        material.reflectivity = Spectrum::scalar(1 - scaled_by_power_of_two(1, -k));
      const ExactScene scene(room);
      const RadiositySolution solution = scene.solve();
      EXPECT_LE(solution.max_relative_width, 1e-12) << k << " " << sides;
      BoundsCheck check;
      check.add(scene, solution, scene.scene().materials);
      EXPECT_EQ(check.misses, 0u) << check.first_miss;
    }
}

TEST(DegenerateRadiosity, IsWhatTheFilesSayToTheLastDigit) {
  for (const std::string stem : {"near_singular_square", "furnace_of_mirrors"}) {
    const ExactScene scene(degenerate(stem));
    const RadiositySolution solution = scene.solve();
    int rows = 0;
    for (const Expectation& row : scene.scene().expect) {
      if (row.quantity != "radiosity") continue;
      ++rows;
      const Rational value = parse_rational(row.value).value();
      const ElementRadiosity& e = of(scene, solution, row.of.at(0));
      EXPECT_EQ(e.radiosity, to_double(value)) << row.name;
      EXPECT_LE(Rational(e.lower), value) << row.name;
      EXPECT_GE(Rational(e.upper), value) << row.name;
      EXPECT_LE(e.upper - e.lower, 1e-14 * e.radiosity) << row.name;
    }
    EXPECT_GE(rows, 3);
    BoundsCheck check;
    check.add(scene, solution, scene.scene().materials);
    EXPECT_EQ(check.misses, 0u) << check.first_miss;
  }
}

}  // namespace
}  // namespace hottel::degenerate_radiosity_test
