#include "solver/compare/judged_pairs.h"

#include <algorithm>
#include <cmath>

namespace hottel {

JudgedPairs::JudgedPairs(const ExchangeMatrix& exact, const ExchangeMatrix& matrix, double beyond,
                         const WrittenFactors& written)
    : exact_(&exact), matrix_(&matrix), beyond_(beyond), written_(written), begin_(exact.size() + 1, 0) {
  const auto add = [&](std::uint32_t from, std::uint32_t to, double value, const std::optional<FactorEntry>& right) {
    if (!written_.has_place(from, to)) return;
    JudgedPair pair{from, to, value};
    if (right) pair.exact = right->factor.value;
    pair.visibility = right ? right->visibility : 0;
    pair.is_off = pair.error() > tolerance(value);
    off_ += pair.is_off;
    pairs_.push_back(pair);
  };
  for (std::uint32_t i = 0; i < exact.size(); ++i) {
    auto right = exact.row(i).begin();
    const auto rights = exact.row(i).end();
    for (const FactorEntry& entry : matrix.row(i)) {
      for (; right != rights && right->to < entry.to; ++right) add(i, right->to, 0, *right);
      const bool is_common = right != rights && right->to == entry.to;
      add(i, entry.to, entry.factor.value, is_common ? std::optional(*right) : std::nullopt);
      if (is_common) ++right;
    }
    for (; right != rights; ++right) add(i, right->to, 0, *right);
    begin_[i + 1] = pairs_.size();
  }
  for (JudgedPair& pair : pairs_) {
    if (!pair.is_off || pair.to == exact.sky()) continue;
    const auto back = row(pair.to);
    const auto reverse = std::lower_bound(back.begin(), back.end(), pair.from,
                                          [](const JudgedPair& each, std::uint32_t to) { return each.to < to; });
    pair.is_reverse_off = reverse != back.end() && reverse->to == pair.from && reverse->is_off;
  }
}

bool JudgedPairs::agrees(const JudgedPair& pair, double with) const {
  const double rest = std::abs(pair.value - with);
  return rest <= tolerance(pair.value) && rest <= pair.error() / 2;
}

double JudgedPairs::rest_of_row(const JudgedPair& pair) const {
  double rest = 1;
  for (const JudgedPair& other : row(pair.from))
    if (other.to != pair.to) rest -= other.value;
  return rest;
}

}  // namespace hottel
