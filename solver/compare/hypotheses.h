// Ways to read the numbers that are off: each says which pairs it explains.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "geometry/plane/arrangement/prepared_scene.h"
#include "solver/compare/verdict.h"

namespace hottel {

// One hypothesis about all pairs at once.
struct Hypothesis {
  Fault fault;
  std::vector<char> explains;  // by place in JudgedPairs::pairs(); only of pairs that are off
  std::string words;

  std::uint64_t count() const;
};

// What follows from the numbers alone.
Hypothesis suppose_transposed(const JudgedPairs& judged);
Hypothesis suppose_constant_factor(const JudgedPairs& judged);
Hypothesis suppose_row_factor(const JudgedPairs& judged);
Hypothesis suppose_permuted(const JudgedPairs& judged);
Hypothesis suppose_sky_missing(const JudgedPairs& judged);
Hypothesis suppose_sky_is_rest(const JudgedPairs& judged);
Hypothesis suppose_missing(const JudgedPairs& judged);

// What takes a look at the scene: the factors without obstacles of the pairs that are off (0 for the others), and the
// factors of both sides of every edge.
std::vector<double> unobstructed_factors(const PreparedScene2& prepared, const JudgedPairs& judged);
Hypothesis suppose_no_occlusion(const JudgedPairs& judged, const std::vector<double>& unobstructed);
Hypothesis suppose_all_or_nothing(const JudgedPairs& judged, const std::vector<double>& unobstructed);
Hypothesis suppose_behind(const JudgedPairs& judged, const std::vector<double>& unobstructed);
Hypothesis suppose_reversed(const PreparedScene2& prepared, const JudgedPairs& judged);

}  // namespace hottel
