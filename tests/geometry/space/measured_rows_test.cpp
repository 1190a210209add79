// Rows that come a range at a time: those of the whole matrix, bit for bit.
#include "geometry/space/exchange/measured_rows.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "geometry/space/exchange/exchange.h"
#include "geometry/space/exchange/exchange_rows.h"
#include "geometry/space/generate/generators.h"
#include "geometry/space/scene/division.h"
#include "geometry/unmeasured_pairs.h"
#include "io/scene/scene_json.h"
#include "tests/geometry/same_rows.h"

namespace hottel::measured_rows_test {
namespace {

Scene3 scene_file(const std::string& name, std::uint32_t elements = 1) {
  Scene3 scene = read_scene_3(std::string(HOTTEL_SOURCE_DIR) + "/scenes/space/" + name);
  if (elements > 1) divide_into(scene, elements);
  return scene;
}

// A mask on a wall, and open sides.
Scene3 masked() {
  return parse_scene_3(R"({"hottel": 1, "dimension": 3, "materials": {"m": {"reflectivity": 0.5}},
    "polygons": [
    {"name": "wall", "points": [[0,0,0],[2,0,0],[2,2,0],[0,2,0]], "material": "m", "back": "m"},
    {"name": "mask", "points": [[0.5,0.5,0],[0.5,1,0],[1,1,0],[1,0.5,0]], "material": "m", "masks": "wall"},
    {"name": "lid", "points": [[0,0,1],[0,2,1],[2,2,1],[2,0,1]], "material": "m"},
    {"name": "fin", "points": [[1,0.2,0.2],[1,1.8,0.2],[1,1.8,0.8],[1,0.2,0.8]], "material": "m"}]})",
                       "masked");
}

void expect_same_report(const ExchangeReport3& a, const ExchangeReport3& b) {
  EXPECT_EQ(a.surfaces, b.surfaces);
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_EQ(a.elements, b.elements);
  EXPECT_EQ(a.pairs, b.pairs);
  EXPECT_EQ(a.enclosed, b.enclosed);
  EXPECT_EQ(a.hidden, b.hidden);
  EXPECT_EQ(a.clear, b.clear);
  EXPECT_EQ(a.mixed, b.mixed);
  EXPECT_EQ(a.nodes, b.nodes);
  EXPECT_EQ(a.proof.narrowed, b.proof.narrowed);
  EXPECT_EQ(a.max_error, b.max_error);
  EXPECT_EQ(a.max_defect, b.max_defect);
  ASSERT_EQ(a.sky.has_value(), b.sky.has_value());
  if (!a.sky) return;
  EXPECT_EQ(a.sky->told, b.sky->told);
  EXPECT_EQ(a.sky->checked, b.sky->checked);
  EXPECT_EQ(a.sky->integrated, b.sky->integrated);
  EXPECT_EQ(a.sky->beyond, b.sky->beyond);
  EXPECT_EQ(a.sky->max_error, b.sky->max_error);
  EXPECT_EQ(a.sky->within, b.sky->within);
  EXPECT_EQ(a.sky->max_difference, b.sky->max_difference);
  EXPECT_EQ(a.sky->farthest, b.sky->farthest);
}

void expect_same(const Scene3& scene, const ExchangeRequest& request, std::initializer_list<std::size_t> entries) {
  const PreparedScene3 prepared = prepare(scene);
  ExchangeReport3 of_whole;
  const ExchangeMatrix whole = exact_exchange(prepared, request, &of_whole);
  for (const std::size_t entries_in_range : entries) {
    PairsInMemory3 pairs(prepared.elements(request.granularity)->count(), entries_in_range);
    ExchangeRows3 measured(prepared, request, &pairs);
    measured.add_all();
    EXPECT_TRUE(measured.pairs().empty());
    ExchangeReport3 of_rows;
    const auto rows = measured.rows(&of_rows);
    EXPECT_EQ(rows->guarantee(), whole.guarantee());
    testing_scenes::expect_same_rows(whole, *rows);
    testing_scenes::expect_same_rows(whole, *rows);  // and once more
    expect_same_report(of_whole, of_rows);
    if (entries_in_range == 1) {
      EXPECT_EQ(rows->count(), whole.size());
    }
  }
}

