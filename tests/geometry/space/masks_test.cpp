// Masks: surfaces that lie on others, front on front, and see nothing but them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "geometry/space/arrangement/arrangement.h"
#include "geometry/space/check/repair.h"
#include "geometry/space/exchange/exchange.h"
#include "geometry/space/exchange/pair_report.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "geometry/space/scene/division.h"
#include "io/scene/scene_json.h"
#include "tests/refusal.h"

namespace hottel::masks_test {
namespace {

constexpr double kOpposite = 0.1998248956983873830415993, kAdjacent = 0.2000437760754031542396002;

Scene3 scene_of(const std::string& polygons) {
  return parse_scene_3(
      R"({"hottel": 1, "dimension": 3, "materials": {"m": {"reflectivity": 0.5}}, "polygons": [)" + polygons + "]}",
      "scene.json");
}

std::string polygon(const std::string& name, const std::string& points, const std::string& more = "") {
  return "{\"name\": \"" + name + "\", \"points\": [" + points + "], \"material\": \"m\"" + more + "}";
}

const std::string kRest =
    polygon("ceiling", "[0,1,1],[1,1,1],[1,0,1],[0,0,1]") + "," + polygon("south", "[0,0,0],[0,0,1],[1,0,1],[1,0,0]") +
    "," + polygon("north", "[0,1,0],[1,1,0],[1,1,1],[0,1,1]") + "," +
    polygon("west", "[0,0,0],[0,1,0],[0,1,1],[0,0,1]") + "," + polygon("east", "[1,0,0],[1,0,1],[1,1,1],[1,1,0]");
const std::string kFloor = polygon("floor", "[0,0,0],[1,0,0],[1,1,0],[0,1,0]");

std::string mask(const std::string& points, const std::string& base = "floor", const std::string& name = "mask") {
  return polygon(name, points, ", \"masks\": \"" + base + "\"");
}

ExchangeMatrix factors(const Scene3& scene, Granularity granularity = Granularity::kFace) {
  return exact_exchange(prepare(scene), {.granularity = granularity, .wants_visibility = true});
}

double factor(const ExchangeMatrix& matrix, const std::string& from, const std::string& to) {
  return matrix.factor(from, to).value;
}

double area(const ExchangeMatrix& matrix, const std::string& name) {
  return matrix.elements()[*matrix.find(name)].area.value;
}

void expect_closed_rows(const ExchangeMatrix& matrix) {
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i)) continue;
    double sum = 0;
    for (const FactorEntry& entry : matrix.row(i)) sum += entry.factor.value;
    EXPECT_NEAR(sum, 1, 1e-13) << matrix.name(i);
  }
}

// What is left of the floor of a cube is half of it, of which the ceiling sees half as much, by symmetry.
TEST(Masks3, TakeNoAreaFromTheirBaseAndAllOfWhatItSeesThere) {
  const ExchangeMatrix matrix =
      factors(scene_of(kFloor + "," + kRest + "," + mask("[0,0,0],[0,0.5,0],[1,0.5,0],[1,0,0]")));
  EXPECT_EQ(area(matrix, "floor"), 1);
  EXPECT_EQ(area(matrix, "mask"), 0.5);
  EXPECT_EQ(factor(matrix, "mask", "floor"), 1);
  EXPECT_EQ(factor(matrix, "floor", "mask"), 0.5);
  EXPECT_EQ(matrix.row(*matrix.find("mask")).size(), 1u);
  EXPECT_EQ(matrix.row(*matrix.find("mask"))[0].visibility, 1);
  EXPECT_NEAR(factor(matrix, "floor", "ceiling"), kOpposite / 2, 1e-14);
  EXPECT_NEAR(factor(matrix, "ceiling", "floor"), kOpposite / 2, 1e-14);
  EXPECT_NEAR(factor(matrix, "ceiling", "mask:back"), kOpposite / 2, 1e-14);
  EXPECT_NEAR(factor(matrix, "west", "floor") + factor(matrix, "west", "mask:back"), kAdjacent, 1e-14);
  EXPECT_EQ(factor(matrix, "ceiling", "mask"), 0);
  expect_closed_rows(matrix);
}

TEST(Masks3, AreTheSameWhereverTheyAreListed) {
  const std::string half = mask("[0,0,0],[0,0.5,0],[1,0.5,0],[1,0,0]");
  const ExchangeMatrix last = factors(scene_of(kFloor + "," + kRest + "," + half));
  const ExchangeMatrix first = factors(scene_of(half + "," + kRest + "," + kFloor));
  for (const char* from : {"floor", "mask", "ceiling", "south"})
    for (const char* to : {"floor", "mask", "ceiling", "south", "mask:back"})
      EXPECT_NEAR(factor(last, from, to), factor(first, from, to), 1e-15) << from << " " << to;
}

