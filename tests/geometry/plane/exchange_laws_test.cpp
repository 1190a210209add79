// The numbered properties of exact_exchange, on scenes of every kind.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>

#include "geometry/plane/prepared/prepared_scene.h"
#include "geometry/scene_names.h"
#include "kernel/support/parallel.h"
#include "tests/geometry/plane/exchange_scenes.h"

namespace hottel::exchange_laws_test {
namespace {

using namespace testing_scenes;

class ExactExchange2 : public testing::TestWithParam<std::string> {
 protected:
  Scene2 scene(std::uint64_t n, std::uint64_t seed = 3) const {
    Scene2 result = generated(GetParam(), n, seed);
    // Some backs that take part in the exchange as well.
    for (std::size_t k = 0; k < result.surfaces.size(); k += 3)
      if (GetParam() != "lattice") result.surfaces[k].back = result.surfaces[k].material;
    return result;
  }
};

std::vector<ElementPair> all_pairs(const ExchangeMatrix& matrix) {
  std::vector<ElementPair> pairs;
  for (std::uint32_t i = 0; i < matrix.size(); ++i)
    for (std::uint32_t j = i; j <= matrix.sky(); ++j)
      if (matrix.has_row(i) || (j < matrix.size() && matrix.has_row(j))) pairs.emplace_back(i, j);
  return pairs;
}

// sum over j of S(i, j) == A_i, as an identity of integers for doubles and of roots for the sums.
TEST_P(ExactExchange2, IsClosed) {
  for (const Granularity granularity : {Granularity::kFace, Granularity::kElement, Granularity::kGroup}) {
    Scene2 with_elements = scene(60);
    for (std::size_t k = 0; k < with_elements.surfaces.size(); k += 4) with_elements.surfaces[k].elements = 3;
    const Exact exact(with_elements, granularity);
    EXPECT_TRUE(exact.report().closure_is_exact);
    const std::vector<ElementPair> pairs = all_pairs(exact.matrix());
    const std::vector<RootSum> sums = exact_exchange_measures(exact.prepared(), granularity, pairs);
    std::vector<RootSum> defects = exact_areas(exact.prepared(), granularity);
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      const auto [i, j] = pairs[k];
      EXPECT_GE(sums[k].sign(), 0);
      defects[i] -= sums[k];
      if (j != i && j != exact.matrix().sky()) defects[j] -= sums[k];
    }
    for (std::uint32_t i = 0; i < exact.matrix().size(); ++i) {
      if (!exact.matrix().has_row(i)) continue;
      EXPECT_TRUE(defects[i].is_zero()) << exact.matrix().elements()[i].name << " " << defects[i].to_string();
      double sum = 0;
      for (const FactorEntry& entry : exact.matrix().row(i)) sum += entry.factor.value;
      EXPECT_NEAR(sum, 1, 1e-13);
    }
  }
}

TEST_P(ExactExchange2, IsReciprocal) {
  const Exact exact(scene(100));
  const ExchangeMatrix& matrix = exact.matrix();
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i)) continue;
    for (std::size_t k = 0; k < matrix.row(i).size(); ++k) {
      const FactorEntry& entry = matrix.row(i)[k];
      if (entry.to == matrix.sky() || !matrix.has_row(entry.to)) continue;
      const auto back = matrix.row(entry.to);
      const auto mirrored =
          std::find_if(back.begin(), back.end(), [i](const FactorEntry& other) { return other.to == i; });
      ASSERT_NE(mirrored, back.end());
      EXPECT_EQ(mirrored->visibility, entry.visibility);
      // One measure, the same to the last bit in both rows.
      const double measure = matrix.measures(i)[k];
      EXPECT_EQ(matrix.measures(entry.to)[static_cast<std::size_t>(mirrored - back.begin())], measure);
      EXPECT_NEAR(entry.factor.value * matrix.elements()[i].area.value, measure, 1e-15 * measure);
      EXPECT_NEAR(mirrored->factor.value * matrix.elements()[entry.to].area.value, measure, 1e-15 * measure);
    }
  }
}

