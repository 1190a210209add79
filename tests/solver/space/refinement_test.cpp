// Polygons divided where light ends: held against many points of every element, each asked for by itself.
#include "solver/space/light/refinement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

#include "geometry/space/exchange/exchange.h"
#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/face_patches.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "geometry/space/scene/division.h"
#include "solver/space/light/direct_light.h"
#include "solver/space/light/scene_light_shares.h"
#include "tests/geometry/space/box_scene.h"

namespace hottel::refinement_test {
namespace {

// A room from -2 to 2 with a plate from -1 to 1 in z = 1, and a pentagon in z = -1.
Scene3 furnished_room() {
  BoxScene3 scene;
  scene.box("room", {-2, -2, -2}, {2, 2, 2}, true);
  scene.polygon("plate", level(-1, -1, 1, 1, 1));
  Polygon3 pentagon;
  pentagon.points = {
      {0, 0, -1}, {1, 0, -1}, {Rational(3, 2), 1, -1}, {Rational(1, 2), Rational(3, 2), -1}, {-1, 1, -1}};
  scene.polygon("pentagon", pentagon);
  return scene;
}

Scene3 lit(Scene3 scene, const Beam3& beam, const Point3& position) {
  Light light;
  light.name = "light" + std::to_string(scene.lights.size());
  light.type = beam.is_even() ? LightType::kPoint : LightType::kSpot;
  light.focus = beam.half_angle;
  light.falloff = beam.falloff;
  light.power = Spectrum::scalar(1);
  scene.lights.push_back(light);
  scene.light_places.push_back({position, beam.axis, {}});
  return scene;
}

std::size_t leaf_count(const std::vector<SurfaceTrees>& trees) {
  std::size_t count = 0;
  for (const SurfaceTrees& of_surface : trees) count += of_surface.front.size() + of_surface.back.size();
  return count;
}

TEST(RefinedTrees3, DivideNothingWithoutLevelsOrWithoutBorders) {
  const Scene3 scene = lit(furnished_room(), {}, {0, 0, Rational(3, 2)});
  EXPECT_EQ(leaf_count(refined_trees(prepare(scene), {})), 0u);
  BoxScene3 empty;
  empty.box("room", {-2, -2, -2}, {2, 2, 2}, true);
  EXPECT_EQ(leaf_count(refined_trees(prepare(lit(empty, {}, {0, 0, 0})), {.everywhere = 0, .at_borders = 4})), 0u);
}

TEST(RefinedTrees3, AreOfOneDepthEverywhere) {
  const Scene3 scene = furnished_room();
  const auto trees = refined_trees(prepare(scene), {.everywhere = 2, .at_borders = 0});
  for (std::size_t s = 0; s < trees.size(); ++s)
    EXPECT_EQ(trees[s].front, uniform_leaves(root_count(scene.polygons[s], 1), 4, 2)) << scene.surfaces[s].name;
}

TEST(RefinedTrees3, ABeamThatTouchesSidesOfElementsOnlyDividesNothingBeyond) {
  BoxScene3 empty;
  empty.box("room", {-2, -2, -2}, {2, 2, 2}, true);
  // 45 degrees about the axis of a wall at the distance 2 is a circle that touches its four sides, and no other wall.
  const auto trees =
      refined_trees(prepare(lit(empty, {{0, 0, -1}, 45, 0}, {0, 0, 0})), {.everywhere = 0, .at_borders = 1});
  EXPECT_EQ(leaf_count(trees), 4u);
}

// Each leaf that is not as deep as may be is lit all over or nowhere, at points all over it.
TEST(RefinedTrees3, LeavesAboveTheLastLevelAreLitWhollyOrNotAtAll) {
  std::mt19937 random(7);
  std::size_t looked_at = 0, deep = 0;
  for (int round = 0; round < 6; ++round) {
    const auto draw = [&]() -> Rational { return Rational(static_cast<int>(random() % 300) - 150) / 101; };
    const Beam3 beam = round % 3 == 0 ? Beam3{}
                                      : Beam3{{draw(), draw(), draw() - 1},
                                              Rational(static_cast<int>(random() % 100) + 15),
                                              round % 3 == 1 ? 0 : 2};
    Scene3 scene = lit(furnished_room(), beam, {draw(), draw(), Rational(1, 7)});
    const PreparedScene3 prepared = prepare(scene);
    const RefinementLevels levels{.everywhere = 1, .at_borders = 3};
    scene = with_trees(scene, refined_trees(prepared, levels));
    const ElementTable3 table(scene, prepared.arrangement(), prepared.occluders(), Granularity::kElement);
    const DirectLight3 light(prepared, scene.light_places[0].position, beam);
    for (std::uint32_t label = 0; label < table.count(); ++label) {
      if (!table.has_row(label)) continue;
      const Element& element = table.elements()[label];
      const bool is_deep = element.path.depth() == levels.at_borders;
      deep += is_deep ? 1 : 0;
      EXPECT_GE(element.path.depth(), 1);
      if (is_deep) continue;
      ++looked_at;
      int is_lit = 0, is_dark = 0;
      for (const ElementTable3::Part& part : table.free_parts(label)) {
        const std::vector<Point3> corners = corners_of(prepared.occluders().vertices(), part.patch);
        const Vector3 normal = cross(corners[1] - corners[0], corners[2] - corners[1]);
        for (int k = 0; k < 12; ++k) {
          // A random point inside: by weights of corners.
          Rational all = 0;
          Rational x = 0, y = 0, z = 0;
          for (const Point3& corner : corners) {
            const Rational weight = 1 + static_cast<int>(random() % 1000);
            all += weight;
            x += weight * corner.x;
            y += weight * corner.y;
            z += weight * corner.z;
          }
          const Point3 point{Rational(x / all), Rational(y / all), Rational(z / all)};
          ++(light.irradiance(point, normal) > 0 ? is_lit : is_dark);
        }
      }
      EXPECT_TRUE(is_lit == 0 || is_dark == 0) << "round " << round << ": " << element.name;
    }
  }
  EXPECT_GT(looked_at, 200u);
  EXPECT_GT(deep, 200u);
}

// What a tree has is what equal parts have, whatever each is called; and a pair is the same in any list of elements.
TEST(ElementTrees3, FactorsAreThoseOfEqualPartsAndOfAnyOtherListBitForBit) {
  Scene3 trees = furnished_room(), parts = trees;
  for (std::size_t s = 0; s < trees.surfaces.size(); ++s) {
    trees.surfaces[s].trees.front = uniform_leaves(root_count(trees.polygons[s], 1), 4, 1);
    parts.surfaces[s].elements = 2;
  }
  const auto factors_of = [](const Scene3& scene) {
    return exact_exchange(prepare(scene), {.granularity = Granularity::kElement, .tolerance = 1e-9});
  };
  const ExchangeMatrix of_trees = factors_of(trees), of_parts = factors_of(parts);
  ASSERT_EQ(of_trees.size(), of_parts.size());
  EXPECT_EQ(of_trees.entry_count(), of_parts.entry_count());
  double tree_sum = 0, part_sum = 0;
  for (std::uint32_t i = 0; i < of_trees.size(); ++i) {
    if (!of_trees.has_row(i)) continue;
    double row = 0;
    for (const FactorEntry& entry : of_trees.row(i)) row += entry.factor.value;
    EXPECT_NEAR(row, 1, 1e-9);
    tree_sum += of_trees.elements()[i].area.value;
    part_sum += of_parts.elements()[i].area.value;
  }
  EXPECT_NEAR(tree_sum, part_sum, 1e-12 * part_sum);
  // One surface divided further: all pairs of others stay as they were.
  Scene3 deeper = trees;
  deeper.surfaces[0].trees.front = uniform_leaves(1, 4, 2);
  const ExchangeMatrix of_deeper = factors_of(deeper);
  std::map<std::string, std::uint32_t> place;
  for (std::uint32_t i = 0; i < of_deeper.size(); ++i) place[of_deeper.elements()[i].name] = i;
  std::size_t compared = 0;
  for (std::uint32_t i = 0; i < of_trees.size(); ++i) {
    const auto from = place.find(of_trees.elements()[i].name);
    if (!of_trees.has_row(i) || from == place.end()) continue;
    for (const FactorEntry& entry : of_trees.row(i)) {
      if (entry.to == of_trees.sky()) continue;
      const auto to = place.find(of_trees.elements()[entry.to].name);
      if (to == place.end()) continue;
      EXPECT_EQ(of_deeper.factor(from->second, to->second), entry.factor);
      ++compared;
    }
  }
  EXPECT_GT(compared, 300u);
}

}  // namespace
}  // namespace hottel::refinement_test
