// What is wrong with radiosities that another program computed, in words.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "solver/compare/written_factors.h"
#include "solver/radiosity/radiosity.h"

namespace hottel {

struct JudgedRadiosity {
  std::uint32_t element = 0, channel = 0;
  double value = 0, exact = 0, lower = 0, upper = 0;

  double error() const { return value > exact ? value - exact : exact - value; }
};

struct RadiosityVerdict {
  std::uint64_t count = 0, outside = 0;  // values; those outside the proven bounds, whatever digits were left out
  double max_error = 0;                  // relative to the largest |B|
  std::vector<JudgedRadiosity> worst;    // at most 5 of those outside, the worst first

  // What most of those outside are, in words: irradiances, net fluxes, emissions, B - E, one reflection only, B times a
  // known constant. Empty when they are none of these.
  std::string hypothesis;
  std::uint64_t explained = 0;
};

// Holds radiosities against a certified solution of the same elements.
//   beyond   what agrees with a reading may differ by so much of the largest |B|, and by the digits left out
// REQUIRES: by_channel[c][i] for all channels of the solution and elements of the matrix.
RadiosityVerdict judge_radiosities(const ExchangeMatrix& exact, const RadiositySolution& solution,
                                   const std::vector<std::vector<double>>& by_channel, const WrittenDigits& digits,
                                   double beyond);

// The verdict as sentences.
std::vector<std::string> verdict_sentences(const RadiosityVerdict& verdict, const ExchangeMatrix& exact,
                                           const RadiositySolution& solution);

}  // namespace hottel
