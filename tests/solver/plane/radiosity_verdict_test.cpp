// Radiosities that are wrong on purpose: what stands for them is named.
#include "solver/compare/radiosity_verdict.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <numbers>

#include "geometry/plane/exchange/exchange.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "io/scene/scene_json.h"

namespace hottel::radiosity_verdict_test {
namespace {

using testing::HasSubstr;

// Radiosities of the contract's box, changed.
class RadiosityVerdictTest : public testing::Test {
 protected:
  using Value = std::function<double(const ElementRadiosity&)>;
  RadiosityVerdict judged(const Value& value, const WrittenDigits& digits = {}) const {
    std::vector<std::vector<double>> values;
    for (const ChannelSolution& channel : solution_.channels) {
      values.emplace_back();
      for (const ElementRadiosity& element : channel.elements) values.back().push_back(value(element));
    }
    return judge_radiosities(exact_, solution_, values, digits, 1e-6);
  }

  PreparedScene2 prepared_ = prepare(read_scene_2(std::string(HOTTEL_SOURCE_DIR) + "/tests/contract/box.json"));
  ExchangeMatrix exact_ = exact_exchange(prepared_);
  RadiositySolution solution_ = solve_radiosity(exact_, prepared_.scene.materials, {});
};

TEST_F(RadiosityVerdictTest, FindsNothingWithinTheBoundsAndTheDigitsWritten) {
  const RadiosityVerdict verdict = judged([](const ElementRadiosity& each) { return each.radiosity; });
  EXPECT_EQ(verdict.outside, 0u);
  EXPECT_EQ(verdict.count, 8u * 3);  // the bottom of the box is covered
  const auto rounded = [](const ElementRadiosity& each) { return std::stod(fmt::format("{:.5f}", each.radiosity)); };
  EXPECT_GT(judged(rounded).outside, 0u);
  EXPECT_EQ(judged(rounded, {5, 6, 0}).outside, 0u);
}

TEST_F(RadiosityVerdictTest, NamesWhatStandsForRadiosities) {
  const std::pair<const char*, Value> kReadings[] = {
      {"irradiances H", [](const ElementRadiosity& each) { return each.irradiance; }},
      {"radiosities without the emission, B - E",
       [](const ElementRadiosity& each) { return each.radiosity - each.emission; }},
      {"net fluxes B - H", [](const ElementRadiosity& each) { return each.net(); }},
      {"emissions: nothing is reflected", [](const ElementRadiosity& each) { return each.emission; }},
      {"radiosities times pi", [](const ElementRadiosity& each) { return std::numbers::pi * each.radiosity; }},
      {"radiosities times 1/2", [](const ElementRadiosity& each) { return each.radiosity / 2; }},
      {"radiosities times 100 (percent)", [](const ElementRadiosity& each) { return 100 * each.radiosity; }}};
  for (const auto& [words, value] : kReadings) {
    const RadiosityVerdict verdict = judged(value);
    EXPECT_EQ(verdict.hypothesis, words);
    EXPECT_EQ(verdict.explained, verdict.outside);
  }
}

TEST_F(RadiosityVerdictTest, TellsRadiositiesOfOtherFaces) {
  std::vector<std::uint32_t> rows;
  for (std::uint32_t i = 0; i < exact_.size(); ++i)
    if (exact_.has_row(i)) rows.push_back(i);
  const auto hypothesis = [&](const std::function<std::size_t(std::size_t)>& of) {
    std::vector<std::vector<double>> values;
    for (const auto& channel : solution_.channels) {
      values.emplace_back(exact_.size(), 0.0);
      for (std::size_t k = 0; k < rows.size(); ++k) values.back()[rows[k]] = channel.elements[rows[of(k)]].radiosity;
    }
    const RadiosityVerdict verdict = judge_radiosities(exact_, solution_, values, {}, 1e-6);
    EXPECT_EQ(verdict.explained, verdict.outside);
    return verdict.hypothesis;
  };
  const std::size_t n = rows.size();
  EXPECT_THAT(hypothesis([n](std::size_t k) { return (k + 1) % n; }),
              testing::StartsWith("radiosities of other faces, shifted by 1: what stands for "));
  EXPECT_THAT(hypothesis([n](std::size_t k) { return (k + n - 1) % n; }), HasSubstr("shifted by 1 the other way"));
  EXPECT_THAT(hypothesis([n](std::size_t k) { return n - 1 - k; }), HasSubstr("in another order"));
}

TEST_F(RadiosityVerdictTest, NamesTheFaceThatIsWrong) {
  const double wall = solution_.channels[1].elements[6].radiosity;
  const RadiosityVerdict verdict =
      judged([&](const ElementRadiosity& each) { return each.radiosity == wall ? 1.01 * wall : each.radiosity; });
  EXPECT_EQ(verdict.outside, 1u);
  EXPECT_EQ(verdict.hypothesis, "");
  EXPECT_THAT(verdict_sentences(verdict, exact_, solution_)[0], HasSubstr("('wall' (g): "));
}

}  // namespace
}  // namespace hottel::radiosity_verdict_test
