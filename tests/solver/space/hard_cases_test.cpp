// The hard cases of docs/hard_cases_in_space.md, at some of their decades: what the exact method promises holds, and
// others lose what is small.
#include <gtest/gtest.h>

#include <string>

#include "benchmarks/reports/space/hard_scenes.h"
#include "geometry/space/exchange/exchange.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "io/scene/scene_json.h"
#include "solver/space/methods/method_catalogue.h"

namespace hottel::hard_cases_test {
namespace {

TEST(ContourMeasure, MeetsHowellsCatalogue) {
  const std::vector<LongPoint> low{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const std::vector<LongPoint> high{{0, 0, 1}, {0, 1, 1}, {1, 1, 1}, {1, 0, 1}};
  const std::vector<LongPoint> side{{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}};
  const auto error = [](const LongReal& value, const char* truth) {
    return abs(LongReal(value - LongReal(truth))).convert_to<double>();
  };
  EXPECT_LT(error(contour_measure(low, high), "0.1998248956983873830416"), 1e-22);
  EXPECT_LT(error(contour_measure(low, side), "0.2000437760754031542396"), 1e-22);
  EXPECT_LT(error(contour_measure(side, low), "0.2000437760754031542396"), 1e-22);
}

// Sides that lie askew are integrated: a square cut in two triangles has the same measure, and theirs are such sides.
TEST(ContourMeasure, IsAdditiveWhereSidesLieAskew) {
  const std::vector<LongPoint> low{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const LongReal whole = contour_measure(low, {{0, 0, 2}, {0, 1, 2}, {1, 1, 2}, {1, 0, 2}});
  const LongReal parts =
      contour_measure(low, {{0, 0, 2}, {0, 1, 2}, {1, 1, 2}}) + contour_measure(low, {{0, 0, 2}, {1, 1, 2}, {1, 0, 2}});
  EXPECT_LT(abs(LongReal(whole - parts)).convert_to<double>(), 1e-55);
}

ExchangeMatrix by(const std::string& method, const HardScene3& scene, const Rational& d) {
  MethodReport report;
  return methods_3().make(method)->compute(prepare(parse_scene_3(hard_scene_json(scene, d), scene.name)),
                                           {.granularity = scene.granularity, .wants_visibility = false}, report);
}

const HardScene3& scene_called(const std::string& name) {
  for (const HardScene3& scene : hard_scenes_3())
    if (scene.name == name) return scene;
  throw std::runtime_error(name);
}

class EveryHardCase3 : public testing::TestWithParam<std::string> {};

TEST_P(EveryHardCase3, TheExactFactorIsWithinItsBoundsAndItsToleranceAndIsNotLost) {
  const HardScene3& scene = scene_called(GetParam());
  for (const int k : {1, 2, 3, 5, 8, 12, 16, 23, 31}) {
    SCOPED_TRACE(k);
    const Rational d = hard_parameter(scene, k);
    const LongReal factor = scene.factor(d);
    const ExchangeMatrix matrix = by("exact", scene, d);
    const std::uint32_t from = matrix.find(scene.from).value(), to = matrix.find(scene.to).value();
    bool is_there = false;
    for (std::size_t n = 0; n < matrix.row(from).size(); ++n) {
      if (matrix.row(from)[n].to != to) continue;
      is_there = true;
      EXPECT_LE(LongReal(matrix.bounds(from, n).lower), factor);
      EXPECT_GE(LongReal(matrix.bounds(from, n).upper), factor);
      EXPECT_LE(hard_errors(matrix.row(from)[n].factor.value, factor).absolute, 1e-11);
    }
    EXPECT_TRUE(is_there);
  }
}

std::vector<std::string> names() {
  std::vector<std::string> result;
  for (const HardScene3& scene : hard_scenes_3()) result.push_back(scene.name);
  return result;
}

INSTANTIATE_TEST_SUITE_P(, EveryHardCase3, testing::ValuesIn(names()), [](const auto& test) { return test.param; });

TEST(HardCases3, AtZeroThereIsNothingAtAll) {
  for (const char* name : {"door", "wall", "kink"}) {
    const HardScene3& scene = scene_called(name);
    EXPECT_TRUE(scene.has_end);
    const ExchangeMatrix matrix = by("exact", scene, 0);
    for (const FactorEntry& entry : matrix.row(matrix.find(scene.from).value()))
      EXPECT_NE(matrix.name(entry.to), scene.to) << name;
  }
}

// Of each the sky is seen past the other, which hides next to nothing of it: that is bounded, not integrated.
TEST(HardCases3, PlatesFarApartSeeTheSkyWithinProvenBounds) {
  const HardScene3& scene = scene_called("far");
  for (const int k : {6, 9, 12, 15}) {
    const ExchangeMatrix matrix = by("exact", scene, hard_parameter(scene, k));
    for (const std::string name : {"lower", "upper"}) {
      const std::uint32_t i = matrix.find(name).value();
      ASSERT_EQ(matrix.row(i).size(), 2u);
      const LongReal truth = 1 - scene.factor(hard_parameter(scene, k));
      const Enclosure bounds = matrix.bounds(i, 1);
      EXPECT_EQ(matrix.row(i)[1].to, matrix.sky());
      EXPECT_LE(LongReal(bounds.lower), truth) << k;
      EXPECT_GE(LongReal(bounds.upper), truth) << k;
      EXPECT_LE(bounds.width(), 1e-9) << k;
    }
  }
}

// Through a gap of a hundred-millionth the exact method sees four digits with its tolerance as it is; others none, or
// what is not there.
TEST(HardCases3, OtherMethodsLoseWhatIsSmall) {
  const HardScene3& door = scene_called("door");
  const Rational d = hard_parameter(door, 8);
  const auto error = [&](const std::string& method) {
    return hard_errors(by(method, door, d).factor(door.from, door.to).value, door.factor(d)).relative;
  };
  EXPECT_LT(error("exact"), 1e-3);
  for (const char* method : {"center", "vertices", "gauss:4", "points:4", "hemicube:256", "rays:16384:sobol"})
    EXPECT_GT(error(method), 0.1) << method;
  EXPECT_GT(error("center-vis"), 0.01);
}

}  // namespace
}  // namespace hottel::hard_cases_test