TEST(MeasuredRows3, AreThoseOfTheMatrixHoweverTheyAreCut) {
  for (const Scene3& scene : {scene_file("two_boxes.json", 2), scene_file("cube.json"), scene_file("attic.json"),
                              scene_file("pierced_triangles.json"), masked()})
    for (const Granularity granularity : {Granularity::kFace, Granularity::kElement, Granularity::kGroup})
      expect_same(scene, {.granularity = granularity}, {1, 50, 1'000'000});
}

TEST(MeasuredRows3, AreThoseOfTheMatrixUnderASky) {
  for (const char* kind : {"town", "street-blocks"}) {
    const Scene3 scene = generate_3({.kind = kind, .n = 3, .seed = 2});
    expect_same(scene, {.wants_visibility = false}, {1, 40});
    expect_same(scene, {.sky = SkyBy::kClosure}, {1, 40, 1'000'000});
  }
}

TEST(MeasuredRows3, AreThoseOfTheMatrixWhereBoundsAreProven) {
  expect_same(generate_3({.kind = "room-touching", .n = 2, .seed = 1}), {.proves = true}, {1, 30, 1'000'000});
  expect_same(generate_3({.kind = "town", .n = 2, .seed = 1}), {.proves = true, .sky = SkyBy::kClosure}, {1, 30});
}

TEST(MeasuredRows3, AreThoseOfTheMatrixWhereSomeAreAskedFor) {
  const Scene3 scene = scene_file("two_boxes.json", 2);
  for (const char* rows : {"fronts", "lamp*"}) {
    const RowChoice choice = RowChoice::of(scene, rows, Granularity::kElement);
    expect_same(scene, {.granularity = Granularity::kElement, .rows = choice}, {1, 50});
    expect_same(scene, {.granularity = Granularity::kElement, .proves = true, .rows = choice}, {50});
  }
}

// As by the matrix.
TEST(MeasuredRows3, OfPairsThatCannotBeMeasuredAreRefused) {
  const PreparedScene3 prepared = prepare(generate_3({.kind = "town", .n = 2, .seed = 1}));
  const ExchangeRequest request{.tolerance = 1e-300};
  PairsInMemory3 pairs(prepared.elements(request.granularity)->count());
  ExchangeRows3 measured(prepared, request, &pairs);
  EXPECT_THROW(exact_exchange(prepared, request), UnmeasuredPairs);
  EXPECT_THROW(measured.add_all(), UnmeasuredPairs);
}

TEST(PairsInMemory3, AreOfBothRangesOfTheirRows) {
  PairsInMemory3 pairs(6, 4);
  pairs.keep(std::vector<PairSum3>{{.i = 4, .j = 6}, {.i = 0, .j = 5}, {.i = 2, .j = 2}});
  pairs.keep(std::vector<PairSum3>{{.i = 0, .j = 3}});
  ASSERT_EQ(pairs.cuts().count(), 3U);  // of two rows each
  const auto of = [&](std::size_t k) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> result;
    for (const PairSum3& pair : pairs.pairs(k)) result.emplace_back(pair.i, pair.j);
    return result;
  };
  using Labels = std::vector<std::pair<std::uint32_t, std::uint32_t>>;
  EXPECT_EQ(of(0), (Labels{{0, 3}, {0, 5}}));
  EXPECT_EQ(of(1), (Labels{{0, 3}, {2, 2}}));
  EXPECT_EQ(of(2), (Labels{{0, 5}, {4, 6}}));
  pairs.keep(std::vector<PairSum3>{{.i = 1, .j = 2}});
  EXPECT_EQ(of(0), (Labels{{0, 3}, {0, 5}, {1, 2}})) << "those that came after others were read";
}

}  // namespace
}  // namespace hottel::measured_rows_test
