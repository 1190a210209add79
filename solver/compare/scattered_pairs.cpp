#include "solver/compare/scattered_pairs.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "solver/compare/samples.h"

namespace hottel {
namespace {

constexpr int kPasses = 12;
constexpr double kFewestFree = 20;  // pairs, beyond those that rows and columns take
constexpr double kLeastFreeShare = 0.25;

// Fits the shares of rows or of columns to what the others leave.
void fit_shares(std::span<const ScatteredPair> pairs, bool is_of_rows, const std::vector<double>& others,
                std::vector<double>& shares) {
  std::vector<double> products(shares.size(), 0), squares(shares.size(), 0);
  std::vector<int> count(shares.size(), 0);
  for (const ScatteredPair& each : pairs) {
    const std::uint32_t here = is_of_rows ? each.pair->from : each.pair->to,
                        there = is_of_rows ? each.pair->to : each.pair->from;
    const double exact = each.pair->exact;
    products[here] += exact * (each.error - others[there] * exact) / each.variance;
    squares[here] += exact * exact / each.variance;
    ++count[here];
  }
  for (std::size_t k = 0; k < shares.size(); ++k) shares[k] = count[k] > 1 ? products[k] / squares[k] : 0;
}

}  // namespace

double variance_of_one(double exact, RaySpread spread) {
  const double of_random = exact * (1 - exact);
  return spread == RaySpread::kEven ? std::sqrt(of_random) : of_random;
}

std::vector<ScatteredPair> scattered_pairs(const JudgedPairs& judged, const std::vector<char>& leave_out,
                                           RaySpread spread) {
  std::vector<ScatteredPair> pairs;
  for (const JudgedPair& pair : judged.pairs()) {
    if (!leave_out.empty() && leave_out[judged.index_of(pair)]) continue;
    const double variance = pair.exact > 0 && pair.exact < 1 ? variance_of_one(pair.exact, spread) : 0;
    if (variance > 0) pairs.push_back({&pair, pair.value - pair.exact, variance, 0});
  }
  std::vector<double> rows(judged.exact().size() + 1, 0), columns(judged.exact().size() + 1, 0);
  for (int pass = 0; pass < kPasses; ++pass) {
    fit_shares(pairs, false, rows, columns);
    fit_shares(pairs, true, columns, rows);
  }
  for (ScatteredPair& each : pairs)
    each.rest = each.error - (rows[each.pair->from] + columns[each.pair->to]) * each.pair->exact;
  return pairs;
}

ScatterScale scatter_scale(std::span<const ScatteredPair> pairs, double rays, double fewest) {
  std::vector<double> squares;
  std::set<std::uint32_t> rows, columns;
  for (const ScatteredPair& each : pairs) {
    if (rays * std::min(each.pair->exact, 1 - each.pair->exact) < fewest) continue;
    squares.push_back(each.rest * each.rest / each.variance);
    rows.insert(each.pair->from);
    columns.insert(each.pair->to);
  }
  const auto count = static_cast<double>(squares.size());
  const double freedom = count - static_cast<double>(rows.size() + columns.size());
  if (freedom < std::max(kFewestFree, kLeastFreeShare * count)) return {};
  const double middle = middle_of(squares);
  return {middle > 0 ? kMedianOfSquares / middle * freedom / count : 0, freedom};
}

}  // namespace hottel