// No entry iff the exact sum is zero; rows ascend.
TEST_P(ExactExchange2, ListsExactlyThePairsThatExchangeLight) {
  const Exact exact(scene(60));
  const ExchangeMatrix& matrix = exact.matrix();
  const std::vector<ElementPair> pairs = all_pairs(matrix);
  const std::vector<RootSum> sums = exact_exchange_measures(exact.prepared(), Granularity::kFace, pairs);
  std::map<ElementPair, bool> is_zero;
  for (std::size_t k = 0; k < pairs.size(); ++k) is_zero[pairs[k]] = sums[k].is_zero();
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i)) {
      EXPECT_TRUE(matrix.row(i).empty());
      continue;
    }
    const auto row = matrix.row(i);
    EXPECT_TRUE(std::is_sorted(row.begin(), row.end(), [](const auto& a, const auto& b) { return a.to < b.to; }));
    for (std::uint32_t j = 0; j <= matrix.sky(); ++j) {
      const bool is_listed = std::any_of(row.begin(), row.end(), [j](const auto& entry) { return entry.to == j; });
      EXPECT_EQ(is_listed, !is_zero.at(std::minmax(i, j)));
    }
    for (const FactorEntry& entry : row) {
      EXPECT_GT(entry.factor.value, 0);
      EXPECT_LE(entry.factor.value, 1);
      EXPECT_GT(entry.visibility, 0);
      EXPECT_LE(entry.visibility, 1);
    }
  }
}

// One pair alone is summed about the vertices between the two only.
TEST_P(ExactExchange2, HasTheSameSumsWhateverElseIsAskedFor) {
  for (const char* factor : {"1", "0.1234567890123456789012345678901234567891"}) {
    for (const Granularity granularity : {Granularity::kFace, Granularity::kGroup}) {
      const Rational scale = number(factor);
      // Far from the origin, stretched, and (with the long factor) in large form.
      const Scene2 stretched = moved(scene(40), [&](const Point2& p) -> Point2 {
        return {scale * p.x + 1000 * p.y, p.y + 1000000 * scale * scale};
      });
      const Exact exact(stretched, granularity);
      std::vector<ElementPair> pairs = all_pairs(exact.matrix());
      const std::vector<RootSum> sums = exact_exchange_measures(exact.prepared(), granularity, pairs);
      std::vector<ElementPair> without_sky;
      std::vector<std::size_t> place;
      for (std::size_t k = 0; k < pairs.size(); ++k) {
        if (pairs[k].second == exact.matrix().sky()) continue;
        without_sky.push_back(pairs[k]);
        place.push_back(k);
      }
      const std::vector<RootSum> together = exact_exchange_measures(exact.prepared(), granularity, without_sky);
      for (std::size_t k = 0; k < place.size(); ++k) {
        EXPECT_TRUE((together[k] - sums[place[k]]).is_zero());
        if (k % 7 != 0) continue;
        const std::vector<RootSum> alone =
            exact_exchange_measures(exact.prepared(), granularity, {without_sky[k], without_sky[k]});
        EXPECT_TRUE((alone[0] - sums[place[k]]).is_zero());
        EXPECT_TRUE((alone[1] - sums[place[k]]).is_zero()) << "asked for twice";
      }
    }
  }
}

TEST_P(ExactExchange2, DoesNotDependOnTheNumberOfThreads) {
  const PreparedScene2 prepared = prepare(scene(400));
  std::vector<Printed> results;
  std::vector<ExchangeReport> reports;
  for (const int threads : {1, 2, 3, 7}) {
    const ThreadLimit limit(threads);
    reports.emplace_back();
    results.push_back(printed(exact_exchange(prepared, {}, &reports.back())));
  }
  for (std::size_t k = 1; k < results.size(); ++k) {
    EXPECT_TRUE(results[k] == results[0]);
    EXPECT_EQ(reports[k].tiers, reports[0].tiers);
    EXPECT_EQ(reports[k].terms, reports[0].terms);
  }
}

TEST_P(ExactExchange2, IsInvariantUnderMotionsAndScaling) {
  const Scene2 original = scene(80);
  const Printed expected = printed(original);
  const Rational far = number("9007199254740993"), third = number("1/3");
  const Rational sine = number("3/5"), cosine = number("4/5");
  const auto expect_same = [&](const char* what, const std::function<Point2(const Point2&)>& motion) {
    EXPECT_TRUE(printed(moved(original, motion)) == expected) << what;
  };
  expect_same("translated", [&](const Point2& p) -> Point2 { return {p.x + far, p.y - far}; });
  expect_same("scaled by 2^20", [&](const Point2& p) -> Point2 { return {p.x * 1048576, p.y * 1048576}; });
  expect_same("scaled by 1/3", [&](const Point2& p) -> Point2 { return {p.x * third, p.y * third}; });
  expect_same("turned", [&](const Point2& p) -> Point2 { return {-p.y, p.x}; });
  expect_same("turned by the angle of 3, 4, 5", [&](const Point2& p) -> Point2 {
    return {cosine * p.x - sine * p.y, sine * p.x + cosine * p.y};
  });
  expect_same("scaled by 1e-300", [&](const Point2& p) -> Point2 {
    return {p.x * number("1e-300"), p.y * number("1e-300")};
  });
}

