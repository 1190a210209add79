#include "solver/radiosity/printed_number.h"

#include <cmath>
#include <limits>

namespace hottel {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

double rounded_down(const Rational& value) {
  const double nearest = to_double(value);
  if (nearest == -kInfinity) return nearest;
  return nearest == kInfinity || Rational(nearest) > value ? std::nextafter(nearest, -kInfinity) : nearest;
}

double rounded_up(const Rational& value) {
  const double nearest = to_double(value);
  if (nearest == kInfinity) return nearest;
  return nearest == -kInfinity || Rational(nearest) < value ? std::nextafter(nearest, kInfinity) : nearest;
}

}  // namespace hottel
