#include "solver/space/sampled_cost.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <random>
#include <utility>
#include <vector>

#include "geometry/exchange_request.h"
#include "geometry/space/exchange/facing.h"
#include "geometry/space/exchange/pair_shares.h"
#include "geometry/space/pairs/pair_integrator.h"
#include "geometry/space/prepared/element_table.h"
#include "solver/plan.h"

namespace hottel {
namespace {

using Part = ElementTable3::Part;

// What is looked at for a pair, in the scenes of benchmarks/plan_estimates.py, on one core: a pair, and of its corners
// each with each; a node of an integral; a sign by the tier that settles it.
constexpr double kSecondsOfAPair = 1.2e-5, kSecondsOfCorners = 4e-7;
constexpr double kSecondsPerNode = 6.5e-7;
constexpr double kSecondsPerSign[3] = {2.1e-8, 2.1e-8, 3.5e-7};
// What a pair is thought to cost where something may stand between, and for the square of how many surfaces may.
constexpr double kSecondsPerMixed = 1e-4, kSecondsPerBetween = 2e-5;

// Pairs that are drawn to tell how many face each other; those of which is asked what may stand between, and patches
// of which is asked what stands before the sky.
constexpr std::size_t kMostDrawn = 20000, kMostAsked = 1000, kMostUnderSky = 40;
// So many draws are enough where what they measure costs that part of all, or so many seconds; and at most.
constexpr double kUsualDraws = 8, kEnoughOfAll = 0.015, kEnoughSeconds = 0.2;
constexpr std::size_t kMostDraws = 200;
constexpr double kGoldenPart = 0.6180339887498949;

struct Pair {
  const Part *a, *b;
};

double plain_cost(const Pair& pair) {
  const double corners = pair.b->patch.is_sky() ? 4 : static_cast<double>(pair.b->patch.corners.size());
  return kSecondsOfAPair + kSecondsOfCorners * static_cast<double>(pair.a->patch.corners.size()) * corners;
}

// Pairs, each with what it is thought to cost.
class ThoughtOf {
 public:
  struct One {
    Pair pair;
    double cost;
  };

  // The cheapest first.
  explicit ThoughtOf(std::vector<One> pairs) : pairs_(std::move(pairs)) {
    std::ranges::stable_sort(pairs_, {}, &One::cost);
    for (const One& one : pairs_) total_ += one.cost;
  }

  std::size_t size() const { return pairs_.size(); }
  const One& operator[](std::size_t number) const { return pairs_[number]; }
  double mean() const { return total_ / static_cast<double>(pairs_.size()); }
  // The number of the one at that part of the sum of all.
  std::size_t at(double part) const {
    double sum = part * total_;
    std::size_t number = 0;
    while (number + 1 < pairs_.size() && (sum -= pairs_[number].cost) >= 0) ++number;
    return number;
  }

 private:
  std::vector<One> pairs_;
  double total_ = 0;
};

class Sampling {
 public:
  explicit Sampling(const PreparedScene3& prepared)
      : prepared_(prepared),
        table_(*prepared.elements(is_divided(prepared.scene) ? Granularity::kElement : Granularity::kFace)),
        shares_(table_, prepared.occluders().vertices(), ExchangeRequest().tolerance),
        count_(table_.parts().size() - table_.parts(table_.sky()).size()) {}

  SampledCost3 result(bool wants_sky) const {
    SampledCost3 cost;
    const std::vector<Pair> facing = facing_pairs(cost.facing);
    for (const Pair& pair : facing) cost.plain += plain_cost(pair);
    cost.plain *= facing.empty() ? 0 : cost.facing / static_cast<double>(facing.size());
    cost.pairs = std::max(cost.plain, cost_of_all(thought_of(facing, kMostAsked), cost.facing, cost));
    if (!wants_sky) return cost;
    const std::vector<Pair> under_sky = pairs_with_sky();
    cost.sky = cost_of_all(thought_of(under_sky, kMostUnderSky), static_cast<double>(under_sky.size()), cost);
    return cost;
  }

 private:
  bool is_facing(const Pair& pair) const {
    return pair.a->patch.surface != pair.b->patch.surface &&
           (table_.has_row(pair.a->label) || table_.has_row(pair.b->label)) &&
           surfaces_face_each_other(prepared_.occluders(), *pair.a, *pair.b);
  }

