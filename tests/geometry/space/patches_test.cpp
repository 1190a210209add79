// Patches of space: polygons that lie on others and take their part of them.
#include "geometry/space/scene/patches.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "geometry/space/arrangement/arrangement.h"
#include "geometry/space/check/contact_findings.h"
#include "geometry/space/check/mesh_findings.h"
#include "geometry/space/check/repair.h"
#include "geometry/space/contacts/near_contacts.h"
#include "geometry/space/exchange/exchange.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "geometry/space/scene/division.h"
#include "io/scene/scene_json.h"
#include "tests/refusal.h"

namespace hottel::patches_3_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

Scene3 scene_of(const std::string& polygons) {
  return parse_scene_3(R"({"hottel": 1, "dimension": 3,
    "materials": {"a": {"reflectivity": 0.5}, "b": {"reflectivity": 0.25}, "c": {"reflectivity": 0.75}},
    "polygons": [)" + polygons +
                           "]}",
                       "scene.json");
}

std::string polygon(const std::string& name, const std::string& points, const std::string& more = "",
                    const std::string& material = "a") {
  return "{\"name\": \"" + name + "\", \"points\": [" + points + "], \"material\": \"" + material + "\"" + more + "}";
}
std::string on(const std::string& base) { return ", \"on\": \"" + base + "\""; }

const std::string kRest =
    polygon("ceiling", "[0,1,1],[1,1,1],[1,0,1],[0,0,1]") + "," + polygon("south", "[0,0,0],[0,0,1],[1,0,1],[1,0,0]") +
    "," + polygon("north", "[0,1,0],[1,1,0],[1,1,1],[0,1,1]") + "," +
    polygon("west", "[0,0,0],[0,1,0],[0,1,1],[0,0,1]") + "," + polygon("east", "[1,0,0],[1,0,1],[1,1,1],[1,1,0]");
const std::string kFloor = polygon("floor", "[0,0,0],[1,0,0],[1,1,0],[0,1,0]");
const std::string kRoom = kFloor + "," + kRest;
const std::string kMat = "[0.25,0.25,0],[0.75,0.25,0],[0.75,0.75,0],[0.25,0.75,0]";

std::string mat(const std::string& more = on("floor"), const std::string& points = kMat) {
  return polygon("mat", points, more, "b");
}

ExchangeMatrix factors(const Scene3& scene, Granularity granularity = Granularity::kFace) {
  return exact_exchange(prepare(scene), {.granularity = granularity});
}
double area(const ExchangeMatrix& matrix, const std::string& name) {
  return matrix.elements()[*matrix.find(name)].area.value;
}
std::string refusal(const std::string& polygons) {
  return refusal_by([&] { prepare(scene_of(polygons)); });
}
double row_sum(const ExchangeMatrix& matrix, const std::string& from) {
  double sum = 0;
  for (const FactorEntry& entry : matrix.row(*matrix.find(from))) sum += entry.factor.value;
  return sum;
}

TEST(Patches3, TakeTheirPartWhateverTheMaterials) {
  const ExchangeMatrix matrix = factors(scene_of(kRoom + "," + mat()));
  EXPECT_EQ(area(matrix, "mat"), 0.25);
  EXPECT_EQ(area(matrix, "floor"), 0.75);
  EXPECT_NEAR(row_sum(matrix, "mat"), 1, 1e-12);
  EXPECT_NEAR(row_sum(matrix, "floor"), 1, 1e-12);
  EXPECT_EQ(area(matrix, "mat:back"), 0);
}

TEST(Patches3, AndWhatIsLeftAddUpToTheWhole) {
  const ExchangeMatrix whole = factors(scene_of(kRoom)), parted = factors(scene_of(kRoom + "," + mat()));
  for (const std::string other : {"ceiling", "south", "north", "west", "east"}) {
    EXPECT_NEAR(whole.factor(other, "floor").value,
                parted.factor(other, "floor").value + parted.factor(other, "mat").value, 1e-13);
    EXPECT_NEAR(whole.factor("floor", other).value,
                0.75 * parted.factor("floor", other).value + 0.25 * parted.factor("mat", other).value, 1e-13);
  }
}

