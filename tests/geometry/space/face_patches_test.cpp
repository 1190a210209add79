// What a face, or a part of it, is made of where others overlap it or a solid covers it.
#include "geometry/space/prepared/face_patches.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "geometry/space/exchange/exchange.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "tests/geometry/space/box_scene.h"

namespace hottel::face_patches_test {
namespace {

using ::testing::ElementsAre;

struct Faces {
  Arrangement3 arrangement;
  Occluders3 occluders;

  explicit Faces(const Scene3& scene) : arrangement(scene), occluders(arrangement.polygons()) {}

  FacePatches3 of(const Face& face, const std::vector<Point3>* part = nullptr) const {
    return face_patches(arrangement, occluders, face, part);
  }
  // The area of each patch, positive where its front looks up; of patches parallel to the floor.
  std::vector<Rational> areas(const std::vector<SidePatch3>& patches) const {
    std::vector<Rational> result;
    for (const SidePatch3& p : patches)
      result.push_back(doubled_area({corners_of(occluders.vertices(), p.patch), {}}).z / 2);
    return result;
  }
};

TEST(FacePatches3, OfAConvexFaceIsOnePatchToEachSide) {
  BoxScene3 scene;
  scene.polygon("a", level(0, 0, 2, 1, 0), 0, 1);
  const Faces faces(scene);
  EXPECT_THAT(faces.areas(faces.of({0, false}).patches), ElementsAre(2));
  const FacePatches3 back = faces.of({0, true});
  EXPECT_THAT(faces.areas(back.patches), ElementsAre(-2));
  EXPECT_TRUE(back.is_free);
  EXPECT_TRUE(back.free.empty());
  EXPECT_EQ(&back.uncovered(), &back.patches);
  EXPECT_TRUE(back.patches[0].is_back);
  // The first corner of a back is that of its front.
  EXPECT_EQ(corners_of(faces.occluders.vertices(), back.patches[0].patch)[0], scene.polygons[0].points[0]);
}

TEST(FacePatches3, OfAFaceThatLosesAPartAreTheRest) {
  BoxScene3 scene;
  scene.polygon("a", level(0, 0, 2, 2, 0));
  scene.polygon("b", level(1, 1, 3, 2, 0));
  const Faces faces(scene);
  EXPECT_THAT(faces.areas(faces.of({0, false}).patches), ElementsAre(4));
  EXPECT_THAT(faces.areas(faces.of({1, false}).patches), ElementsAre(1));
  EXPECT_TRUE(faces.of({1, false}).is_free);
}

TEST(FacePatches3, StayWholeWhereASolidCoversSomeOfThem) {
  BoxScene3 scene;
  scene.polygon("floor", level(0, 0, 4, 4, 0));
  scene.box("box", {1, 1, 0}, {2, 2, 1});
  const Faces faces(scene);
  const FacePatches3 floor = faces.of({0, false});
  EXPECT_FALSE(floor.is_free);
  EXPECT_THAT(faces.areas(floor.patches), ElementsAre(16));
  Rational free;
  for (const Rational& area : faces.areas(floor.uncovered())) {
    EXPECT_GT(area, 0);
    free += area;
  }
  EXPECT_EQ(free, 15);
  for (const SidePatch3& p : floor.free) EXPECT_EQ(p.patch.surface, floor.patches[0].patch.surface);
}

TEST(FacePatches3, OfAFaceThatIsCoveredWhollyAreNone) {
  BoxScene3 scene;
  scene.polygon("floor", level(0, 0, 4, 4, 0));
  const std::uint32_t bottom = scene.box("box", {1, 1, 0}, {2, 2, 1});
  const Faces faces(scene);
  EXPECT_TRUE(faces.of({bottom, false}).uncovered().empty());
  EXPECT_TRUE(faces.of({bottom + kTop, true}).uncovered().empty());
}

TEST(FacePatches3, OfAPartAreWhatItHasOfEachPiece) {
  BoxScene3 scene;
  scene.polygon("floor", level(0, 0, 4, 4, 0));
  scene.box("box", {1, 1, 0}, {2, 2, 1});
  const Faces faces(scene);
  const auto free_of = [&](const Polygon3& part) { return faces.of({0, false}, &part.points); };
  const FacePatches3 quarter = free_of(level(0, 0, 2, 2, 0));
  EXPECT_FALSE(quarter.is_free);
  EXPECT_THAT(faces.areas(quarter.patches), ElementsAre(4));
  Rational free;
  for (const Rational& area : faces.areas(quarter.free)) free += area;
  EXPECT_EQ(free, 3);
  // Beside what is covered a part is whole, and within it it is not there.
  const FacePatches3 beside = free_of(level(2, 0, 4, 4, 0));
  EXPECT_TRUE(beside.is_free);
  EXPECT_THAT(faces.areas(beside.patches), ElementsAre(8));
  EXPECT_TRUE(free_of(level(1, 1, 2, 2, 0)).uncovered().empty());
}

TEST(FacePatches3, LookToTheSideOfTheFaceWhereThePieceIsOfAnotherSurface) {
  // A thin wall as a -> b and b -> a: the piece is the first one's.
  BoxScene3 scene;
  scene.polygon("up", level(0, 0, 2, 2, 0), 0);
  scene.polygon("down", turned(level(0, 0, 2, 2, 0)), 1);
  const Faces faces(scene);
  EXPECT_THAT(faces.areas(faces.of({1, false}).patches), ElementsAre(-4));
  const Polygon3 part = turned(level(0, 0, 1, 1, 0));
  EXPECT_THAT(faces.areas(faces.of({1, false}, &part.points).patches), ElementsAre(-1));
}

TEST(FacePatches3, ElementsOfBothSidesOfAThinWallSumToItsFaces) {
  BoxScene3 scene;
  scene.polygon("up", level(0, 0, 2, 2, 0), 0);
  scene.polygon("down", turned(level(0, 0, 2, 2, 0)), 1);
  scene.polygon("ground", level(0, 0, 2, 2, -1), 0);
  const double whole = exact_exchange(prepare(scene), {.tolerance = 1e-12}).factor("ground", "down").value;
  scene.surfaces[1].elements = 2;
  const ExchangeMatrix matrix =
      exact_exchange(prepare(scene), {.granularity = Granularity::kElement, .tolerance = 1e-12});
  double sum = 0;
  for (int k = 0; k < 4; ++k) sum += matrix.factor("ground", "down#" + std::to_string(k)).value;
  EXPECT_NEAR(sum, whole, 1e-12);
  EXPECT_GT(whole, 0.1);
}

TEST(PatchOf, KeepsCornersExactly) {
  BoxScene3 scene;
  scene.polygon("a", level(0, 0, 3, 3, 0));
  const Faces faces(scene);
  const std::vector<Point3> corners{{Rational(1, 3), Rational(1, 7), 0}, {2, Rational(1, 5), 0}, {1, 2, 0}};
  EXPECT_EQ(corners_of(faces.occluders.vertices(), patch_of(faces.occluders, 0, corners, false)), corners);
  const auto turned_round = corners_of(faces.occluders.vertices(), patch_of(faces.occluders, 0, corners, true));
  EXPECT_THAT(turned_round, ElementsAre(corners[0], corners[2], corners[1]));
}

}  // namespace
}  // namespace hottel::face_patches_test
