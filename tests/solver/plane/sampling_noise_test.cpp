// Matrices that scatter as rays do: how many rays, and whether they lean. Nothing that is unbiased is called biased.
#include "solver/compare/sampling_noise.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <utility>

#include "solver/plane/methods/method_catalogue.h"
#include "tests/sanitizers.h"
#include "tests/solver/plane/judged_matrices.h"

namespace hottel::sampling_noise_test {
namespace {

using testing::HasSubstr;

// A room with two boxes and a lamp, in pieces: some faces see neither box.
Scene2 furnished_room() {
  return parse_scene_2(R"({"hottel": 1, "dimension": 2, "materials": {"wall": {"reflectivity": 0.6}},
    "edges": [{"name": "lamp", "points": [[1, 2.9], [2, 2.9]], "material": "wall", "back": "wall"}],
    "polylines": [
      {"name": "room", "points": [[0, 0], [0, 1], [0, 2], [0, 3], [2, 3], [4, 3], [5, 3], [5, 2], [5, 1], [5, 0],
                                  [4, 0], [2, 0]], "closed": true, "material": "wall"},
      {"name": "box", "points": [[2, 0.5], [2.5, 0.5], [3, 0.5], [3, 1], [3, 1.5], [2.5, 1.5], [2, 1.5], [2, 1]],
       "closed": true, "material": "wall"},
      {"name": "block", "points": [[4, 1], [4.5, 1.2], [4.2, 1.8]], "closed": true, "material": "wall"}]})",
                       "furnished.json");
}

// Factors by row and column.
using Factors = std::map<ElementPair, double>;

ExchangeMatrix matrix_of(const Judged& judged, const Factors& factors) {
  std::vector<std::size_t> begin(1, 0);
  std::vector<FactorEntry> entries;
  auto next = factors.begin();
  for (std::uint32_t i = 0; i < judged.exact.size(); ++i) {
    for (; next != factors.end() && next->first.first == i; ++next)
      if (next->second != 0) entries.push_back({next->first.second, {next->second, 0}, 1});
    begin.push_back(entries.size());
  }
  return judged.matrix(std::move(begin), std::move(entries));
}

// Of n rays from each face (n of the face), those that end on each other, over n.
Factors hits(const Judged& judged, std::uint64_t seed, const std::function<int(std::uint32_t)>& rays,
             const std::function<double(std::uint32_t, const FactorEntry&)>& lean = {}) {
  std::mt19937_64 random(seed);
  Factors factors;
  for (std::uint32_t i = 0; i < judged.exact.size(); ++i) {
    double odds = 0;
    const auto weight = [&](const FactorEntry& entry) { return entry.factor.value * (lean ? lean(i, entry) : 1.0); };
    for (const FactorEntry& entry : judged.exact.row(i)) odds += weight(entry);
    int left = rays(i);
    for (const FactorEntry& entry : judged.exact.row(i)) {
      const double chance = odds > 0 ? std::min(1.0, weight(entry) / odds) : 0;
      const int hit = chance >= 1 ? left : std::binomial_distribution<int>(left, chance)(random);
      factors[{i, entry.to}] = static_cast<double>(hit) / rays(i);
      left -= hit;
      odds -= weight(entry);
    }
  }
  return factors;
}

// A number of rays for each pair, by itself.
Factors pairs_alone(const Judged& judged, std::uint64_t seed, int rays) {
  std::mt19937_64 random(seed);
  Factors factors;
  for (std::uint32_t i = 0; i < judged.exact.size(); ++i)
    for (const FactorEntry& entry : judged.exact.row(i))
      factors[{i, entry.to}] =
          std::binomial_distribution<int>(rays, std::min(1.0, entry.factor.value))(random) / static_cast<double>(rays);
  return factors;
}

// Both ways put together, or one taken for both.
Factors both_ways(const Judged& judged, Factors factors, bool takes_one) {
  const auto area = [&](std::uint32_t i) { return judged.exact.elements()[i].area.value; };
  Factors result = factors;
  for (const auto& [pair, value] : factors) {
    const auto [i, j] = pair;
    const auto reverse = factors.find({j, i});
    if (reverse == factors.end() || j == i) continue;
    const double there = area(i) * value, back = area(j) * reverse->second;
    result[pair] = (takes_one ? (i < j ? there : back) : (there + back) / 2) / area(i);
  }
  return result;
}

std::optional<SamplingNoise> noise_of(const Judged& judged, const ExchangeMatrix& matrix) {
  return sampling_noise(JudgedPairs(judged.exact, matrix, 1e-6, {}));
}

std::string bias_of(const Judged& judged, const Factors& factors) {
  const auto noise = noise_of(judged, matrix_of(judged, factors));
  if (!noise) return "no noise";
  if (!noise->bias.is_biased()) return "";
  return (noise->bias.is_leaky ? "leaky: " : "") + (noise->bias.sums.empty() ? "" : noise->bias.sums[0].words);
}

constexpr std::uint64_t kSeeds = kHasAddressSanitizer ? 20 : 200;