TEST(Patches3, AreTheSceneWithAHoleCutByHand) {
  const std::string screen = polygon("screen", "[0.2,0.4,0.1],[0.9,0.4,0.1],[0.5,0.9,0.4]", R"(, "back": "c")");
  const std::string hole = polygon("floor", "[0,0,0],[1,0,0],[1,1,0],[0,1,0]", R"(, "holes": [[)" + kMat + "]]");
  const ExchangeMatrix patched = factors(scene_of(kRoom + "," + screen + "," + mat())),
                       by_hand = factors(scene_of(hole + "," + kRest + "," + screen + "," + mat("")));
  for (const std::string from : {"floor", "mat", "screen:back", "ceiling"})
    for (const std::string to : {"floor", "mat", "screen", "screen:back", "ceiling", "west"})
      EXPECT_NEAR(patched.factor(from, to).value, by_hand.factor(from, to).value, 1e-12) << from << " " << to;
}

TEST(Patches3, HaveABackOnlyWithAMaterial) {
  const std::string plate = polygon("plate", "[0,0,0],[1,0,0],[1,1,0],[0,1,0]", R"(, "back": "c")");
  const ExchangeMatrix without = factors(scene_of(plate + "," + mat(on("plate")))),
                       with = factors(scene_of(plate + "," + mat(on("plate") + R"(, "back": "a")")));
  EXPECT_EQ(area(without, "plate:back"), 1);
  EXPECT_EQ(area(with, "plate:back"), 0.75);
  EXPECT_EQ(area(with, "mat:back"), 0.25);
  const std::string turned = "[0.25,0.25,0],[0.25,0.75,0],[0.75,0.75,0],[0.75,0.25,0]";
  const ExchangeMatrix below = factors(scene_of(plate + "," + mat(on("plate:back"), turned)));
  EXPECT_EQ(area(below, "plate"), 1);
  EXPECT_EQ(area(below, "plate:back"), 0.75);
}

TEST(Patches3, OfAChainTheInnermostWinsWhereverItIsListed) {
  const std::string spot = polygon("spot", "[0.25,0.25,0],[0.5,0.25,0],[0.5,0.5,0],[0.25,0.5,0]", on("mat"), "c");
  for (const std::string& text : {spot + "," + mat() + "," + kRoom, kRoom + "," + mat() + "," + spot}) {
    const ExchangeMatrix matrix = factors(scene_of(text));
    EXPECT_EQ(area(matrix, "spot"), 0.0625);
    EXPECT_EQ(area(matrix, "mat"), 0.1875);
    EXPECT_EQ(area(matrix, "floor"), 0.75);
  }
}

TEST(Patches3, MaySpanFacesOfAGroup) {
  const std::string halves = polygon("f1", "[0,0,0],[1,0,0],[1,1,0]", R"(, "group": "floor")") + "," +
                             polygon("f2", "[0,0,0],[1,1,0],[0,1,0]", R"(, "group": "floor")");
  const ExchangeMatrix matrix = factors(scene_of(halves + "," + kRest + "," + mat()));
  EXPECT_EQ(area(matrix, "mat"), 0.25);
  EXPECT_EQ(area(matrix, "f1"), 0.375);
  EXPECT_EQ(area(matrix, "f2"), 0.375);
  EXPECT_THAT(refusal(halves + "," + kRest + "," + mat(on("f1"))),
              AllOf(HasSubstr("'mat' leaves 'f1'"), HasSubstr("there is nothing of that")));
}

TEST(Patches3, LeaveElementsTheirNumbers) {
  Scene3 scene = scene_of(kRoom + "," + polygon("tile", "[0,0,0],[0.5,0,0],[0.5,0.5,0],[0,0.5,0]", on("floor"), "b"));
  scene.surfaces[0].elements = 2;
  const ExchangeMatrix matrix = factors(scene, Granularity::kElement);
  for (const auto& [name, has_row] :
       {std::pair{"floor#0", false}, {"floor#1", true}, {"floor#3", true}, {"tile", true}})
    EXPECT_EQ(matrix.has_row(*matrix.find(name)), has_row) << name;
}

