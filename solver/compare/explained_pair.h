// A pair of elements that a method gets most wrong, and what makes it hard.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "solver/compare/matrix_errors.h"
#include "solver/compare/method_result.h"

namespace hottel {

// How much of a pair is hidden, how near and at what angle its elements are: why a method may find it hard. Numbers are
// for people: rounded, without bounds.
struct PairExplanation {
  std::optional<double> visibility;  // S / S0; nothing when they do not face each other. Of the sky: its factor
  std::optional<double> distance;    // between their middles [scene unit]; nothing of the sky
  std::optional<double> angle;       // between their normals [degrees], 180 when they look at each other
  std::string reason;                // in words, e.g. "partly hidden, touching"
};

// "they do not face each other", "hidden", "partly hidden" or "in full view".
inline std::string sight_in_words(const std::optional<double>& visibility) {
  if (!visibility) return "they do not face each other";
  return *visibility == 0 ? "hidden" : *visibility < 1 ? "partly hidden" : "in full view";
}

// ", missed", ", light where there is none", or nothing.
inline std::string mistake_in_words(const PairError& pair) {
  if (pair.value == 0 && pair.exact > 0) return ", missed";
  return pair.value > 0 && pair.exact == 0 ? ", light where there is none" : "";
}

// A pair that a method gets most wrong, with its elements by name; "sky" for the sky.
struct ExplainedPair {
  std::string method, from, to;
  PairError error;
  PairExplanation explanation;
};

// Returns the pairs that a result gets most wrong, the worst first, at most `count` (worst_pairs() of matrix_errors.h).
// exact: as given to the explainer, one of PairExplainer2 and its like. REQUIRES a result with its matrix.
template <class Explainer>
std::vector<ExplainedPair> explained_worst_pairs(const Explainer& explainer, const ExchangeMatrix& exact,
                                                 const MethodResult& result, std::size_t count) {
  std::vector<ExplainedPair> explained;
  for (const PairError& pair :
       worst_pairs(result.matrix, exact, count, result.report.written.value_or(WrittenFactors())))
    explained.push_back({result.info.name, exact.name(pair.from), exact.name(pair.to), pair, explainer.explain(pair)});
  return explained;
}

}  // namespace hottel
