#include "kernel/written_double.h"

#include <cmath>
#include <limits>

#include "kernel/support/failure.h"

namespace hottel {
namespace {

constexpr double kLost = std::numeric_limits<double>::quiet_NaN();

}  // namespace

double written_double(const Rational& value) {
  const double nearest = to_double(value);
  return nearest == 0 && value != 0 ? kLost : nearest;
}

double written_double(const Rounded& value) { return value.value == 0 && value.side != 0 ? kLost : value.value; }

std::string written_problem(double value) {
  return std::isnan(value)   ? "is below the range of doubles"
         : std::isinf(value) ? "is beyond the range of doubles"
                             : "";
}

void require_double(double value, const std::string& what, const std::string& more) {
  if (const std::string problem = written_problem(value); !problem.empty())
    throw RequestError(what + " " + problem + more);
}

double required_double(const Rounded& value, const std::string& what) {
  const double written = written_double(value);
  require_double(written, what);
  return written;
}

}  // namespace hottel
