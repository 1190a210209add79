// Edges divided where light ends: held against many points of every element, each asked for by itself.
#include "solver/plane/light/refinement.h"

#include <gtest/gtest.h>

#include <random>

#include "geometry/plane/predicates/vertices.h"
#include "geometry/plane/scene/division.h"
#include "geometry/plane/visibility/point_location.h"
#include "solver/plane/light/lit_region.h"
#include "tests/solver/plane/lit_scenes.h"

namespace hottel::refinement_test {
namespace {

Light spot(const Rational& focus) {
  Light light;
  light.name = "spot";
  light.type = LightType::kSpot;
  light.focus = focus;
  light.power = Spectrum::scalar(1);
  return light;
}

Light bulb() {
  Light light;
  light.name = "bulb";
  light.power = Spectrum::scalar(1);
  return light;
}

std::size_t leaf_count(const std::vector<SurfaceTrees>& trees) {
  std::size_t count = 0;
  for (const SurfaceTrees& of_surface : trees) count += of_surface.front.size() + of_surface.back.size();
  return count;
}

std::vector<SurfaceTrees> trees_of(Scene2 scene, const Light& light, const LightPlace2& place,
                                   const RefinementLevels& levels) {
  scene.add_light(light, place);
  validate(scene);
  return refined_trees(prepare(std::move(scene)), levels);
}

const Rational kHalf(1, 2);

TEST(RefinedTrees2, WithoutLevelsThereAreNone) {
  EXPECT_EQ(leaf_count(trees_of(pillar_room(), bulb(), {{kHalf, Rational(1, 5)}}, {})), 0u);
}

TEST(RefinedTrees2, AreOfOneDepthEverywhereWhereLightsEndNowhere) {
  // A bulb in the middle of a square lights all of it.
  const auto trees = trees_of(square_room(), bulb(), {{kHalf, kHalf}}, {.everywhere = 2, .at_borders = 6});
  for (const SurfaceTrees& wall : trees) {
    EXPECT_EQ(wall.front, uniform_leaves(1, 2, 2));
    EXPECT_TRUE(wall.back.empty()) << "black backs are not divided";
  }
  EXPECT_EQ(leaf_count(trees_of(square_room(), bulb(), {{kHalf, kHalf}}, {.everywhere = 0, .at_borders = 6})), 0u);
}

TEST(RefinedTrees2, ABeamThatEndsInCornersOfElementsDividesNothing) {
  // From the middle of the square 45 degrees about the x axis are the right wall.
  const LightPlace2 place{{kHalf, kHalf}, {1, 0}};
  EXPECT_EQ(leaf_count(trees_of(square_room(), spot(45), place, {.everywhere = 0, .at_borders = 8})), 0u);
  // Turned by a quarter of it, it ends in the middle of a wall, and at the corner between two elements of it.
  LightPlace2 turned = place;
  turned.turned = 45;
  const auto trees = trees_of(square_room(), spot(45), turned, {.everywhere = 0, .at_borders = 8});
  EXPECT_EQ(leaf_count(trees), 4u) << "two walls of two halves each";
}

TEST(RefinedTrees2, HalvesOneElementALevelWhereOneBorderEnds) {
  // At 30 degrees the border meets the wall at an irrational place: one of two halves holds it at every level.
  LightPlace2 place{{Rational(1, 10), kHalf}, {1, 0}};
  const auto trees = trees_of(square_room(), spot(Rational(30)), place, {.everywhere = 0, .at_borders = 10});
  for (const SurfaceTrees& wall : trees)
    for (const std::vector<TreeNode>* face : {&wall.front, &wall.back})
      if (!face->empty()) {
        EXPECT_TRUE(are_whole(*face, 1, 2));
        EXPECT_TRUE(face->size() == 11 || face->size() == 12) << face->size();
      }
  EXPECT_GT(leaf_count(trees), 0u);
}

// Every leaf that is not as deep as may be is lit all over or nowhere, at points all over it; and each node that was
// divided, though it need not have been, has a border in it or next to it.
TEST(RefinedTrees2, LeavesAboveTheLastLevelAreLitWhollyOrNotAtAll) {
  std::mt19937 random(5);
  std::size_t lit_leaves = 0, deep_leaves = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    Scene2 scene = seed % 2 == 0 ? pillar_room() : random_lattice_scene(seed, 9);
    const Rational unit = seed % 2 == 0 ? Rational(1, 101) : Rational(8, 101);
    LightPlace2 place{{unit * static_cast<int>(random() % 100 + 1), unit * static_cast<int>(random() % 100 + 1)},
                      {static_cast<int>(random() % 9) - 4, static_cast<int>(random() % 9) + 1}};
    place.turned = Rational(static_cast<int>(random() % 360));
    const int focus = static_cast<int>(random() % 180) + 1;
    scene.add_light(focus > 150 ? bulb() : spot(Rational(focus)), place);
    try {
      validate(scene);
    } catch (const InputError&) {
      continue;  // on an edge, or in one's way
    }
    const RefinementLevels levels{.everywhere = 1, .at_borders = 5};
    const PreparedScene2 prepared = prepare(scene);
    const auto trees = refined_trees(prepared, levels);
    const PointLocation2 location(prepared.arrangement.vertices(), prepared.arrangement.triangulation());
    const LitRegion2 region(prepared, location, scene.lights[0], scene.light_places[0]);
    const Vertices2& vertices = prepared.arrangement.vertices();
    // Owned pieces tell which places are of which face; lit from its own side.
    for (const PieceSideId side : prepared.arrangement.sides()) {
      if (prepared.arrangement.is_covered(side)) continue;
      const FacePart2& owner = prepared.arrangement.owner(side);
      const auto& leaves = trees[owner.surface].of(owner.is_back);
      if (leaves.empty()) continue;
      const Segment2 piece = prepared.arrangement.turned_piece(side);  // the side on its right
      const Point2 a = vertices.to_scene(vertices.exact(piece.a)), b = vertices.to_scene(vertices.exact(piece.b));
      const Rational turn = (b.x - a.x) * (place.position.y - a.y) - (b.y - a.y) * (place.position.x - a.x);
      const bool faces_light = turn < 0;
      const Edge2& edge = scene.edges[owner.surface];
      for (const TreeNode& leaf : leaves) {
        const EdgeSpan2 span = EdgeSpan2::of(1, leaf);
        int lit = 0, dark = 0;
        for (int k = 0; k < 16; ++k) {
          // No simple fractions: borders are there.
          const Rational t = span.from + (span.to - span.from) * Rational(194 * k + 61) / 3104;
          const Point2 p = point_at(edge, t);
          const Rational ux = b.x - a.x, uy = b.y - a.y;
          const Rational s = ux != 0 ? Rational((p.x - a.x) / ux) : Rational((p.y - a.y) / uy);
          if (s <= 0 || s >= 1) continue;
          const Eye2 eye(vertices, vertices.from_scene(p));
          const bool is_lit = faces_light && region.irradiance(eye) > 0;
          ++(is_lit ? lit : dark);
        }
        if (leaf.path.depth() < levels.at_borders) {
          EXPECT_TRUE(lit == 0 || dark == 0) << "seed " << seed << ": " << element_name("", 1, leaf);
          ++lit_leaves;
        } else {
          ++deep_leaves;
        }
      }
    }
  }
  EXPECT_GT(lit_leaves, 300u);
  EXPECT_GT(deep_leaves, 50u);
}

}  // namespace
}  // namespace hottel::refinement_test
