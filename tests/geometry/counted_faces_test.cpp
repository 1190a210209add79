// Elements and pairs counted before they are made, and how many see each other, from some that are drawn.
#include "geometry/counted_faces.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <string>
#include <vector>

#include "geometry/plane/exchange/exchange.h"
#include "geometry/plane/exchange/pair_estimate.h"
#include "geometry/plane/generate/generators.h"
#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "geometry/plane/scene/division.h"
#include "geometry/space/exchange/exchange.h"
#include "geometry/space/exchange/pair_estimate.h"
#include "geometry/space/generate/generators.h"
#include "geometry/space/prepared/element_table.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "geometry/space/scene/division.h"
#include "io/scene/scene_json.h"

namespace hottel::counted_faces_test {
namespace {

std::string shown(const std::string& file) { return std::string(HOTTEL_SOURCE_DIR) + "/scenes/" + file; }

double entries_of_pairs(const ExchangeMatrix& matrix) {
  double pairs = 0;  // but those with the sky
  for (std::uint32_t i = 0; i < matrix.size(); ++i)
    for (const FactorEntry& entry : matrix.row(i))
      if (entry.to != matrix.sky()) pairs += matrix.has_row(entry.to) ? 0.5 : 1;
  return pairs;
}

TEST(CountedFaces, HaveThePairsOfABruteForce) {
  const std::vector<CountedFace> faces{{0, false, 3, true}, {0, true, 1, false}, {1, false, 2, true},
                                       {1, true, 4, true},  {2, false, 1, true}, {2, true, 1, false}};
  std::vector<std::size_t> face_of;
  for (std::size_t f = 0; f < faces.size(); ++f) face_of.insert(face_of.end(), faces[f].elements, f);
  double pairs = 0, rows = 0;
  for (std::size_t a = 0; a < face_of.size(); ++a) {
    rows += faces[face_of[a]].has_row;
    for (std::size_t b = 0; b < a; ++b)
      pairs += face_of[a] != face_of[b] && (faces[face_of[a]].has_row || faces[face_of[b]].has_row);
  }
  const ElementPairCounts counts = pair_counts(faces);
  EXPECT_EQ(counts.elements, static_cast<double>(face_of.size()));
  EXPECT_EQ(counts.rows, rows);
  EXPECT_EQ(counts.pairs, pairs);
}

TEST(CountedFaces, CountTheElementsThatTheTablesHave) {
  Scene3 boxes = read_scene_3(shown("space/two_boxes.json"));
  divide_into(boxes, 3);
  for (const Granularity granularity : {Granularity::kFace, Granularity::kElement})
    EXPECT_EQ(pair_counts(counted_faces_3(boxes, granularity)).elements,
              static_cast<double>(element_counts(boxes, granularity).all));
  Scene2 apartment = read_scene_2(shown("showcase/apartment.json"));
  divide_into(apartment, 4);
  const PreparedScene2 divided = prepare(apartment, Divided2::kYes);
  const ElementTable2 table(apartment, divided.arrangement, divided.division, Granularity::kElement);
  EXPECT_EQ(pair_counts(counted_faces_2(apartment, Granularity::kElement)).elements,
            static_cast<double>(table.count()));
}

TEST(EstimatedPairs, InThePlaneAreThoseThatSeeEachOther) {
  std::vector<Scene2> scenes{read_scene_2(shown("showcase/apartment.json")),
                             generate_2({.kind = "clutter", .n = 300, .seed = 3}),
                             generate_2({.kind = "maze", .n = 200, .seed = 3})};
  for (Scene2& scene : scenes) {
    divide_into(scene, 4);
    const double exact = entries_of_pairs(exact_exchange(
        prepare(scene, Divided2::kYes), {.granularity = Granularity::kElement, .wants_visibility = false}));
    const SampledPairs pairs = estimated_pairs_2(scene, counted_faces_2(scene, Granularity::kElement));
    if (!pairs.is_known) {
      EXPECT_LT(exact, 2 * pairs.pairs) << scene.about;
      continue;
    }
    EXPECT_LT(pairs.pairs, 2 * exact) << scene.about;
    EXPECT_GT(pairs.pairs, exact / 2) << scene.about;
  }
}

TEST(EstimatedPairs, InSpaceAreThoseThatSeeEachOther) {
  std::vector<Scene3> scenes{read_scene_3(shown("space/two_boxes.json")), read_scene_3(shown("space/cube.json")),
                             generate_3({.kind = "room-floating", .n = 4, .seed = 3})};
  for (Scene3& scene : scenes) {
    divide_into(scene, 2);
    const double exact = entries_of_pairs(exact_exchange(
        prepare(scene), {.granularity = Granularity::kElement, .wants_visibility = false, .tolerance = 1e-6}));
    const SampledPairs pairs = estimated_pairs_3(scene, counted_faces_3(scene, Granularity::kElement));
    ASSERT_TRUE(pairs.is_known);
    EXPECT_LT(pairs.pairs, 2 * exact) << scene.about;
    EXPECT_GT(pairs.pairs, exact / 2) << scene.about;
  }
}

// However many elements there will be: of polygons with holes, of scenes as small and as large as doubles go.
TEST(EstimatedPairs, DoNotDependOnScaleNorTakeLonger) {
  const auto plates = [](const std::string& e) {
    return parse_scene_3(R"({"hottel": 1, "dimension": 3, "materials": {"m": {}}, "polygons": [
      {"name": "low", "points": [[0,0,0],["1e)" +
                             e + R"(",0,0],["1e)" + e + R"(","1e)" + e + R"(",0],[0,"1e)" + e +
                             R"(",0]], "material": "m"},
      {"name": "high", "points": [[0,0,"2e)" +
                             e + R"("],[0,"1e)" + e + R"(","2e)" + e + R"("],["1e)" + e + R"(","1e)" + e + R"(","2e)" +
                             e + R"("],["1e)" + e + R"(",0,"2e)" + e + R"("]], "material": "m"}]})",
                         "plates.json");
  };
  for (const char* exponent : {"0", "300", "-300"}) {
    Scene3 scene = plates(exponent);
    divide_into(scene, 1000);
    const auto begin = std::chrono::steady_clock::now();
    const SampledPairs pairs = estimated_pairs_3(scene, counted_faces_3(scene, Granularity::kElement));
    EXPECT_TRUE(pairs.is_known);
    EXPECT_NEAR(pairs.pairs, 1e12, 1e11) << exponent;
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(10)) << "of a thousand years";
  }
}

