// Methods held against the exact one in space.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "io/external/space/external_matrix.h"
#include "io/scene/scene_json.h"
#include "solver/compare/verdict.h"
#include "solver/space/compare/method_comparison.h"
#include "solver/space/compare/pair_explanation.h"
#include "solver/space/compare/verdict.h"

namespace hottel::compare_test {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::StartsWith;

const MethodComparison3& comparison() {
  static const MethodComparison3 made(
      Simulation3(read_scene_3(std::string(HOTTEL_SOURCE_DIR) + "/scenes/space/two_boxes.json")));
  return made;
}

TEST(MethodComparison3, TellsNoErrorSmallerThanThatOfTheReference) {
  const ReferenceErrors& reference = comparison().reference();
  EXPECT_GT(reference.max, 0);
  EXPECT_LE(reference.max, 1e-9);
  EXPECT_LE(reference.rms, reference.max);
  const MethodResult exact = comparison().run(*all_methods_3().make("exact"), 1);
  EXPECT_EQ(exact.errors.max, reference.max);
  EXPECT_EQ(exact.errors.rms, reference.rms);
  EXPECT_LT(exact.errors.closure, 1e-12);
  ASSERT_TRUE(exact.max_radiosity_error.has_value());
  EXPECT_EQ(*exact.max_radiosity_error, reference.radiosity);
  const MethodResult center = comparison().run(*all_methods_3().make("points:2"), 1);
  EXPECT_GT(center.errors.max, 1e-4);
  EXPECT_GT(*center.max_radiosity_error, reference.radiosity);
}

TEST(PairExplainer3, SaysWhyAPairIsHard) {
  const PairExplainer3 explainer(comparison().prepared(), comparison().exact());
  const ExchangeMatrix& exact = comparison().exact();
  const auto explain = [&](const std::string& from, const std::string& to, double value) {
    const std::uint32_t i = *exact.find(from), j = *exact.find(to);
    return explainer.explain({i, j, value, exact.factor(i, j).value});
  };
  const PairExplanation walls = explain("left", "right", 0.1);
  EXPECT_THAT(walls.reason, StartsWith("partly hidden, "));
  EXPECT_NEAR(*walls.distance, 5.5, 1e-12);
  EXPECT_NEAR(*walls.angle, 180, 1e-12);
  EXPECT_THAT(explain("left", "floor", 0).reason, HasSubstr("touching, missed"));
  EXPECT_EQ(explain("low.side_1", "low.side_2", 0).reason, "they do not face each other, touching");
  const PairExplanation sky = explain("left", "sky", 0.5);
  EXPECT_EQ(sky.reason, "hidden toward the sky, light where there is none");
  EXPECT_FALSE(sky.distance.has_value());
}

// The exact matrix with one mistake that others make, as if it were read from a file.
TEST(Verdict3, NamesWhatIsWrong) {
  const ExchangeMatrix& exact = comparison().exact();
  const auto judged = [&](auto change) {
    std::vector<std::size_t> begin{0};
    std::vector<FactorEntry> entries;
    for (std::uint32_t i = 0; i < exact.size(); ++i) {
      for (const FactorEntry& entry : exact.row(i)) entries.push_back({entry.to, {change(entry), 0}, entry.visibility});
      begin.push_back(entries.size());
    }
    ExchangeMatrix matrix(exact.elements(), Guarantee::kEstimated);
    matrix.assign(begin, entries);
    WrittenFactors written;
    written.digits.relative = 0x1p-53;
    const Verdict verdict = judge(comparison().prepared(), exact, matrix, {.beyond = 1e-6, .written = written});
    return verdict_sentences(verdict, exact);
  };
  EXPECT_THAT(judged([](const FactorEntry& entry) { return entry.factor.value * std::numbers::pi; }),
              Contains(HasSubstr("pi")));
  // Occlusion forgotten.
  EXPECT_THAT(
      judged([](const FactorEntry& entry) {
        return entry.visibility > 0 ? entry.factor.value / entry.visibility : entry.factor.value;
      }),
      Contains(HasSubstr("visibility is all or nothing: of partly hidden pairs 85 are taken as wholly visible")));
}

}  // namespace
}  // namespace hottel::compare_test
