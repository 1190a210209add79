// Polygons moved, turned, copied, added and taken out.
#include "viewer/edit/space/scene_edits.h"

#include <gtest/gtest.h>

#include "geometry/space/arrangement/solids.h"
#include "kernel/support/failure.h"
#include "tests/viewer/edit/space/edited_scenes.h"

namespace hottel::scene_edits_test {
namespace {

using testing_edits::furnished;

std::uint32_t called(const Scene3& scene, const std::string& name) { return scene.find(name).value(); }

std::vector<std::uint32_t> of_group(const Scene3& scene, const std::string& name) {
  std::vector<std::uint32_t> all;
  for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s)
    if (scene.groups[scene.surfaces[s].group].name == name) all.push_back(s);
  return all;
}

const Polygon3& polygon(const Scene3& scene, const std::string& name) { return scene.polygons[called(scene, name)]; }

// What is saved is what is seen.
void expect_to_be_read_as_it_is(const Scene3& scene) {
  const Scene3 read = parse_scene_3(write_scene_3(scene), scene.file);
  EXPECT_EQ(read.polygons, scene.polygons);
  EXPECT_EQ(read.groups, scene.groups);
  EXPECT_EQ(read.bases, scene.bases);
  ASSERT_EQ(read.surfaces.size(), scene.surfaces.size());
  for (std::size_t s = 0; s < read.surfaces.size(); ++s) {
    EXPECT_EQ(read.surfaces[s].name, scene.surfaces[s].name);
    EXPECT_EQ(read.surfaces[s].group, scene.surfaces[s].group);
    EXPECT_EQ(read.surfaces[s].on, scene.surfaces[s].on);
  }
}

TEST(MoveCorners, StretchesWhatMeetsThem) {
  const Scene3 scene = furnished();
  const Corners3 top{polygon(scene, "box.top").points, {}};
  const Scene3 moved = move_corners(scene, top, {0, 0, Rational(1, 2)});
  EXPECT_EQ(edit_problem(scene, moved), "");
  EXPECT_EQ(polygon(moved, "box.a").points[2], (Point3{2, 1, Rational(3, 2)}));
  EXPECT_EQ(polygon(moved, "box.bottom"), polygon(scene, "box.bottom"));
  EXPECT_FALSE(Solids3(moved).is_empty());
  expect_to_be_read_as_it_is(moved);
}

// (5)
TEST(MoveCorners, TakesPatchesAlong) {
  const Scene3 scene = furnished();
  const Scene3 moved = move_corners(scene, {polygon(scene, "rear").points, {}}, {0, Rational(1, 2), 0});
  EXPECT_EQ(edit_problem(scene, moved), "");
  EXPECT_EQ(polygon(moved, "window").points[0].y, Rational(9, 2));
  EXPECT_EQ(polygon(moved, "picture").points[0].y, Rational(9, 2));
  EXPECT_EQ(polygon(moved, "floor").points[2].y, Rational(9, 2));
}

TEST(PlanesToKeep, LeaveFacesOfBoxesFreeAndHoldCorners) {
  const Scene3 scene = furnished();
  EXPECT_TRUE(planes_to_keep(scene, {polygon(scene, "box.top").points, {}}).empty());
  EXPECT_EQ(planes_to_keep(scene, {{Point3{1, 1, 1}}, {}}).size(), 3u);
  EXPECT_TRUE(planes_to_keep(scene, {{Point3{Rational(16, 5), Rational(16, 5), 1}}, {}}).empty()) << "of triangles";
  EXPECT_EQ(planes_to_keep(scene, {{}, {called(scene, "window")}}).size(), 1u) << "it slides";
  EXPECT_TRUE(planes_to_keep(scene, {{}, of_group(scene, "box")}).empty());
  EXPECT_EQ(planes_to_keep(scene, {{Point3{Rational(4, 5), 3, Rational(4, 5)}}, {}}).size(), 1u) << "of a hole";
}

// All ways along the planes are ways that keep everything plane.
TEST(PlanesToKeep, AreEnough) {
  const Scene3 scene = furnished();
  for (const Polygon3& of : scene.polygons)
    for (const Point3& corner : corners_of(of)) {
      const auto normals = planes_to_keep(scene, {{corner}, {}});
      Vector3 way{Rational(1, 100), Rational(1, 90), Rational(1, 80)};
      if (normals.size() > 1) continue;
      if (normals.size() == 1) way = cross(normals[0], way);
      const std::string problem = edit_problem(scene, move_corners(scene, {{corner}, {}}, way));
      EXPECT_EQ(problem.find("plane"), std::string::npos) << problem;
    }
}

TEST(MoveCorner, MovesOneAlone) {
  const Scene3 scene = furnished();
  const std::uint32_t s = called(scene, "tent[0]");
  const Scene3 moved = move_corner(scene, s, scene.polygons[s].points[2], {0, 0, 1});
  EXPECT_EQ(moved.polygons[s].points[2].z, 2);
  EXPECT_EQ(polygon(moved, "tent[1]"), polygon(scene, "tent[1]"));
}

// (6) and (7)
TEST(RotateSurfaces, TurnsSquarelyExactlyAndElseStaysPlane) {
  const Scene3 scene = furnished();
  const auto box = of_group(scene, "box");
  const Point3 middle{Rational(3, 2), Rational(3, 2), Rational(1, 2)};
  Scene3 turned = scene;
  for (int k = 0; k < 4; ++k) turned = rotate_surfaces(turned, box, middle, k < 2 ? 2 : 0, k % 2 == 0 ? 90 : -90, 3);
  EXPECT_EQ(turned.polygons, scene.polygons);
  const Scene3 round = rotate_surfaces(scene, box, middle, 2, 15, 3);
  EXPECT_EQ(edit_problem(scene, round), "");
  for (const std::uint32_t s : box)
    for (const Point3& p : round.polygons[s].points) EXPECT_LE(p.x.get_den(), 1000);
  const Scene3 tilted = rotate_surfaces(round, box, {Rational(7, 5), Rational(13, 10), 0}, 0, 20, 3);
  EXPECT_EQ(edit_problem(round, tilted), "") << "rounding would bend it";
  EXPECT_FALSE(Solids3(tilted).is_empty());
  const Vector3 side = tilted.polygons[box[1]].points[1] - tilted.polygons[box[1]].points[0];
  const Vector3 before = round.polygons[box[1]].points[1] - round.polygons[box[1]].points[0];
  EXPECT_EQ(dot(side, side), dot(before, before)) << "turned exactly";
  expect_to_be_read_as_it_is(tilted);
}

TEST(ReverseSurfaces, TwiceIsNothing) {
  const Scene3 scene = furnished();
  const std::vector<std::uint32_t> frame{called(scene, "frame"), called(scene, "tent[0]")};
  const Scene3 once = reverse_surfaces(scene, frame);
  const Vector3 a = doubled_area(once.polygons[frame[0]]), b = doubled_area(scene.polygons[frame[0]]);
  EXPECT_EQ((Vector3{Rational(-a.x), Rational(-a.y), Rational(-a.z)}), b);
  EXPECT_EQ(reverse_surfaces(once, frame).polygons, scene.polygons);
}

TEST(EraseSurfaces, TakesPatchesAndEmptyGroupsAlong) {
  const Scene3 scene = furnished();
  const Scene3 erased = erase_surfaces(scene, std::vector{called(scene, "rear")});
  EXPECT_FALSE(erased.find("window") || erased.find("picture") || erased.find("rear"));
  EXPECT_EQ(erased.surfaces.size(), scene.surfaces.size() - 3);
  EXPECT_EQ(edit_problem(scene, erased), "");
  expect_to_be_read_as_it_is(erased);
  expect_to_be_read_as_it_is(erase_surfaces(scene, of_group(scene, "box")));
}

TEST(DuplicateSurfaces, CopiesGroupsAsGroupsAndPatchesOntoTheirCopies) {
  const Scene3 scene = furnished();
  auto which = of_group(scene, "box");
  which.push_back(called(scene, "rear"));
  which.push_back(called(scene, "tent[1]"));
  const AddedSurfaces3 added = duplicate_surfaces(scene, which, {Rational(1, 4), Rational(1, 4), 0});
  EXPECT_EQ(added.surfaces.size(), 10u) << "six faces, the wall and what lies on it, a triangle";
  EXPECT_EQ(edit_problem(scene, added.scene), "");
  EXPECT_EQ(of_group(added.scene, "box copy").size(), 6u);
  EXPECT_TRUE(added.scene.find("tent[1] copy"));
  const Surface& copy = added.scene.surfaces[called(added.scene, "window copy")];
  EXPECT_EQ(added.scene.bases[*copy.on].name, "rear copy");
  const Surface& picture = added.scene.surfaces[called(added.scene, "picture copy")];
  EXPECT_EQ(added.scene.bases[*picture.on].name, "window copy");
  EXPECT_EQ(Solids3(added.scene).meshes().size(), Solids3(scene).meshes().size() + 1);
  expect_to_be_read_as_it_is(added.scene);
}

TEST(DuplicateSurfaces, NamesPiecesOfGroupsByTheGroup) {
  const Scene3 scene = furnished();
  const AddedSurfaces3 added = duplicate_surfaces(scene, of_group(scene, "tent"), {0, 0, 1});
  EXPECT_TRUE(added.scene.find("tent copy[0]") && added.scene.find("tent copy[1]"));
}

TEST(AddBox, IsASolidWithItsFrontsOutward) {
  const Scene3 scene = furnished();
  const AddedSurfaces3 added = add_box(scene, {3, 1, 0}, {Rational(7, 2), 2, Rational(1, 2)}, 1);
  EXPECT_EQ(edit_problem(scene, added.scene), "");
  EXPECT_EQ(added.surfaces.size(), 6u);
  EXPECT_TRUE(added.scene.find("box 1.top"));
  EXPECT_TRUE(Solids3(added.scene).around({Rational(13, 4), Rational(3, 2), Rational(1, 4)}));
  expect_to_be_read_as_it_is(added.scene);
}

TEST(AddRectangle, LooksWhereItIsToldAndIsAPatchWhereItLies) {
  const Scene3 scene = furnished();
  const AddedSurfaces3 free = add_rectangle(scene, {3, 1, 2}, {Rational(7, 2), 2, 2}, false, 2);
  EXPECT_GT(doubled_area(polygon(free.scene, "rectangle 1")).z, 0);
  EXPECT_FALSE(free.scene.surfaces.back().on);
  const AddedSurfaces3 back = add_rectangle(scene, {3, 1, 2}, {Rational(7, 2), 2, 2}, true, 2);
  EXPECT_LT(doubled_area(polygon(back.scene, "rectangle 1")).z, 0);
  const AddedSurfaces3 patch = add_rectangle(scene, {1, 1, 3}, {2, 2, 3}, true, 2);
  EXPECT_EQ(edit_problem(scene, patch.scene), "");
  EXPECT_EQ(patch.scene.bases[*patch.scene.surfaces.back().on].name, "ceiling");
  expect_to_be_read_as_it_is(patch.scene);
}

TEST(EditProblem, SaysWhatIsWrong) {
  const Scene3 scene = furnished();
  const Scene3 bent = move_corners(scene, {{Point3{1, 1, 1}}, {}}, {0, 0, 1});
  EXPECT_NE(edit_problem(scene, bent).find("plane"), std::string::npos) << edit_problem(scene, bent);
  const Scene3 flat = move_corners(scene, {polygon(scene, "box.top").points, {}}, {0, 0, -1});
  EXPECT_NE(edit_problem(scene, flat), "") << "sides of height zero";
  const Scene3 beside = move_corners(scene, {{}, {called(scene, "window")}}, {2, 0, 0});
  EXPECT_NE(edit_problem(scene, beside).find("window"), std::string::npos);
  const Scene3 at_bulb = move_corners(scene, {{}, {called(scene, "ceiling")}}, {0, 0, Rational(-1, 2)});
  EXPECT_NE(edit_problem(scene, at_bulb).find("bulb"), std::string::npos);
}

}  // namespace
}  // namespace hottel::scene_edits_test
