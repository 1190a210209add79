// What is wrong with radiosities that another program computed, in words.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "solver/compare/method_report.h"
#include "solver/radiosity/radiosity.h"

namespace hottel {

// One radiosity of a file beside the certified one, with its proven bounds. [W/m²]
struct JudgedRadiosity {
  std::uint32_t element = 0, channel = 0;
  double value = 0, exact = 0, lower = 0, upper = 0;

  double error() const { return value > exact ? value - exact : exact - value; }
};

// What is to be said of the radiosities of a file.
//
//   (1) a value is outside iff no number that prints as it lies within the proven bounds
//   (2) `hypothesis` is not empty only where it explains at least half of those outside; `explained` is how many
//   (3) max_error is 0 where all values are the certified ones, and infinite where only the scene is dark
struct RadiosityVerdict {
  std::uint64_t count = 0, outside = 0;  // values; those outside the proven bounds, whatever digits were left out
  double max_error = 0;                  // relative to the largest |B|
  std::vector<JudgedRadiosity> worst;    // at most 5 of those outside, the worst first

  // What most of those outside are, in words: irradiances, net fluxes, emissions, B - E, one reflection only, B times a
  // known constant. Empty when they are none of these.
  std::string hypothesis;
  std::uint64_t explained = 0;
};

// Holds radiosities against a certified solution of the same elements. Elements without a row are not judged.
//   beyond   what agrees with a reading may differ by so much of the largest |B|, and by the digits left out
// What reflects once (E + rho F E) is reckoned without the light of the sky, which the solution does not hold.
// REQUIRES: by_channel[c][i] for all channels of the solution and elements of the matrix. COST: a pass over the values
// for each of about twenty readings.
RadiosityVerdict judge_radiosities(const ExchangeMatrix& exact, const RadiositySolution& solution,
                                   const std::vector<std::vector<double>>& by_channel, const WrittenDigits& digits,
                                   double beyond);

// The verdict as sentences, without a full stop: one where nothing is outside, else a second one for the hypothesis.
// REQUIRES the matrix and the solution that were judged against.
std::vector<std::string> verdict_sentences(const RadiosityVerdict& verdict, const ExchangeMatrix& exact,
                                           const RadiositySolution& solution);

}  // namespace hottel
