#include "tests/storm/law_run.h"

#include <fmt/core.h>

#include <numeric>

namespace hottel::storm {

std::uint64_t LawCounts::all_checks() const { return std::accumulate(checks.begin(), checks.end(), std::uint64_t{0}); }

std::uint64_t LawCounts::all_failures() const {
  return std::accumulate(failures.begin(), failures.end(), std::uint64_t{0});
}

void LawCounts::add(const LawCounts& other) {
  scenes += other.scenes;
  parts += other.parts;
  checks.resize(other.checks.size());
  failures.resize(other.failures.size());
  seconds.resize(other.seconds.size());
  for (std::size_t l = 0; l < checks.size(); ++l) {
    checks[l] += other.checks[l];
    failures[l] += other.failures[l];
    seconds[l] += other.seconds[l];
  }
  if (other.slowest > slowest) slowest_number = other.slowest_number;
  slowest = std::max(slowest, other.slowest);
  total += other.total;
}

std::string LawCounts::text(const std::vector<const char*>& laws, const char* part) const {
  std::string text = fmt::format(
      "{} scenes of {:.1f} {}, {} checks, {} failures; {:.2f} ms a scene, at most {:.0f} ms, of scene {}\n\n", scenes,
      static_cast<double>(parts) / static_cast<double>(scenes), part, all_checks(), all_failures(),
      1e3 * total / static_cast<double>(scenes), 1e3 * slowest, slowest_number);
  for (std::size_t l = 0; l < laws.size(); ++l)
    text +=
        fmt::format("{:24} {:>12} checks {:>6} failures {:>10.1f} s\n", laws[l], checks[l], failures[l], seconds[l]);
  return text + "\n";
}

}  // namespace hottel::storm
