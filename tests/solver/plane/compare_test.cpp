// How far matrices are from the exact one, what methods take, and what is read off: on matrices made by hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>

#include "geometry/plane/exchange/exchange.h"
#include "io/scene/scene_json.h"
#include "solver/compare/face_means.h"
#include "solver/compare/matrix_errors.h"
#include "solver/compare/timing.h"
#include "solver/compare/work_precision.h"
#include "solver/plane/compare/method_comparison.h"
#include "solver/plane/compare/pair_explanation.h"
#include "solver/plane/methods/method_catalogue.h"
#include "tests/solver/dimensions.h"

namespace hottel::compare_test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

using Rows = std::vector<std::map<std::uint32_t, double>>;

// A matrix of as many elements as rows, each of length 1 and with a material; the column after the last is the sky.
ExchangeMatrix matrix_of(const Rows& rows) {
  std::vector<Element> elements(rows.size());
  std::vector<std::size_t> begin{0};
  std::vector<FactorEntry> entries;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    elements[i].name = "face" + std::to_string(i);
    elements[i].material = 0;
    elements[i].area = {1, 0};
    for (const auto& [to, value] : rows[i]) entries.push_back({to, {value, 0}});
    begin.push_back(entries.size());
  }
  ExchangeMatrix matrix(elements, Guarantee::kEstimated);
  matrix.assign(begin, entries);
  return matrix;
}

const Rows kExactRows = {{{1, 0.5}, {2, 0.5}}, {{0, 0.5}, {1, 0.25}, {2, 0.25}}};  // 2 is the sky

TEST(MatrixErrors, AreZeroForTheExactMatrix) {
  const ExchangeMatrix exact = matrix_of(kExactRows);
  const MatrixErrors errors = matrix_errors(exact, exact);
  EXPECT_EQ(errors.max, 0);
  EXPECT_EQ(errors.rms, 0);
  EXPECT_EQ(errors.closure, 0);
  EXPECT_EQ(errors.pairs, 5u);
  EXPECT_TRUE(worst_pairs(exact, exact, 10).empty());
}

TEST(MatrixErrors, CountPairsPresentInEitherMatrixAndNoOthers) {
  // One factor missing (0 for 0.25), one too many (0.125 for 0), one wrong by 1/8, two right; an explicit zero that
  // the exact matrix does not have is no pair.
  const ExchangeMatrix exact = matrix_of(kExactRows);
  const ExchangeMatrix matrix = matrix_of({{{0, 0.0}, {1, 0.625}, {2, 0.5}}, {{0, 0.5}, {2, 0.25}}});
  const MatrixErrors errors = matrix_errors(matrix, exact);
  EXPECT_EQ(errors.pairs, 5u);
  EXPECT_EQ(errors.max, 0.25);
  EXPECT_DOUBLE_EQ(errors.rms, std::sqrt((0.125 * 0.125 + 0.25 * 0.25) / 5));
  EXPECT_EQ(errors.closure, 0.25);

  const MatrixErrors with_more = matrix_errors(matrix_of({{{0, 0.125}, {1, 0.5}, {2, 0.5}}, kExactRows[1]}), exact);
  EXPECT_EQ(with_more.pairs, 6u);
  EXPECT_EQ(with_more.max, 0.125);
  EXPECT_DOUBLE_EQ(with_more.rms, 0.125 / std::sqrt(6));
}

TEST(MatrixErrors, AreInfiniteWhereAFactorIsNoFiniteNumber) {
  const ExchangeMatrix exact = matrix_of(kExactRows);
  for (const double bad : {kInfinity, std::nan("")}) {
    const MatrixErrors errors = matrix_errors(matrix_of({{{1, bad}, {2, 0.5}}, kExactRows[1]}), exact);
    EXPECT_EQ(errors.max, kInfinity);
    EXPECT_EQ(errors.rms, kInfinity);
  }
}

