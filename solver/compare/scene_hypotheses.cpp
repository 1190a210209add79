#include "solver/compare/scene_hypotheses.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "geometry/name.h"
#include "kernel/support/parallel.h"
#include "solver/compare/samples.h"

namespace hottel {

namespace {

// Whether some pair would exchange something, is wholly hidden, and is 0 in the file.
bool hides_a_pair(const JudgedScene& scene, const JudgedPairs& judged) {
  return judged.any_of_zeros(
      [&](std::uint32_t i, std::uint32_t j) { return scene.unobstructed_factor(i, j) > 2 * judged.tolerance(0); });
}

}  // namespace

Hypothesis suppose_no_occlusion(const JudgedScene& scene, const JudgedPairs& judged,
                                const std::vector<double>& unobstructed) {
  Hypothesis result = explains_nothing(Fault::kNoOcclusion, judged);
  std::uint64_t partly = 0, wholly = 0;
  for (const JudgedPair& pair : judged.pairs()) {
    const std::size_t k = judged.index_of(pair);
    if (!pair.is_off || unobstructed[k] == 0 || pair.visibility == 1 || !judged.agrees(pair, unobstructed[k])) continue;
    result.explains[k] = 1;
    ++(pair.exact > 0 ? partly : wholly);
  }
  if (wholly == 0 && hides_a_pair(scene, judged)) return explains_nothing(Fault::kNoOcclusion, judged);
  result.words = fmt::format(
      "nothing hides anything: factors are those without obstacles ({} of pairs partly hidden, "
      "{} of pairs wholly hidden)",
      partly, wholly);
  return result;
}

Hypothesis suppose_all_or_nothing(const JudgedPairs& judged, const std::vector<double>& unobstructed) {
  Hypothesis result = explains_nothing(Fault::kAllOrNothing, judged);
  std::uint64_t visible = 0, hidden = 0;
  for (const JudgedPair& pair : judged.pairs()) {
    const std::size_t k = judged.index_of(pair);
    if (!pair.is_off || pair.exact == 0 || !(pair.visibility < 1) || pair.to == judged.exact().sky()) continue;
    const bool is_visible = judged.agrees(pair, unobstructed[k]), is_hidden = judged.agrees(pair, 0);
    if (!is_visible && !is_hidden) continue;
    result.explains[k] = 1;
    ++(is_visible ? visible : hidden);
  }
  result.words = fmt::format(
      "visibility is all or nothing: of partly hidden pairs {} are taken as wholly visible and "
      "{} as wholly hidden",
      visible, hidden);
  return result;
}

Hypothesis suppose_behind(const JudgedPairs& judged, const std::vector<double>& unobstructed) {
  Hypothesis result = explains_nothing(Fault::kBehind, judged);
  for (const JudgedPair& pair : judged.pairs()) {
    const std::size_t k = judged.index_of(pair);
    if (pair.is_off && pair.exact == 0 && unobstructed[k] == 0 && pair.to != judged.exact().sky())
      result.explains[k] = 1;
  }
  result.words = "light goes between faces that do not face each other";
  return result;
}

namespace {

// Factors of both sides of every surface, by side.
class BothSides {
 public:
  explicit BothSides(ExchangeMatrix matrix) : matrix_(std::move(matrix)) {
    for (std::uint32_t i = 0; i < matrix_.size(); ++i) place_[key(matrix_.elements()[i], false)] = i;
  }

  // F(from, to), each turned around or not. Nothing for a back as a whole whose front is divided.
  std::optional<double> factor(const ExchangeMatrix& exact, const JudgedPair& pair, bool turn_from,
                               bool turn_to) const {
    const auto from = place_.find(key(exact.elements()[pair.from], turn_from));
    if (from == place_.end()) return std::nullopt;
    if (pair.to == exact.sky()) return matrix_.factor(from->second, matrix_.sky()).value;
    const auto to = place_.find(key(exact.elements()[pair.to], turn_to));
    if (to == place_.end()) return std::nullopt;
    return matrix_.factor(from->second, to->second).value;
  }

 private:
  using Key = std::tuple<std::uint32_t, bool, std::uint32_t, TreeNode>;
  static Key key(const Element& element, bool is_turned) {
    return {element.surface, element.is_back != is_turned, element.parts, element.node()};
  }

