// What methods of computing view factors say of themselves and of a run.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/exchange_report.h"
#include "kernel/enclosure.h"
#include "solver/compare/written_factors.h"

namespace hottel {

// What a method says of itself before it has run.
struct MethodInfo {
  std::string name;      // in full, variant and parameter included: "gauss:4:normalised"
  std::string family;    // what a sweep of the parameter belongs to: "gauss"
  double parameter = 0;  // points, pixels, rays; 0 when there is none
  Guarantee guarantee = Guarantee::kEstimated;
  std::string reference;  // who described it, and where
};

// How a matrix came about: what a method tells of one run.
struct MethodReport {
  ExchangeReport counts;                  // of the scene and the matrix; tiers and gaps where the method has any
  double row_defect = 0;                  // max |sum_j F_ij - 1| as computed, before any normalisation
  std::optional<double> standard_error;   // of the worst factor, where the method is random
  std::optional<double> seconds;          // where the method knows better than who called it (an outside command)
  std::optional<WrittenFactors> written;  // where the factors were read from a file
  std::vector<std::string> notes;         // e.g. the seed
  std::vector<std::string> gaps;  // those of the notes that tell of columns a file has not, be there light or not
};

// What is said first of factors by a method that is not exact. of: what is guaranteed of them.
std::string method_sentence(const MethodInfo& info, Guarantee of, const MethodReport& report);

// Seconds of wall-clock time.
struct Timing {
  double median = 0, fastest = 0, slowest = 0;
  int runs = 0;  // that were counted
};

}  // namespace hottel
