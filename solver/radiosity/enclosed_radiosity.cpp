#include "solver/radiosity/enclosed_radiosity.h"

#include <algorithm>

#include "kernel/support/failure.h"
#include "solver/radiosity/irradiance.h"

namespace hottel {
namespace {

// The same matrix with one end of every enclosure as its factors: doubles, and nothing is said of them.
ExchangeMatrix matrix_of_ends(const ExchangeMatrix& matrix, double Enclosure::*end) {
  std::vector<std::size_t> begin{0};
  std::vector<FactorEntry> entries;
  entries.reserve(matrix.entry_count());
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    for (std::size_t k = 0; k < matrix.row(i).size(); ++k) {
      FactorEntry entry = matrix.row(i)[k];
      entry.factor = {matrix.bounds(i, k).*end, 0};
      entries.push_back(entry);
    }
    begin.push_back(entries.size());
  }
  ExchangeMatrix result(matrix.elements(), Guarantee::kEstimated);
  result.assign(std::move(begin), std::move(entries));
  return result;
}

// The bounds of one channel from those of the least and the most light.
void set_bounds(const ExchangeMatrix& matrix, const ChannelSolution& least, const ChannelSolution& most,
                const Rational& sky_emission, ChannelSolution& channel) {
  channel.max_relative_width = 0;
  channel.dark = most.dark;
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i)) continue;
    ElementRadiosity& element = channel.elements[i];
    element.lower = least.elements[i].lower;
    element.upper = most.elements[i].upper;
    element.radiosity = std::clamp(element.radiosity, element.lower, element.upper);
    // More light, more of it absorbed.
    element.net_lower = most.elements[i].net_lower;
    element.net_upper = least.elements[i].net_upper;
    if (element.radiosity > 0)
      channel.max_relative_width =
          std::max(channel.max_relative_width, (element.upper - element.lower) / element.radiosity);
  }
  set_irradiances(matrix, sky_emission, channel);
}

}  // namespace

RadiositySolution solve_enclosed(const ExchangeMatrix& matrix, const Spectrum& sky_emission,
                                 const RadiosityOptions& options, const SolveDoubles& solve) {
  HOTTEL_REQUIRE(matrix.guarantee() == Guarantee::kEnclosed);
  int solved = 0;
  const auto progress = [&](double fraction) { options.progress((solved + fraction) / 3); };
  RadiosityOptions as_asked = options, by_default;
  if (options.progress) as_asked.progress = by_default.progress = progress;

  RadiositySolution solution = solve(matrix, as_asked, true);
  ++solved;
  const RadiositySolution least = solve(matrix_of_ends(matrix, &Enclosure::lower), by_default, false);
  ++solved;
  const RadiositySolution most = solve(matrix_of_ends(matrix, &Enclosure::upper), by_default, false);

  solution.max_relative_width = 0;
  for (std::size_t c = 0; c < solution.channels.size(); ++c) {
    set_bounds(matrix, least.channels[c], most.channels[c], sky_emission.value[c], solution.channels[c]);
    solution.max_relative_width = std::max(solution.max_relative_width, solution.channels[c].max_relative_width);
  }
  for (const RadiositySolution* bound : {&least, &most})
    for (const auto& [stage, seconds] : bound->seconds) solution.seconds[stage] += seconds;
  for (const std::string& note : most.notes)
    if (std::find(solution.notes.begin(), solution.notes.end(), note) == solution.notes.end())
      solution.notes.push_back(note);
  return solution;
}

}  // namespace hottel
