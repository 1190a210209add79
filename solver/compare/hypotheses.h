// Ways to read the numbers that are off: each says which pairs it explains.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "solver/compare/fault.h"
#include "solver/compare/judged_pairs.h"

namespace hottel {

// One hypothesis about all pairs at once.
struct Hypothesis {
  Fault fault;
  std::vector<char> explains;  // by place in JudgedPairs::pairs(); only of pairs that are off
  std::string words;

  std::uint64_t count() const;
};

// Explains no pair.
Hypothesis explains_nothing(Fault fault, const JudgedPairs& judged);

// What follows from the numbers alone.
Hypothesis suppose_transposed(const JudgedPairs& judged);
Hypothesis suppose_constant_factor(const JudgedPairs& judged);
Hypothesis suppose_row_factor(const JudgedPairs& judged);
Hypothesis suppose_permuted(const JudgedPairs& judged);
Hypothesis suppose_sky_missing(const JudgedPairs& judged);
Hypothesis suppose_sky_is_rest(const JudgedPairs& judged);
Hypothesis suppose_missing(const JudgedPairs& judged);

}  // namespace hottel