TEST(MatrixErrors, LeaveOutWhatHasNoPlaceAndTellItApart) {
  const ExchangeMatrix exact = matrix_of(kExactRows);
  const ExchangeMatrix matrix = matrix_of({{{1, 0.25}}, {{0, 0.5}}});
  WrittenFactors places;
  places.has_column = {1, 1, 0};
  MatrixErrors errors = matrix_errors(matrix, exact, places);
  EXPECT_EQ(errors.pairs, 3u);
  EXPECT_EQ(errors.max, 0.25);
  EXPECT_EQ(errors.max_of_others, 0.25);
  EXPECT_EQ(errors.closure, 0.25) << "of the columns there are";
  EXPECT_EQ(errors.missing.columns, std::vector<std::uint32_t>{2});
  EXPECT_EQ(errors.missing.pairs, 1u);
  EXPECT_EQ(errors.missing.largest, 0.25);
  EXPECT_EQ(worst_pairs(matrix, exact, 10, places).size(), 2u);

  places.has_row = {0, 1};
  errors = matrix_errors(matrix, exact, places);
  EXPECT_EQ(errors.pairs, 2u);
  EXPECT_EQ(errors.max_of_others, 0);
  EXPECT_EQ(errors.missing.rows, std::vector<std::uint32_t>{0});
  EXPECT_EQ(missing_sentences(errors, exact).size(), 3u);

  places.has_row = {0, 0};
  errors = matrix_errors(matrix, exact, places);
  EXPECT_TRUE(std::isnan(errors.max) && std::isnan(errors.rms) && std::isnan(errors.closure));
}

TEST(MatrixErrors, OfTinySizeDoNotUnderflow) {
  const MatrixErrors errors = matrix_errors(matrix_of({{{0, 1e-200}}}), matrix_of({{{0, 3e-200}}}));
  EXPECT_DOUBLE_EQ(errors.rms, 2e-200);
}

TEST(WorstPairs, AreTheLargestErrorsInOrder) {
  Rows exact(1), found(1);
  const std::vector<int> errors = {3, 1, 4, 1, 5, 9, 2, 6, 5, 3};
  for (std::uint32_t k = 0; k < errors.size(); ++k) {
    exact[0][k] = 100;
    found[0][k] = 100 + (k % 2 == 0 ? 1 : -1) * errors[k];
  }
  for (Rows* rows : {&exact, &found}) rows->resize(errors.size());
  std::vector<std::uint32_t> order;
  for (const PairError& pair : worst_pairs(matrix_of(found), matrix_of(exact), 5)) order.push_back(pair.to);
  EXPECT_THAT(order, ::testing::ElementsAre(5, 7, 4, 8, 2));
  EXPECT_TRUE(worst_pairs(matrix_of(found), matrix_of(exact), 0).empty());
  EXPECT_EQ(worst_pairs(matrix_of(found), matrix_of(exact), 100).size(), errors.size());
}

TEST(FaceMeans, AreWeightedByAreaAndComparedByTheLargest) {
  std::vector<Element> elements(3);
  elements[0].surface = elements[1].surface = 0;
  elements[2].surface = 1;
  elements[2].is_back = true;
  const double areas[] = {1, 3, 2};
  for (std::size_t i = 0; i < 3; ++i) {
    elements[i].material = 0;
    elements[i].area = {areas[i], 0};
  }
  ExchangeMatrix matrix(elements, Guarantee::kEstimated);
  RadiositySolution solution;
  solution.channels.resize(1);
  solution.channels[0].elements.resize(3);
  const double radiosities[] = {4, 8, 1};
  for (std::size_t i = 0; i < 3; ++i) solution.channels[0].elements[i].radiosity = radiosities[i];
  const FaceMeans means = face_mean_radiosities(matrix, solution);
  EXPECT_EQ(means.at(0), (std::vector<std::optional<double>>{7, std::nullopt, std::nullopt, 1}));
  EXPECT_EQ(face_mean_error(means, means), 0);
  FaceMeans finer = means;
  finer[0][3] = 3;
  finer[0][0] = 8;
  EXPECT_EQ(face_mean_error(means, finer), 0.25);
}