std::string box(const std::string& low, const std::string& high) {
  const std::string b = R"(, "group": "box")";
  return polygon("bottom",
                 "[0.25,0.25," + low + "],[0.25,0.75," + low + "],[0.5,0.75," + low + "],[0.5,0.25," + low + "]", b) +
         "," +
         polygon("top",
                 "[0.25,0.25," + high + "],[0.5,0.25," + high + "],[0.5,0.75," + high + "],[0.25,0.75," + high + "]",
                 b) +
         "," +
         polygon("b1",
                 "[0.25,0.25," + low + "],[0.5,0.25," + low + "],[0.5,0.25," + high + "],[0.25,0.25," + high + "]", b) +
         "," +
         polygon("b2", "[0.5,0.25," + low + "],[0.5,0.75," + low + "],[0.5,0.75," + high + "],[0.5,0.25," + high + "]",
                 b) +
         "," +
         polygon("b3",
                 "[0.5,0.75," + low + "],[0.25,0.75," + low + "],[0.25,0.75," + high + "],[0.5,0.75," + high + "]", b) +
         "," +
         polygon("b4",
                 "[0.25,0.75," + low + "],[0.25,0.25," + low + "],[0.25,0.25," + high + "],[0.25,0.75," + high + "]",
                 b);
}

TEST(Patches3, AreCoveredBySolids) {
  const ExchangeMatrix matrix = factors(scene_of(kRoom + "," + mat() + "," + box("0", "0.5")));
  EXPECT_EQ(area(matrix, "mat"), 0.125);
  EXPECT_EQ(area(matrix, "floor"), 0.75);
}

// A label on a box, of its group or not: the box stays solid, and the label is seen.
TEST(Patches3, DoNotCountWhetherAGroupCloses) {
  const std::string label = "[0.3,0.3,0.5],[0.4,0.3,0.5],[0.4,0.4,0.5],[0.3,0.4,0.5]";
  for (const std::string& more : {on("box") + R"(, "group": "box")", on("top")}) {
    const Scene3 scene = scene_of(kRoom + "," + box("0", "0.5") + "," + polygon("label", label, more, "b"));
    const ExchangeMatrix matrix = factors(scene);
    EXPECT_FALSE(matrix.has_row(*matrix.find("bottom"))) << more;
    EXPECT_NEAR(area(matrix, "label"), 0.01, 1e-17);
    EXPECT_THAT(mesh_findings(scene, find_meshes(scene)), IsEmpty());
    EXPECT_THAT(contact_findings(scene, find_contacts(scene)), testing::SizeIs(testing::Le(8u)));
  }
}

TEST(Patches3, AreToldWhereTheyAreNot) {
  EXPECT_THAT(refusal(kRoom + "," + mat(on("floor"), "[0.25,0.25,0.01],[0.75,0.25,0],[0.75,0.75,0],[0.25,0.75,0.01]")),
              AllOf(HasSubstr("'mat' does not lie on 'floor'"), HasSubstr("is 0.01 off its plane")));
  EXPECT_THAT(refusal(kRoom + "," + mat(on("floor"), "[0.25,0.25,0],[0.25,0.75,0],[0.75,0.75,0],[0.75,0.25,0]")),
              HasSubstr("'mat' looks the other way than 'floor'"));
  EXPECT_THAT(refusal(kRoom + "," + mat(on("floor"), "[0.5,0.5,0],[1.5,0.5,0],[1.5,0.75,0],[0.5,0.75,0]")),
              AllOf(HasSubstr("'mat' leaves 'floor'"), HasSubstr("around (")));
  EXPECT_THAT(refusal(kRoom + "," + mat(on("floor"), "[2.5,0.5,0],[3.5,0.5,0],[3.5,0.75,0],[2.5,0.75,0]")),
              HasSubstr("it is beside it"));
  EXPECT_THAT(refusal(kRoom + "," + mat(on("flor"))), HasSubstr("there is no surface or group of that name"));
  EXPECT_THAT(refusal(kRoom + "," + mat(on("mat"))), HasSubstr("'mat' lies on itself"));
}