  // Calls it with all pairs of patches, or with some that are drawn; returns for how many each of these stands.
  double each_pair(const std::function<void(const Pair&)>& visit) const {
    const std::vector<Part>& parts = table_.parts();
    const std::size_t all = count_ < 2 ? 0 : count_ * (count_ - 1) / 2;
    if (all <= kMostDrawn) {
      for (std::size_t b = 1; b < count_; ++b)
        for (std::size_t a = 0; a < b; ++a) visit({&parts[a], &parts[b]});
      return 1;
    }
    std::mt19937_64 random(1);
    for (std::size_t k = 0; k < kMostDrawn; ++k) {
      const std::size_t a = random() % count_, other = random() % (count_ - 1), b = other < a ? other : other + 1;
      visit({&parts[std::min(a, b)], &parts[std::max(a, b)]});
    }
    return static_cast<double>(all) / kMostDrawn;
  }

  std::vector<Pair> facing_pairs(double& count) const {
    std::vector<Pair> facing;
    const double each = each_pair([&](const Pair& pair) {
      if (is_facing(pair)) facing.push_back(pair);
    });
    count = each * static_cast<double>(facing.size());
    return facing;
  }

  std::vector<Pair> pairs_with_sky() const {
    std::vector<Pair> pairs;
    const Part& sky = table_.parts(table_.sky()).front();
    for (std::size_t a = 0; a < count_; ++a)
      if (table_.has_row(table_.parts()[a].label)) pairs.push_back({&table_.parts()[a], &sky});
    return pairs;
  }

  double thought_cost(const Pair& pair) const {
    const auto between = static_cast<double>(prepared_.measurer().count_between(pair.a->patch, pair.b->patch));
    return plain_cost(pair) + (between > 0 ? kSecondsPerMixed + between * between * kSecondsPerBetween : 0);
  }

  // Some of the pairs.
  ThoughtOf thought_of(std::vector<Pair> pairs, std::size_t most) const {
    std::mt19937_64 random(2);
    std::vector<ThoughtOf::One> some;
    for (std::size_t k = 0; k < std::min(most, pairs.size()); ++k) {
      std::swap(pairs[k], pairs[k + random() % (pairs.size() - k)]);
      some.push_back({pairs[k], thought_cost(pairs[k])});
    }
    return ThoughtOf(std::move(some));
  }

  // Of `count` pairs for which these stand: of those that are drawn, by what they cost over what they were thought to.
  double cost_of_all(const ThoughtOf& pairs, double count, SampledCost3& spent) const {
    if (pairs.size() == 0) return 0;
    std::map<std::size_t, double> costs;
    double ratios = 0, here = 0, part = 0.5, all = 0;
    for (std::size_t draw = 1; draw <= kMostDraws; ++draw) {
      const std::size_t drawn = pairs.at(part);
      part = std::fmod(part + kGoldenPart, 1.0);
      const auto [place, is_new] = costs.emplace(drawn, 0);
      if (is_new) here += place->second = cost_of(pairs[drawn].pair);
      ratios += place->second / pairs[drawn].cost;
      all = pairs.mean() * count * ratios / static_cast<double>(draw);
      if (is_enough(draw, here, all)) break;
    }
    spent.sampling += here;
    spent.measured += costs.size();
    return costs.size() == pairs.size() ? here * count / static_cast<double>(pairs.size()) : all;
  }

  // Whether so many draws are enough: the fewer the more they cost.
  static bool is_enough(std::size_t draws, double spent, double all) {
    const double part = spent / std::min(kEnoughSeconds, kEnoughOfAll * all);
    return part >= 1 && part * static_cast<double>(draws) >= kUsualDraws;
  }

  // What is looked at for a pair. More is tried where that does not come within the tolerance.
  double cost_of(const Pair& pair) const {
    PairRequest3 request{.share = shares_.share(*pair.a, *pair.b), .effort = Effort3::kUsual};
    const auto measure = [&] { return prepared_.measurer().measure(pair.a->patch, pair.b->patch, request); };
    const PairResult3 usual = measure();
    const double cost = plain_cost(pair) + seconds_of_looks_3(usual.nodes, usual.signs);
    if (usual.problem.empty()) return cost;
    request.effort = Effort3::kAll;
    const PairResult3 more = measure();
    return cost + seconds_of_looks_3(more.nodes, more.signs);
  }

  const PreparedScene3& prepared_;
  const ElementTable3& table_;
  const PairShares3 shares_;
  const std::size_t count_;  // of patches without the sky
};

}  // namespace

double seconds_of_looks_3(std::uint64_t nodes, const SignCounts& signs) {
  double seconds = static_cast<double>(nodes) * kSecondsPerNode;
  for (int tier = 0; tier < 3; ++tier) seconds += static_cast<double>(signs.by_tier[tier]) * kSecondsPerSign[tier];
  return seconds;
}

SampledCost3 sampled_cost(const PreparedScene3& prepared, bool wants_sky) {
  return Sampling(prepared).result(wants_sky);
}

}  // namespace hottel