// A computation whose runs take what it is told, the last one for ever.
std::function<double()> taking(std::vector<double> seconds, int& runs) {
  return
      [seconds, &runs] { return seconds[std::min<std::size_t>(static_cast<std::size_t>(runs++), seconds.size() - 1)]; };
}

TEST(Timing, DoesNotCountTheWarmUp) {
  int runs = 0;
  const Timing timing = time_repeatedly(taking({0.9, 0.3, 0.1, 0.2}, runs));
  EXPECT_EQ(runs, 4);
  EXPECT_EQ(timing.runs, 3);
  EXPECT_EQ(timing.median, 0.2);
  EXPECT_EQ(timing.fastest, 0.1);
  EXPECT_EQ(timing.slowest, 0.3);
}

TEST(Timing, GoesOnForHalfASecondOrAThousandRuns) {
  int runs = 0;
  EXPECT_EQ(time_repeatedly(taking({0.0625}, runs)).runs, 8);
  runs = 0;
  EXPECT_EQ(time_repeatedly(taking({0}, runs)).runs, 1000);
}

TEST(Timing, RunsWhatIsSlowAsSeldomAsItMay) {
  int runs = 0;
  EXPECT_EQ(time_repeatedly(taking({20}, runs)).runs, 1);
  EXPECT_EQ(runs, 1);
  runs = 0;
  EXPECT_EQ(time_repeatedly(taking({2}, runs)).runs, 3);
  EXPECT_EQ(runs, 3);
}

TEST(Timing, RepeatsAsOftenAsAskedAndTakesTheMiddleOfAnEvenNumber) {
  int runs = 0;
  const Timing timing = time_repeatedly(taking({5, 1, 4, 2, 8}, runs), 4);
  EXPECT_EQ(runs, 5);
  EXPECT_EQ(timing.runs, 4);
  EXPECT_EQ(timing.median, 3);
}

const std::vector<WorkPoint> kCurve = {{"m:1", 1, 1e-1}, {"m:2", 10, 1e-3}, {"m:3", 30, 1e-2}, {"m:4", 100, 1e-4}};

TEST(SecondsToReach, AreInterpolatedInLogarithms) {
  EXPECT_DOUBLE_EQ(*seconds_to_reach(kCurve, 1e-2), std::sqrt(10));
  EXPECT_DOUBLE_EQ(*seconds_to_reach(kCurve, 1e-3), 10);
}

TEST(SecondsToReach, PassOverPointsThatACheaperOneBeats) {
  EXPECT_DOUBLE_EQ(*seconds_to_reach(kCurve, std::pow(10, -3.5)), std::sqrt(1000));
}

TEST(SecondsToReach, AreTheCheapestPointsAtLeastAndNothingBeyondTheBest) {
  EXPECT_EQ(seconds_to_reach(kCurve, 0.5), 1);
  EXPECT_EQ(seconds_to_reach(kCurve, 1e-5), std::nullopt);
  EXPECT_EQ(seconds_to_reach({}, 1), std::nullopt);
}

TEST(SecondsToReach, JumpWhereAnErrorIsZeroOrInfinite) {
  EXPECT_EQ(seconds_to_reach(std::array{WorkPoint{"a", 1, 0.5}, WorkPoint{"b", 7, 0}}, 1e-9), 7);
  EXPECT_EQ(seconds_to_reach(std::array{WorkPoint{"a", 1, kInfinity}, WorkPoint{"b", 7, 1e-9}}, 1e-3), 7);
}