struct Counter {
  const char* name;
  std::function<Factors(const Judged&, std::uint64_t)> factors;
};

TEST(SamplingNoise, UnbiasedCountersAreCalledSo) {
  const auto equally = [](int n) { return [n](std::uint32_t) { return n; }; };
  const std::vector<Counter> counters = {
      {"counter", [&](const Judged& judged, auto seed) { return hits(judged, seed, equally(4000)); }},
      {"of few rays", [&](const Judged& judged, auto seed) { return hits(judged, seed, equally(150)); }},
      {"by area",
       [](const Judged& judged, auto seed) {
         return hits(judged, seed, [&](std::uint32_t i) {
           return 50 + static_cast<int>(4000 * judged.exact.elements()[i].area.value);
         });
       }},
      {"pairs alone", [](const Judged& judged, auto seed) { return pairs_alone(judged, seed, 4000); }},
      {"symmetrised",
       [&](const Judged& judged, auto seed) { return both_ways(judged, hits(judged, seed, equally(4000)), false); }},
      {"one way",
       [&](const Judged& judged, auto seed) { return both_ways(judged, hits(judged, seed, equally(4000)), true); }}};
  for (const auto& scene : {furnished_room, apartment, clutter}) {
    const Judged judged(scene());
    for (const Counter& counter : counters) {
      std::map<std::string, int> told;
      int alarms = 0;
      for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        const std::string bias = bias_of(judged, counter.factors(judged, seed));
        if (bias == "" || bias == "no noise") continue;
        ++told[bias];
        ++alarms;
      }
      // 1 in 1000 is allowed: two of 200 come about once in 60 such series.
      EXPECT_LE(alarms, 1) << counter.name << " " << judged.prepared.scene.file << ": " << told.begin()->first;
    }
  }
}

TEST(SamplingNoise, RaysOfHottelsOwnAreCalledUnbiasedWhateverTheSeed) {
  const Judged judged(furnished_room());
  for (const char* name : {"rays:512", "rays:512:stratified", "rays:512:sobol"}) {
    int alarms = 0;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
      MethodReport report;
      const auto method = methods_2().make(fmt::format("{}:seed={}", name, seed));
      const auto noise = noise_of(judged, method->compute(judged.prepared, {.wants_visibility = false}, report));
      alarms += !noise || noise->bias.is_biased();
    }
    EXPECT_LE(alarms, 1) << name;
  }
}

TEST(SamplingNoise, CountersThatLoseHitsOrMoveThemAreCalledBiased) {
  const Judged judged(furnished_room());
  constexpr int kTries = 60;
  std::map<std::string, int> told;  // how often by the words they should have
  for (std::uint64_t seed = 1; seed <= kTries; ++seed) {
    const Factors right = hits(judged, seed, [](std::uint32_t) { return 4000; });
    const auto of = [&](const ElementPair& pair) {
      return std::pair(judged.exact.name(pair.first), judged.exact.name(pair.second));
    };
    const auto tell = [&](const std::string& what, Factors wrong, std::initializer_list<const char*> words) {
      const std::string bias = bias_of(judged, wrong);
      told[what] += std::all_of(words.begin(), words.end(),
                                [&](const char* word) { return bias.find(word) != std::string::npos; });
    };
    for (const double loss : {0.05, 0.1, 0.3}) {
      Factors wrong = right;
      for (auto& [pair, value] : wrong)
        if (of(pair).second.starts_with("box")) value *= 1 - loss;
      tell(fmt::format("box {}", loss), wrong, {"leaky: ", "hits on 'box", " are short by "});
    }
    Factors lamp = right, all = right, moved = right;
    for (auto& [pair, value] : lamp)
      if (of(pair).first == "lamp") value *= 0.8;
    tell("lamp", lamp, {"leaky: what leaves 'lamp' is short by 20 %"});
    for (auto& [pair, value] : all) value *= 0.97;
    tell("all", all, {"all factors are too small by 3 %"});
    for (auto& [pair, value] : all) value /= -0.97;
    tell("sign", all, {"all factors are about the exact ones times -1 (the sign)"});
    // A tenth of what hits the box is counted on a wall: rows sum to 1 as before.
    for (const auto& [pair, value] : right)
      if (const auto wall = moved.find({pair.first, *judged.exact.find("room[0]")});
          wall != moved.end() && of(pair).second.starts_with("box")) {
        wall->second += 0.1 * value;
        moved[pair] = 0.9 * value;
      }
    tell("moved", moved, {"hits on "});
  }
  for (const auto& [what, count] : told)
    EXPECT_GE(count, what == "box 0.05" || what == "moved" ? kTries * 8 / 10 : kTries * 98 / 100) << what;
}

