#include "solver/compare/timing.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "kernel/support/failure.h"

namespace hottel {
namespace {

constexpr double kLongWarmUp = 1, kEnough = 0.5, kTooMuch = 10;  // seconds
constexpr std::size_t kFewestRuns = 3, kMostRuns = 1000;

}  // namespace

Timing time_repeatedly(const std::function<double()>& run, const std::optional<int>& runs) {
  HOTTEL_REQUIRE(!runs || *runs >= 1);
  std::vector<double> seconds;
  if (const double warm_up = run(); !runs && warm_up > kLongWarmUp) seconds.push_back(warm_up);
  const auto is_done = [&] {
    if (runs) return seconds.size() == static_cast<std::size_t>(*runs);
    const double total = std::accumulate(seconds.begin(), seconds.end(), 0.0);
    return (seconds.size() >= kFewestRuns && total >= kEnough) || total >= kTooMuch || seconds.size() == kMostRuns;
  };
  while (!is_done()) seconds.push_back(run());
  std::sort(seconds.begin(), seconds.end());
  const std::size_t half = seconds.size() / 2;
  const double median = seconds.size() % 2 == 1 ? seconds[half] : (seconds[half - 1] + seconds[half]) / 2;
  return {median, seconds.front(), seconds.back(), static_cast<int>(seconds.size())};
}

}  // namespace hottel
