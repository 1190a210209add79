#include "solver/compare/composed_readings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>

#include "geometry/name.h"
#include "solver/compare/reading_parts.h"
#include "solver/compare/samples.h"
#include "solver/methods/factor_rows.h"

namespace hottel {
namespace {

constexpr std::size_t kSample = 2000;          // pairs
constexpr double kNear = 1e-3;                 // of a ratio to one with a name
constexpr double kLeastShareOfSample = 0.85;   // that agree, for all to be tried
constexpr std::uint32_t kMostReordered = 500;  // elements

enum class Hiding : unsigned char { kTrue, kAllOrNothing, kNone };

// Several faults at once, but for the constant.
struct Reading {
  std::optional<PointRule> rule;  // nothing: the true factor
  Hiding hiding = Hiding::kTrue;
  const Orientation* orientation = &kOrientations.front();

  int price() const { return (rule ? 2 : 0) + (hiding == Hiding::kTrue ? 0 : 1) + orientation->price(); }
};

std::string rule_words(PointRule rule) {
  switch (rule) {
    case PointRule::kCenter:
      return "factors are those between centres";
    case PointRule::kDisk:
      return "factors are those from a centre to a disk of the same area";
    case PointRule::kVertices:
      return "factors are the means over pairs of corners";
    case PointRule::kGauss2:
      return "factors are the means over 2 Gauss points in each direction";
    case PointRule::kGauss4:
      break;
  }
  return "factors are the means over 4 Gauss points in each direction";
}

// What a reading predicts of a pair: a number, or that or 0.
struct Prediction {
  double value = 0;
  bool may_be_zero = false;
};

// What readings predict, and how well the numbers agree.
class Predictions {
 public:
  Predictions(const JudgedScene& scene, const JudgedPairs& judged, const std::vector<double>& unobstructed)
      : scene_(scene), judged_(judged), unobstructed_(unobstructed) {
    std::vector<const JudgedPair*> pairs;
    for (const JudgedPair& pair : judged.pairs())
      if (pair.to != sky()) pairs.push_back(&pair);
    sample_ = thinned(pairs, kSample);
  }

  // The ratio by which most of the sample agrees, where kLeastShareOfSample of it does.
  std::optional<Ratio> ratio_of(const Reading& reading) const;
  // Which pairs the reading explains; nothing where it leaves too many.
  std::optional<Hypothesis> explained(const Reading& reading, const Ratio& ratio) const;
  // What it predicts of a pair without constant; nothing of one whose other row is not there.
  std::optional<Prediction> of(const Reading& reading, std::uint32_t from, std::uint32_t to) const;

  bool may_go_to_sky(const JudgedPair& pair, double ratio) const;

 private:
  std::uint32_t sky() const { return judged_.exact().sky(); }
  double area(std::uint32_t i) const { return judged_.exact().elements()[i].area.value; }
  double unobstructed(std::uint32_t from, std::uint32_t to, const std::optional<FactorEntry>& entry) const;
  bool agrees(const JudgedPair& pair, const Prediction& prediction, double ratio) const {
    const auto is_near = [&](double with) {
      return pair.is_off ? judged_.agrees(pair, with) : std::abs(pair.value - with) <= judged_.tolerance(pair.value);
    };
    return is_near(ratio * prediction.value) || (prediction.may_be_zero && is_near(0));
  }
  bool centres_face(std::uint32_t from, std::uint32_t to) const;
  std::size_t agreeing(const std::vector<std::optional<Prediction>>& predictions, double ratio) const;
  bool sees_what_is_hidden(const Reading& reading, double ratio, double most) const;

