// Some rows alone: swept about few vertices, with the sums of all of them.
#include "geometry/plane/exchange/swept_vertices.h"

#include <gtest/gtest.h>

#include <random>

#include "geometry/plane/exchange/exchange_sums.h"
#include "geometry/plane/exchange/gap_terms.h"
#include "tests/geometry/plane/exchange_scenes.h"

namespace hottel::swept_vertices_test {
namespace {

using namespace testing_scenes;

ElementTable2 only(const ElementTable2& table, const std::vector<std::uint32_t>& rows) {
  std::vector<bool> is_chosen(table.count());
  for (const std::uint32_t row : rows) is_chosen[row] = true;
  ElementTable2 result = table;
  result.keep_rows(is_chosen);
  return result;
}

// Every gap that adds a term joins two of the vertices.
void expect_terms_between(const Arrangement2& arrangement, const ElementTable2& table) {
  const std::vector<VertexId> swept = swept_vertices(arrangement, table);
  std::vector<char> is_swept(arrangement.vertices().size(), 0);
  for (const VertexId v : swept) is_swept[v.index()] = 1;
  View2 view;
  for (const VertexId v : arrangement.vertices().ids()) {
    look_around(arrangement.vertices(), arrangement.triangulation(), v, view);
    for_each_gap(arrangement.vertices(), v, view, true, [&](const Gap2& gap) {
      for_each_term(gap, table, [&](std::uint32_t, std::uint32_t, int) {
        EXPECT_TRUE(is_swept[gap.v.index()] != 0 && is_swept[gap.w.index()] != 0);
      });
    });
  }
}

void expect_terms_between(const Scene2& scene, Granularity granularity, std::uint64_t seed) {
  const PreparedScene2 prepared = prepare(scene);
  const ElementTable2& all = *prepared.elements(granularity);
  std::mt19937_64 random(seed);
  for (int k = 0; k < 6; ++k) {
    std::vector<std::uint32_t> rows;
    for (int n = 0; n <= k % 3; ++n) rows.push_back(static_cast<std::uint32_t>(random() % all.count()));
    expect_terms_between(prepared.arrangement, only(all, rows));
  }
}

TEST(SweptVertices2, AreTheEndsOfAllGapsWithTermsOfTheRows) {
  for (const std::uint64_t n : {40U, 120U})
    for (const Scene2& scene : all_kinds(n)) {
      expect_terms_between(scene, Granularity::kFace, n);
      expect_terms_between(in_groups_of_five(scene), Granularity::kGroup, n);
    }
}

TEST(SweptVertices2, AreTheseOnLattices) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed)
    expect_terms_between(generated("lattice", 8 + seed % 40, seed), Granularity::kFace, seed);
}

TEST(SweptVertices2, AreFewWhereOneSeesLittle) {
  const PreparedScene2 prepared = prepare(generated("clutter", 4000, 1));
  const ElementTable2& all = *prepared.elements(Granularity::kFace);
  const std::uint32_t row = all.count() / 2;
  EXPECT_LT(swept_vertices(prepared.arrangement, only(all, {row})).size(), 400U);
  EXPECT_EQ(swept_vertices(prepared.arrangement, all).size(), prepared.arrangement.vertices().size());
}

TEST(SweptVertices2, AreNoneForRowsThatThereAreNot) {
  const PreparedScene2 prepared = prepare(generated("clutter", 400, 1));
  EXPECT_TRUE(
      swept_vertices(prepared.arrangement, only(*prepared.elements(Granularity::kFace), std::vector<std::uint32_t>()))
          .empty());
}

}  // namespace
}  // namespace hottel::swept_vertices_test
