// What some point of a face sees, against a slow second way: critical points face by face, and view factors between.
#include "geometry/plane/visibility/weak_visibility.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "geometry/plane/generate/generators.h"
#include "geometry/plane/visibility/critical_points.h"
#include "geometry/plane/visibility/point_view.h"
#include "geometry/scene_names.h"
#include "io/scene/scene_json.h"

namespace hottel::weak_visibility_test {
namespace {

using testing::ElementsAre;

Scene2 generated(const std::string& kind, std::uint64_t n) {
  GeneratorRequest2 request;
  request.kind = kind;
  request.n = n;
  request.seed = 3;
  return generate_2(request);
}

const SeenFace2* find(const WeakVisibility2& sight, const Face& face) {
  const auto place =
      std::find_if(sight.faces.begin(), sight.faces.end(), [&](const SeenFace2& seen) { return seen.face == face; });
  return place == sight.faces.end() ? nullptr : &*place;
}

bool is_in(const SeenFace2* seen, const Rational& t) {
  return seen != nullptr && std::any_of(seen->stretches.begin(), seen->stretches.end(),
                                        [&](const Stretch2& s) { return s.begin < t && t < s.end; });
}

// Every face that owns a side.
std::set<Face> faces_of(const Arrangement2& arrangement) {
  std::set<Face> faces;
  for (const PieceSideId side : arrangement.sides())
    if (!arrangement.is_covered(side)) faces.insert(arrangement.owner(side));
  return faces;
}

void expect_second_way(const PreparedScene2& prepared, const Face& from) {
  const Arrangement2& arrangement = prepared.arrangement;
  const WeakVisibility2 sight = weak_visibility(prepared, from);
  const std::string name = face_name(prepared.scene, from);
  bool sees_sky = false;
  for (const Face& face : faces_of(arrangement)) {
    if (face == from) {
      EXPECT_EQ(find(sight, face), nullptr);
      continue;
    }
    const SeenFace2* seen = find(sight, face);
    std::vector<Rational> places{0, 1};
    for (const CriticalPoint2& c : critical_points(arrangement, prepared.scene, face, from)) places.push_back(c.t);
    for (const VertexId v : arrangement.vertices().ids()) {  // contacts
      const Edge2& edge = prepared.scene.edges[face.surface];
      const Point2 p = arrangement.vertices().to_scene(arrangement.vertices().exact(v));
      const Rational ux = edge.to.x - edge.from.x, uy = edge.to.y - edge.from.y;
      if (ux * (p.y - edge.from.y) != uy * (p.x - edge.from.x)) continue;
      const Rational t = ((p.x - edge.from.x) * ux + (p.y - edge.from.y) * uy) / (ux * ux + uy * uy);
      if (t > 0 && t < 1) places.push_back(t);
    }
    if (seen)
      for (const Stretch2& s : seen->stretches) places.insert(places.end(), {s.begin, s.end});
    std::sort(places.begin(), places.end());
    for (std::size_t k = 0; k + 1 < places.size(); ++k) {
      if (places[k] == places[k + 1]) continue;
      const Rational t = (places[k] + places[k + 1]) / 2;
      // Is the place owned by this face at all?
      const auto factors = point_factors_by_face(prepared, face, t);
      const bool is_seen =
          std::any_of(factors.begin(), factors.end(), [&](const FaceFactor2& f) { return f.to == name; });
      EXPECT_EQ(is_in(seen, t), is_seen) << name << " sees " << face_name(prepared.scene, face) << " at " << t;
    }
  }
  for (int k = 1; k < 997 && !sees_sky; ++k)
    for (const FaceFactor2& f : point_factors_by_face(prepared, from, Rational(k, 997)))
      sees_sky = sees_sky || f.to == "sky";
  EXPECT_TRUE(sight.sees_sky || !sees_sky) << name;
}

TEST(WeakVisibility2, StretchesAreThoseBetweenCriticalPointsFromWhichTheFaceIsSeen) {
  for (const char* kind : {"room", "clutter", "maze", "plates", "pillars", "comb", "star"}) {
    SCOPED_TRACE(kind);
    const PreparedScene2 prepared = prepare(generated(kind, 24));
    const std::set<Face> faces = faces_of(prepared.arrangement);
    std::size_t count = 0;
    for (const Face& face : faces)
      if (prepared.scene.surfaces[face.surface].back || !face.is_back)
        if (count++ % 5 == 0) expect_second_way(prepared, face);
  }
}

PreparedScene2 scene(const std::string& edges) {
  return prepare(
      parse_scene_2(R"({"hottel": 1, "dimension": 2, "materials": {"m": {}}, "edges": [)" + edges + "]}", "test.json"));
}

TEST(WeakVisibility2, ShadowsEndOnLinesThroughTheEndsOfFaceAndOccluder) {
  // The floor from 0 to 4 at height 0, a wall at height 3 above, an occluder from 1 to 3 at height 1.
  const PreparedScene2 prepared = scene(R"({"name": "floor", "points": [[4, 0], [0, 0]], "material": "m"},
      {"name": "occluder", "points": [[3, 1], [1, 1]], "material": "m"},
      {"name": "top", "points": [[-12, 3], [16, 3]], "material": "m"})");
  const WeakVisibility2 sight = weak_visibility(prepared, face_of(prepared.scene, "floor"));
  ASSERT_NE(find(sight, face_of(prepared.scene, "top")), nullptr);
  // Behind the occluder all of the top is seen past one of its ends: from (0,0) past (1,1) up to (3,3), from (4,0) past
  // (3,1) up to (1,3), and these overlap.
  EXPECT_THAT(find(sight, face_of(prepared.scene, "top"))->stretches, ElementsAre(Stretch2{0, 1}));
  EXPECT_EQ(find(sight, face_of(prepared.scene, "occluder")), nullptr);
  EXPECT_THAT(find(sight, face_of(prepared.scene, "occluder:back"))->stretches, ElementsAre(Stretch2{0, 1}));
  EXPECT_TRUE(sight.sees_sky);
}

TEST(WeakVisibility2, AWideOccluderLeavesAnExactUmbra) {
  const PreparedScene2 prepared = scene(R"({"name": "floor", "points": [[1, 0], [0, 0]], "material": "m"},
      {"name": "occluder", "points": [[3, 1], [-2, 1]], "material": "m"},
      {"name": "top", "points": [[-12, 2], [16, 2]], "material": "m"})");
  const WeakVisibility2 sight = weak_visibility(prepared, face_of(prepared.scene, "floor"));
  // From (0,0) past (-2,1) to (-4,2); from (1,0) past (3,1) to (5,2).
  EXPECT_THAT(find(sight, face_of(prepared.scene, "top"))->stretches,
              ElementsAre(Stretch2{0, Rational(2, 7)}, Stretch2{Rational(17, 28), 1}));
  EXPECT_EQ(find(sight, face_of(prepared.scene, "top"))->share, Rational(19, 28));
}

}  // namespace
}  // namespace hottel::weak_visibility_test