// The mirror image with all edges reversed keeps every front in front.
TEST_P(ExactExchange2, IsInvariantUnderReflection) {
  const Scene2 original = scene(80);
  Scene2 mirrored = moved(original, [](const Point2& p) -> Point2 { return {-p.x, p.y}; });
  for (Edge2& surface : mirrored.edges) std::swap(surface.from, surface.to);
  EXPECT_TRUE(printed(mirrored) == printed(original));
}

std::string other_side(const std::string& name) {
  return name.ends_with(":back") ? name.substr(0, name.size() - 5) : name + ":back";
}

// An edge reversed is the same wall with front and back swapped.
TEST_P(ExactExchange2, IsInvariantUnderReversalOfEdges) {
  Scene2 original = scene(80);
  for (Surface& surface : original.surfaces) surface.back = surface.material;
  Scene2 reversed = original;
  for (std::size_t k = 0; k < reversed.surfaces.size(); k += 2) std::swap(reversed.edges[k].from, reversed.edges[k].to);
  std::map<std::string, bool> is_reversed;
  for (std::size_t k = 0; k < reversed.surfaces.size(); ++k) is_reversed[reversed.surfaces[k].name] = k % 2 == 0;
  const auto rename = [&](const std::string& name) {
    const std::string front = name.ends_with(":back") ? other_side(name) : name;
    return is_reversed.at(front) ? other_side(name) : name;
  };
  EXPECT_TRUE(printed(exact_exchange(prepare(reversed)), rename) == printed(original));
}

// Leaves only edges that share no piece: of a shared one the first listed is the owner.
Scene2 without_overlaps(Scene2 scene) {
  std::vector<char> is_dropped(scene.surfaces.size(), 0);
  const Arrangement2 arrangement(scene, Division2(scene.surfaces.size(), 1));
  for (std::size_t piece = 0; piece < arrangement.pieces().size(); ++piece) {
    const auto sources = arrangement.sources(piece);
    for (std::size_t k = 1; k < sources.size(); ++k) is_dropped[sources[k].surface] = 1;
  }
  std::vector<std::uint32_t> kept;
  for (std::uint32_t k = 0; k < scene.surfaces.size(); ++k)
    if (!is_dropped[k]) kept.push_back(k);
  scene.keep(kept);
  return scene;
}

TEST_P(ExactExchange2, IsInvariantUnderPermutationOfEdges) {
  const Scene2 original = without_overlaps(scene(80));
  ASSERT_GT(original.surfaces.size(), 30u);
  Scene2 shuffled = original;
  std::mt19937_64 random(1);
  std::vector<std::uint32_t> order(original.surfaces.size());
  std::iota(order.begin(), order.end(), 0u);
  std::shuffle(order.begin(), order.end(), random);
  shuffled.keep(order);
  EXPECT_TRUE(printed(shuffled) == printed(original));
}

// S of a face is the sum of S of its elements, as sums of roots.
TEST_P(ExactExchange2, IsTheSumOverElements) {
  Scene2 divided = scene(40);
  for (std::size_t k = 0; k < divided.surfaces.size(); ++k)
    divided.surfaces[k].elements = static_cast<std::uint32_t>(1 + k % 4);
  const Exact faces(divided), elements(divided, Granularity::kElement);
  std::map<std::tuple<std::uint32_t, bool>, std::uint32_t> face_of;
  for (std::uint32_t i = 0; i < faces.matrix().size(); ++i)
    face_of[{faces.matrix().elements()[i].surface, faces.matrix().elements()[i].is_back}] = i;
  const auto face = [&](std::uint32_t element) {
    if (element == elements.matrix().sky()) return faces.matrix().sky();
    const Element& e = elements.matrix().elements()[element];
    return face_of.at({e.surface, e.is_back});
  };
  std::map<ElementPair, RootSum> total;
  const std::vector<ElementPair> parts = all_pairs(elements.matrix());
  const std::vector<RootSum> part_sums = exact_exchange_measures(elements.prepared(), Granularity::kElement, parts);
  for (std::size_t k = 0; k < parts.size(); ++k)
    total[std::minmax(face(parts[k].first), face(parts[k].second))] += part_sums[k];
  const std::vector<ElementPair> wholes = all_pairs(faces.matrix());
  const std::vector<RootSum> sums = exact_exchange_measures(faces.prepared(), Granularity::kFace, wholes);
  for (std::size_t k = 0; k < wholes.size(); ++k) EXPECT_TRUE((sums[k] - total[wholes[k]]).is_zero());
}