TEST(Patches3, AreNoMasksAndSolids) {
  EXPECT_THAT(refusal(kRoom + "," + mat(on("floor") + R"(, "masks": "floor")")), HasSubstr("it does not mask one too"));
  EXPECT_THAT(refusal(kRoom + "," + mat(on("floor") + R"(, "behind": "open")")), HasSubstr("has no \"behind\""));
  const std::string mask = polygon("mask", "[0.5,0.5,0],[0.5,0.9,0],[0.9,0.9,0],[0.9,0.5,0]", R"(, "masks": "floor")");
  EXPECT_THAT(refusal(kRoom + "," + mat() + "," + mask), HasSubstr("'mask' masks 'floor' where 'mat' lies on it"));
}

TEST(Patches3, AreNotOnMasks) {
  const std::string mask = polygon("mask", "[0.5,0.5,0],[0.5,0.9,0],[0.9,0.9,0],[0.9,0.5,0]", R"(, "masks": "floor")");
  const std::string label = "[0.5,0.5,0],[0.5,0.7,0],[0.7,0.7,0],[0.7,0.5,0]",
                    back = "[0.5,0.5,0],[0.7,0.5,0],[0.7,0.7,0],[0.5,0.7,0]";
  EXPECT_THAT(refusal(kRoom + "," + mask + "," + polygon("label", label, on("mask"), "b")),
              HasSubstr("'label' lies on 'mask', which masks 'floor': nothing lies between the two"));
  EXPECT_EQ(refusal(kRoom + "," + mask + "," + polygon("label", back, on("mask:back"), "b")), "");
  EXPECT_THAT(refusal(kRoom + "," + mask + "," + polygon("label", back, on("mask:back") + R"(, "back": "a")", "b")),
              HasSubstr("'label' lies on 'mask'"));
}

// What a back of a patch on a solid looks at is covered, and so is what a patch on the back of it looks at.
TEST(Patches3, WithBacksOnSolidsAreCoveredInside) {
  const auto with = [&](const std::string& points, const std::string& more) {
    const ExchangeMatrix matrix =
        factors(scene_of(kRoom + "," + box("0", "0.5") + "," + polygon("win", points, more, "b")));
    return std::array{area(matrix, "win"), area(matrix, "top")};
  };
  const std::string up = "[0.3,0.3,0.5],[0.4,0.3,0.5],[0.4,0.4,0.5],[0.3,0.4,0.5]",
                    down = "[0.3,0.3,0.5],[0.3,0.4,0.5],[0.4,0.4,0.5],[0.4,0.3,0.5]";
  const auto plain = with(up, on("top")), backed = with(up, R"(, "back": "a")" + on("top"));
  EXPECT_EQ(plain, backed);
  EXPECT_NEAR(backed[0], 0.01, 1e-15);
  const auto inside = with(down, on("top:back"));
  EXPECT_EQ(inside[0], 0);
  EXPECT_NEAR(inside[1], plain[0] + plain[1], 1e-15);
  EXPECT_NEAR(with(down, R"(, "back": "a")" + on("top:back"))[1], plain[1], 1e-15);
}

// The back of a patch on a patch without one is that of the wall below.
TEST(Patches3, OnPatchesHaveBacksOfTheirOwn) {
  const Scene3 scene =
      scene_of(polygon("wall", "[0,0,0],[10,0,0],[10,1,0],[0,1,0]", R"(, "back": "a")") + "," +
               polygon("win", "[2,0,0],[8,0,0],[8,1,0],[2,1,0]", on("wall"), "b") + "," +
               polygon("pane", "[3,0,0],[5,0,0],[5,1,0],[3,1,0]", R"(, "back": "c")" + on("win"), "c"));
  const ExchangeMatrix matrix = factors(scene);
  for (const auto& [name, size] : {std::pair("wall", 4), {"wall:back", 8}, {"win", 4}, {"pane", 2}, {"pane:back", 2}})
    EXPECT_EQ(area(matrix, name), size) << name;
  Rational left;
  for (const Polygon3& part : beside_patches(PatchCarriers3(scene), {0, true})) left += doubled_area(part).z / 2;
  EXPECT_EQ(left, 8);
}

