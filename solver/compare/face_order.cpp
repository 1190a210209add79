// Faces in another order than the scene has them.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "geometry/name.h"
#include "solver/compare/hypotheses.h"

namespace hottel {
namespace {

constexpr std::uint32_t kMostFaces = 500;
constexpr std::uint64_t kMostChecks = 20'000'000;

// Looks for an order p of the faces with a row such that value(i, j) is exact(p(i), p(j)), face by face, taking back
// what does not fit.
class OrderSearch {
 public:
  explicit OrderSearch(const JudgedPairs& judged) : judged_(judged) {
    const ExchangeMatrix& exact = judged.exact();
    for (std::uint32_t i = 0; i < exact.size(); ++i)
      if (exact.has_row(i)) faces_.push_back(i);
    n_ = faces_.size();
  }

  // The order as places among the faces with a row; empty when there is none.
  std::vector<std::size_t> find();
  const std::vector<std::uint32_t>& faces() const { return faces_; }

 private:
  void fill();
  void find_candidates();
  bool fits(std::size_t row, std::size_t as) const;
  bool place(std::size_t depth);
  bool is_near(double value, double exact) const { return std::abs(value - exact) <= judged_.tolerance(value); }

  const JudgedPairs& judged_;
  std::vector<std::uint32_t> faces_;
  std::size_t n_ = 0;
  std::vector<double> value_, exact_;  // dense, of the faces with a row
  std::vector<std::vector<std::size_t>> candidates_;
  std::vector<std::size_t> turn_, order_;  // rows, fewest candidates first; what each is
  std::vector<char> is_taken_;
  mutable std::uint64_t checks_ = 0;
};

void OrderSearch::fill() {
  std::vector<std::size_t> place(judged_.exact().size() + 1, n_);
  for (std::size_t k = 0; k < n_; ++k) place[faces_[k]] = k;
  value_.assign(n_ * n_, 0);
  exact_.assign(n_ * n_, 0);
  for (const JudgedPair& pair : judged_.pairs())
    if (place[pair.to] < n_) {
      value_[place[pair.from] * n_ + place[pair.to]] = pair.value;
      exact_[place[pair.from] * n_ + place[pair.to]] = pair.exact;
    }
}

// A row may be another when both hold the same numbers, in whatever order.
void OrderSearch::find_candidates() {
  const auto sorted_row = [&](const std::vector<double>& dense, std::size_t k) {
    std::vector<double> row(dense.begin() + static_cast<std::ptrdiff_t>(k * n_),
                            dense.begin() + static_cast<std::ptrdiff_t>((k + 1) * n_));
    std::sort(row.begin(), row.end(), std::greater<>());  // the largest tell the most
    return row;
  };
  std::vector<std::vector<double>> exact_rows;
  for (std::size_t k = 0; k < n_; ++k) exact_rows.push_back(sorted_row(exact_, k));
  candidates_.assign(n_, {});
  for (std::size_t k = 0; k < n_; ++k) {
    const std::vector<double> row = sorted_row(value_, k);
    for (std::size_t as = 0; as < n_; ++as)
      if (std::equal(row.begin(), row.end(), exact_rows[as].begin(),
                     [&](double value, double exact) { return is_near(value, exact); }))
        candidates_[k].push_back(as);
    const auto itself = std::find(candidates_[k].begin(), candidates_[k].end(), k);
    if (itself != candidates_[k].end()) std::rotate(candidates_[k].begin(), itself, itself + 1);
  }
}

bool OrderSearch::fits(std::size_t row, std::size_t as) const {
  for (const std::size_t other : turn_) {
    if (order_[other] == n_ && other != row) break;  // not placed yet, nor what comes after it
    const std::size_t other_as = other == row ? as : order_[other];
    ++checks_;
    if (!is_near(value_[row * n_ + other], exact_[as * n_ + other_as]) ||
        !is_near(value_[other * n_ + row], exact_[other_as * n_ + as]))
      return false;
    if (other == row) break;
  }
  return true;
}

bool OrderSearch::place(std::size_t depth) {
  if (depth == n_) return true;
  const std::size_t row = turn_[depth];
  for (const std::size_t as : candidates_[row]) {
    if (checks_ > kMostChecks) return false;
    if (is_taken_[as] || !fits(row, as)) continue;
    is_taken_[as] = 1;
    order_[row] = as;
    if (place(depth + 1)) return true;
    is_taken_[as] = 0;
    order_[row] = n_;
  }
  return false;
}

std::vector<std::size_t> OrderSearch::find() {
  if (n_ < 2 || n_ > kMostFaces) return {};
  fill();
  find_candidates();
  for (std::size_t k = 0; k < n_; ++k) turn_.push_back(k);
  std::stable_sort(turn_.begin(), turn_.end(),
                   [&](std::size_t a, std::size_t b) { return candidates_[a].size() < candidates_[b].size(); });
  if (candidates_[turn_.front()].empty()) return {};
  order_.assign(n_, n_);
  is_taken_.assign(n_, 0);
  return place(0) ? order_ : std::vector<std::size_t>();
}

std::string order_words(const JudgedPairs& judged, const std::vector<std::uint32_t>& faces,
                        const std::vector<std::size_t>& order) {
  const std::size_t n = order.size();
  bool is_reversed = true, is_shifted = true;
  std::size_t moved = 0, first = n;
  for (std::size_t k = 0; k < n; ++k) {
    is_reversed = is_reversed && order[k] == n - 1 - k;
    is_shifted = is_shifted && order[k] == (k + order[0]) % n;
    if (order[k] == k) continue;
    ++moved;
    if (first == n) first = k;
  }
  const auto name = [&](std::size_t k) { return quoted_name(judged.exact().elements()[faces[k]].name); };
  const std::string how = is_reversed  ? " (reversed)"
                          : is_shifted ? fmt::format(" (shifted by {})", order[0])
                          : moved == 2 ? " (two are exchanged)"
                                       : "";
  return fmt::format("faces are in another order{}: what stands for {} belongs to {}", how, name(first),
                     name(order[first]));
}

}  // namespace

Hypothesis suppose_permuted(const JudgedPairs& judged) {
  Hypothesis result{Fault::kPermuted, std::vector<char>(judged.pairs().size(), 0), ""};
  if (judged.off() < 2) return result;
  OrderSearch search(judged);
  const std::vector<std::size_t> order = search.find();
  if (order.empty()) return result;
  // Backs without a row and the sky go with the fronts.
  const ExchangeMatrix& exact = judged.exact();
  std::vector<std::uint32_t> becomes(exact.size() + 1);
  for (std::uint32_t i = 0; i <= exact.sky(); ++i) becomes[i] = i;
  for (std::size_t k = 0; k < order.size(); ++k) becomes[search.faces()[k]] = search.faces()[order[k]];
  for (const JudgedPair& pair : judged.pairs())
    if (pair.is_off && judged.agrees(pair, exact.factor(becomes[pair.from], becomes[pair.to]).value))
      result.explains[judged.index_of(pair)] = 1;
  if (result.count() > 0) result.words = order_words(judged, search.faces(), order);
  return result;
}

}  // namespace hottel
