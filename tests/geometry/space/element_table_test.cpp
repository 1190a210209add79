// Elements of scenes in space: their names and order, their patches, their areas, the sky.
#include "geometry/space/prepared/element_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "geometry/space/exchange/facing.h"
#include "geometry/space/prepared/area_sum.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"

namespace hottel::element_table_test {
namespace {

using ::testing::ElementsAre;

// A wall with two sides, a slanted triangle with a black back, a roof with two sides. "wall" and "roof" are a group.
constexpr const char* kThree = R"({"hottel": 1, "dimension": 3, "materials": {"m": {}, "w": {}}, "polygons": [
  {"name": "wall", "points": [[0,0,0],[2,0,0],[2,0,1],[0,0,1]], "material": "m", "back": "w", "elements": 2,
   "group": "house"},
  {"name": "slope", "points": [[5,0,0],[6,0,0],[5,"1/3",1]], "material": "w", "elements": 2},
  {"name": "roof", "points": [[0,0,2],[1,0,2],[1,1,3],[0,1,3]], "material": "m", "back": "m", "group": "house"}]})";

struct Table {
  Scene3 scene;
  Arrangement3 arrangement;
  Occluders3 occluders;
  ElementTable3 elements;

  explicit Table(const std::string& json, Granularity granularity = Granularity::kFace)
      : scene(parse_scene_3(json, "scene.json")),
        arrangement(scene),
        occluders(arrangement.polygons()),
        elements(scene, arrangement, occluders, granularity) {}
};

std::vector<std::string> names_of(const Table& table) {
  std::vector<std::string> names;
  for (const Element& element : table.elements.elements()) names.push_back(element.name);
  return names;
}

TEST(ElementTable3, IsInTheOrderOfTheContract) {
  EXPECT_THAT(names_of(Table(kThree)), ElementsAre("wall", "wall:back", "slope", "slope:back", "roof", "roof:back"));
  EXPECT_THAT(
      names_of(Table(kThree, Granularity::kElement)),
      ElementsAre("wall#0", "wall#1", "wall#2", "wall#3", "wall:back#0", "wall:back#1", "wall:back#2", "wall:back#3",
                  "slope#0", "slope#1", "slope#2", "slope#3", "slope:back", "roof", "roof:back"));
  EXPECT_THAT(names_of(Table(kThree, Granularity::kGroup)), ElementsAre("house", "house:back", "slope", "slope:back"));
}

TEST(ElementTable3, OnlyWhatHasAMaterialHasARow) {
  const Table faces(kThree);
  for (std::uint32_t i = 0; i < faces.elements.count(); ++i)
    EXPECT_EQ(faces.elements.has_row(i), faces.elements.elements()[i].name != "slope:back");
  EXPECT_FALSE(faces.elements.has_row(faces.elements.sky()));
  EXPECT_EQ(faces.elements.elements()[1].material, 1u);
}

TEST(ElementTable3, CountsWhatItWillHold) {
  for (const Granularity granularity : {Granularity::kFace, Granularity::kElement, Granularity::kGroup}) {
    const Table table(kThree, granularity);
    const ElementCounts3 counts = element_counts(table.scene, granularity);
    EXPECT_EQ(counts.all, table.elements.count());
    std::uint64_t rows = 0;
    for (std::uint32_t i = 0; i < table.elements.count(); ++i) rows += table.elements.has_row(i);
    EXPECT_EQ(counts.with_material, rows);
  }
  Scene3 many = Table(kThree).scene;
  for (Surface& surface : many.surfaces) surface.elements = kMaxElements;
  EXPECT_EQ(element_counts(many, Granularity::kElement).all, 5'000'000'000'001u);
  const Arrangement3 arrangement(many);
  EXPECT_THROW(ElementTable3(many, arrangement, Occluders3(many.polygons), Granularity::kElement), RequestError);
}

