// What is told of a computation of view factors.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "kernel/rounding.h"

namespace hottel {

// How the numbers came about.
struct ExchangeReport {
  std::uint64_t surfaces = 0, vertices = 0, pieces = 0, elements = 0, pairs = 0, gaps = 0, terms = 0;
  TierCounts tiers;                       // one count a rounded number: factors both ways, visibilities
  bool closure_is_exact = false;          // the integer identity sum_j 2 S(i, j) = 2 A_i held in every row
  std::map<std::string, double> seconds;  // of stages that ran
};

}  // namespace hottel
