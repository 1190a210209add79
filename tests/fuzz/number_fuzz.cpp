// Any text as a number: refused, or exact; its nearest double's shortest decimal reads back to that double.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "kernel/rational.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto value = hottel::parse_rational(std::string_view(reinterpret_cast<const char*>(data), size));
  if (!value) return 0;
  const double nearest = hottel::to_double(*value);
  if (!std::isfinite(nearest)) return 0;
  const auto printed = hottel::parse_rational(hottel::shortest(nearest));
  if (!printed || hottel::to_double(*printed) != nearest) std::abort();
  // No neighbour is nearer.
  for (const double other : {std::nextafter(nearest, -HUGE_VAL), std::nextafter(nearest, HUGE_VAL)})
    if (std::isfinite(other) && abs(*value - hottel::Rational(other)) < abs(*value - hottel::Rational(nearest)))
      std::abort();
  return 0;
}
