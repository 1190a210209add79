#include "geometry/space/prepared/area_sum.h"

#include <cmath>

#include "kernel/ball.h"
#include "kernel/root_sum.h"
#include "kernel/rounding.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

constexpr long kMostPrecision = 1024;
constexpr std::size_t kFewTerms = 16;

}  // namespace

Rounded AreaSum3::rounded(const Rational& unit) const {
  HOTTEL_REQUIRE(!shares_.empty());
  // The canonical sum compares each term with all others: of many terms it is asked only where balls cannot tell.
  for (long precision = 128; shares_.size() > kFewTerms && precision <= kMostPrecision; precision *= 2) {
    Ball sum;
    for (const auto& [squared, share] : shares_)
      sum.add_product(Ball::root(squared, precision), Ball::of(Rational(share * unit), precision), precision);
    const Enclosure nearest = sum.nearest_of_ends();
    if (nearest.lower != nearest.upper || !std::isfinite(nearest.lower)) continue;
    if (const int side = sum.compare(nearest.lower); side != 0) return {nearest.lower, static_cast<signed char>(side)};
  }
  RootSum sum;
  for (const auto& [squared, share] : shares_) sum.add(Rational(share * unit), Rational(squared));
  return round_quotient(sum, RootSum(Rational(1))).number;
}

}  // namespace hottel