TEST(Masks3, ABaseMaskedAllOverSeesNothingElse) {
  const ExchangeMatrix matrix =
      factors(scene_of(kFloor + "," + kRest + "," + mask("[0,0,0],[0,0.5,0],[1,0.5,0],[1,0,0]") + "," +
                       mask("[0,0.5,0],[0,1,0],[1,1,0],[1,0.5,0]", "floor", "other")));
  EXPECT_EQ(factor(matrix, "floor", "mask"), 0.5);
  EXPECT_EQ(factor(matrix, "floor", "other"), 0.5);
  EXPECT_EQ(matrix.row(*matrix.find("floor")).size(), 2u);
  EXPECT_EQ(factor(matrix, "other", "floor"), 1);
  EXPECT_NEAR(factor(matrix, "ceiling", "mask:back") + factor(matrix, "ceiling", "other:back"), kOpposite, 1e-14);
  expect_closed_rows(matrix);
}

// Areas are multiples of a root: sqrt 2, and half of it.
TEST(Masks3, LieInAnyPlane) {
  const ExchangeMatrix matrix = factors(scene_of(polygon("floor", "[0,0,0],[1,0,1],[1,1,1],[0,1,0]") + "," +
                                                 mask("[0,0,0],[0,0.5,0],[1,0.5,1],[1,0,1]")));
  EXPECT_EQ(area(matrix, "floor"), 1.4142135623730951);
  EXPECT_EQ(area(matrix, "mask"), 0.70710678118654757);
  EXPECT_EQ(factor(matrix, "mask", "floor"), 1);
  EXPECT_EQ(factor(matrix, "floor", "mask"), 0.5);
  EXPECT_NEAR(factor(matrix, "floor", "sky"), 0.5, 1e-9);
}

// An L on a floor with a hole and seven corners: 3/4 of a unit on 4 - 1/4 units.
TEST(Masks3, NeedNotBeConvexNorTheirBases) {
  const Scene3 scene = scene_of(polygon("floor", "[0,0,0],[1,0,0],[2,0,0],[2,2,0],[1,2,0],[0,2,0]",
                                        ", \"holes\": [[[1.25,1.25,0],[1.75,1.25,0],[1.75,1.75,0],[1.25,1.75,0]]]") +
                                "," + mask("[0,0,0],[0,1,0],[0.5,1,0],[0.5,0.5,0],[1,0.5,0],[1,0,0]"));
  const ExchangeMatrix matrix = factors(scene);
  EXPECT_EQ(area(matrix, "floor"), 3.75);
  EXPECT_EQ(area(matrix, "mask"), 0.75);
  EXPECT_EQ(factor(matrix, "mask", "floor"), 1);
  EXPECT_EQ(factor(matrix, "floor", "mask"), 0.2);
}

TEST(Masks3, AreDividedWithTheirBases) {
  Scene3 scene = scene_of(kFloor + "," + kRest + "," + mask("[0,0,0],[0,0.5,0],[1,0.5,0],[1,0,0]"));
  divide_into(scene, 3);
  const ExchangeMatrix matrix = factors(scene, Granularity::kElement);
  // The mask begins along x = 0: elements of it are 1/6 deep in y, those of the floor 1/3.
  EXPECT_EQ(area(matrix, "mask#0"), 1.0 / 18);
  EXPECT_EQ(area(matrix, "floor#4"), 1.0 / 9);
  EXPECT_NEAR(factor(matrix, "mask#0", "floor#0"), 1, 1e-15);
  EXPECT_NEAR(factor(matrix, "mask#5", "floor#4"), 1, 1e-15);
  EXPECT_NEAR(factor(matrix, "floor#4", "mask#5"), 0.5, 1e-15);
  EXPECT_EQ(factor(matrix, "mask#0", "floor#1"), 0);
  double shared = 0;
  for (std::uint32_t k = 0; k < 9; ++k)
    for (std::uint32_t l = 0; l < 9; ++l)
      shared += factor(matrix, "mask#" + std::to_string(k), "floor#" + std::to_string(l)) / 18;
  EXPECT_NEAR(shared, 0.5, 1e-15);
  expect_closed_rows(matrix);
}

