#include "geometry/space/contacts/near_contacts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/space/check/contact_findings.h"
#include "geometry/space/scene/near_plane.h"
#include "tests/geometry/space/check/small_scene.h"

namespace hottel::near_contacts_test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing_space::add;
using testing_space::add_box;
using testing_space::empty_scene;
using testing_space::q;
using testing_space::told;
using testing_space::unit_room;
using Kind = NearContact3::Kind;

const Rational kGap = Rational(1) / 1000000;

void add_floor(Scene3& scene) { add(scene, "floor", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}); }

Findings3 found(const Scene3& scene) { return contact_findings(scene, find_contacts(scene)); }

TEST(NearContacts3, NoneInACleanRoom) {
  Scene3 scene = unit_room();
  EXPECT_THAT(told(scene, found(scene)), IsEmpty());
  add_box(scene, "box", {q("1/4"), q("1/4"), 0}, {q("3/4"), q("3/4"), q("1/2")}, false);
  EXPECT_THAT(told(scene, found(scene)), IsEmpty()) << "a box on the floor";
}

TEST(NearContacts3, ACornerOverAFace) {
  Scene3 scene = empty_scene();
  add_floor(scene);
  add(scene, "tip", {{q("1/2"), q("1/2"), kGap}, {1, 0, 1}, {0, 1, 1}});
  const Contacts3 contacts = find_contacts(scene);
  ASSERT_EQ(contacts.near.size(), 1u);
  const NearContact3& contact = contacts.near[0];
  EXPECT_EQ(contact.kind, Kind::kCornerFace);
  EXPECT_THAT(contact.surfaces, ElementsAre(1u));
  EXPECT_THAT(contact.targets, ElementsAre(0u));
  EXPECT_EQ(contact.to, (Point3{q("1/2"), q("1/2"), 0}));
  EXPECT_EQ(contact.squared, kGap * kGap);
  EXPECT_FALSE(contact.sticks_out);
  EXPECT_THAT(told(scene, found(scene)), ElementsAre("warning near-contact floor tip"));
}

TEST(NearContacts3, ACornerBesideAnEdge) {
  Scene3 scene = empty_scene();
  add_floor(scene);
  add(scene, "tip", {{q("1/2"), -kGap, 0}, {1, -1, 1}, {0, -1, 1}});
  const Contacts3 contacts = find_contacts(scene);
  ASSERT_EQ(contacts.near.size(), 1u);
  EXPECT_EQ(contacts.near[0].kind, Kind::kCornerEdge);
  EXPECT_EQ(contacts.near[0].to, (Point3{q("1/2"), 0, 0}));
}

TEST(NearContacts3, TwoCornersAreToldOnceWithAllThatEndThere) {
  Scene3 scene = empty_scene();
  add_floor(scene);
  add(scene, "wall", {{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}});
  add(scene, "tip", {{-kGap, -kGap, -kGap}, {-1, -1, 0}, {-1, 0, -1}});
  const Contacts3 contacts = find_contacts(scene);
  ASSERT_EQ(contacts.near.size(), 1u);
  EXPECT_EQ(contacts.near[0].kind, Kind::kCornerCorner);
  EXPECT_THAT(contacts.near[0].surfaces, ElementsAre(0u, 1u));
  EXPECT_THAT(contacts.near[0].targets, ElementsAre(2u));
  EXPECT_EQ(contacts.near[0].squared, 3 * kGap * kGap);
}

TEST(NearContacts3, EdgesThatPassByEachOther) {
  Scene3 scene = empty_scene();
  add(scene, "below", {{-1, 0, 0}, {1, 0, 0}, {0, 0, -1}});
  add(scene, "above", {{0, -1, kGap}, {0, 1, kGap}, {0, 0, 1}});
  const Contacts3 contacts = find_contacts(scene);
  ASSERT_EQ(contacts.near.size(), 1u);
  EXPECT_EQ(contacts.near[0].kind, Kind::kEdgeEdge);
  EXPECT_EQ(contacts.near[0].from, (Point3{0, 0, 0}));
  EXPECT_EQ(contacts.near[0].to, (Point3{0, 0, kGap}));
  EXPECT_THAT(told(scene, found(scene)), ElementsAre("warning near-contact below above"));
}

TEST(NearContacts3, NearIsAPartOfTheNarrowestWidthWhateverTheScale) {
  for (const char* scale : {"1", "1e-300", "1e300", "1/3"})
    for (const bool is_near : {false, true}) {
      // The corner is an end of a side of 1, and the heights of the triangle are larger than 1/2.
      const Rational unit = q(scale), gap = unit * (is_near ? q("4.88e-4") : q("1e-3"));
      Scene3 scene = empty_scene();
      add(scene, "floor", {{0, 0, 0}, {unit, 0, 0}, {unit, unit, 0}, {0, unit, 0}});
      add(scene, "tip", {{unit / 2, unit / 2, gap}, {unit / 2, unit, unit}, {unit / 2, 0, unit}});
      EXPECT_EQ(find_contacts(scene).near.size(), is_near ? 1u : 0u) << scale;
    }
}