TEST(ElementTable3, PatchesAreThoseOfTheirElements) {
  for (const Granularity granularity : {Granularity::kFace, Granularity::kElement, Granularity::kGroup}) {
    const Table table(kThree, granularity);
    std::size_t next = 0;
    for (std::uint32_t label = 0; label <= table.elements.sky(); ++label)
      for (const ElementTable3::Part& part : table.elements.parts(label)) {
        EXPECT_EQ(&part, &table.elements.parts()[next++]);
        EXPECT_EQ(part.label, label);
        EXPECT_EQ(part.patch.is_sky(), label == table.elements.sky());
      }
    EXPECT_EQ(next, table.elements.parts().size());
    EXPECT_EQ(table.elements.parts(table.elements.sky()).size(), 1u);
  }
  EXPECT_EQ(Table(kThree, Granularity::kGroup).elements.parts(1).size(), 2u);
  EXPECT_FALSE(Table(kThree, Granularity::kGroup).elements.is_one_patch(1));
}

IntegerVector doubled_area_of(const Patch3& patch) {
  IntegerVector sum;
  for (std::size_t k = 1; k + 1 < patch.corners.size(); ++k) {
    const IntegerVector turn =
        cross(difference(patch.corners[k], patch.corners[0]), difference(patch.corners[k + 1], patch.corners[0]));
    sum = {sum.x + turn.x, sum.y + turn.y, sum.z + turn.z};
  }
  return sum;
}

TEST(ElementTable3, CornersGoAroundCounterClockwiseSeenFromTheFrontOfThePatch) {
  for (const Granularity granularity : {Granularity::kFace, Granularity::kElement, Granularity::kGroup}) {
    const Table table(kThree, granularity);
    for (const ElementTable3::Part& part : table.elements.parts()) {
      if (part.patch.is_sky()) continue;
      const Integer along = dot(doubled_area_of(part.patch), table.occluders.exact_normal(part.patch.surface));
      EXPECT_EQ(sgn(along), part.is_back ? -1 : 1);
    }
  }
  // The first corner of a back is that of its front.
  const Table faces(kThree);
  EXPECT_EQ(faces.elements.parts(0)[0].patch.corners[0], faces.elements.parts(1)[0].patch.corners[0]);
  EXPECT_EQ(faces.elements.parts(0)[0].patch.corners[1], faces.elements.parts(1)[0].patch.corners[3]);
}

TEST(ElementTable3, AreasAreCorrectlyRounded) {
  const Table faces(kThree);
  const auto& elements = faces.elements.elements();
  EXPECT_EQ(elements[0].area, (Rounded{2, 0}));
  EXPECT_EQ(elements[1].area, (Rounded{2, 0}));
  // Half of the length of (0, -1, 1/3): sqrt(10) / 6 = 0.52704627669472988866648...
  EXPECT_EQ(elements[2].area.value, 0.52704627669472988);
  EXPECT_NE(elements[2].area.side, 0);
  EXPECT_EQ(elements[4].area.value, std::sqrt(2));
  const Table parts(kThree, Granularity::kElement);
  for (std::uint32_t k = 0; k < 8; ++k) EXPECT_EQ(parts.elements.elements()[k].area, (Rounded{0.5, 0}));
  EXPECT_EQ(parts.elements.elements()[8].area.value, 0.52704627669472988 / 4);
  const Table groups(kThree, Granularity::kGroup);
  // 2 + sqrt(2), with sqrt(2) = 1.41421356237309504880168872...
  EXPECT_EQ(groups.elements.elements()[0].area.value, 3.4142135623730950);
}

TEST(ElementTable3, ExtentsAreAreasInTheUnitOfTheVertices) {
  const Table faces(kThree);
  const Vertices3& vertices = faces.occluders.vertices();
  const Rational unit = scaled_by_power_of_two(vertices.scale(), vertices.shift());
  for (std::uint32_t i = 0; i < faces.elements.count(); ++i)
    EXPECT_NEAR(faces.elements.extent(i).value * to_double(unit * unit), faces.elements.elements()[i].area.value,
                1e-15);
}

TEST(ElementTable3, TheSkyIsOnePatch) {
  const Table table(kThree);
  const auto sky = table.elements.parts(table.elements.sky());
  ASSERT_EQ(sky.size(), 1u);
  EXPECT_TRUE(sky.front().patch.is_all_of_the_sky());
}

