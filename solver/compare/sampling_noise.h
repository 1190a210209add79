// Errors that are those of sampling: how many rays would scatter so, and whether they lean.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "solver/compare/judged_pairs.h"
#include "solver/compare/noise_bias.h"

namespace hottel {

// What errors look like that come of counting where rays end.
//
// N rays that leave a face at random end on j in a number that is binomial about N F: the error of F has the variance
// F (1 - F) / N, and rows are independent of each other. So (value - exact)² / (F (1 - F)) has the mean 1/N whatever F
// is, and the median 0.455/N where N F is not small.
struct SamplingNoise {
  double rays = 0;       // N: from the mean over all pairs; of what leans from the rests (scattered_pairs.h)
  bool is_even = false;  // spread evenly, not at random
  NoiseBias bias;
  std::vector<char> explains;  // by place in judged.pairs(): off, and within what N rays scatter
};

// Returns the noise that the errors are, or nothing where they are not like it.
//
//   (1) they are like it iff of the pairs with 5 rays or more the median and the mean tell of numbers of rays within a
//       factor of 3, no more than 2 % are more than 4 deviations off, at least half are off, and no side, too much or
//       too little, has more than 3/4; and of all pairs no more than 2 % have light where there is none. There must be
//       20 pairs, and 8 rays. Where `may_lean`, errors that are not may be once shares of rows and columns are taken
//       off, and these are told as biases
//   (2) a bias is told as noise_bias() tells it
//   (3) rays that are spread evenly over places and directions (stratified, Sobol) scatter less, and large factors less
//       so beside small ones: the variance is taken for sqrt(F (1 - F)) / N^(3/2). It is tried where random rays do not
//       fit
//   (4) N rays miss most of the faces of which N F is below 1/2, and give the others 1/N. Where many more of these have
//       hits, and smaller ones, more rays were counted than the errors tell of: they are none of chance, and nothing is
//       returned
//   (5) nor is it where errors grow with the factors as those do that are in proportion to them
// leave_out: by place in judged.pairs(), pairs that do not count; empty: all do. COST: a few passes, and two sorts.
std::optional<SamplingNoise> sampling_noise(const JudgedPairs& judged, const std::vector<char>& leave_out = {},
                                            bool may_lean = true);

// How many rays, and whether they lean.
std::string noise_words(const SamplingNoise& noise);

}  // namespace hottel
