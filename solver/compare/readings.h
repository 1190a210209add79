// Ways to read the numbers that are off: each says which pairs it explains.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "geometry/plane/exchange/exchange.h"
#include "solver/compare/verdict.h"

namespace hottel {

// One hypothesis about all pairs at once.
struct Reading {
  Fault fault;
  std::vector<char> explains;  // by place in JudgedPairs::pairs(); only of pairs that are off
  std::string words;

  std::uint64_t count() const;
};

// What follows from the numbers alone.
Reading read_transposed(const JudgedPairs& judged);
Reading read_constant_factor(const JudgedPairs& judged);
Reading read_row_factor(const JudgedPairs& judged);
Reading read_permuted(const JudgedPairs& judged);
Reading read_sky_missing(const JudgedPairs& judged);
Reading read_sky_is_rest(const JudgedPairs& judged);
Reading read_missing(const JudgedPairs& judged);

// What takes a look at the scene: the factors without obstacles of the pairs that are off (0 for the others), and the
// factors of both sides of every edge.
std::vector<double> unobstructed_factors(const PreparedScene2& prepared, const JudgedPairs& judged);
Reading read_no_occlusion(const JudgedPairs& judged, const std::vector<double>& unobstructed);
Reading read_all_or_nothing(const JudgedPairs& judged, const std::vector<double>& unobstructed);
Reading read_behind(const JudgedPairs& judged, const std::vector<double>& unobstructed);
Reading read_reversed(const PreparedScene2& prepared, const JudgedPairs& judged);

}  // namespace hottel