TEST(NearContacts3, WhatIsNearAWallWithADoorAlongTheFloorIsTold) {
  Scene3 scene = empty_scene();
  add(scene, "wall", {{0, 0, 0}, {4, 0, 0}, {4, 0, 3}, {0, 0, 3}});
  scene.polygons[0].holes = {{{1, 0, 0}, {1, 0, 2}, {2, 0, 2}, {2, 0, 0}}};
  add(scene, "shelf", {{3, kGap, 1}, {3, 1, 1}, {q("7/2"), 1, 1}, {q("7/2"), kGap, 1}});
  EXPECT_THAT(told(scene, found(scene)),
              ElementsAre("warning near-contact wall shelf", "warning near-contact wall shelf"));
  EXPECT_THAT(told(scene, shape_findings(scene)), IsEmpty()) << "the door is no needle";
}

TEST(NearContacts3, WhatPiercesAFaceByALittleSticksOut) {
  Scene3 scene = empty_scene();
  add_floor(scene);
  add(scene, "tip", {{q("1/2"), q("1/2"), -kGap}, {1, 0, 1}, {0, 1, 1}});
  EXPECT_THAT(told(scene, found(scene)), ElementsAre("warning overshoot floor tip"));
}

TEST(NearContacts3, SurfacesThatMeetAlongAnEdgeMakeAnAngle) {
  Scene3 scene = empty_scene();
  add_floor(scene);
  add(scene, "lid", {{0, 0, 0}, {1, 0, 0}, {1, 1, kGap}, {0, 1, kGap}});
  EXPECT_THAT(told(scene, found(scene)), ElementsAre("note needle floor lid", "note needle floor lid"));
}

TEST(NearContacts3, ASeamOfTilesNextToACornerOnThemIsNoGap) {
  Scene3 scene = empty_scene();
  add_floor(scene);
  add(scene, "tile", {{1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}});
  add(scene, "tip", {{1 - kGap, q("1/2"), 0}, {1, 0, 1}, {0, 1, 1}});
  EXPECT_THAT(told(scene, found(scene)), IsEmpty());
}

TEST(NearContacts3, APartitionThatDoesNotReachTheWallIsToldThoughTheFloorJoinsThem) {
  Scene3 scene = unit_room();
  const Rational x = 1 - kGap;
  add(scene, "partition", {{q("1/2"), q("1/2"), 0}, {x, q("1/2"), 0}, {x, q("1/2"), 1}, {q("1/2"), q("1/2"), 1}});
  EXPECT_THAT(told(scene, found(scene)),
              ElementsAre("warning near-contact right partition", "warning near-contact right partition"));
}

TEST(NearContacts3, JunctionsAndCrossingsAreNotes) {
  Scene3 scene = empty_scene();
  add_floor(scene);
  add(scene, "half", {{q("1/2"), 0, 0}, {q("1/2"), 0, 1}, {2, 0, 1}, {2, 0, 0}});
  EXPECT_THAT(told(scene, found(scene)), ElementsAre("note t-junction floor half", "note t-junction floor half"));
  scene = empty_scene();
  add_floor(scene);
  add(scene, "blade", {{q("1/4"), q("1/2"), -1}, {q("3/4"), q("1/2"), -1}, {q("1/2"), q("1/2"), 1}});
  EXPECT_THAT(told(scene, found(scene)), ElementsAre("note crossing floor blade"));
}

TEST(NearContacts3, OfManyPolygonsCostSeconds) {
  Scene3 scene = empty_scene();
  constexpr int kTiles = 60;
  for (int i = 0; i < kTiles; ++i)
    for (int k = 0; k < kTiles; ++k)
      add(scene, "t" + std::to_string(i) + "_" + std::to_string(k),
          {{i, k, 0}, {i + 1, k, 0}, {i + 1, k + 1, 0}, {i, k + 1, 0}}, "tiles");
  add(scene, "tip", {{q("30.5"), q("30.5"), kGap}, {30, 30, 1}, {31, 30, 1}});
  EXPECT_THAT(told(scene, found(scene)), ElementsAre("warning near-contact t30_30 tip"));
}

TEST(Shapes3, DuplicatesNeedlesAndBentPolygonsAreTold) {
  Scene3 scene = empty_scene();
  add_floor(scene);
  EXPECT_THAT(told(scene, shape_findings(scene)), IsEmpty());
  add(scene, "again", {{1, 1, 0}, {0, 1, 0}, {0, 0, 0}, {1, 0, 0}});
  EXPECT_THAT(told(scene, shape_findings(scene)), ElementsAre("warning duplicate floor again"));
  std::reverse(scene.polygons[1].points.begin(), scene.polygons[1].points.end());
  EXPECT_THAT(told(scene, shape_findings(scene)), ElementsAre("note duplicate floor again"));
  scene = empty_scene();
  add(scene, "splinter", {{0, 0, 0}, {1, 0, 0}, {q("1/2"), kGap, 0}});
  EXPECT_THAT(told(scene, shape_findings(scene)), ElementsAre("note needle splinter"));
  scene = empty_scene();
  add(scene, "bent", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, q("1/1000000")}});
  EXPECT_THAT(told(scene, shape_findings(scene)), IsEmpty()) << "it is no polygon";
  ASSERT_TRUE(accept_nearly_plane(scene.polygons[0], q("1/1000000")));
  const Findings3 findings = shape_findings(scene);
  EXPECT_THAT(told(scene, findings), ElementsAre("note not-plane bent"));
}

}  // namespace
}  // namespace hottel::near_contacts_test