  ExchangeMatrix matrix_;
  std::map<Key, std::uint32_t> place_;
};

// Surfaces with factors that are off, none of which goes where nothing gets from their other side.
std::vector<char> may_be_turned(const JudgedScene& scene, const JudgedPairs& judged) {
  const ExchangeMatrix& exact = judged.exact();
  std::vector<char> may_be, cannot;
  for (const Element& element : exact.elements())
    may_be.resize(std::max<std::size_t>(may_be.size(), element.surface + 1), 0);
  cannot = may_be;
  for (const JudgedPair& pair : judged.pairs()) {
    const std::uint32_t surface = exact.elements()[pair.from].surface;
    may_be[surface] |= static_cast<char>(pair.is_off);
    const bool is_lit = pair.to != exact.sky() && std::abs(pair.value) > judged.tolerance(pair.value);
    if (is_lit && !cannot[surface]) cannot[surface] = static_cast<char>(!scene.reaches_behind(pair.from, pair.to));
  }
  for (std::size_t s = 0; s < may_be.size(); ++s) may_be[s] = may_be[s] && !cannot[s];
  return may_be;
}

}  // namespace

Hypothesis suppose_reversed(const JudgedScene& scene, const JudgedPairs& judged) {
  Hypothesis result = explains_nothing(Fault::kReversed, judged);
  const ExchangeMatrix& exact = judged.exact();
  const auto surface_of = [&](std::uint32_t i) { return exact.elements()[i].surface; };
  std::vector<char> is_turned = may_be_turned(scene, judged);
  if (std::ranges::find(is_turned, 1) == is_turned.end()) return result;
  std::optional<ExchangeMatrix> factors = scene.factors_of_both_sides();
  if (!factors) return result;
  const BothSides both(std::move(*factors));
  const auto agrees = [&](const JudgedPair& pair, bool turn_from, bool turn_to) {
    const auto factor = both.factor(exact, pair, turn_from, turn_to);
    return !factor || std::abs(pair.value - *factor) <= judged.tolerance(pair.value);
  };
  // Every row, turned around, is to agree whether or not the other face is turned.
  for (const JudgedPair& pair : judged.pairs()) {
    char& turned = is_turned[surface_of(pair.from)];
    turned = turned && (agrees(pair, true, false) || agrees(pair, true, true));
  }
  // Rows that sum to nothing are missing, not turned, where the file has a place for all they may see.
  const bool is_complete = std::all_of(exact.elements().begin(), exact.elements().end(), [&](const Element& element) {
    return judged.has_column(static_cast<std::uint32_t>(&element - exact.elements().data()));
  });
  for (std::uint32_t i = 0; i < exact.size() && is_complete && judged.has_column(exact.sky()); ++i) {
    double lack = exact.has_row(i) ? 1 : 0;
    for (const JudgedPair& pair : judged.row(i)) lack -= pair.value;
    if (std::abs(lack) > judged.tolerance(1) * static_cast<double>(exact.size())) is_turned[surface_of(i)] = 0;
  }
  std::vector<std::string> names;
  for (std::size_t s = 0; s < is_turned.size(); ++s) {
    if (is_turned[s]) names.push_back(scene.surface_name(static_cast<std::uint32_t>(s)));
  }
  for (const JudgedPair& pair : judged.pairs()) {
    if (!pair.is_off) continue;
    const bool from = is_turned[surface_of(pair.from)], to = pair.to != exact.sky() && is_turned[surface_of(pair.to)];
    if (!from && !to) continue;
    if (const auto factor = both.factor(exact, pair, from, to); factor && judged.agrees(pair, *factor))
      result.explains[judged.index_of(pair)] = 1;
  }
  result.words = "the back is taken for the front of " + listed_names(names);
  return result;
}

namespace {

constexpr std::size_t kSampleOfMethod = 400;  // pairs

double prediction(const PairwiseMethod& method, const JudgedPair& pair) {
  if (method.takes_visibility && pair.visibility == 0) return 0;
  return method.factor(pair.from, pair.to) * (method.takes_visibility ? pair.visibility : 1);
}

// Whether a pair agrees with what a method gives, and whether that speaks for the method.
struct Agreement {
  bool agrees = false, is_evidence = false;
};

Agreement agreement(const PairwiseMethod& method, const JudgedPairs& judged, const JudgedPair& pair) {
  const double factor = prediction(method, pair);
  if (!judged.agrees(pair, factor)) return {};
  const double unobstructed = pair.visibility > 0 ? pair.exact / pair.visibility : 0;
  return {true, factor != 0 && !judged.agrees(pair, unobstructed)};
}

bool is_enough(std::uint64_t evidence, std::uint64_t of) {
  return static_cast<double>(evidence) >= kLeastShareOfMethod * static_cast<double>(of);
}

std::vector<const JudgedPair*> pairs_off(const JudgedPairs& judged) {
  std::vector<const JudgedPair*> pairs;
  for (const JudgedPair& pair : judged.pairs())
    if (pair.is_off && pair.to != judged.exact().sky()) pairs.push_back(&pair);
  return pairs;
}

// What the pairs that are off say for a method, by place. COST: parallel.
std::vector<Agreement> agreements(const PairwiseMethod& method, const JudgedPairs& judged,
                                  const std::vector<const JudgedPair*>& pairs) {
  constexpr std::size_t kPairsATask = 64;
  std::vector<Agreement> all(pairs.size());
  parallel_for(
      all.size(), [&](std::size_t k) { all[k] = agreement(method, judged, *pairs[k]); }, kPairsATask);
  return all;
}

std::uint64_t evidence_in(const std::vector<Agreement>& all) {
  return static_cast<std::uint64_t>(std::ranges::count_if(all, [](const Agreement& each) { return each.is_evidence; }));
}

}  // namespace

Hypothesis suppose_method(const JudgedScene& scene, const JudgedPairs& judged) {
  Hypothesis best = explains_nothing(Fault::kMethod, judged);
  if (judged.exact().size() > kMostApproximated) return best;
  const std::vector<const JudgedPair*> pairs = pairs_off(judged), sample = thinned(pairs, kSampleOfMethod);
  std::uint64_t most = 0;
  for (const PairwiseMethod& method : scene.pairwise_methods()) {
    if (!is_enough(2 * evidence_in(agreements(method, judged, sample)), sample.size())) continue;
    const std::vector<Agreement> all = agreements(method, judged, pairs);
    if (!is_enough(evidence_in(all), judged.off())) continue;
    Hypothesis hypothesis = explains_nothing(Fault::kMethod, judged);
    for (std::size_t k = 0; k < pairs.size(); ++k)
      hypothesis.explains[judged.index_of(*pairs[k])] = static_cast<char>(all[k].agrees);
    for (const JudgedPair& pair : judged.pairs())
      if (pair.is_off && pair.to == judged.exact().sky())
        hypothesis.explains[judged.index_of(pair)] =
            static_cast<char>(judged.agrees(pair, std::max(0.0, judged.rest_of_row(pair))));
    if (hypothesis.count() <= most) continue;
    most = hypothesis.count();
    best = std::move(hypothesis);
    best.words = fmt::format("factors are those of an approximate method, as `{}` gives", method.name);
  }
  return best;
}

}  // namespace hottel
