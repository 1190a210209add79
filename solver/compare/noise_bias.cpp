#include "solver/compare/noise_bias.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <numbers>
#include <set>

#include "geometry/name.h"
#include "kernel/plain_functions.h"
#include "solver/compare/named_factors.h"
#include "solver/compare/samples.h"

namespace hottel {
namespace {

constexpr double kExactByChance = 1e-4;      // of as many rows
constexpr double kLevelOfLeaky = 0.05;       // at which a method that leaks for sure is called biased
constexpr std::size_t kFewestToScatter = 4;  // pairs that tell how much a row scatters
constexpr const char* kAllFactors = "all factors";
constexpr std::size_t kMostTold = 3;

enum class SumKind { kHits, kRow, kAll };

// A sum of errors with the variance of unbiased rays.
struct Sum {
  std::string of;
  SumKind kind = SumKind::kHits;
  std::vector<std::uint32_t> members{};  // columns, or the row
  double error = 0, exact = 0, variance = 0;
  double own = 0;  // the squares of what is left of it, row by row
  std::size_t rows = 0;
  double log_chance = 0;  // of one test
};

// "box[1]#0" has the names "box[1]#0", "box[1]" and "box". Backs are in no group.
std::vector<std::string> names_of(const std::string& element) {
  std::vector<std::string> names = {element};
  const std::string face = element.substr(0, element.find('#'));
  if (face != element) names.push_back(face);
  if (const std::size_t bracket = face.rfind('['); bracket != std::string::npos && bracket > 0 && face.back() == ']')
    names.push_back(face.substr(0, bracket));
  return names;
}

std::string words_of(const Sum& sum) {
  const double ratio = 1 + sum.error / sum.exact;
  if (sum.of == kAllFactors)
    for (const NamedFactor& named : kNamedFactors)
      if (std::abs(named.value - 1) > 0.1 && std::abs(ratio / named.value - 1) < 0.02)
        return fmt::format("all factors are about the exact ones times {}", named.words);
  const bool is_more = sum.error > 0;
  const char* how = sum.of.starts_with("what ")   ? (is_more ? "is too much" : "is short")
                    : sum.of.starts_with("hits ") ? (is_more ? "are too many" : "are short")
                                                  : (is_more ? "are too large" : "are too small");
  return fmt::format("{} {} by {:.2g} %", sum.of, how, 100 * std::abs(sum.error / sum.exact));
}

class BiasTests {
 public:
  BiasTests(const JudgedPairs& judged, std::span<const ScatteredPair> pairs, RaySpread spread, double scale,
            double rays)
      : judged_(judged), pairs_(pairs), spread_(spread), scale_(scale), rays_(rays) {
    look_at_rows();
    is_symmetric_ = is_symmetric(judged, pairs);
    name_columns();
  }

  NoiseBias run();

 private:
  using Row = std::span<const ScatteredPair>;

  void look_at_rows();
  void name_columns();
  double widening(Row row) const;
  void add_row(Row row);
  void add_weighted(Sum& sum, bool is_of_counts, const std::function<double(const JudgedPair&)>& weight) const;
  void add_by_signs();
  bool is_counter() const { return is_counter_; }
  // Of a part of a row: hits that one counter counts on several faces are counted together.
  double variance_of_part(double exact, double variances) const {
    return is_counter() && spread_ == RaySpread::kRandom ? exact * (1 - std::min(exact, 1.0)) : variances;
  }
  template <class Visit>
  void for_each_row(const Visit& visit) const {
    for (std::size_t begin = 0, end = 0; begin < pairs_.size(); begin = end) {
      while (end < pairs_.size() && pairs_[end].pair->from == pairs_[begin].pair->from) ++end;
      visit(pairs_.subspan(begin, end - begin));
    }
  }
  double log_chance(const Sum& sum) const {
    if (sum.error == 0 || !(sum.exact > 0)) return 0;
    const double half = is_symmetric_ ? 0 : std::abs(sum.error) / (3 * rays_);
    return std::numbers::ln2 - sum.error * sum.error / 2 / (sum.variance + half);
  }