TEST(WorkReading, NamesTheCheapestFamilyAndTheFactor) {
  const std::vector<WorkCurve> curves = {{"exact", {{"exact", 4, 0}}},
                                         {"m", kCurve},
                                         {"n", {{"n", 2, 0.1}}},
                                         {"slow", {{"slow", 1e3, 1e-6}}},
                                         {"exact:normalised", {{"exact:normalised", 1, 1e-16}}},
                                         {"arithmetic:doubles", {{"arithmetic:doubles", 1, 1e-15}}}};
  const auto readings = read_off(curves, std::array{1e-2, 1e-3, 1e-6, 1e-9});
  ASSERT_EQ(readings.size(), 4u);
  EXPECT_EQ(readings[0].family, "m");
  EXPECT_EQ(readings[1].seconds, 10);
  EXPECT_EQ(readings[2].family, "slow");
  EXPECT_EQ(readings[3].family, "");
  EXPECT_EQ(
      to_sentence(readings[0]),
      "at an error of 0.01 exact (4 s) is 1.26 times slower than the cheapest method that reaches it, m (3.16 s)");
  EXPECT_EQ(to_sentence(readings[1]),
            "at an error of 0.001 exact (4 s) is 2.5 times faster than the cheapest method that reaches it, m (10 s)");
  EXPECT_EQ(to_sentence(readings[3]),
            "at an error of 1e-09 exact (4 s) stands alone: no other method that is timed reaches it");
  EXPECT_TRUE(read_off(std::span(curves).subspan(1), std::array{0.1}).empty());
  EXPECT_TRUE(read_off(std::span(curves).first(1), std::array{0.1}).empty()) << "exact alone";
}

TEST(MethodComparison2, FindsNothingWrongWithTheExactMethod) {
  const MethodComparison2 comparison{Simulation2(PlaneTests::furnace("0.5"))};
  const MethodResult result = comparison.run(*methods_2().make("exact"), 1);
  EXPECT_EQ(result.errors.max, 0);
  EXPECT_EQ(result.max_radiosity_error, 0);
  EXPECT_GT(result.timing.median, 0);
  EXPECT_EQ(result.declared_error, 0);
}

// A unit square that a screen without a back divides in two.
TEST(PairExplanation, TellsHowMuchIsHiddenHowFarAndAtWhatAngle) {
  const PreparedScene2 prepared =
      prepare(parse_scene_2(R"({"hottel":1,"dimension":2,"materials":{"m":{"reflectivity":0.5}},
    "polylines":[{"name":"room","points":[[0,0],[0,1],[1,1],[1,0]],"closed":true,"material":"m"}],
    "edges":[{"name":"screen","points":[[0.5,0],[0.5,1]],"material":"m"}]})",
                            "divided"),
              Divided2::kYes);
  const ExchangeMatrix exact = exact_exchange(prepared, {.granularity = Granularity::kElement});
  const PairExplainer2 explainer(prepared, exact);
  const auto element = [&](const char* name) { return *exact.find(name); };
  const auto explain = [&](const char* from, const char* to, double value) {
    const std::uint32_t i = element(from), j = std::string(to) == "sky" ? exact.sky() : element(to);
    return explainer.explain({i, j, value, exact.factor(i, j).value});
  };

  const PairExplanation hidden = explain("room[0]", "room[2]", 0.1);  // the left and the right wall
  EXPECT_EQ(hidden.visibility, 0);
  EXPECT_EQ(hidden.distance, 1);
  EXPECT_DOUBLE_EQ(*hidden.angle, 180);
  EXPECT_EQ(hidden.reason, "hidden, far, light where there is none");

  const PairExplanation partly = explain("room[1]", "room[3]", 0);
  EXPECT_GT(*partly.visibility, 0);
  EXPECT_LT(*partly.visibility, 1);
  EXPECT_EQ(partly.reason, "partly hidden, far, missed");

  const PairExplanation corner = explain("room[0]", "room[1]", 0.25);
  EXPECT_DOUBLE_EQ(*corner.angle, 90);
  EXPECT_DOUBLE_EQ(*corner.distance, std::sqrt(0.5));
  EXPECT_EQ(corner.reason, "partly hidden, touching");

  const PairExplanation itself = explain("room[0]", "room[0]", 0.25);
  EXPECT_EQ(itself.visibility, std::nullopt);
  EXPECT_EQ(itself.reason, "they do not face each other, touching, light where there is none");

  const PairExplanation sky = explain("room[0]", "sky", 0.25);
  EXPECT_EQ(sky.distance, std::nullopt);
  EXPECT_EQ(sky.reason, "hidden toward the sky, light where there is none");
}

}  // namespace
}  // namespace hottel::compare_test
