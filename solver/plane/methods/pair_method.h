// Methods that look at two straight runs at a time: what they share.
#pragma once

#include <functional>
#include <optional>
#include <utility>

#include "solver/methods/pair_rows.h"
#include "solver/plane/methods/element_geometry.h"
#include "solver/plane/methods/exchange_method.h"

namespace hottel {

// A method whose factor of two elements depends on these two, and on what stands between them.
//
// The matrix (matrix_of_pairs) and the claims are made here: a pair that exchanges nothing is claimed to be exactly 0,
// one that nothing hides to be within error_of_free_runs(), one that is hidden in part as the method says.
class PairMethod2 : public ElementMethod2 {
 public:
  const MethodInfo& info() const final { return info_; }
  FactorsOfPairs factors_of_pairs(const PreparedScene2& prepared) const final;
  std::optional<double> declared_error(const PreparedScene2& prepared) const final;
  // COST: that of the exact matrix, once.
  ClaimedErrors claimed_errors(const PreparedScene2& prepared) const final;

 protected:
  explicit PairMethod2(MethodInfo info) : info_(std::move(info)) {}
  ExchangeMatrix compute_elements(const PreparedScene2& prepared, const std::function<void(double)>& progress,
                                  MethodReport& report) const final;

  using Pairs = PairsOfElements;
  // REQUIRES that `prepared` and `geometry` outlive what is returned.
  virtual Pairs pairs(const PreparedScene2& prepared, const ElementGeometry2& geometry) const = 0;

  // What the method claims of two runs that nothing hides from each other: a bound for the error of the measure S(a, b)
  // divided by the product of their lengths, in local units. Infinity: nothing.
  virtual double error_of_free_runs(const Vertices2& vertices, const ElementGeometry2& geometry, const ElementRun2& a,
                                    const ElementRun2& b) const;

  // Whether the claim holds also for pairs that others hide in part: when the method knows the hidden part exactly.
  virtual bool claims_hidden_pairs() const { return false; }

 private:
  double error_of_free_pair(const Vertices2& vertices, const ElementGeometry2& geometry, std::uint32_t from,
                            std::uint32_t to) const;
  MethodInfo info_;
};

// The factors that belong to a measure S(a, b) of two runs: F_ab = S / (length of a), summed over the runs of both
// elements. Both are 0 where the sum is not above 0.
template <class Measure>
PairFactors sum_over_runs(const ElementGeometry2& geometry, std::uint32_t i, std::uint32_t j, const Measure& measure) {
  double sum = 0;
  for (const ElementRun2& a : geometry.runs(i))
    for (const ElementRun2& b : geometry.runs(j)) sum += measure(a, b);
  return sum > 0 ? PairFactors{sum / geometry.length(i), sum / geometry.length(j)} : PairFactors{};
}

}  // namespace hottel
