#include "solver/compare/method_result.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernel/support/failure.h"

namespace hottel {

double error_of(const MethodResult& result, ErrorKind kind) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  switch (kind) {
    case ErrorKind::kMaxFactor:
      return result.errors.max;
    case ErrorKind::kRmsFactor:
      return result.errors.rms;
    case ErrorKind::kFaceRadiosity:
      return result.face_radiosity_error.value_or(kNone);
    case ErrorKind::kRadiosity:
      break;
  }
  return result.max_radiosity_error.value_or(kNone);
}

double max_radiosity_error(const RadiositySolution& solution, const RadiositySolution& exact) {
  HOTTEL_REQUIRE(solution.channels.size() == exact.channels.size());
  double difference = 0;
  for (std::size_t c = 0; c < exact.channels.size(); ++c) {
    const auto &found = solution.channels[c].elements, &wanted = exact.channels[c].elements;
    HOTTEL_REQUIRE(found.size() == wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      const double here = std::abs(found[i].radiosity - wanted[i].radiosity);
      if (std::isnan(here)) return std::numeric_limits<double>::infinity();
      difference = std::max(difference, here);
    }
  }
  return difference == 0 ? 0 : difference / largest_radiosity(exact);
}

}  // namespace hottel