// Many rays by odds that are wrong err by a rule, and give factors far smaller than the few random rays could that
// would scatter so.
TEST(SamplingNoise, OddsThatAreWrongAreNoNumberOfRays) {
  const Judged judged(furnished_room());
  const auto odds = [](std::uint32_t i, const FactorEntry& entry) {
    return std::pow(entry.factor.value, 0.2) * (1 + 0.6 * std::sin(7.0 * i + 3.0 * entry.to));
  };
  const Factors wrong = hits(
      judged, 3, [](std::uint32_t) { return 50000; }, odds);
  const Verdict verdict = judge(judged.prepared, judged.exact, matrix_of(judged, wrong), {});
  EXPECT_THAT(faults(verdict), testing::IsEmpty()) << judged.sentences(verdict);
}

TEST(SamplingNoise, TellsHowManyRaysScatterSo) {
  for (const auto& scene : {apartment, clutter})
    for (const int rays : {100, 1000, 10000}) {
      const Judged judged(scene());
      const ExchangeMatrix matrix = matrix_of(judged, hits(judged, 7, [&](std::uint32_t) { return rays; }));
      const JudgedPairs pairs(judged.exact, matrix, 1e-6, {});
      const auto noise = sampling_noise(pairs);
      ASSERT_TRUE(noise) << rays;
      EXPECT_NEAR(noise->rays / rays, 1, 0.15);
      EXPECT_FALSE(noise->bias.is_biased());
      const Verdict verdict = judge(judged.prepared, judged.exact, matrix, {});
      EXPECT_THAT(faults(verdict), testing::ElementsAre(Fault::kSamplingNoise)) << judged.sentences(verdict);
      EXPECT_LE(verdict.unexplained, verdict.off / 100);
      EXPECT_THAT(judged.sentences(verdict), HasSubstr("random rays a face would give, unbiased"));
    }
}

TEST(SamplingNoise, TellsRaysOfHottelsOwnWhetherRandomOrSpreadEvenly) {
  const Judged judged(apartment());
  for (const auto& [name, words] :
       {std::pair("rays:1024", "random"), std::pair("rays:1024:stratified", "evenly spread"),
        std::pair("rays:1024:sobol", "evenly spread")}) {
    MethodReport report;
    const ExchangeMatrix matrix = methods_2().make(name)->compute(judged.prepared, {.wants_visibility = false}, report);
    const auto noise = sampling_noise(JudgedPairs(judged.exact, matrix, 1e-6, {}));
    ASSERT_TRUE(noise) << name;
    EXPECT_EQ(noise->is_even, std::string(words) != "random") << name;
    EXPECT_LT(std::abs(std::log(noise->rays / 1024)), std::log(4)) << name << " " << noise->rays;
    EXPECT_FALSE(noise->bias.is_biased()) << name;
    EXPECT_THAT(judged.sentences(judge(judged.prepared, judged.exact, matrix, {})),
                HasSubstr(std::string(words) + " rays a face would give, unbiased"));
  }
  for (const char* name : {"center", "hemicube:256", "gauss:8", "strings"}) {
    MethodReport report;
    const ExchangeMatrix matrix = methods_2().make(name)->compute(judged.prepared, {.wants_visibility = false}, report);
    EXPECT_FALSE(sampling_noise(JudgedPairs(judged.exact, matrix, 1e-6, {}))) << name;
  }
}

TEST(SamplingNoise, TellsScatterThatLeans) {
  const Judged judged(apartment());
  const Verdict verdict =
      judge(judged.prepared, judged.exact,
            matrix_of(judged, hits(
                                  judged, 7, [](std::uint32_t) { return 1000; },
                                  [](auto, const FactorEntry& entry) { return entry.visibility < 1 ? 1.1 : 1.0; })),
            {});
  EXPECT_EQ(faults(verdict).at(0), Fault::kSamplingNoise) << judged.sentences(verdict);
  EXPECT_THAT(judged.sentences(verdict), HasSubstr("but biased: factors of partly hidden pairs are too large by "));
}

TEST(SamplingNoise, TakesErrorsOfARuleForNoScatter) {
  const Judged judged(apartment());
  for (const auto& value : std::vector<Judged::Value>{
           [](auto, auto, double e) { return 1.01 * e; },
           [&](auto i, auto j, double e) { return judged.vis(i, j) < 1 ? (judged.vis(i, j) < 0.5 ? 0 : 2 * e) : e; }})
    EXPECT_FALSE(sampling_noise(JudgedPairs(judged.exact, judged.changed(value), 1e-6, {})));
}

TEST(SamplingNoise, TellsScatterBesideAnotherFault) {
  const Judged judged(clutter());
  const ExchangeMatrix matrix = matrix_of(judged, hits(judged, 7, [](std::uint32_t) { return 1000; }));
  const auto is_wall = [&](std::uint32_t j) { return judged.exact.name(j).starts_with("wall"); };
  const Verdict verdict =
      judge(judged.prepared, judged.exact,
            judged.changed([&](auto i, auto j, double) { return is_wall(j) ? 0 : matrix.factor(i, j).value; }), {});
  EXPECT_THAT(faults(verdict), testing::ElementsAre(Fault::kMissing, Fault::kSamplingNoise))
      << judged.sentences(verdict);
}

}  // namespace
}  // namespace hottel::sampling_noise_test
