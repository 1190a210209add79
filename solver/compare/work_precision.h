// What accuracy costs: methods as points of time and error, families as curves.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "solver/compare/method_result.h"

namespace hottel {

inline constexpr const char* kExactFamily = "exact";            // the method that all others are held against
inline constexpr const char* kArithmeticFamily = "arithmetic";  // the same sweep in other arithmetic

// What one run of a method cost, and how wrong it was.
struct WorkPoint {
  std::string method;
  double seconds = 0, error = 0;  // error: of the kind that was asked for
  double parameter = 0;           // MethodInfo::parameter
};

// The members of a family, in the order they were run.
struct WorkCurve {
  std::string family;
  std::vector<WorkPoint> points;
};

// Returns one curve a family, in the order in which families first appear; seconds are medians. Results without time,
// or without an error of this kind, are left out. COST: results times families.
std::vector<WorkCurve> work_curves(std::span<const MethodResult> results, ErrorKind kind = ErrorKind::kMaxFactor);

// Returns the least time in which a family gets down to an error: on the polyline, in logarithms, through
// the points that no cheaper point beats. Nothing when its best point is worse than that; never less than
// its cheapest point takes.
//
//   (1) a point with error 0 is reached at its own time: there is no logarithm to interpolate in
// REQUIRES error > 0; throws ContractViolation otherwise.
std::optional<double> seconds_to_reach(std::span<const WorkPoint> curve, double error);

// What one reads off at an error: which approximation gets there first, and what the exact method takes. Families that
// are the exact method once more, normalised or in other arithmetic, are no approximations.
struct WorkReading {
  double error = 0;
  double exact_seconds = 0;
  std::string family;  // the cheapest; empty when none reaches the error
  double seconds = 0;  // of that family
};

// One reading for each error that is asked for, in their order; none without the method "exact". REQUIRES errors > 0.
std::vector<WorkReading> read_off(std::span<const WorkCurve> curves, std::span<const double> errors);

// Returns a sentence without a full stop that names the kind of error; times within a tenth of each other are said to
// be about as long. "at an error of 0.001 exact (250 µs) is 5.2 times faster than the cheapest method that reaches it,
// gauss (1.3 ms)"
std::string to_sentence(const WorkReading& reading, ErrorKind kind = ErrorKind::kMaxFactor);

}  // namespace hottel
