// Elements under trees: their factors are those of the same edges given from the start, and cuts decide nothing else.
#include <gtest/gtest.h>

#include <map>
#include <string>

#include "geometry/plane/exchange/exchange.h"
#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "geometry/plane/scene/division.h"
#include "tests/solver/plane/lit_scenes.h"
#include "tests/solver/plane/random_trees.h"

namespace hottel::element_trees_test {
namespace {

ExchangeMatrix factors_of(const Scene2& scene) {
  return exact_exchange(prepare(scene, Divided2::kYes), {.granularity = Granularity::kElement});
}

// Entries by the names of both elements.
using Entries = std::map<std::pair<std::string, std::string>, FactorEntry>;
Entries entries_of(const ExchangeMatrix& matrix, const std::map<std::string, std::string>& name_of = {}) {
  Entries entries;
  const auto called = [&](std::uint32_t label) {
    const std::string name = label == matrix.sky() ? "sky" : matrix.elements()[label].name;
    const auto other = name_of.find(name);
    return other == name_of.end() ? name : other->second;
  };
  for (std::uint32_t i = 0; i < matrix.size(); ++i)
    if (matrix.has_row(i))
      for (const FactorEntry& entry : matrix.row(i)) entries[{called(i), called(entry.to)}] = entry;
  return entries;
}

void expect_same(const Entries& a, const Entries& b, const std::string& what) {
  ASSERT_EQ(a.size(), b.size()) << what;
  for (const auto& [names, entry] : a) {
    const auto other = b.find(names);
    ASSERT_NE(other, b.end()) << what << ": " << names.first << " to " << names.second;
    EXPECT_EQ(entry.factor, other->second.factor) << what << ": " << names.first << " to " << names.second;
    EXPECT_EQ(entry.visibility, other->second.visibility) << what;
  }
}

// Every leaf of the fronts as an edge of its own, where no back has a material; and what each is called then.
Scene2 with_leaves_as_edges(const Scene2& scene, std::map<std::string, std::string>& name_of) {
  Scene2 result = scene;
  result.surfaces.clear();
  result.edges.clear();
  for (std::size_t s = 0; s < scene.surfaces.size(); ++s) {
    const Surface& surface = scene.surfaces[s];
    const std::vector<TreeNode> leaves =
        surface.trees.front.empty() ? uniform_leaves(surface.elements, 2, 0) : surface.trees.front;
    for (std::size_t k = 0; k < leaves.size(); ++k) {
      const EdgeSpan2 span = EdgeSpan2::of(surface.elements, leaves[k]);
      Surface part = surface;
      part.name = surface.name + "." + std::to_string(k);
      part.elements = 1;
      part.trees = {};
      name_of[part.name] = element_name(surface.name, surface.elements, leaves[k]);
      result.add(part, {point_at(scene.edges[s], span.from), point_at(scene.edges[s], span.to)});
    }
  }
  return result;
}

Entries without_backs(const Entries& entries) {
  Entries result;
  for (const auto& [names, entry] : entries)
    if (!names.second.ends_with(":back")) result.emplace(names, entry);
  return result;
}

TEST(ElementTrees2, FactorsAreThoseOfTheSameEdgesGivenFromTheStartBitForBit) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    Scene2 scene = random_lattice_scene(seed, 4 + static_cast<int>(seed % 9));
    for (Surface& surface : scene.surfaces) surface.back.reset();
    scene = with_random_trees(std::move(scene), 3, seed);
    std::map<std::string, std::string> name_of;
    const Scene2 split = with_leaves_as_edges(scene, name_of);
    // To the black backs, which are not divided, whole rows are compared.
    expect_same(without_backs(entries_of(factors_of(scene))),
                without_backs(entries_of(exact_exchange(prepare(split)), name_of)), "seed " + std::to_string(seed));
  }
}