TEST(Patches3, ThatOverlapNeedOneMaterial) {
  const std::string other = "[0.5,0.5,0],[0.9,0.5,0],[0.9,0.9,0],[0.5,0.9,0]";
  EXPECT_THAT(refusal(kRoom + "," + mat() + "," + polygon("rug", other, on("floor"), "c")),
              HasSubstr("claim the same side with different materials"));
  EXPECT_EQ(refusal(kRoom + "," + mat() + "," + polygon("rug", other, on("floor"), "b")), "");
}

// A wall turned by some angle and typed to six digits: a strip across it, from border to border.
TEST(Patches3, AreProjectedWithinTheDigits) {
  const std::string wall = "[0,0,0],[2.598076,1.5,0],[2.598076,1.5,2.5],[0,0,2.5]";
  const std::string strip = "[0.866025,0.500001,0],[1.732051,1,0],[1.732051,1,2.5],[0.866025,0.500001,2.5]";
  const Scene3 scene = scene_of(polygon("wall", wall) + "," + polygon("strip", strip, on("wall"), "b"));
  const Vector3 normal = doubled_area(scene.polygons[0]);
  for (const Point3& p : scene.polygons[1].points) EXPECT_EQ(dot(normal, p - scene.polygons[0].points[0]), 0);
  EXPECT_TRUE(parse_scene_3(write_scene_3(scene), "scene.json")->polygons == scene.polygons);
}

TEST(Patches3, AreNotProjectedFromFarForTheirSize) {
  const std::string field = polygon("field", "[0,0,0],[40000,0,0],[40000,40000,0],[0,40000,0]");
  EXPECT_THAT(refusal(field + "," + polygon("p", "[5,5,3],[6,5,3],[6,6,3],[5,6,3]", on("field"), "b")),
              HasSubstr("is 3 off its plane"));
  EXPECT_EQ(refusal(field + "," + polygon("p", "[5,5,3],[306,5,3],[306,6,3],[5,6,3]", on("field"), "b")), "");
}

const std::string kBent = "[0,0,0],[1,0,0.000001],[1,1,0],[0,1,0.000003]";  // two triangles, from (0, 0) to (1, 1)

TEST(Patches3, LieOnBentBases) {
  const std::string inside = "[0.1,0.5,0],[0.3,0.5,0],[0.3,0.7,0],[0.1,0.7,0]";
  const Scene3 on_one = scene_of(polygon("floor", kBent) + "," + mat(on("floor"), inside));
  EXPECT_FALSE(on_one.polygons[1].is_nearly_plane);
  const Scene3 scene = scene_of(polygon("floor", kBent) + "," + mat(on("floor")));
  const Polygon3& across = scene.polygons[1];
  ASSERT_TRUE(across.is_nearly_plane);
  // Each facet of it lies on one of the floor, and their area, as seen from above, is that of the mat.
  Rational seen;
  for (const Polygon3& part : facets_of(across)) {
    const Polygon3 floor[]{{{{0, 0, 0}, {1, 0, Rational(1, 1000000)}, {1, 1, 0}}},
                           {{{0, 0, 0}, {1, 1, 0}, {0, 1, Rational(3, 1000000)}}}};
    EXPECT_TRUE(std::ranges::any_of(floor, [&](const Polygon3& facet) {
      return std::ranges::all_of(part.points, [&](const Point3& p) { return contains(facet, p); });
    }));
    seen += doubled_area(part).z / 2;
  }
  EXPECT_EQ(seen, Rational(1, 4));
  const ExchangeMatrix matrix = factors(scene);
  EXPECT_NEAR(area(matrix, "mat") + area(matrix, "floor"), 1, 1e-11);
  EXPECT_TRUE(parse_scene_3(write_scene_3(scene), "scene.json")->polygons == scene.polygons);
  EXPECT_THAT(
      refusal(polygon("floor", kBent) + "," + mat(on("floor"), "[0.5,0.5,0],[1.5,0.5,0],[1.5,0.75,0],[0.5,0.75,0]")),
      AllOf(HasSubstr("'mat' leaves 'floor'"), HasSubstr("around (")));
}

