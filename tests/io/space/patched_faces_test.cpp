#include "io/scene/space/patched_faces.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "geometry/space/arrangement/arrangement.h"
#include "geometry/space/arrangement/solids.h"
#include "io/scene/exact_decimal.h"
#include "io/scene/scene_json.h"
#include "io/scene/space/mesh_adder.h"
#include "io/scene/space/mesh_writer.h"
#include "io/scene/space/vs3_reader.h"
#include "io/scene/space/vs3_writer.h"

namespace hottel::patched_faces_test {
namespace {

using ::testing::Contains;
using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::Not;

bool is_decimal(const Point3& p) {
  return exact_decimal_text(p.x) && exact_decimal_text(p.y) && exact_decimal_text(p.z);
}

Scene3 scene_of_polygons(const std::string& polygons) {
  return parse_scene_3(R"({"hottel": 1, "dimension": 3, "materials": {"a": {"reflectivity": 0.1},
                          "b": {"reflectivity": 0.2}, "c": {"reflectivity": 0.3}}, "polygons": [)" +
                           polygons + "]}",
                       "scene.json");
}

// A wall turned by 24 degrees and typed to six digits, and a window on it.
std::string turned_wall(const std::string& window) {
  return R"({"name": "wall", "points": [[-0.406737,0.913545,0],[3.247445,2.540492,0],[3.247445,2.540492,3],
             [-0.406737,0.913545,3]], "material": "a"}, {"name": "win", "material": "b", )" +
         window + "}";
}
const std::string kOnBack =
    R"("points": [[0.506809,1.320282,2],[2.3339,2.133755,2],[2.3339,2.133755,1],[0.506809,1.320282,1]], "on": "wall:back")";

TEST(PatchedFaces, BackToBackAreTheSameTriangles) {
  const Scene3 scene = scene_of_polygons(turned_wall(kOnBack));
  const PatchCarriers3 carriers(scene);
  const PatchedFaces3 faces(carriers, is_decimal);
  EXPECT_TRUE(faces.cuts(0));
  const std::vector<Polygon3> wall = faces.of({0, false}), window = faces.of({1, false});
  EXPECT_EQ(window.size(), 2u);
  for (Polygon3 triangle : window) {
    std::reverse(triangle.points.begin() + 1, triangle.points.end());
    EXPECT_THAT(wall, Contains(triangle));
  }
  Vector3 sum;
  for (const Polygon3& triangle : wall) {
    const Vector3 area = doubled_area(triangle);
    sum = {sum.x + area.x, sum.y + area.y, sum.z + area.z};
  }
  EXPECT_EQ(sum, doubled_area(scene.polygons[0]));
}

TEST(PatchedFaces, WhatIsHeldIsCutAsItsPatchesSay) {
  const Scene3 scene = scene_of_polygons(turned_wall(kOnBack));
  const PatchCarriers3 carriers(scene);
  const PatchedFaces3 faces(carriers, [](const Point3&) { return true; });
  EXPECT_EQ(faces.of({0, false}), beside_patches(carriers, {0, false}));
  EXPECT_EQ(faces.of({0, true}), beside_patches(carriers, {0, true}));
  const PatchedFaces3 left(carriers, is_decimal, [](std::uint32_t) { return true; });
  EXPECT_TRUE(left.leaves(0));
  EXPECT_FALSE(left.cuts(0));
}

// Turns and types to six digits.
class Turned {
 public:
  explicit Turned(double angle, double tilt) : angle_(angle), tilt_(tilt) {}
  std::string operator()(double x, double y, double z) const {
    const double u = std::cos(angle_) * x - std::sin(angle_) * y, v = std::sin(angle_) * x + std::cos(angle_) * y;
    char text[100];
    std::snprintf(text, sizeof text, "[%.6f,%.6f,%.6f]", u, std::cos(tilt_) * v - std::sin(tilt_) * z,
                  std::sin(tilt_) * v + std::cos(tilt_) * z);
    return text;
  }

 private:
  double angle_, tilt_;
};

