#include "solver/space/check/scene_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "kernel/support/failure.h"
#include "solver/space/simulation/simulation.h"
#include "tests/geometry/space/check/small_scene.h"

namespace hottel::scene_check_test {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing_space::add;
using testing_space::add_box;
using testing_space::empty_scene;
using testing_space::q;
using testing_space::told;
using testing_space::unit_room;

const Rational kGap = Rational(1) / 1000000;

SceneCheck3 checked(const Scene3& scene) {
  const Simulation3 simulation(scene);
  return check_scene(scene, {.prepared = [&] { return simulation.prepared(); },
                             .factors = [&]() -> std::shared_ptr<const ExchangeMatrix> {
                               const auto computed = simulation.factors();
                               return {computed, &computed->matrix};
                             }});
}

std::vector<std::string> told_of(const Scene3& scene) { return told(scene, checked(scene).findings); }

Scene3 closed_room() {
  Scene3 scene = unit_room();
  scene.closed = true;
  return scene;
}

TEST(SceneCheck3, ACleanRoomHasNoFindings) {
  EXPECT_THAT(told_of(closed_room()), IsEmpty());
  Scene3 scene = closed_room();
  add_box(scene, "box", {q("1/4"), q("1/4"), q("1/4")}, {q("3/4"), q("3/4"), q("3/4")}, false);
  EXPECT_THAT(told_of(scene), IsEmpty()) << "a box that floats";
  EXPECT_NE(checked(scene).factors, nullptr);
}

TEST(SceneCheck3, APromiseThatIsBrokenIsAnError) {
  Scene3 scene = closed_room();
  scene.polygons[1].points = {{0, 0, 1}, {0, 1, 1}, {1 - kGap, 1, 1}, {1 - kGap, 0, 1}};
  const SceneCheck3 check = checked(scene);
  EXPECT_TRUE(has_error(check.findings));
  ASSERT_FALSE(check.findings.empty());
  EXPECT_EQ(check.findings[0].kind, "not-closed");
  EXPECT_EQ(check.findings[0].at, (Point3{1 - kGap, q("1/2"), 1})) << "where an edge lies on nothing";
  scene.closed = false;
  EXPECT_THAT(told_of(scene), Contains("note opening bottom front rear left right"));
}

// What hangs free has edges that lie on nothing, and is not where the room is open.
TEST(SceneCheck3, APlateThatHangsFreeIsNotBlamedForAFloorUpsideDown) {
  Scene3 scene = closed_room();
  std::ranges::reverse(scene.polygons[0].points);
  scene.add(
      scene.surfaces[0],
      {.points = {{q("1/4"), q("1/4"), q("3/4")}, {q("1/4"), q("1/2"), q("3/4")}, {q("1/2"), q("1/2"), q("3/4")}}});
  scene.surfaces.back().name = "plate";
  scene.surfaces.back().group = static_cast<std::uint32_t>(scene.groups.size());
  scene.groups.push_back({"plate"});
  const SceneCheck3 check = checked(scene);
  ASSERT_FALSE(check.findings.empty());
  EXPECT_EQ(check.findings[0].kind, "not-closed");
  ASSERT_TRUE(check.findings[0].at);
  EXPECT_EQ(check.findings[0].at->z, 0);
  EXPECT_EQ(check.findings[0].message.find("plate"), std::string::npos) << check.findings[0].message;
}

TEST(SceneCheck3, AnOpenSceneThatPromisesNothingIsFine) {
  Scene3 scene = unit_room();
  scene.surfaces.pop_back();
  scene.polygons.pop_back();
  scene.groups.pop_back();
  EXPECT_THAT(told_of(scene), IsEmpty());
}

TEST(SceneCheck3, BlackBacksAreToldOnceABack) {
  Scene3 scene = closed_room();
  add(scene, "screen",
      {{q("1/4"), q("1/2"), q("1/4")}, {q("3/4"), q("1/2"), q("1/4")}, {q("1/2"), q("1/2"), q("3/4")}});
  const SceneCheck3 check = checked(scene);
  ASSERT_THAT(told(scene, check.findings), ElementsAre("warning black-back screen"));
  EXPECT_THAT(check.findings[0].message, HasSubstr("'rear' loses F = "));
  scene.surfaces.back().back = 0;
  EXPECT_THAT(told_of(scene), IsEmpty());
}

TEST(SceneCheck3, AClosedMeshWithDarkFrontsInsideIsInsideOut) {
  Scene3 scene = closed_room();
  add_box(scene, "box", {q("1/4"), q("1/4"), q("1/4")}, {q("3/4"), q("3/4"), q("3/4")}, true);
  EXPECT_THAT(told_of(scene),
              ElementsAre("warning inside-out box.bottom box.top box.front box.rear box.left box.right"));
  scene.surfaces.back().material = 1;  // a lamp shines there: a room
  EXPECT_THAT(told_of(scene), Contains(HasSubstr("warning black-back box.bottom")));
  EXPECT_THAT(told_of(scene), Contains(HasSubstr("warning inside-out box.bottom")));
}

TEST(SceneCheck3, AnEmptyDarkRoomIsAskedAbout) {
  Scene3 scene = empty_scene();
  scene.materials.pop_back();
  add_box(scene, "hall", {0, 0, 0}, {1, 1, 1}, true);
  EXPECT_THAT(told_of(scene), ElementsAre("note inside-out hall.bottom hall.top hall.front hall.rear hall.left "
                                          "hall.right",
                                          "note no-light"));
}

TEST(SceneCheck3, ASolidThatHoldsOthersIsAskedAbout) {
  Scene3 scene = empty_scene();
  add_box(scene, "hall", {0, 0, 0}, {4, 4, 4}, false);
  add_box(scene, "box", {1, 1, 1}, {2, 2, 2}, false);
  scene.surfaces.back().material = 1;
  const SceneCheck3 check = checked(scene);
  ASSERT_FALSE(check.findings.empty());
  EXPECT_EQ(check.findings[0].kind, "filled-room");
  EXPECT_THAT(check.findings[0].message,
              HasSubstr("'hall' is solid, and 'box' is in its interior, where nothing is seen; the light of 'box' is "
                        "lost: was a room meant?"));
  for (const Finding3& finding : check.findings) EXPECT_NE(finding.kind, "covered");
}

TEST(SceneCheck3, WhatABoxStandsOnWhollyIsCovered) {
  Scene3 scene = closed_room();
  add_box(scene, "box", {q("1/4"), q("1/4"), 0}, {q("3/4"), q("3/4"), q("1/2")}, false);
  EXPECT_THAT(told_of(scene), ElementsAre("note covered box.bottom"));
  scene.surfaces[6].material = 1;
  EXPECT_THAT(told_of(scene), ElementsAre("warning covered box.bottom"));
  // Not where what it stands on is as warm.
  set_gray_body(Spectrum::scalar(Rational(9, 10)), Spectrum::scalar(300), scene.materials[0]);
  for (const auto& [temperature, told_as] : {std::pair(300, "note"), {310, "warning"}}) {
    set_gray_body(Spectrum::scalar(Rational(1, 2)), Spectrum::scalar(temperature), scene.materials[1]);
    EXPECT_THAT(told_of(scene), ElementsAre(told_as + std::string(" covered box.bottom")));
  }
}

TEST(SceneCheck3, ASolidInFreeSpaceSeesOnlyTheSky) {
  Scene3 scene = empty_scene();
  add_box(scene, "box", {0, 0, 0}, {1, 1, 1}, false);
  scene.surfaces[0].material = 1;
  EXPECT_THAT(told_of(scene),
              ElementsAre("note sees-only-sky box.bottom box.top box.front box.rear box.left box.right"));
}

TEST(SceneCheck3, ClaimsThatConflictAreAnError) {
  Scene3 scene = closed_room();
  Surface& carpet = add(scene, "carpet", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  carpet.material = 1;
  const SceneCheck3 check = checked(scene);
  EXPECT_TRUE(has_error(check.findings));
  EXPECT_THAT(told(scene, check.findings), Contains("error conflicting-claims carpet"));
  EXPECT_THAT(told(scene, check.findings), Contains("note light-not-checked"));
  EXPECT_EQ(check.factors, nullptr);
}

TEST(SceneCheck3, WhatCannotBeComputedIsNotCheckedAndThatIsSaid) {
  const Scene3 scene = closed_room();
  const SceneCheck3 check = check_scene(scene, {.prepared = [&] { return Simulation3(scene).prepared(); },
                                                .factors = []() -> std::shared_ptr<const ExchangeMatrix> {
                                                  throw RequestError("memory does not suffice");
                                                }});
  EXPECT_THAT(told(scene, check.findings), ElementsAre("note light-not-checked"));
  EXPECT_FALSE(has_error(check.findings));
}

// A box of mirrors that shine into it, closed and with fronts inward.
Scene3 room_of_mirrors() {
  Scene3 scene = closed_room();
  for (Material& material : scene.materials) material.reflectivity = Spectrum::scalar(1);
  return scene;
}

// The kinds of the errors, and whether solve refuses the scene too.
std::vector<std::string> errors_of(const Scene3& scene) {
  const SceneCheck3 check = checked(scene);
  Findings3 errors;
  for (const Finding3& finding : check.findings)
    if (finding.severity == Severity::kError) errors.push_back(finding);
  bool is_refused = false;
  try {
    (void)Simulation3(scene).radiosities();
  } catch (const RequestError&) {
    is_refused = true;
  }
  EXPECT_EQ(is_refused, !errors.empty());
  return told(scene, errors);
}

TEST(SceneCheck3, ARoomOfMirrorsHasNoSolutionWhenItEmits) {
  Scene3 scene = room_of_mirrors();
  EXPECT_THAT(errors_of(scene), ElementsAre("error no-solution bottom top front rear left right"));
  EXPECT_EQ(checked(scene).findings[0].at, (Point3{q("1/2"), q("1/2"), 0}));
  scene.materials[1].emission = {};
  EXPECT_THAT(errors_of(scene), IsEmpty()) << "without a lamp radiosity is 0, the limit";
  scene = room_of_mirrors();
  scene.materials[1].reflectivity = Spectrum::scalar(q("1/2"));
  EXPECT_THAT(errors_of(scene), IsEmpty()) << "the lamp absorbs";
  scene = room_of_mirrors();
  scene.closed = false;
  scene.surfaces.pop_back();
  scene.polygons.pop_back();
  scene.groups.pop_back();
  EXPECT_THAT(errors_of(scene), IsEmpty()) << "a way to the sky";
}

// Factors of furnished rooms are estimates, and what their rows lack of 1 is no way out.
TEST(SceneCheck3, AFurnishedRoomOfMirrorsHasNoSolutionEither) {
  Scene3 scene = room_of_mirrors();
  add(scene, "plate", {{q("1/4"), q("1/4"), q("1/2")}, {q("3/4"), q("1/4"), q("1/2")}, {q("1/2"), q("3/4"), q("1/2")}});
  scene.surfaces.back().material = scene.surfaces.front().material;
  scene.surfaces.back().back = scene.surfaces.front().material;
  EXPECT_EQ(Simulation3(scene).factors()->matrix.guarantee(), Guarantee::kEstimated);
  EXPECT_THAT(errors_of(scene), ElementsAre(HasSubstr("error no-solution ")));
  EXPECT_THROW(Simulation3(scene).radiosities(), RequestError);
  scene.materials[1].emission = {};
  EXPECT_THAT(errors_of(scene), IsEmpty());
  const auto dark = Simulation3(scene).radiosities();
  for (const ElementRadiosity& element : dark->channels[0].elements) EXPECT_EQ(element.radiosity, 0);
}

TEST(SceneCheck3, OfTwoRoomsTheOneWithoutASolutionIsNamed) {
  Scene3 scene = closed_room();
  add_box(scene, "far", {5, 0, 0}, {6, 1, 1}, true);
  scene.materials.push_back({"mirror", Spectrum::scalar(1), Spectrum::scalar(q("1e-300"))});
  for (std::size_t s = 6; s < scene.surfaces.size(); ++s) scene.surfaces[s].material = 2;
  EXPECT_THAT(errors_of(scene),
              ElementsAre("error no-solution far.bottom far.top far.front far.rear far.left far.right"));
}

TEST(SceneCheck3, WhatDoublesCannotTellIsAnError) {
  for (const char* scale : {"1e-400", "1e-200", "1e-150", "1", "1e150", "1e200", "1e400"})
    for (const char* emission : {"1e-300", "1", "1e300", "1e400"})
      for (const char* loss : {"1e-400", "1e-200", "1/2", "1"}) {
        Scene3 scene = closed_room();
        for (Polygon3& polygon : scene.polygons)
          for (Point3& p : polygon.points) p = {p.x * q(scale), p.y * q(scale), p.z * q(scale)};
        scene.materials[0].reflectivity = Spectrum::scalar(1 - q(loss));
        scene.materials[1].reflectivity = Spectrum::scalar(1 - q(loss));
        scene.materials[1].emission = Spectrum::scalar(q(emission));
        SCOPED_TRACE(std::string("scale ") + scale + ", emission " + emission + ", loss " + loss);
        for (const std::string& error : errors_of(scene)) EXPECT_THAT(error, HasSubstr("error beyond-doubles"));
      }
  Scene3 scene = closed_room();
  scene.sky_emission = Spectrum::scalar(q("1e400"));
  EXPECT_THAT(errors_of(scene), ElementsAre("error beyond-doubles"));
  scene = closed_room();
  scene.materials[1].emission = Spectrum::scalar(q("1e400"));
  EXPECT_THAT(errors_of(scene), ElementsAre("error beyond-doubles top"));
  EXPECT_THAT(checked(scene).findings[0].message, HasSubstr("the emission of 'top' is beyond the range of doubles"));
}

TEST(SceneCheck3, OfManyFacesSomeAreLookedFromAndThatIsSaid) {
  Scene3 scene = closed_room();
  for (int k = 0; k < 40; ++k) {
    const Rational x = Rational(k % 8 + 1) / 10, y = Rational(k / 8 + 1) / 10, z = q("1/2"), w = q("1/20");
    add_box(scene, "box" + std::to_string(k), {x, y, z}, {x + w, y + w, z + w}, false);
  }
  const SceneCheck3 closed = checked(scene);
  EXPECT_THAT(told(scene, closed.findings), ElementsAre("note light-not-checked"));
  EXPECT_EQ(closed.factors, nullptr);
  scene.materials[1].emission = Spectrum::scalar(q("1e400"));
  EXPECT_THAT(told_of(scene), ElementsAre("error beyond-doubles top", "note light-not-checked"));
  scene.polygons[1].points.pop_back();  // half of the ceiling is left
  const SceneCheck3 open = checked(scene);
  ASSERT_TRUE(has_error(open.findings));
  EXPECT_EQ(open.findings[0].kind, "not-closed");
}

TEST(SceneCheck3, MaterialsWithoutSurfacesAreNoted) {
  Scene3 scene = closed_room();
  scene.materials.push_back({"spare", {}, {}});
  EXPECT_THAT(told_of(scene), ElementsAre("note unused-material"));
}

}  // namespace
}  // namespace hottel::scene_check_test