TEST(ElementTable3, CornersAreToldInTheSceneAndCorrectlyRounded) {
  const Table table(kThree, Granularity::kElement);
  const auto corners = element_corners(table.elements, table.occluders.vertices());
  using Points = std::vector<std::array<double, 3>>;
  EXPECT_EQ(corners[1], (Points{{1, 0, 0}, {2, 0, 0}, {2, 0, 0.5}, {1, 0, 0.5}}));
  EXPECT_EQ(corners[5], (Points{{1, 0, 0}, {1, 0, 0.5}, {2, 0, 0.5}, {2, 0, 0}}));  // of the back
  EXPECT_EQ(corners[11], (Points{{5, 1.0 / 6, 0.5}, {5.5, 1.0 / 6, 0.5}, {5, 1.0 / 3, 1}}));
  const Table groups(kThree, Granularity::kGroup);
  EXPECT_TRUE(element_corners(groups.elements, groups.occluders.vertices())[0].empty());
}

TEST(ElementTable3, AnEmptySceneHasNoElementsAndNoSky) {
  const Table table(R"({"hottel": 1, "dimension": 3, "polygons": []})");
  EXPECT_EQ(table.elements.count(), 0u);
  EXPECT_TRUE(table.elements.parts().empty());
}

// The second way: patches in doubles.
bool is_before(const Table& table, const ElementTable3::Part& other, const ElementTable3::Part& part) {
  const auto at = [](const Patch3& patch, std::size_t k) {
    const IntegerVector& c = patch.corners[k];
    const double w = patch.weight.get_d();
    return std::array<double, 3>{c.x.get_d() / w, c.y.get_d() / w, c.z.get_d() / w};
  };
  const IntegerVector n = table.occluders.exact_normal(part.patch.surface);
  const auto o = at(part.patch, 0);
  for (std::size_t k = 0; k < other.patch.corners.size(); ++k) {
    const auto c = at(other.patch, k);
    const double height = n.x.get_d() * (c[0] - o[0]) + n.y.get_d() * (c[1] - o[1]) + n.z.get_d() * (c[2] - o[2]);
    if ((part.is_back ? -height : height) > 1e-9) return true;
  }
  return false;
}

TEST(FaceEachOther, IsDecidedForEveryElement) {
  // A slanted screen over a floor: each of its sides has only some elements of the floor before it.
  const Table table(R"({"hottel": 1, "dimension": 3, "materials": {"m": {}}, "polygons": [
    {"name": "floor", "points": [[0,0,0],[4,0,0],[4,4,0],[0,4,0]], "material": "m", "back": "m", "elements": 4},
    {"name": "screen", "points": [[2,0,0],[2,4,0],[3,4,1],[3,0,1]], "material": "m", "back": "m", "elements": 2}]})",
                    Granularity::kElement);
  std::size_t facing = 0, parted = 0;
  for (const ElementTable3::Part& i : table.elements.parts())
    for (const ElementTable3::Part& j : table.elements.parts()) {
      if (i.patch.is_sky() || j.patch.is_sky()) continue;
      const bool expected = i.patch.surface != j.patch.surface && is_before(table, i, j) && is_before(table, j, i);
      EXPECT_EQ(face_each_other(table.occluders, i, j), expected)
          << table.elements.elements()[i.label].name << " " << table.elements.elements()[j.label].name;
      facing += expected;
      parted += surfaces_face_each_other(table.occluders, i, j) && !expected;
    }
  EXPECT_GT(facing, 0u);
  EXPECT_GT(parted, 0u);  // the faces do, these elements do not
}

TEST(AreaSum3, OfManyRootsIsRoundedAsTheCanonicalSum) {
  AreaSum3 many;
  double sum = 0;
  for (unsigned long k = 2; k < 60; ++k) {
    many.add(Rational(1) / 3, Integer(k));
    sum += std::sqrt(static_cast<double>(k)) / 3;
  }
  const Rounded rounded = many.rounded(7);
  EXPECT_NEAR(rounded.value, 7 * sum, 1e-12);
  EXPECT_NE(rounded.side, 0);
  // A sum that is a double: balls cannot tell on which side of it.
  AreaSum3 whole;
  Integer expected = 0;
  for (unsigned long k = 1; k < 30; ++k) {
    whole.add(1, Integer(k * k));
    expected += k;
  }
  EXPECT_EQ(whole.rounded(1), (Rounded{expected.get_d(), 0}));
}

}  // namespace
}  // namespace hottel::element_table_test