  const JudgedScene& scene_;
  const JudgedPairs& judged_;
  const std::vector<double>& unobstructed_;
  std::vector<const JudgedPair*> sample_;
};

double Predictions::unobstructed(std::uint32_t from, std::uint32_t to, const std::optional<FactorEntry>& entry) const {
  if (entry && entry->visibility > 0) return entry->factor.value / entry->visibility;
  const auto known = [&](std::uint32_t i, std::uint32_t j) -> const JudgedPair* {
    const auto row = judged_.row(i);
    const auto at = std::lower_bound(row.begin(), row.end(), j,
                                     [](const JudgedPair& each, std::uint32_t column) { return each.to < column; });
    return at != row.end() && at->to == j && at->is_off ? &*at : nullptr;
  };
  if (const JudgedPair* pair = known(from, to)) return unobstructed_[judged_.index_of(*pair)];
  if (const JudgedPair* pair = known(to, from)) return unobstructed_[judged_.index_of(*pair)] * area(to) / area(from);
  return scene_.unobstructed_factor(from, to);
}

std::optional<Prediction> Predictions::of(const Reading& reading, std::uint32_t from, std::uint32_t to) const {
  const std::uint32_t i = reading.orientation->is_transposed ? to : from, j = from + to - i;
  if (!judged_.exact().has_row(i)) return std::nullopt;
  const std::optional<FactorEntry> entry = judged_.exact().row(i).find(j);
  const double visibility = entry ? entry->visibility : 0;
  if (visibility == 0 && reading.hiding != Hiding::kNone) return Prediction{};
  Prediction prediction;
  prediction.value = reading.rule ? scene_.factor_by(*reading.rule, i, j) : unobstructed(i, j, entry);
  if (reading.hiding == Hiding::kTrue) prediction.value *= visibility;
  prediction.may_be_zero = reading.hiding == Hiding::kAllOrNothing && (visibility < 1 || !centres_face(i, j));
  prediction.value *= reading.orientation->multiple(area(from), area(to));
  return prediction;
}

// Where they do not, the segment between them runs through a body, or comes from behind.
bool Predictions::centres_face(std::uint32_t from, std::uint32_t to) const {
  const auto place = scene_.place_of(from, to);
  return place && place->from_cosine > 0 && place->to_cosine > 0;
}

std::size_t Predictions::agreeing(const std::vector<std::optional<Prediction>>& predictions, double ratio) const {
  std::size_t count = 0;
  for (std::size_t k = 0; k < sample_.size(); ++k)
    count += predictions[k] && agrees(*sample_[k], *predictions[k], ratio);
  return count;
}

std::optional<Ratio> Predictions::ratio_of(const Reading& reading) const {
  std::vector<std::optional<Prediction>> predictions;
  std::vector<double> ratios;
  for (const JudgedPair* pair : sample_) {
    predictions.push_back(of(reading, pair->from, pair->to));
    const double predicted = predictions.back() ? predictions.back()->value : 0;
    if (predicted != 0 && std::abs(pair->value) > 100 * judged_.tolerance(pair->value))
      ratios.push_back(pair->value / predicted);
  }
  if (ratios.size() < kFewestValues) return std::nullopt;
  const double median = middle_of(ratios);
  const std::size_t most = agreeing(predictions, median), without = agreeing(predictions, 1);
  const auto is_enough = [&](std::size_t count) {
    return static_cast<double>(count) >= kLeastShareOfSample * static_cast<double>(sample_.size()) &&
           50 * count >= 49 * most;
  };
  if (is_enough(without)) return Ratio{};
  if (const auto named = named_ratio(median, kNear); named && is_enough(agreeing(predictions, named->value)))
    return named;
  return is_enough(most) ? std::optional(Ratio{median, ""}) : std::nullopt;
}

bool Predictions::may_go_to_sky(const JudgedPair& pair, double ratio) const {
  const double rest = judged_.rest_of_row(pair);
  return judged_.agrees(pair, 0) || judged_.agrees(pair, ratio * pair.exact) || judged_.agrees(pair, rest) ||
         judged_.agrees(pair, std::max(0.0, rest));
}

// Whether pairs that are wholly hidden, and are 0 in the file, would have more than `most` factors.
bool Predictions::sees_what_is_hidden(const Reading& reading, double ratio, double most) const {
  double count = 0;
  return reading.hiding == Hiding::kNone && judged_.any_of_zeros([&](std::uint32_t i, std::uint32_t j) {
    const auto prediction = of(reading, i, j);
    count += prediction && std::abs(ratio * prediction->value) > 2 * judged_.tolerance(0);
    return count > most;
  });
}

std::optional<Hypothesis> Predictions::explained(const Reading& reading, const Ratio& ratio) const {
  Hypothesis result = explains_nothing(Fault::kMethod, judged_);
  const double most = (1 - kLeastShareOfComposed) * static_cast<double>(judged_.off());
  double disagree = 0, lit = 0;  // lit: though wholly hidden, as predicted
  std::vector<double> values;
  for (const JudgedPair& pair : judged_.pairs()) {
    if (pair.to == sky()) {
      if (pair.is_off) result.explains[judged_.index_of(pair)] = static_cast<char>(may_go_to_sky(pair, ratio.value));
      continue;
    }
    const auto prediction = of(reading, pair.from, pair.to);
    const bool is_right = prediction && agrees(pair, *prediction, ratio.value);
    disagree += !is_right;
    if (disagree > most) return std::nullopt;
    if (!is_right || !pair.is_off) continue;
    result.explains[judged_.index_of(pair)] = 1;
    if (prediction->value != 0) values.push_back(prediction->value);
    lit += pair.visibility == 0 && prediction->value != 0;
  }
  std::sort(values.begin(), values.end());
  const auto end = std::unique(values.begin(), values.end(),
                               [](double a, double b) { return std::abs(b - a) <= 1e-9 * std::abs(b); });
  if (static_cast<std::size_t>(end - values.begin()) < kFewestValues) return std::nullopt;
  if (sees_what_is_hidden(reading, ratio.value, (1 - kLeastShareOfComposed) * lit)) return std::nullopt;
  return result;
}

// What was done, in words: the rule, what hides, the order, the constant.
ToldParts told(const Reading& reading, const Ratio& ratio) {
  ToldParts parts;
  if (reading.rule) parts.add(Fault::kMethod, rule_words(*reading.rule));
  if (reading.hiding == Hiding::kNone) parts.add(Fault::kNoOcclusion, "nothing hides anything");
  if (reading.hiding == Hiding::kAllOrNothing) parts.add(Fault::kAllOrNothing, "visibility is all or nothing");
  parts.add(*reading.orientation);
  parts.add(ratio);
  return parts;
}

// Factors in rows and columns, without the sky: what a reading predicts but for its order.
ExchangeMatrix predicted_matrix(const Predictions& predictions, const Reading& reading, const JudgedPairs& judged) {
  const ExchangeMatrix& exact = judged.exact();
  std::vector<std::vector<FactorEntry>> rows(exact.size());
  for (std::uint32_t i = 0; i < exact.size(); ++i)
    for (std::uint32_t j = 0; j < exact.size() && exact.has_row(i); ++j)
      if (const auto prediction = predictions.of(reading, i, j);
          prediction && prediction->value != 0 && judged.has_place(i, j))
        rows[i].push_back({j, {prediction->value, 0}, 1});
  return matrix_of_rows(exact.elements(), rows);
}

// Without the sky.
ExchangeMatrix divided_by(double ratio, const ExchangeMatrix& matrix) {
  std::vector<std::vector<FactorEntry>> rows(matrix.size());
  for (std::uint32_t i = 0; i < matrix.size(); ++i)
    for (const FactorEntry& entry : matrix.row(i))
      if (entry.to != matrix.sky()) rows[i].push_back({entry.to, {entry.factor.value / ratio, 0}, 1});
  return matrix_of_rows(matrix.elements(), rows);
}

// The ratio of the largest factors between faces, by size: no order changes these. Nothing where they differ otherwise.
std::optional<Ratio> ratio_of_largest(const ExchangeMatrix& matrix, const ExchangeMatrix& predicted) {
  const auto sorted = [](const ExchangeMatrix& of) {
    std::vector<double> values;
    for (std::uint32_t i = 0; i < of.size(); ++i)
      for (const FactorEntry& entry : of.row(i))
        if (entry.to != of.sky()) values.push_back(entry.factor.value);
    std::sort(values.begin(), values.end(), std::greater<>());
    return values;
  };
  const std::vector<double> a = sorted(matrix), b = sorted(predicted);
  const std::size_t count = std::min({a.size(), b.size(), std::size_t{100}});
  if (count < kFewestValues || !(b[count / 2] > 0)) return std::nullopt;
  Ratio ratio{a[count / 2] / b[count / 2], ""};
  std::size_t equal = 0;
  for (std::size_t k = 0; k < count; ++k) equal += std::abs(a[k] / (ratio.value * b[k]) - 1) < kNear;
  if (10 * equal < 9 * count) return std::nullopt;
  if (std::abs(ratio.value - 1) < kNear / 10) return Ratio{};
  const auto named = named_ratio(ratio.value, kNear / 10);
  return named ? *named : ratio;
}

std::optional<Hypothesis> reordered(const Predictions& predictions, const Reading& reading, const JudgedPairs& judged) {
  const ExchangeMatrix predicted = predicted_matrix(predictions, reading, judged);
  const std::optional<Ratio> ratio = ratio_of_largest(judged.matrix(), predicted);
  if (!ratio || (ratio->value == 1 && reading.price() == 0)) return std::nullopt;  // that alone is known
  const ExchangeMatrix scaled = divided_by(ratio->value, judged.matrix());
  const JudgedPairs frame(predicted, scaled, judged.tolerance(0) / std::min(1.0, std::abs(ratio->value)),
                          judged.places());
  for (const auto& suppose : {suppose_permuted, suppose_shifted, suppose_rows_permuted, suppose_columns_permuted}) {
    const Hypothesis order = suppose(frame);
    if (static_cast<double>(order.count()) < kLeastShareOfComposed * static_cast<double>(frame.off())) continue;
    if (frame.off() < kFewestValues) continue;
    const LeftWrong is_wrong(frame, order.explains);
    Hypothesis result = explains_nothing(Fault::kPermuted, judged);
    for (const JudgedPair& pair : judged.pairs())
      result.explains[judged.index_of(pair)] = static_cast<char>(
          pair.is_off && (pair.to == judged.exact().sky() ? predictions.may_go_to_sky(pair, ratio->value)
                                                          : !is_wrong.at(pair.from, pair.to)));
    ToldParts parts = told(reading, *ratio);
    parts.add(order.fault, order.words);
    parts.tell(result);
    return result;
  }
  return std::nullopt;
}

std::vector<Reading> readings_of(const JudgedScene& scene) {
  std::vector<Reading> readings;
  std::vector<std::optional<PointRule>> rules{std::nullopt};
  for (const PointRule rule : scene.point_rules()) rules.emplace_back(rule);
  for (const auto& rule : rules)
    for (const Hiding hiding : {Hiding::kTrue, Hiding::kNone, Hiding::kAllOrNothing})
      for (const Orientation& orientation : kOrientations) readings.push_back({rule, hiding, &orientation});
  return readings;
}

}  // namespace

std::optional<Hypothesis> suppose_composed(const JudgedScene& scene, const JudgedPairs& judged,
                                           const std::vector<double>& unobstructed, Orders orders) {
  const bool is_large = judged.exact().size() > kMostApproximated;
  const Predictions predictions(scene, judged, unobstructed);
  struct Candidate {
    Reading reading;
    Ratio ratio;
    int price() const { return reading.price() + ratio.price(); }
  };
  std::vector<Candidate> candidates;
  for (const Reading& reading : readings_of(scene)) {
    if (is_large && (reading.rule || reading.hiding == Hiding::kNone)) continue;
    if (const auto ratio = predictions.ratio_of(reading); ratio && reading.price() + ratio->price() > 0)
      candidates.push_back({reading, *ratio});
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.price() < b.price(); });
  std::optional<Hypothesis> best;
  int price = 0;
  for (const Candidate& candidate : candidates) {
    if (best && candidate.price() > price) break;
    auto hypothesis = predictions.explained(candidate.reading, candidate.ratio);
    if (!hypothesis ||
        static_cast<double>(hypothesis->count()) < kLeastShareOfComposed * static_cast<double>(judged.off()))
      continue;
    if (best && hypothesis->count() <= best->count()) continue;
    best = std::move(hypothesis);
    price = candidate.price();
    told(candidate.reading, candidate.ratio).tell(*best);
  }
  if (best || orders == Orders::kRight || judged.exact().size() > kMostReordered) return best;
  for (const Reading& reading : readings_of(scene))
    if (reading.hiding != Hiding::kAllOrNothing && reading.orientation->from_power == 0 &&
        reading.orientation->to_power == 0)
      if (auto hypothesis = reordered(predictions, reading, judged)) return hypothesis;
  return std::nullopt;
}

}  // namespace hottel