TEST(ElementTrees2, HalvesOfHalvesAreFourEqualParts) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    Scene2 trees = random_lattice_scene(seed, 8), parts = trees;
    std::map<std::string, std::string> name_of;
    for (std::size_t s = 0; s < trees.surfaces.size(); ++s) {
      parts.surfaces[s].elements = 4;
      for (const bool is_back : {false, true}) {
        if (!trees.surfaces[s].material_of(is_back)) continue;
        auto& leaves = is_back ? trees.surfaces[s].trees.back : trees.surfaces[s].trees.front;
        leaves = uniform_leaves(1, 2, 2);
        const std::string face = trees.surfaces[s].name + (is_back ? ":back" : "");
        for (std::uint32_t k = 0; k < 4; ++k)
          name_of[element_name(face, 4, {k, {}})] = element_name(face, 1, leaves[k]);
      }
    }
    expect_same(entries_of(factors_of(trees)), entries_of(factors_of(parts), name_of), "seed " + std::to_string(seed));
  }
}

TEST(ElementTrees2, RowsCloseAndReciprocityHolds) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    const Scene2 scene = with_random_trees(random_lattice_scene(seed, 10), 4, seed);
    const ExchangeMatrix matrix = factors_of(scene);
    for (std::uint32_t i = 0; i < matrix.size(); ++i) {
      if (!matrix.has_row(i)) continue;
      double sum = 0;
      for (const FactorEntry& entry : matrix.row(i)) {
        sum += entry.factor.value;
        if (entry.to == matrix.sky() || !matrix.has_row(entry.to)) continue;
        const double there = entry.factor.value * matrix.elements()[i].area.value;
        const double back = matrix.factor(entry.to, i).value * matrix.elements()[entry.to].area.value;
        EXPECT_NEAR(there, back, 4e-16 * there);
      }
      EXPECT_NEAR(sum, 1, 1e-14) << "seed " << seed;
    }
  }
}

TEST(Arrangement2, CutsDecideNothingOfOwnersAndSolids) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    Scene2 scene = random_lattice_scene(seed, 12);
    if (seed % 2 == 0) add_polygon(scene, {{2, 2}, {6, 2}, {6, 5}, {2, 5}});  // a solid among them
    const Scene2 divided = with_random_trees(scene, 4, seed);
    const Arrangement2 whole(scene, Division2(scene.surfaces.size()));
    const Arrangement2 cut(divided, division_of(divided));
    // Each piece lies in one piece of the other, and what its sides are is the same.
    std::size_t found = 0;
    for (std::size_t p = 0; p < cut.pieces().size(); ++p) {
      const auto at = [&](const Arrangement2& arrangement, VertexId v) {
        return arrangement.vertices().to_scene(arrangement.vertices().exact(v));
      };
      const Edge2 part{at(cut, cut.pieces()[p].a), at(cut, cut.pieces()[p].b)};
      for (std::size_t w = 0; w < whole.pieces().size(); ++w) {
        const Edge2 all{at(whole, whole.pieces()[w].a), at(whole, whole.pieces()[w].b)};
        const auto along = [&](const Point2& q) -> std::optional<Rational> {
          const Rational ux = all.to.x - all.from.x, uy = all.to.y - all.from.y, x = q.x - all.from.x,
                         y = q.y - all.from.y;
          if (ux * y != uy * x) return std::nullopt;
          return Rational(ux != 0 ? x / ux : y / uy);
        };
        const auto from = along(part.from), to = along(part.to);
        if (!from || !to || *from < 0 || *to < 0 || *from > 1 || *to > 1) continue;
        ++found;
        EXPECT_LT(*from, *to) << "a part points the same way";
        for (std::size_t side = 0; side < 2; ++side) {
          const PieceSideId here = sides_of(p)[side], there = sides_of(w)[side];
          ASSERT_EQ(cut.is_covered(here), whole.is_covered(there));
          if (cut.is_covered(here)) continue;
          EXPECT_EQ(Face(cut.owner(here)), Face(whole.owner(there)));
        }
      }
    }
    EXPECT_EQ(found, cut.pieces().size()) << "seed " << seed;
  }
}

}  // namespace
}  // namespace hottel::element_trees_test