TEST(EstimatedPairs, SeeThroughHolesAndNotThroughScreens) {
  const auto screened = [](const std::string& screen) {
    Scene3 scene = parse_scene_3(R"({"hottel": 1, "dimension": 3, "materials": {"m": {}}, "polygons": [
      {"name": "low", "points": [[0,0,0],[1,0,0],[1,1,0],[0,1,0]], "material": "m"},
      {"name": "high", "points": [[0,0,2],[0,1,2],[1,1,2],[1,0,2]], "material": "m"},
      {"name": "screen", "points": [[-9,-9,1],[9,-9,1],[9,9,1],[-9,9,1]], "material": "m")" +
                                     screen + "}]}",
                                 "screen.json");
    for (Surface& surface : scene.surfaces)
      if (surface.name != "screen") surface.elements = 50;
    return estimated_pairs_3(scene, counted_faces_3(scene, Granularity::kElement));
  };
  EXPECT_FALSE(screened("").is_known);
  const SampledPairs through = screened(R"(, "holes": [[[-2,-2,1],[-2,3,1],[3,3,1],[3,-2,1]]])");
  EXPECT_TRUE(through.is_known);
  EXPECT_NEAR(through.pairs, 2500.0 * 2500, 700000);
}

}  // namespace
}  // namespace hottel::counted_faces_test
