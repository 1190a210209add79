// Readings of the numbers alone.
#include "solver/compare/hypotheses.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/name.h"
#include "solver/compare/named_factors.h"

namespace hottel {
namespace {

constexpr double kClear = 100;        // tolerances, from which on a number tells a ratio
constexpr std::uint64_t kFewest = 3;  // pairs that are no coincidence

// Marks the pairs that agree with what a reading predicts of them.
template <class Predict>
Hypothesis hypothesis(Fault fault, const JudgedPairs& judged, const Predict& predict) {
  Hypothesis result = explains_nothing(fault, judged);
  for (const JudgedPair& pair : judged.pairs())
    if (pair.is_off)
      if (const std::optional<double> with = predict(pair); with && judged.agrees(pair, *with))
        result.explains[judged.index_of(pair)] = 1;
  return result;
}

// The ratio that fits these pairs best: of the products value * exact to the squares.
double best_ratio(std::span<const JudgedPair> pairs, const std::vector<char>* wanted, const JudgedPairs& judged) {
  double products = 0, squares = 0;
  for (const JudgedPair& pair : pairs) {
    if (pair.to == judged.exact().sky() || (wanted && !(*wanted)[judged.index_of(pair)])) continue;
    products += pair.value * pair.exact;
    squares += pair.exact * pair.exact;
  }
  return squares > 0 ? products / squares : 0;
}

Hypothesis scaled_by(double ratio, const JudgedPairs& judged) {
  return hypothesis(Fault::kConstantFactor, judged, [&](const JudgedPair& pair) -> std::optional<double> {
    return pair.exact == 0 ? std::nullopt : std::optional(ratio * pair.exact);
  });
}

// A ratio that many of the pairs share: of those of the largest factors, the one that explains most, made better.
Hypothesis most_common_ratio(const JudgedPairs& judged, double& ratio) {
  std::vector<const JudgedPair*> large;
  for (const JudgedPair& pair : judged.pairs())
    if (pair.is_off && pair.exact > 0 && std::abs(pair.value) > kClear * judged.tolerance(pair.value))
      large.push_back(&pair);
  constexpr std::size_t kTried = 24;
  const std::size_t tried = std::min(kTried, large.size());
  std::partial_sort(large.begin(), large.begin() + static_cast<std::ptrdiff_t>(tried), large.end(),
                    [](const JudgedPair* a, const JudgedPair* b) { return a->exact > b->exact; });
  Hypothesis best = explains_nothing(Fault::kConstantFactor, judged);
  for (std::size_t k = 0; k < tried; ++k) {
    Hypothesis each = scaled_by(large[k]->value / large[k]->exact, judged);
    if (each.count() > best.count()) best = std::move(each);
  }
  if (best.count() == 0) return best;
  ratio = best_ratio(judged.pairs(), &best.explains, judged);
  Hypothesis refined = scaled_by(ratio, judged);
  return refined.count() >= best.count() ? refined : best;
}

// True iff the ratio holds for the pairs that are not off, too.
bool holds_for_all(const JudgedPairs& judged, double ratio) {
  return std::all_of(judged.pairs().begin(), judged.pairs().end(), [&](const JudgedPair& pair) {
    return pair.is_off || std::abs(pair.value - ratio * pair.exact) <= judged.tolerance(pair.value);
  });
}

// How many different factors a reading explains: what is symmetric repeats itself, and is no further evidence.
std::size_t different_factors(const JudgedPairs& judged, const Hypothesis& hypothesis) {
  std::vector<double> factors;
  for (const JudgedPair& pair : judged.pairs())
    if (hypothesis.explains[judged.index_of(pair)]) factors.push_back(pair.exact);
  std::sort(factors.begin(), factors.end());
  const auto end = std::unique(factors.begin(), factors.end(), [](double a, double b) { return b - a <= 1e-12 * b; });
  return static_cast<std::size_t>(end - factors.begin());
}

}  // namespace

Hypothesis explains_nothing(Fault fault, const JudgedPairs& judged) {
  return {fault, std::vector<char>(judged.pairs().size(), 0), ""};
}

std::uint64_t Hypothesis::count() const {
  return static_cast<std::uint64_t>(std::count(explains.begin(), explains.end(), 1));
}

Hypothesis suppose_transposed(const JudgedPairs& judged) {
  const ExchangeMatrix& exact = judged.exact();
  const auto has_row = [&](std::uint32_t j) { return j != exact.sky() && exact.has_row(j); };
  Hypothesis result = hypothesis(Fault::kTransposed, judged, [&](const JudgedPair& pair) -> std::optional<double> {
    return has_row(pair.to) ? std::optional(exact.factor(pair.to, pair.from).value) : std::nullopt;
  });
  std::uint64_t off = 0;
  for (const JudgedPair& pair : judged.pairs()) off += pair.is_off && has_row(pair.to);
  if (result.count() < kFewest || result.count() < off) {
    result.words =
        "factors stand at each other's place: F(j, i) for F(i, j), as if divided by the area of the other "
        "face";
    return result;
  }
  // What has no row is empty in the transposed matrix.
  for (const JudgedPair& pair : judged.pairs())
    if (pair.is_off && !has_row(pair.to) && judged.agrees(pair, 0)) result.explains[judged.index_of(pair)] = 1;
  result.words = "the matrix is transposed: F(j, i) stands for F(i, j), or was divided by the area of the other face";
  return result;
}

Hypothesis suppose_constant_factor(const JudgedPairs& judged) {
  double ratio = 1;
  Hypothesis best = most_common_ratio(judged, ratio);
  std::string named;
  if (different_factors(judged, best) < kFewest) best = explains_nothing(Fault::kConstantFactor, judged);
  for (const NamedFactor& factor : kNamedFactors) {
    Hypothesis each = scaled_by(factor.value, judged);
    if (each.count() == 0 || each.count() < best.count() || (each.count() == best.count() && !named.empty())) continue;
    best = std::move(each);
    ratio = factor.value;
    named = factor.words;
  }
  const bool is_all = best.count() == judged.off() && holds_for_all(judged, ratio);
  best.words = fmt::format("{} the exact ones times {}", is_all ? "all factors are" : "factors are",
                           named.empty() ? fmt::format("{:.6g}", ratio) : named);
  return best;
}

namespace {

struct ScaledRow {
  std::uint32_t row;
  double ratio;
};

// Rows of which all factors, the sky's perhaps excepted, are off by one ratio other than 0; none when each of them has
// one factor only, of which any number is some multiple.
std::vector<ScaledRow> scaled_rows(const JudgedPairs& judged) {
  std::vector<ScaledRow> rows;
  bool is_evident = false;
  for (std::uint32_t i = 0; i < judged.exact().size(); ++i) {
    const double ratio = best_ratio(judged.row(i), nullptr, judged);
    std::uint64_t off = 0;
    bool is_one_ratio = true;
    for (const JudgedPair& pair : judged.row(i)) {
      if (pair.to == judged.exact().sky()) continue;
      off += pair.is_off;
      is_one_ratio = is_one_ratio && std::abs(pair.value - ratio * pair.exact) <= judged.tolerance(pair.value);
    }
    if (off == 0 || !is_one_ratio || ratio == 0) continue;
    rows.push_back({i, ratio});
    is_evident = is_evident || off >= 2;
  }
  return is_evident ? rows : std::vector<ScaledRow>();
}

// Two rows divided by the area of each other.
std::optional<std::pair<std::uint32_t, std::uint32_t>> exchanged_areas(const JudgedPairs& judged,
                                                                       const std::vector<ScaledRow>& rows) {
  const auto area = [&](const ScaledRow& row) { return judged.exact().elements()[row.row].area.value; };
  const auto near = [](double a, double b) { return std::abs(a - b) <= 1e-4 * b; };
  if (rows.size() != 2) return std::nullopt;
  if (!near(rows[0].ratio, area(rows[0]) / area(rows[1])) || !near(rows[1].ratio, area(rows[1]) / area(rows[0])))
    return std::nullopt;
  return std::pair(rows[0].row, rows[1].row);
}

std::string row_factor_words(const JudgedPairs& judged, const std::vector<ScaledRow>& rows) {
  if (const auto pair = exchanged_areas(judged, rows))
    return fmt::format("the areas of {} and {} are exchanged: their rows are divided by each other's area",
                       quoted_name(judged.exact().name(pair->first)), quoted_name(judged.exact().name(pair->second)));
  bool is_one = true;
  double least = rows[0].ratio, most = rows[0].ratio;
  for (const ScaledRow& row : rows) {
    double sum = 0, largest = 0;
    for (const JudgedPair& pair : judged.row(row.row)) {
      if (pair.to != judged.exact().sky()) sum += pair.value;
      largest = std::max(largest, std::abs(pair.value));
    }
    const auto terms = static_cast<double>(judged.row(row.row).size());
    is_one = is_one && std::abs(sum - 1) <= terms * judged.tolerance(largest);
    least = std::min(least, row.ratio);
    most = std::max(most, row.ratio);
  }
  if (is_one)
    return fmt::format(
        "{} rows are normalised: rescaled by {:.4g} to {:.4g}, so that what goes to faces sums to 1 "
        "without the sky",
        rows.size(), least, most);
  return fmt::format("{} rows are rescaled, each by a ratio of its own from {:.6g} to {:.6g}", rows.size(), least,
                     most);
}

}  // namespace

Hypothesis suppose_row_factor(const JudgedPairs& judged) {
  Hypothesis result = explains_nothing(Fault::kRowFactor, judged);
  const std::vector<ScaledRow> rows = scaled_rows(judged);
  for (const ScaledRow& row : rows)
    for (const JudgedPair& pair : judged.row(row.row))
      if (pair.is_off && judged.agrees(pair, row.ratio * pair.exact)) result.explains[judged.index_of(pair)] = 1;
  if (!rows.empty()) result.words = row_factor_words(judged, rows);
  return result;
}

Hypothesis suppose_sky_missing(const JudgedPairs& judged) {
  Hypothesis result = hypothesis(Fault::kSkyMissing, judged, [&](const JudgedPair& pair) {
    return pair.to == judged.exact().sky() ? std::optional(0.0) : std::nullopt;
  });
  result.words = "nothing goes to the sky";
  return result;
}

Hypothesis suppose_sky_is_rest(const JudgedPairs& judged) {
  Hypothesis result = hypothesis(Fault::kSkyIsRest, judged, [&](const JudgedPair& pair) -> std::optional<double> {
    if (pair.to != judged.exact().sky()) return std::nullopt;
    return judged.rest_of_row(pair);
  });
  result.words = "the sky gets what the rows lack of 1, and so their errors";
  return result;
}

Hypothesis suppose_missing(const JudgedPairs& judged) {
  Hypothesis result = hypothesis(Fault::kMissing, judged, [](const JudgedPair&) { return std::optional(0.0); });
  result.words = "pairs that see each other are missing or 0";
  std::uint64_t above = 0, below = 0;  // the diagonal
  for (const JudgedPair& pair : judged.pairs()) {
    if (std::abs(pair.value) <= judged.tolerance(pair.value) || pair.to == judged.exact().sky()) continue;
    if (!judged.exact().has_row(pair.to)) continue;
    ++(pair.to > pair.from ? above : below);
  }
  if (above + below >= kFewest && (above == 0 || below == 0))
    result.words = fmt::format(
        "only one triangle of the matrix is there, the {} one, as of a symmetric one; the other half is 0 (A F is "
        "symmetric, F is not)",
        above == 0 ? "lower" : "upper");
  return result;
}

}  // namespace hottel
