// Which vertices of a scene see each other.
#include "geometry/plane/visibility/visibility_graph.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "geometry/plane/generate/generators.h"
#include "io/scene/scene_json.h"
#include "kernel/support/interrupt.h"
#include "kernel/support/parallel.h"

namespace hottel::visibility_graph_test {
namespace {

using ::testing::ElementsAre;

PreparedScene2 scene(const std::string& surfaces) {
  return prepare(
      parse_scene_2(R"({"hottel": 1, "dimension": 2, "materials": {"m": {}}, )" + surfaces + "}", "test.json"));
}

PreparedScene2 generated(const std::string& kind, std::uint64_t n) {
  GeneratorRequest2 request;
  request.kind = kind;
  request.n = n;
  return prepare(generate_2(request));
}

std::vector<VisiblePair2> graph(const PreparedScene2& prepared) {
  std::vector<VisiblePair2> result;
  visibility_graph(
      prepared, [&](std::span<const VisiblePair2> pairs) { result.insert(result.end(), pairs.begin(), pairs.end()); });
  return result;
}

// "0-1" where free, "0=1" along a piece.
std::vector<std::string> texts(const std::vector<VisiblePair2>& pairs) {
  std::vector<std::string> result;
  for (const VisiblePair2& pair : pairs)
    result.push_back(std::to_string(pair.v) + (pair.along == kNoPiece ? "-" : "=") + std::to_string(pair.w));
  return result;
}

TEST(VisibilityGraph2, OfARoomHasItsSidesAndDiagonals) {
  const auto pairs = graph(scene(
      R"("polylines": [{"name": "room", "points": [[0,0],[0,3],[4,3],[4,0]], "closed": true, "material": "m"}])"));
  EXPECT_THAT(texts(pairs), ElementsAre("0=1", "0-2", "0=3", "1=2", "1-3", "2=3"));
  EXPECT_EQ(pairs[1].length, 5);
}

TEST(VisibilityGraph2, OfASolidHasItsSidesAlone) {
  const PreparedScene2 prepared = scene(
      R"("polylines": [{"name": "box", "points": [[0,0],[4,0],[4,3],[0,3]], "closed": true, "material": "m"}],
         "edges": [{"name": "inside", "points": [[1,1],[2,2]], "material": "m"}])");
  EXPECT_THAT(texts(graph(prepared)), ElementsAre("2=3", "2=5", "3=4", "4=5"))
      << "what lies in a solid sees nothing, and edges come first";
}

TEST(VisibilityGraph2, OfVerticesOnALineHasNeighboursAlone) {
  // Three tips at height 1; the one between stands in the way of the others.
  const PreparedScene2 prepared = scene(R"("edges": [
      {"name": "a", "points": [[0,0],[0,1]], "material": "m"}, {"name": "b", "points": [[1,3],[1,1]], "material": "m"},
      {"name": "c", "points": [[2,0],[2,1]], "material": "m"}])");
  std::vector<std::string> level;
  for (const std::string& text : texts(graph(prepared)))
    if (text.find_first_of("024") == std::string::npos) level.push_back(text);
  EXPECT_THAT(level, ElementsAre("1-3", "3-5"));
}

TEST(VisibilityGraph2, NumbersCrossingsLastAndSaysWhoCrossesThere) {
  const PreparedScene2 prepared = scene(R"("edges": [
      {"name": "a", "points": [[0,0],[2,2]], "material": "m"}, {"name": "b", "points": [[0,2],[2,0]], "material": "m"},
      {"name": "c", "points": [[2,2],[3,2]], "material": "m"}])");
  const auto vertices = graph_vertices(prepared);
  ASSERT_EQ(vertices.size(), 6u);
  EXPECT_EQ(vertices[1].surface, 0u) << "a and c end there";
  EXPECT_EQ(vertices[4].surface, 2u);
  EXPECT_FALSE(vertices[4].is_crossing);
  EXPECT_EQ(vertices[5].surface, 0u);
  EXPECT_TRUE(vertices[5].is_crossing);
  EXPECT_THAT(texts(graph(prepared)),
              ElementsAre("0-2", "0-3", "0=5", "1-2", "1-3", "1=4", "1=5", "2=5", "3-4", "3=5", "4-5"));
}

TEST(VisibilityGraph2, OfOneEdgeIsThatEdge) {
  const auto pairs = graph(scene(R"("edges": [{"name": "a", "points": [["1/3",0],[2,2]], "material": "m"}])"));
  ASSERT_THAT(texts(pairs), ElementsAre("0=1"));
  EXPECT_EQ(pairs[0].length, std::sqrt(61.0) / 3) << "sqrt(25/9 + 4); the quotient happens to round correctly";
}

TEST(VisibilityGraph2, LengthsAreTheNearestDoublesWhateverTheScale) {
  // 3-4-5 with a hair between: neither the large nor the small length loses a digit.
  const auto pairs = graph(scene(R"("edges": [{"name": "a", "points": [[0,0],["3e200","4e200"]], "material": "m"},
                                            {"name": "b", "points": [[-1,0],[-1,"1e-200"]], "material": "m"}])"));
  EXPECT_EQ(pairs.front().length, 5e200);
  EXPECT_EQ(pairs.back().length, 1e-200);
}

TEST(VisibilityGraph2, IsTheSameForAnyNumberOfThreadsAndStopsWhenTold) {
  const PreparedScene2 prepared = generated("clutter", 200);
  const auto many = graph(prepared);
  const ThreadLimit one(1);
  const auto few = graph(prepared);
  ASSERT_EQ(many.size(), few.size());
  EXPECT_EQ(texts(many), texts(few));
  for (std::size_t k = 1; k < many.size(); ++k)
    EXPECT_TRUE(many[k - 1].v < many[k].v || (many[k - 1].v == many[k].v && many[k - 1].w < many[k].w));
  const auto nothing = [](std::span<const VisiblePair2>) {};
  EXPECT_THROW(visibility_graph(prepared, nothing, [](double) { throw Interrupted(); }), Interrupted);
}

}  // namespace
}  // namespace hottel::visibility_graph_test