  const JudgedPairs& judged_;
  std::span<const ScatteredPair> pairs_;
  RaySpread spread_;
  double scale_, rays_;
  RowClosure rows_;
  bool is_counter_ = false;  // more rows are exact than would be where pairs are counted one by one
  std::vector<char> is_row_off_;
  bool is_symmetric_ = false;
  std::vector<Sum> sums_;                            // of columns first
  std::vector<std::vector<std::size_t>> of_column_;  // the places of its sums
};

// The chance of `count` or more where `expected` are.
double poisson_tail(std::size_t count, double expected) {
  double below = 0, term = same_bits::exp(-expected);
  for (std::size_t k = 0; k < count; ++k) {
    below += term;
    term *= expected / static_cast<double>(k + 1);
  }
  return std::max(0.0, 1 - below);
}

void BiasTests::look_at_rows() {
  double by_chance = 0;
  is_row_off_.assign(judged_.exact().size(), 0);
  for_each_row([&](Row row) {
    const std::uint32_t i = row.front().pair->from;
    double sum = 0, exact = 0, slack = judged_.tolerance(0);
    std::size_t off = 0;
    for (const JudgedPair& pair : judged_.row(i)) {
      sum += pair.value;
      exact += pair.exact;
      slack += judged_.rounding(pair.value);
      off += pair.is_off;
    }
    double tested = 0, counts = 0;  // the variance of the number of hits, pair by pair
    for (const ScatteredPair& each : row) {
      tested += each.pair->exact;
      counts += rays_ * each.pair->exact * (1 - each.pair->exact);
    }
    if (exact < 1 - 1e-9 || tested < exact - 1e-9) return;  // some of it is not in the file, or left out
    const double defect = std::abs(sum - exact);
    is_row_off_[i] = defect > slack;
    if (off < 2) return;
    ++(defect > slack ? rows_.off : rows_.exact);
    rows_.most = std::max(rows_.most, defect);
    by_chance += 1 / std::sqrt(1 + 2 * std::numbers::pi * counts);
  });
  is_counter_ = rows_.exact > 0 && poisson_tail(rows_.exact, by_chance) < kExactByChance;
}

void BiasTests::name_columns() {
  std::map<std::string, std::vector<std::uint32_t>> by_name;
  std::set<std::uint32_t> columns;
  for (const ScatteredPair& each : pairs_) columns.insert(each.pair->to);
  for (const std::uint32_t j : columns)
    for (const std::string& name : names_of(judged_.exact().name(j))) by_name[name].push_back(j);
  std::set<std::vector<std::uint32_t>> taken;  // a face of one element, a group of one face
  of_column_.resize(judged_.exact().size() + 1);
  for (const auto& [name, members] : by_name) {
    if (!taken.insert(members).second) continue;
    for (const std::uint32_t j : members) of_column_[j].push_back(sums_.size());
    const bool is_sky = members.front() == judged_.exact().sky();
    const std::string of = (is_symmetric_ ? "factors of " : "hits on ") + quoted_name(name);
    sums_.push_back({is_sky ? "what goes to the sky" : of, SumKind::kHits, members});
  }
}

// By how much a row scatters more than all do: by the median, which a few pairs that are wrong otherwise leave alone.
double BiasTests::widening(Row row) const {
  if (row.size() < kFewestToScatter) return 1;
  std::vector<double> squares;
  for (const ScatteredPair& each : row) squares.push_back(each.rest * each.rest * scale_ / each.variance);
  const auto count = static_cast<double>(row.size());
  return std::max(1.0, middle_of(squares) / kMedianOfSquares * count / (count - 2));
}

void BiasTests::add_row(Row row) {
  struct Part {
    double error = 0, exact = 0, variances = 0, rest = 0;
  };
  std::map<std::size_t, Part> parts;
  Part whole;
  const auto add = [](Part& part, const ScatteredPair& each) {
    part.error += each.error;
    part.exact += each.pair->exact;
    part.variances += each.variance;
    part.rest += each.rest;
  };
  for (const ScatteredPair& each : row) {
    add(whole, each);
    for (const std::size_t k : of_column_[each.pair->to]) add(parts[k], each);
  }
  const double wide = widening(row) / scale_;
  for (const auto& [k, part] : parts) {
    Sum& sum = sums_[k];
    sum.error += part.error;
    sum.exact += part.exact;
    sum.variance += wide * variance_of_part(part.exact, part.variances);
    sum.own += part.rest * part.rest;
    ++sum.rows;
  }
  const std::uint32_t i = row.front().pair->from;
  if (!is_row_off_[i]) return;
  sums_.push_back({"what leaves " + quoted_name(judged_.exact().name(i)),
                   SumKind::kRow,
                   {i},
                   whole.error,
                   whole.exact,
                   wide * whole.variances});
}

// A sum over all rows, each pair with a weight from 0 to 1. is_of_counts: its variance is that of one counter.
void BiasTests::add_weighted(Sum& sum, bool is_of_counts,
                             const std::function<double(const JudgedPair&)>& weight) const {
  for_each_row([&](Row row) {
    double squares = 0, mean = 0, variances = 0;
    for (const ScatteredPair& each : row) {
      const double w = weight(*each.pair);
      sum.error += w * each.error;
      mean += w * each.pair->exact;
      squares += w * w * each.pair->exact;
      variances += w * w * each.variance;
    }
    sum.exact += mean;
    sum.variance += widening(row) / scale_ * (is_of_counts ? std::max(0.0, squares - mean * mean) : variances);
  });
}

// Of factors that are the same both ways: each pair once, and no variance but its own.
void BiasTests::add_by_signs() {
  const ExchangeMatrix& exact = judged_.exact();
  Sum all{kAllFactors, SumKind::kAll};
  for (const ScatteredPair& each : pairs_) {
    const JudgedPair& pair = *each.pair;
    const bool is_row = pair.to != exact.sky() && exact.has_row(pair.to);
    if (is_row && pair.to < pair.from) continue;
    const double area = exact.elements()[pair.from].area.value;
    const auto add = [&](Sum& sum) {
      sum.error += area * each.error;
      sum.exact += area * pair.exact;
      sum.variance += area * each.error * area * each.error;
    };
    add(all);
    std::set<std::size_t> places(of_column_[pair.to].begin(), of_column_[pair.to].end());
    if (is_row) places.insert(of_column_[pair.from].begin(), of_column_[pair.from].end());
    for (const std::size_t k : places) add(sums_[k]);
  }
  sums_.push_back(all);
}

NoiseBias BiasTests::run() {
  if (is_symmetric_) {
    add_by_signs();
  } else {
    for_each_row([&](Row row) { add_row(row); });
    const std::uint32_t sky = judged_.exact().sky();
    Sum all{kAllFactors, SumKind::kAll}, hidden{"factors of partly hidden pairs", SumKind::kAll},
        large{"large factors", SumKind::kAll};
    const bool is_of_counts = is_counter() && spread_ == RaySpread::kRandom;
    if (rows_.off > 0) add_weighted(all, false, [](const JudgedPair&) { return 1.0; });
    add_weighted(hidden, is_of_counts, [sky](const JudgedPair& pair) {
      return pair.to != sky && pair.visibility > 0 && pair.visibility < 1 ? 1.0 : 0.0;
    });
    add_weighted(large, is_of_counts, [](const JudgedPair& pair) { return pair.exact; });
    sums_.insert(sums_.end(), {all, hidden, large});
  }
  for (Sum& sum : sums_) {
    if (!is_symmetric_ && sum.rows > 2)
      sum.variance =
          std::max(sum.variance, sum.own * static_cast<double>(sum.rows) / static_cast<double>(sum.rows - 1));
    // What roundings leave of a sum that is the same in every row is no error.
    if (std::abs(sum.error) <= 1e-12 * sum.exact) sum.error = 0;
    sum.log_chance = log_chance(sum) + same_bits::log(static_cast<double>(sums_.size()));
  }
  std::stable_sort(sums_.begin(), sums_.end(), [](const Sum& a, const Sum& b) { return a.log_chance < b.log_chance; });
  NoiseBias result;
  result.rows = rows_;
  // What is wrong with all is wrong with the large ones, too.
  if (sums_.front().kind == SumKind::kAll)
    if (const auto all = std::find_if(sums_.begin(), sums_.end(), [](const Sum& sum) { return sum.of == kAllFactors; });
        all != sums_.end() && all->log_chance < same_bits::log(kBiasLevel))
      std::rotate(sums_.begin(), all, all + 1);
  result.is_leaky = !is_symmetric_ && is_counter() && rows_.off > 0;
  const double level = result.is_leaky ? kLevelOfLeaky : kBiasLevel;
  std::set<std::uint32_t> told;
  for (const Sum& sum : sums_) {
    if (sum.log_chance > same_bits::log(level) || result.sums.size() == kMostTold) break;
    if (sum.kind != sums_.front().kind || std::any_of(sum.members.begin(), sum.members.end(),
                                                      [&](std::uint32_t member) { return told.contains(member); }))
      continue;
    result.sums.push_back({words_of(sum), sum.error / sum.exact, same_bits::exp(sum.log_chance)});
    told.insert(sum.members.begin(), sum.members.end());
    if (sum.kind == SumKind::kAll) break;
  }
  return result;
}

}  // namespace

bool is_symmetric(const JudgedPairs& judged, std::span<const ScatteredPair> pairs) {
  const ExchangeMatrix& exact = judged.exact();
  std::size_t both = 0;
  for (const ScatteredPair& each : pairs) {
    const JudgedPair& pair = *each.pair;
    if (!pair.is_off || pair.to <= pair.from || pair.to == exact.sky() || !exact.has_row(pair.to)) continue;
    const double reverse = judged.matrix().factor(pair.to, pair.from).value;
    const double a = exact.elements()[pair.from].area.value, b = exact.elements()[pair.to].area.value;
    if (std::abs(a * pair.value - b * reverse) > a * judged.tolerance(pair.value) + b * judged.tolerance(reverse))
      return false;
    ++both;
  }
  return both > 1;
}

NoiseBias noise_bias(const JudgedPairs& judged, std::span<const ScatteredPair> pairs, RaySpread spread, double scale,
                     double rays) {
  return BiasTests(judged, pairs, spread, scale, rays).run();
}

}  // namespace hottel