TEST(Masks3, OfAGroupSeeTheGroupOfTheirBase) {
  const ExchangeMatrix matrix =
      factors(scene_of(polygon("left", "[0,0,0],[0.5,0,0],[0.5,1,0],[0,1,0]", ", \"group\": \"floor\"") + "," +
                       polygon("right", "[0.5,0,0],[1,0,0],[1,1,0],[0.5,1,0]", ", \"group\": \"floor\"") + "," + kRest +
                       "," + mask("[0,0,0],[0,0.5,0],[0.5,0.5,0],[0.5,0,0]", "left")),
              Granularity::kGroup);
  EXPECT_EQ(area(matrix, "floor"), 1);
  EXPECT_EQ(factor(matrix, "mask", "floor"), 1);
  EXPECT_EQ(factor(matrix, "floor", "mask"), 0.25);
  expect_closed_rows(matrix);
}

TEST(Masks3, AndBaseAreOnePairOfTheReport) {
  const PreparedScene3 ready =
      prepare(scene_of(kFloor + "," + kRest + "," + mask("[0,0,0],[0,0.5,0],[1,0.5,0],[1,0,0]")));
  const PairReport3 report = pair_report(ready, Face{6, false}, Face{0, false}, 1e-9);
  EXPECT_EQ(report.exchange.value, 0.5);
  EXPECT_EQ(report.unobstructed.value, 0.5);
  EXPECT_EQ(report.visibility->value, 1);
  EXPECT_TRUE(report.is_whole);
  EXPECT_EQ(report.factor_from->value, 1);
  EXPECT_EQ(report.factor_to->value, 0.5);
  EXPECT_EQ(pair_report(ready, Face{6, false}, Face{1, false}, 1e-9).exchange.value, 0);
}

TEST(Masks3, KeepTheirCornersWhenGapsAreClosed) {
  const Scene3 scene = scene_of(polygon("speck", "[5,5,5],[5,5.0000001,5],[5.0000001,5,5]") + "," + kFloor + "," +
                                polygon("wall", "[0,0,0.0000001],[0,0,1],[1,0,1],[1,0,0.0000001]") + "," +
                                mask("[0,0.0000001,0],[0,0.5,0],[1,0.5,0],[1,0.0000001,0]"));
  const Repair3 repair = close_gaps(scene, Rational(1, 1000));
  EXPECT_EQ(repair.scene.surfaces.size(), 3u);  // the speck has no area any more
  EXPECT_EQ(repair.scene.masks, (std::vector<Mask3>{{2, 0}}));
  EXPECT_EQ(repair.scene.polygons[2], scene.polygons[3]);
  EXPECT_EQ(repair.scene.polygons[0], scene.polygons[1]);
}

TEST(Masks3, AreRefusedWhereTheyAreNotOnTheirBase) {
  const auto refusal = [](const std::string& polygons) {
    return refusal_by([&] { Arrangement3{scene_of(polygons)}; });
  };
  const std::string floor = kFloor + ",\n";
  EXPECT_EQ(
      refusal(floor + mask("[0,0,0],[0,0.5,0],[2,0.5,0],[2,0,0]")).find("scene.json:2: 'mask' is not within 'floor', "),
      0u);
  EXPECT_EQ(
      refusal(floor + mask("[5,0,0],[5,0.5,0],[7,0.5,0],[7,0,0]")).find("scene.json:2: 'mask' is not within 'floor', "),
      0u);
  EXPECT_EQ(refusal(floor + mask("[0,0,0],[0,0.5,0],[1,0.5,0],[1,0,0]") + ",\n" +
                    mask("[0,0,0],[0,1,0],[0.5,1,0],[0.5,0,0]", "floor", "other"))
                .find("scene.json:3: 'other' and 'mask' mask the same place of 'floor', around "),
            0u);
  EXPECT_EQ(refusal(floor + mask("[0,0,1],[0,0.5,1],[1,0.5,1],[1,0,1]")),
            "scene.json:2: polygon 'mask' is not exactly in the plane of 'floor', which it masks");
  EXPECT_EQ(refusal(floor + mask("[0,0,0],[1,0,0],[1,0.5,0],[0,0.5,0]")),
            "scene.json:2: polygon 'mask' faces the same way as 'floor', which it masks: masks face it");
  EXPECT_EQ(refusal(floor + mask("[0,0,0],[0,0.5,0],[1,0.5,0],[1,0,0]", "mask")),
            "scene.json:2: polygon 'mask' masks itself");
  EXPECT_EQ(refusal(floor + mask("[0,0,0],[0,0.5,0],[1,0.5,0],[1,0,0]", "flor")),
            "scene.json:2: polygon 'mask' masks 'flor', but there is no such polygon");
  EXPECT_EQ(refusal(floor + mask("[0,0,0],[0,0.5,0],[1,0.5,0],[1,0,0]") + ",\n" +
                    mask("[0,0,0],[1,0,0],[1,0.5,0],[0,0.5,0]", "mask", "other")),
            "scene.json:3: polygon 'other' masks 'mask', which is a mask itself");
}

}  // namespace
}  // namespace hottel::masks_test
