// Matrices that are wrong on purpose: the fault is found and named, and nothing else is.
#include "solver/plane/compare/verdict.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "solver/plane/methods/method_catalogue.h"
#include "tests/solver/plane/judged_matrices.h"

namespace hottel::verdict_test {
namespace {

using testing::Contains;
using testing::HasSubstr;

class VerdictTest : public testing::TestWithParam<bool> {  // printed to 6 decimals, or not
 protected:
  // The one fault explains every pair that is off.
  static void expect_only(Fault fault, const Judged& judged, const Judged::Value& value,
                          const std::string& words = "") {
    const Verdict verdict = judged.judge_it(value, GetParam());
    EXPECT_GT(verdict.off, 0u);
    EXPECT_THAT(faults(verdict), testing::ElementsAre(fault)) << judged.sentences(verdict);
    EXPECT_EQ(verdict.unexplained, 0u) << judged.sentences(verdict);
    EXPECT_THAT(judged.sentences(verdict), HasSubstr(words));
  }
};

const std::function<Scene2()> kScenes[] = {convex_room, apartment, clutter};

TEST_P(VerdictTest, FindsNothingInTheExactMatrix) {
  for (const auto& scene : kScenes) {
    const Judged judged(scene());
    const Verdict verdict = judged.judge_it([](auto, auto, double e) { return e; }, GetParam());
    EXPECT_EQ(verdict.off, 0u);
    EXPECT_EQ(verdict.unsymmetric + verdict.rows_off + verdict.negative + verdict.above_one, 0u);
    EXPECT_THAT(judged.sentences(verdict), testing::StartsWith("all "));
    EXPECT_THAT(judged.sentences(verdict), HasSubstr("reciprocity A_i F_ij = A_j F_ji holds"));
  }
}

TEST_P(VerdictTest, NamesOneWrongPair) {
  for (const auto& scene : kScenes) {
    const Judged judged(scene());
    const auto [a, b] = judged.pair_with([](double vis) { return vis == 1; });
    const auto value = [a = a, b = b](auto i, auto j, double e) { return i == a && j == b ? 0.83 * e : e; };
    const Verdict verdict = judged.judge_it(value, GetParam());
    EXPECT_EQ(verdict.off, 1u);
    EXPECT_EQ(verdict.unexplained, 1u);
    EXPECT_EQ(verdict.unsymmetric, 1u);
    EXPECT_EQ(verdict.rows_off, 1u);
    EXPECT_THAT(judged.sentences(verdict),
                HasSubstr(fmt::format("1 is wrong by no pattern that is known: '{}' to '{}': ",
                                      judged.exact.elements()[a].name, judged.exact.elements()[b].name)));
    EXPECT_THAT(judged.sentences(verdict), HasSubstr("(the factor the other way is right)"));
  }
}

TEST_P(VerdictTest, FindsATransposedMatrixAndATransposedPair) {
  for (const auto& scene : kScenes) {
    const Judged judged(scene());
    const auto transposed = [&](std::uint32_t i, std::uint32_t j) {
      return j != judged.exact.sky() && judged.exact.has_row(j) ? judged.exact.factor(j, i).value : 0;
    };
    expect_only(
        Fault::kTransposed, judged, [&](auto i, auto j, double) { return transposed(i, j); },
        "the matrix is transposed");
    const auto [a, b] = judged.pair_with([](double vis) { return vis > 0; });
    expect_only(
        Fault::kTransposed, judged,
        [&, a = a, b = b](auto i, auto j, double e) {
          return (i == a && j == b) || (i == b && j == a) ? transposed(i, j) : e;
        },
        "factors stand at each other's place");
  }
}

TEST_P(VerdictTest, FindsVisibilityThatIsAllOrNothing) {
  for (const auto& scene : {kScenes[1], kScenes[2]}) {
    const Judged judged(scene());
    const auto decided = [&](std::uint32_t i, std::uint32_t j, double e) {
      const double vis = judged.vis(i, j);
      return j == judged.exact.sky() || vis == 0 || vis == 1 ? e : vis < 0.5 ? 0 : judged.free(i, j);
    };
    expect_only(Fault::kAllOrNothing, judged, decided, "visibility is all or nothing");
    const auto [a, b] = judged.pair_with([](double vis) { return vis > 0.1 && vis < 0.9; });
    for (const double whole : {0.0, judged.free(a, b)})
      expect_only(Fault::kAllOrNothing, judged,
                  [&, a = a, b = b](auto i, auto j, double e) { return i == a && j == b ? whole : e; });
  }
}

TEST_P(VerdictTest, FindsThatNothingHides) {
  for (const auto& scene : {kScenes[1], kScenes[2]}) {
    const Judged judged(scene());
    expect_only(
        Fault::kNoOcclusion, judged,
        [&](auto i, auto j, double e) { return j == judged.exact.sky() ? e : judged.free(i, j); },
        "nothing hides anything");
  }
}

TEST_P(VerdictTest, NamesConstantFactors) {
  const double pi = std::numbers::pi;
  const std::pair<double, const char*> kFactors[] = {
      {pi, "times pi:"},           {1 / pi, "times 1/pi:"},     {2, "times 2:"},
      {0.5, "times 1/2:"},         {-1, "times -1 (the sign)"}, {0.9, "times 0.9"},
      {3.14 / pi, "times 3.14/pi"}};
  for (const auto& scene : kScenes) {
    const Judged judged(scene());
    for (const auto& [factor, words] : kFactors)
      expect_only(
          Fault::kConstantFactor, judged, [factor = factor](auto, auto, double e) { return factor * e; },
          std::string("all factors are the exact ones ") + words);
  }
}

TEST_P(VerdictTest, FindsRowsThatWereRescaled) {
  const Judged judged(box_under_a_lamp());
  const auto to_faces = [&](std::uint32_t i) { return 1 - judged.exact.factor(i, judged.exact.sky()).value; };
  const Verdict verdict = judged.judge_it(
      [&](auto i, auto j, double e) { return j == judged.exact.sky() ? 0 : e / to_faces(i); }, GetParam());
  EXPECT_THAT(faults(verdict), testing::UnorderedElementsAre(Fault::kRowFactor, Fault::kSkyMissing));
  EXPECT_THAT(judged.sentences(verdict), HasSubstr("so that what goes to faces sums to 1 without the sky"));
  EXPECT_EQ(verdict.unexplained, 0u);

  const Judged room(convex_room());
  const auto area = [&](std::uint32_t i) { return room.exact.elements()[i].area.value; };
  expect_only(
      Fault::kAreas, room, [&](auto i, auto, double e) { return area(i) * e; }, "direct exchange areas A F");
  expect_only(
      Fault::kRowFactor, room,
      [&](auto i, auto, double e) { return i == 0   ? e * area(0) / area(2)
                                           : i == 2 ? e * area(2) / area(0)
                                                    : e; },
      "the areas of 'room[0]' and 'room[1]' are exchanged");
  expect_only(
      Fault::kRowFactor, room, [](auto i, auto, double e) { return (1 + 0.01 * i) * e; }, "each by a ratio of its own");
}

TEST_P(VerdictTest, FindsFacesInAnotherOrder) {
  for (const auto& scene : kScenes) {
    const Judged judged(scene());
    std::vector<std::uint32_t> faces;
    for (std::uint32_t i = 0; i < judged.exact.size(); ++i)
      if (judged.exact.has_row(i)) faces.push_back(i);
    const auto n = static_cast<std::uint32_t>(faces.size());
    const auto check = [&](const std::function<std::uint32_t(std::uint32_t)>& place, const std::string& words) {
      std::vector<std::uint32_t> becomes(judged.exact.size() + 1);
      for (std::uint32_t i = 0; i <= judged.exact.sky(); ++i) becomes[i] = i;
      for (std::uint32_t k = 0; k < n; ++k) becomes[faces[k]] = faces[place(k)];
      expect_only(
          Fault::kPermuted, judged,
          [&](auto i, auto j, double) { return judged.exact.factor(becomes[i], becomes[j]).value; }, words);
    };
    check([&](std::uint32_t k) { return n - 1 - k; }, "in another order (reversed)");
    check([&](std::uint32_t k) { return (k + 2) % n; }, "in another order (shifted by 2)");
    check([&](std::uint32_t k) { return k == 1 ? 3 : k == 3 ? 1 : k; }, "in another order (two are exchanged)");
  }
}

TEST_P(VerdictTest, FindsFacesThatAreTurnedAround) {
  Scene2 turned = apartment();
  Scene2 right = turned;
  const std::uint32_t which = 5;
  for (Scene2* scene : {&turned, &right}) scene->surfaces[which].back = scene->surfaces[which].material;
  std::swap(turned.edges[which].from, turned.edges[which].to);
  const Judged judged(right), other(turned);
  const Verdict verdict =
      judged.judge_it([&](auto i, auto j, double) { return other.exact.factor(i, j).value; }, GetParam());
  EXPECT_THAT(faults(verdict), Contains(Fault::kReversed)) << judged.sentences(verdict);
  EXPECT_THAT(judged.sentences(verdict), HasSubstr("the back is taken for the front of"));

  // All edges the other way round, as in a file where y points down: fronts see what backs should.
  Scene2 inside_out = clutter();
  for (Surface& surface : inside_out.surfaces) surface.back = surface.material;
  for (Edge2& edge : inside_out.edges) std::swap(edge.from, edge.to);
  const Judged room(clutter()), reversed(inside_out);
  expect_only(Fault::kReversed, room, [&](auto i, auto j, double) { return reversed.exact.factor(i, j).value; });
}

TEST_P(VerdictTest, FindsWhatIsMissing) {
  const Judged judged(box_under_a_lamp());
  const std::uint32_t sky = judged.exact.sky();
  expect_only(
      Fault::kSkyMissing, judged, [&](auto, auto j, double e) { return j == sky ? 0 : e; }, "nothing goes to the sky");

  const auto pair = judged.pair_with([](double vis) { return vis == 1; });
  const std::uint32_t a = pair.first, b = pair.second;
  const auto without = [&, a = a, b = b](auto i, auto j, double e) { return i == a && j == b ? 0 : e; };
  expect_only(Fault::kMissing, judged, without, "missing or 0");
  expect_only(
      Fault::kMissing, judged, [](auto, auto, double) { return 0.0; }, "missing or 0");

  const auto with_rest = [&](auto i, auto j, double e) {
    return j == sky ? e + (i == a ? judged.exact.factor(a, b).value : 0) : without(i, j, e);
  };
  const Verdict verdict = judged.judge_it(with_rest, GetParam());
  EXPECT_THAT(faults(verdict), testing::ElementsAre(Fault::kSkyIsRest, Fault::kMissing)) << judged.sentences(verdict);
}

TEST_P(VerdictTest, FindsLightWhereFacesDoNotFaceEachOther) {
  const Judged judged(clutter());
  std::uint32_t hidden = 0;
  while (judged.exact.factor(0, hidden).value > 0 || judged.free(0, hidden) > 0 || hidden == 0) ++hidden;
  expect_only(Fault::kBehind, judged, [&](auto i, auto j, double e) { return i == 0 && j == hidden ? 0.0123 : e; });
}

// One matrix with three faults in different places: each is found, and named by its pair.
TEST_P(VerdictTest, TellsApartFaultsThatStandTogether) {
  const Judged judged(apartment());
  const auto [a, b] = judged.pair_with([](double vis) { return vis == 1; });
  const auto [c, d] = judged.pair_with([](double vis) { return vis > 0.1 && vis < 0.9; });
  std::uint32_t e = 0, f = 0;
  for (std::uint32_t i = 0; i < judged.exact.size(); ++i)
    for (std::uint32_t j = 0; j < judged.exact.size(); ++j)
      if (judged.exact.has_row(i) && judged.exact.factor(i, j).value > 0.05 && i != a && i != b && i != c && i != d)
        e = i, f = j;
  const double free = judged.free(c, d);
  const Verdict verdict = judged.judge_it(
      [&, a = a, b = b, c = c, d = d](auto i, auto j, double x) {
        if ((i == a && j == b) || (i == b && j == a)) return judged.exact.factor(j, i).value;
        if (i == c && j == d) return free;
        return i == e && j == f ? 0.93 * x : x;
      },
      GetParam());
  EXPECT_EQ(verdict.off, 4u);
  EXPECT_THAT(faults(verdict), testing::ElementsAre(Fault::kTransposed, Fault::kAllOrNothing));
  EXPECT_EQ(verdict.unexplained, 1u);
  for (const std::uint32_t i : {a, b, c, d, e, f})
    EXPECT_THAT(judged.sentences(verdict), HasSubstr("'" + judged.exact.elements()[i].name + "'"));
}

TEST_P(VerdictTest, CountsFactorsBelowZeroAndAboveOne) {
  const Judged judged(convex_room());
  const Verdict verdict = judged.judge_it(
      [](auto i, auto j, double e) { return i == 0 && j == 2   ? -0.5
                                            : i == 2 && j == 0 ? 1.25
                                                               : e; }, GetParam());
  EXPECT_EQ(verdict.negative, 1u);
  EXPECT_EQ(verdict.above_one, 1u);
  EXPECT_THAT(judged.sentences(verdict), HasSubstr("1 factor is negative, to -0.5; 1 factor exceeds 1, to 1.25"));
}

INSTANTIATE_TEST_SUITE_P(Written, VerdictTest, testing::Bool(),
                         [](const auto& is_printed) { return is_printed.param ? "ToSixDecimals" : "InFull"; });

TEST(Verdict, FindsIndicesThatAreShifted) {
  const Judged judged(clutter());
  const std::uint32_t n = judged.exact.size() + 1;  // the sky among them
  const auto exact = [&](std::uint32_t i, std::uint32_t j) {
    return i == judged.exact.sky() ? 0 : judged.exact.factor(i, j).value;
  };
  const auto said = [&](const Judged::Value& value, Fault fault) {
    const Verdict verdict = judged.judge_it(value, false);
    EXPECT_EQ(faults(verdict), std::vector{fault}) << judged.sentences(verdict);
    return judged.sentences(verdict);
  };
  EXPECT_THAT(said([&](auto i, auto j, double) { return exact((i + n - 1) % n, (j + n - 1) % n); }, Fault::kShifted),
              HasSubstr("indices are shifted, rows and columns by 1"));
  EXPECT_THAT(said([&](auto i, auto j, double) { return exact(i, (j + n - 1) % n); }, Fault::kShifted),
              HasSubstr("only the columns by 1"));
  EXPECT_THAT(said([&](auto i, auto j, double) { return exact((i + 1) % n, j); }, Fault::kShifted),
              HasSubstr("only the rows by 1"));
}

TEST(Verdict, FindsRowsOrColumnsInAnotherOrder) {
  const Judged judged(convex_room());
  const std::vector<std::uint32_t> order = {3, 0, 4, 1, 2};
  std::vector<std::uint32_t> rows;
  for (std::uint32_t i = 0; i < judged.exact.size(); ++i)
    if (judged.exact.has_row(i)) rows.push_back(i);
  ASSERT_EQ(rows.size(), order.size());
  const auto moved = [&](std::uint32_t i) {
    const auto found = std::find(rows.begin(), rows.end(), i);
    return found == rows.end() ? i : rows[order[static_cast<std::size_t>(found - rows.begin())]];
  };
  for (const bool is_of_rows : {true, false}) {
    const Verdict verdict = judged.judge_it(
        [&](auto i, auto j, double) {
          return is_of_rows ? judged.exact.factor(moved(i), j).value : judged.exact.factor(i, moved(j)).value;
        },
        false);
    EXPECT_EQ(faults(verdict), std::vector{is_of_rows ? Fault::kRowsPermuted : Fault::kColumnsPermuted})
        << judged.sentences(verdict);
    EXPECT_THAT(judged.sentences(verdict), HasSubstr(is_of_rows ? "only the rows are" : "only the columns are"));
  }
}

TEST(Verdict, FindsOneTriangleAlone) {
  const Judged judged(clutter());
  const Verdict verdict = judged.judge_it([](auto i, auto j, double e) { return j > i ? 0 : e; }, false);
  EXPECT_THAT(judged.sentences(verdict), HasSubstr("only one triangle of the matrix is there, the lower one"));
}

TEST(Verdict, FindsFactorsOfAnApproximateMethod) {
  const Judged judged(apartment());
  for (const auto& [name, words] :
       {std::pair("center", "factors are those between centres; visibility is all or nothing"),
        std::pair("vertices", "factors are the means over pairs of corners; visibility is all or nothing"),
        std::pair("gauss:2", "as `gauss:2` gives")}) {
    MethodReport report;
    const ExchangeMatrix matrix = methods_2().make(name)->compute(judged.prepared, {.wants_visibility = false}, report);
    const Verdict verdict = judge(judged.prepared, judged.exact, matrix, {});
    EXPECT_EQ(faults(verdict).at(0), Fault::kMethod) << judged.sentences(verdict);
    EXPECT_THAT(judged.sentences(verdict), HasSubstr(words));
  }
}

TEST(Verdict, NamesNoReadingOfFewerPairsThanItsShare) {
  const Judged judged(clutter());
  // Every factor is wrong by a ratio of its own, but for one that is missing.
  const auto [a, b] = judged.pair_with([](double vis) { return vis == 1; });
  const auto ratio = [](std::uint32_t i, std::uint32_t j) {
    return 1.1 + 0.4 * std::fmod(i * 0.7548776662466927 + j * 0.5698402909980532, 1.0);
  };
  const Verdict verdict = judged.judge_it(
      [&, a = a, b = b](auto i, auto j, double e) { return i == a && j == b ? 0 : e * ratio(i, j); }, false);
  EXPECT_TRUE(verdict.findings.empty()) << judged.sentences(verdict);
  EXPECT_THAT(judged.sentences(verdict), HasSubstr("readings of fewer than 2 % of the pairs are not named"));
}

TEST(Verdict, RowsThatTheFileDoesNotHaveAreNotJudged) {
  const Judged judged(apartment());
  VerdictOptions options;
  options.written.has_row.assign(judged.exact.size(), 1);
  options.written.has_row[0] = options.written.has_row[7] = 0;
  const Verdict verdict =
      judge(judged.prepared, judged.exact,
            judged.changed([&](auto i, auto, double e) { return options.written.has_row[i] ? e : 0; }), options);
  EXPECT_EQ(verdict.off + verdict.rows_off + verdict.unsymmetric, 0u) << judged.sentences(verdict);
}

TEST(Verdict, DigitsThatWereNotWrittenAreNoErrors) {
  const Judged judged(clutter());
  const auto rounded = judged.changed([](auto, auto, double e) { return std::stod(fmt::format("{:.4f}", e)); });
  VerdictOptions options;
  EXPECT_GT(judge(judged.prepared, judged.exact, rounded, options).off, 0u);
  options.written.digits = {4, 4, 0};
  EXPECT_EQ(judge(judged.prepared, judged.exact, rounded, options).off, 0u);
}

TEST(Verdict, ColumnsThatTheFileDoesNotHaveAreNotJudged) {
  const Judged judged(box_under_a_lamp());
  VerdictOptions options;
  options.written.digits.relative = 1e-16;
  for (std::uint32_t j = 0; j <= judged.exact.sky(); ++j)
    options.written.has_column.push_back(j != judged.exact.sky() && judged.exact.has_row(j));
  const auto radiating = judged.changed([&](auto, auto j, double e) { return options.written.has_column[j] ? e : 0; });
  const Verdict verdict = judge(judged.prepared, judged.exact, radiating, options);
  EXPECT_EQ(verdict.off, 0u) << judged.sentences(verdict);
  EXPECT_EQ(verdict.rows_off, 0u);
}

}  // namespace
}  // namespace hottel::verdict_test