// S of two groups is the sum over their faces; a group sees itself, counted once for each direction.
TEST_P(ExactExchange2, IsTheSumOverGroups) {
  const Scene2 grouped = in_groups_of_five(scene(40));
  const Exact faces(grouped), groups(grouped, Granularity::kGroup);
  std::map<std::string, std::uint32_t> number_of;
  for (std::uint32_t i = 0; i < groups.matrix().size(); ++i) number_of[groups.matrix().elements()[i].name] = i;
  const auto group = [&](std::uint32_t i) {
    if (i == faces.matrix().sky()) return groups.matrix().sky();
    const Element& e = faces.matrix().elements()[i];
    return number_of.at(grouped.groups[grouped.surfaces[e.surface].group].name + (e.is_back ? ":back" : ""));
  };
  std::map<ElementPair, RootSum> total;
  std::vector<ElementPair> wholes;
  for (std::uint32_t i = 0; i < faces.matrix().size(); ++i)
    for (std::uint32_t j = i; j <= faces.matrix().sky(); ++j) wholes.emplace_back(i, j);
  const std::vector<RootSum> sums = exact_exchange_measures(faces.prepared(), Granularity::kFace, wholes);
  for (std::size_t k = 0; k < wholes.size(); ++k) {
    const ElementPair pair = std::minmax(group(wholes[k].first), group(wholes[k].second));
    total[pair] += pair.first == pair.second ? sums[k] * Rational(2) : sums[k];
  }
  const bool has_only_whole_rows = std::all_of(grouped.surfaces.begin(), grouped.surfaces.end(),
                                               [](const Surface& s) { return s.back.has_value(); });
  const std::vector<ElementPair> pairs = all_pairs(groups.matrix());
  const std::vector<RootSum> group_sums = exact_exchange_measures(groups.prepared(), Granularity::kGroup, pairs);
  int self = 0;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const auto is_front = [&](std::uint32_t i) {
      return i == groups.matrix().sky() || !groups.matrix().elements()[i].is_back;
    };
    // Black backs among the faces have no rows of their own, so that their sums with each other are not known.
    if (!has_only_whole_rows && !(is_front(pairs[k].first) && is_front(pairs[k].second))) continue;
    EXPECT_TRUE((group_sums[k] - total[pairs[k]]).is_zero());
    self += pairs[k].first == pairs[k].second && !group_sums[k].is_zero();
  }
  EXPECT_TRUE(self > 0 || GetParam() == "plates");
}

std::vector<std::string> kinds() {
  std::vector<std::string> names;
  for (const GeneratorKind2& kind : generator_kinds_2()) names.push_back(kind.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Kinds, ExactExchange2, testing::ValuesIn(kinds()),
                         [](const auto& kind) { return kind.param; });

TEST(ExactExchange2OfGroups, SeesAllOfItselfInAClosedRoom) {
  Scene2 scene = scene_of(room("4"));
  scene.groups = {"room"};
  for (Surface& surface : scene.surfaces) surface.group = 0;
  const Exact exact(scene, Granularity::kGroup);
  EXPECT_EQ(exact.factor("room", "room"), (Rounded{1, 0}));
  EXPECT_EQ(exact.text("room", "room"), "16");
  EXPECT_EQ(exact.visibility("room", "room"), 1);
}

TEST(ExactExchange2OfGroups, SeesWhatAnAngleSeesOfItself) {
  // The inside of a right angle with legs 3 and 4: 2 S = 3 + 4 - 5 in each direction.
  Scene2 scene = scene_of({{"up", "0", "0", "0", "3"}, {"along", "4", "0", "0", "0"}});
  scene.groups = {"angle"};
  for (Surface& surface : scene.surfaces) surface.group = 0;
  const Exact exact(scene, Granularity::kGroup);
  EXPECT_EQ(exact.text("angle", "angle"), "2");
  EXPECT_EQ(exact.text("angle", "sky"), "5");
  EXPECT_EQ(exact.factor("angle", "angle").value, 2.0 / 7);
  EXPECT_EQ(exact.visibility("angle", "angle"), 1);
}

}  // namespace
}  // namespace hottel::exchange_laws_test