// A box of one group on a floor, and patches on its sides, on the front and the back of a wall, some up to the border;
// and one on a patch.
std::string furnished(const Turned& at, std::mt19937& random) {
  std::string text;
  const auto add = [&](const std::string& name, const std::vector<std::string>& points, const std::string& more) {
    text += std::string(text.empty() ? "" : ", ") + R"({"name": ")" + name + R"(", "points": [)";
    for (std::size_t k = 0; k < points.size(); ++k) text += (k > 0 ? "," : "") + points[k];
    text += "], " + more + "}";
  };
  add("floor", {at(0, 0, 0), at(9, 0, 0), at(9, 9, 0), at(0, 9, 0)}, R"("material": "c")");
  const std::string box = R"("material": "a", "group": "box")";
  add("top", {at(1, 1, 3), at(4, 1, 3), at(4, 4, 3), at(1, 4, 3)}, box);
  add("bottom", {at(1, 1, 0), at(1, 4, 0), at(4, 4, 0), at(4, 1, 0)}, box);
  add("south", {at(1, 1, 0), at(4, 1, 0), at(4, 1, 3), at(1, 1, 3)}, box);
  add("north", {at(4, 4, 0), at(1, 4, 0), at(1, 4, 3), at(4, 4, 3)}, box);
  add("west", {at(1, 4, 0), at(1, 1, 0), at(1, 1, 3), at(1, 4, 3)}, box);
  add("east", {at(4, 1, 0), at(4, 4, 0), at(4, 4, 3), at(4, 1, 3)}, box);
  add("wall", {at(9, 8, 1), at(1, 8, 1), at(1, 8, 3), at(9, 8, 3)}, R"("material": "a")");
  const auto low = [&] { return 0.25 * static_cast<double>(random() % 3); };
  const auto high = [&] { return 1 - 0.3 * static_cast<double>(random() % 2); };
  const double a = 1 + 3 * low() / 2, b = 1 + 3 * high(), c = 3 * low() / 2, d = 3 * high();
  const auto add_chain = [&](bool is_inner) {
    if (is_inner)
      add("pane", {at(a, 1, c), at((a + b) / 2, 1, c), at((a + b) / 2, 1, d), at(a, 1, d)},
          R"("material": "c", "on": "window")");
    else
      add("window", {at(a, 1, c), at(b, 1, c), at(b, 1, d), at(a, 1, d)}, R"("material": "b", "on": "south")");
  };
  const bool is_inner_first = random() % 2 == 0;
  add_chain(is_inner_first);
  add_chain(!is_inner_first);
  add("lamp", {at(2, 8, 1), at(3, 8, 1), at(3, 8, 2), at(2, 8, 2)}, R"("material": "b", "on": "wall:back")");
  add("door", {at(7, 8, 1), at(6, 8, 1), at(6, 8, 2.3), at(7, 8, 2.3)}, R"("material": "c", "on": "wall")");
  return text;
}

// The areas of fronts by group, of what is free.
std::map<std::string, double> areas(const Scene3& scene) {
  const Arrangement3 arrangement(scene);
  std::map<std::string, double> result;
  for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s) {
    double area = 0;
    for (const PieceSide3& side : arrangement.sides({s, false})) {
      const Piece3& piece = arrangement.pieces()[side.piece];
      if (piece.side(side.is_back).cover != Piece3::Cover::kFree) continue;
      const auto [x, y, z] = to_doubles(doubled_area(piece.polygon));
      area += std::sqrt(x * x + y * y + z * z) / 2;
    }
    result[scene.groups[scene.surfaces[s].group].name] += area;
  }
  return result;
}

bool is_box_solid(const Scene3& scene) {
  const Solids3 solids(scene);
  for (std::uint32_t g = 0; g < scene.groups.size(); ++g)
    if (scene.groups[g].name == "box")
      return solids.mesh_of(g) != nullptr && solids.mesh_of(g)->kind == ClosedMesh3::Kind::kSolid;
  return false;
}

// How much of a solid's foot rounding may leave free.
constexpr double kNear = 1e-9;

TEST(PatchedFaces, SolidsAndAreasOutliveRounding) {
  std::mt19937 random(20260);  // NOLINT
  int solid_decks = 0;
  for (int k = 0; k < 24; ++k) {
    const double angle = k % 8 == 0 ? 0 : static_cast<double>(random() % 1000) * std::numbers::pi / 500;
    const double tilt = k % 3 == 2 ? static_cast<double>(random() % 1000) * std::numbers::pi / 500 : 0;
    const Turned at(angle, tilt);
    const Scene3 scene = scene_of_polygons(furnished(at, random));
    ASSERT_TRUE(is_box_solid(scene)) << k;
    const std::map<std::string, double> expected = areas(scene);
    const WrittenMesh3 mesh = write_mesh_3(scene, MeshFormat3::kObj, "scene.mtl");
    const Scene3 from_mesh = scene_of(parse_mesh_3(MeshFormat3::kObj, mesh.bytes, "scene.obj", [&](const auto&) {
                               return mesh.library;
                             })).scene;
    const WrittenVs3Deck3 deck = write_vs3_3(scene, true);
    const Scene3 from_deck = parse_vs3_3(deck.text, "scene.vs3").scene;
    EXPECT_THAT(mesh.notes, Each(Not(HasSubstr("hollow")))) << k;
    // A deck cannot say that pieces of a patch lie on pieces of what is not quite plane, or comes later.
    const bool is_told = std::ranges::any_of(
        deck.notes, [](const std::string& note) { return note.find("hollow in the file") != std::string::npos; });
    EXPECT_NE(is_box_solid(from_deck), is_told) << k;
    solid_decks += is_told ? 0 : 1;
    EXPECT_TRUE(is_box_solid(from_mesh)) << k;
    for (const Scene3* again : {&from_mesh, &from_deck}) {
      if (!is_box_solid(*again)) continue;
      std::map<std::string, double> found = areas(*again);
      EXPECT_EQ(found.size(), expected.size());
      for (const auto& [name, area] : expected) EXPECT_NEAR(found[name], area, kNear) << k << name;
    }
  }
  EXPECT_GE(solid_decks, 6);
}

}  // namespace
}  // namespace hottel::patched_faces_test