// On several bent pieces, from border to border, with a patch on it across the same bends; a ridge is no bend.
TEST(Patches3, LieAcrossBendsOfSeveral) {
  const std::string other = "[1,0,0.000001],[2,0,0],[2,1,0.000002],[1,1,0]";
  const std::string pieces =
      polygon("left", kBent, R"(, "group": "floor")") + "," + polygon("right", other, R"(, "group": "floor")");
  const Scene3 scene = scene_of(pieces + "," + mat(on("floor"), "[0.5,0,0],[1.5,0,0],[1.5,1,0],[0.5,1,0]") + "," +
                                polygon("rug", "[0.75,0.25,0],[1.25,0.25,0],[1.25,0.75,0],[0.75,0.75,0]", on("mat")));
  const ExchangeMatrix matrix = factors(scene);
  EXPECT_NEAR(area(matrix, "rug"), 0.25, 1e-11);
  EXPECT_NEAR(area(matrix, "mat"), 0.75, 1e-11);
  EXPECT_NEAR(area(matrix, "left"), 0.5, 1e-11);
  const std::string roof = polygon("west", "[0,0,0],[1,0,1],[1,1,1],[0,1,0]", R"(, "group": "roof")") + "," +
                           polygon("east", "[1,0,1],[2,0,0],[2,1,0],[1,1,1]", R"(, "group": "roof")");
  EXPECT_THAT(refusal(roof + "," + mat(on("roof"), "[0.5,0,0.5],[1.5,0,0.5],[1.5,1,0.5],[0.5,1,0.5]")),
              HasSubstr("'mat' does not lie on 'roof'"));
}

// What a face exchanges with a bent wall it exchanges with what is left of that and the patch across its bend.
TEST(Patches3, AcrossBendsExchangeWhatWasTheBases) {
  const std::string lamp = polygon("lamp", "[0.2,0.2,1],[0.2,0.8,1],[0.8,0.8,1],[0.8,0.2,1]");
  const ExchangeMatrix bare = factors(scene_of(polygon("floor", kBent) + "," + lamp));
  const ExchangeMatrix patched = factors(scene_of(polygon("floor", kBent) + "," + lamp + "," + mat(on("floor"))));
  const auto exchange = [](const ExchangeMatrix& matrix, const std::string& to) {
    return matrix.factor("lamp", to).value;
  };
  EXPECT_NEAR(exchange(patched, "floor") + exchange(patched, "mat"), exchange(bare, "floor"), 1e-12);
}

TEST(Patches3, StayInRepairs) {
  const Scene3 scene = scene_of(polygon("floor", "[0,0,0],[1,0,0],[1,1,0],[0,1,0]") + "," +
                                polygon("wall", "[0,0,0.001],[0,1,0.001],[0,1,1],[0,0,1]") + "," + mat());
  const Repair3 repair = close_gaps(scene, Rational(1, 100));
  EXPECT_TRUE(repair.scene.polygons[0] == scene.polygons[0] && repair.scene.polygons[2] == scene.polygons[2]);
  EXPECT_EQ(repair.scene.polygons[1].points[0], (Point3{0, 0, 0}));
}

TEST(Patches3, LeaveConvexPartsOfTheirBases) {
  const Scene3 scene = scene_of(kRoom + "," + mat());
  const PatchCarriers3 carriers(scene);
  Rational left;
  for (const Polygon3& part : beside_patches(carriers, {0, false})) {
    EXPECT_TRUE(is_convex(part));
    left += doubled_area(part).z / 2;
  }
  EXPECT_EQ(left, Rational(3, 4));
  EXPECT_TRUE(beside_patches(carriers, {0, true}) == std::vector{scene.polygons[0]});
}

}  // namespace
}  // namespace hottel::patches_3_test
