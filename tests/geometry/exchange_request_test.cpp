// Which rows are asked for, and that asking for some changes none.
#include "geometry/exchange_request.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "geometry/near_names.h"
#include "geometry/plane/exchange/exchange.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "geometry/space/exchange/exchange.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"

namespace hottel::exchange_request_test {
namespace {

using ::testing::ElementsAre;

std::string source(const std::string& file) { return std::string(HOTTEL_SOURCE_DIR) + "/" + file; }

// A room of a polyline with a screen in it that has a material on both sides.
Scene2 room() {
  return parse_scene_2(R"({"hottel": 1, "dimension": 2, "materials": {"m": {"reflectivity": 0.5}}, "edges": [
    {"name": "screen", "points": [[1, 1], [3, 2]], "material": "m", "back": "m", "elements": 2}], "polylines": [
    {"name": "room", "points": [[0, 0], [0, 3], [4, 3], [4, 0]], "closed": true, "material": "m"}]})",
                       "room");
}

std::vector<std::string> chosen(const Scene2& scene, const std::string& word, Granularity granularity) {
  const std::vector<Element> elements =
      exact_exchange(prepare(scene, Divided2::kYes), {.granularity = granularity}).elements();
  std::vector<std::string> names;
  for (const std::uint32_t label : RowChoice::of(scene, word, granularity).labels(elements))
    names.push_back(elements[label].name);
  return names;
}

TEST(RowChoice, IsOfFrontsOrOfNames) {
  const Scene2 scene = room();
  EXPECT_THAT(chosen(scene, "screen", Granularity::kFace), ElementsAre("screen", "screen:back"));
  EXPECT_THAT(chosen(scene, "screen:back", Granularity::kFace), ElementsAre("screen:back"));
  EXPECT_THAT(chosen(scene, "room[1]", Granularity::kFace), ElementsAre("room[1]", "room[1]:back"));
  EXPECT_THAT(chosen(scene, "scr*:back", Granularity::kElement), ElementsAre("screen:back#0", "screen:back#1"));
  EXPECT_THAT(chosen(scene, "fronts", Granularity::kGroup), ElementsAre("screen", "room"));
  EXPECT_THAT(chosen(scene, "room[2]", Granularity::kGroup), ElementsAre("room", "room:back"));
  EXPECT_EQ(chosen(scene, "*", Granularity::kElement).size(), 4u + 8);
  EXPECT_TRUE(RowChoice().is_all());
  EXPECT_FALSE(RowChoice::of(scene, "fronts", Granularity::kFace).is_all());
  EXPECT_THROW(RowChoice::of(scene, "wall", Granularity::kFace), UnknownName);
  EXPECT_THROW(RowChoice::of(scene, "sky", Granularity::kFace), UnknownName);
}

// Rows that are chosen are those of the whole matrix, bit for bit, and all others are empty.
void expect_rows_of(const ExchangeMatrix& whole, const ExchangeMatrix& some, const RowChoice& choice) {
  ASSERT_EQ(whole.size(), some.size());
  std::size_t entries = 0;
  for (std::uint32_t i = 0; i < whole.size(); ++i) {
    if (!choice.has(whole.elements()[i])) {
      EXPECT_TRUE(some.row(i).empty()) << whole.name(i);
      continue;
    }
    ASSERT_EQ(whole.row(i).size(), some.row(i).size()) << whole.name(i);
    for (std::size_t k = 0; k < whole.row(i).size(); ++k, ++entries) {
      const FactorEntry &a = whole.row(i)[k], &b = some.row(i)[k];
      EXPECT_EQ(a.to, b.to);
      EXPECT_EQ(a.factor, b.factor) << whole.name(i) << " " << whole.name(a.to);
      EXPECT_EQ(a.visibility, b.visibility);
      EXPECT_EQ(whole.bounds(i, k).lower, some.bounds(i, k).lower) << whole.name(i) << " " << whole.name(a.to);
      EXPECT_EQ(whole.bounds(i, k).upper, some.bounds(i, k).upper);
      EXPECT_EQ(whole.guarantee(i, k), some.guarantee(i, k));
      ASSERT_EQ(whole.measures(i).size(), some.measures(i).size());
      EXPECT_TRUE(whole.measures(i).empty() || whole.measures(i)[k] == some.measures(i)[k]);
    }
  }
  EXPECT_GT(entries, 0u);
}

TEST(RowChoice, RowsOfThePlaneAreThoseOfTheWholeMatrix) {
  for (const Scene2& scene : std::vector<Scene2>{room(), read_scene_2(source("scenes/showcase/apartment.json"))})
    for (const Granularity granularity : {Granularity::kFace, Granularity::kElement, Granularity::kGroup})
      for (const std::string& word : {std::string("fronts"), scene.surfaces.front().name, scene.groups.back().name}) {
        const PreparedScene2 prepared = prepare(scene, Divided2::kYes);
        ExchangeRequest request{.granularity = granularity, .wants_measures = true};
        const ExchangeMatrix whole = exact_exchange(prepared, request);
        request.rows = RowChoice::of(scene, word, granularity);
        expect_rows_of(whole, exact_exchange(prepared, request), request.rows);
      }
}

TEST(RowChoice, RowsOfSpaceAreThoseOfTheWholeMatrix) {
  for (const char* file : {"scenes/space/two_boxes.json", "scenes/space/city_block.json"})
    for (const Granularity granularity : {Granularity::kFace, Granularity::kGroup})
      for (const double tolerance : {1e-9, 1e-3})
        for (const SkyBy sky : {SkyBy::kIntegral, SkyBy::kClosure}) {
          const Scene3 scene = read_scene_3(source(file));
          const PreparedScene3 prepared = prepare(scene);
          ExchangeRequest request{.granularity = granularity, .tolerance = tolerance, .sky = sky};
          const ExchangeMatrix whole = exact_exchange(prepared, request);
          for (const std::string& word :
               {std::string("fronts"), scene.surfaces.front().name, scene.surfaces.back().name}) {
            request.rows = RowChoice::of(scene, word, granularity);
            ExchangeReport3 report;
            expect_rows_of(whole, exact_exchange(prepared, request, &report), request.rows);
            EXPECT_LT(report.max_defect, 1e-2 * tolerance + 1e-11);
          }
        }
}

}  // namespace
}  // namespace hottel::exchange_request_test
