#include "solver/radiosity/enclosed_radiosity.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "kernel/exact_double.h"
#include "kernel/support/failure.h"
#include "solver/radiosity/factor_ends.h"
#include "solver/radiosity/irradiance.h"
#include "solver/radiosity/printed_number.h"

namespace hottel {
namespace {

// Whether sources are known so well that nothing is gained by looking at their ends.
bool are_narrow(const ExchangeMatrix& matrix, const RadiositySources& sources) {
  const auto is_narrow = [&](const SourceSpectrum& spectrum) {
    for (int c = 0; c < 3; ++c) {
      if (c != sources.only_channel.value_or(c)) continue;
      const RationalEnclosure& number = spectrum[c];
      if (!number.is_exact() && scaled_by_power_of_two(number.upper - number.lower, 48) > number.upper) return false;
    }
    return true;
  };
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i)) continue;
    if (!is_narrow(sources.emission[i])) return false;
    if (!sources.direct_irradiance.empty() && !is_narrow(sources.direct_irradiance[i])) return false;
  }
  return is_narrow(sources.sky);
}

// A double not above value - width, one not below value + width.
double lowered(double value, const Rational& width) {
  return width == 0 || !std::isfinite(value) ? value : rounded_down(exact_value(value) - width);
}
double raised(double value, const Rational& width) {
  return width == 0 || !std::isfinite(value) ? value : rounded_up(exact_value(value) + width);
}

// Moves the ends of bounds that two proofs give to the narrower ones. The least light is what `least` says of lower
// bounds of radiosities and upper ones of nets, the most what `most` says of the others.
void narrow_least(const RadiositySolution& by, RadiositySolution& least) {
  for (std::size_t c = 0; c < least.channels.size(); ++c)
    for (std::size_t i = 0; i < least.channels[c].elements.size(); ++i) {
      ElementRadiosity& element = least.channels[c].elements[i];
      element.lower = std::max(element.lower, by.channels[c].elements[i].lower);
      element.net_upper = std::min(element.net_upper, by.channels[c].elements[i].net_upper);
    }
}
void narrow_most(const RadiositySolution& by, RadiositySolution& most) {
  for (std::size_t c = 0; c < most.channels.size(); ++c)
    for (std::size_t i = 0; i < most.channels[c].elements.size(); ++i) {
      ElementRadiosity& element = most.channels[c].elements[i];
      element.upper = std::min(element.upper, by.channels[c].elements[i].upper);
      element.net_lower = std::max(element.net_lower, by.channels[c].elements[i].net_lower);
    }
}

// The bounds of one channel from those of the least and the most light. are_at_ends: of sources at their ends; else
// both are of all that they may be.
void set_bounds(const ExchangeMatrix& matrix, const ChannelSolution& least, const ChannelSolution& most,
                const RadiositySources& sources, bool are_at_ends, int of, ChannelSolution& channel) {
  channel.max_relative_width = 0;
  channel.dark = most.dark;
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i)) continue;
    ElementRadiosity& element = channel.elements[i];
    element.lower = least.elements[i].lower;
    element.upper = most.elements[i].upper;
    HOTTEL_REQUIRE(element.lower <= element.upper);  // each end is proven
    element.radiosity = std::clamp(element.radiosity, element.lower, element.upper);
    // More light, more of it absorbed, and where the most is absorbed the least may be emitted.
    const RationalEnclosure& emission = sources.emission[i][of];
    const Rational width = are_at_ends ? Rational(emission.upper - emission.lower) : Rational(0);
    element.net_lower = lowered(most.elements[i].net_lower, width);
    element.net_upper = raised(least.elements[i].net_upper, width);
    if (element.radiosity > 0)
      channel.max_relative_width =
          std::max(channel.max_relative_width, (element.upper - element.lower) / element.radiosity);
  }
  set_irradiances(matrix, sources, of, channel);
}

}  // namespace

// A matrix of doubles, of which only bounds are wanted.
struct EnclosedRadiosity::Ends {
  ExchangeMatrix matrix;
  FactorsAsGiven as_given;

  Ends(ExchangeMatrix of, const std::vector<Spectrum>& reflectivity)
      : matrix(std::move(of)), as_given(matrix, reflectivity) {}
  Ends(const Ends&) = delete;
  Ends& operator=(const Ends&) = delete;
};

EnclosedRadiosity::EnclosedRadiosity(const ExchangeMatrix& matrix, const std::vector<Spectrum>& reflectivity)
    : matrix_(matrix), as_given_(matrix, reflectivity), has_closed_rows_(has_closed_enclosures(matrix)) {
  if (matrix.guarantee() != Guarantee::kEnclosed) return;
  lower_ = std::make_unique<const Ends>(matrix_of_ends(matrix, &Enclosure::lower), reflectivity);
  upper_ = std::make_unique<const Ends>(matrix_of_ends(matrix, &Enclosure::upper), reflectivity);
}

EnclosedRadiosity::~EnclosedRadiosity() = default;

RadiositySolution EnclosedRadiosity::solve(const RadiositySources& sources, const RadiosityOptions& options) const {
  const bool is_narrow = are_narrow(matrix_, sources);
  if (is_narrow && !lower_) return as_given_.solve(sources, options, false);
  const auto sources_at = [&](End end) { return is_narrow ? sources : sources.at(end); };
  const int by_defects = !has_closed_rows_ ? 0 : is_narrow ? 1 : 2;
  int solved = 0;
  const auto progress = [&](double fraction) { options.progress((solved + fraction) / (3 + by_defects)); };
  RadiosityOptions as_asked = options, by_default;
  by_default.serves_many = options.serves_many;
  if (options.progress) as_asked.progress = by_default.progress = progress;

  RadiositySolution solution = as_given_.solve(sources_at(End::kMiddle), as_asked, false);
  ++solved;
  RadiositySolution least = (lower_ ? lower_->as_given : as_given_).solve(sources_at(End::kLower), by_default, true);
  ++solved;
  RadiositySolution most = (upper_ ? upper_->as_given : as_given_).solve(sources_at(End::kUpper), by_default, true);
  for (int k = 0; k < by_defects; ++k) {
    ++solved;
    // The same of both ends where sources are narrow.
    const RadiositySolution closed = as_given_.solve(sources_at(k == 0 ? End::kLower : End::kUpper), by_default, true,
                                                     {.meant = FactorsMeant::kWithinBounds});
    if (k == 0) narrow_least(closed, least);
    if (k + 1 == by_defects) narrow_most(closed, most);
    for (const auto& [stage, seconds] : closed.seconds) solution.seconds[stage] += seconds;
  }

  solution.max_relative_width = 0;
  for (std::size_t c = 0; c < solution.channels.size(); ++c) {
    set_bounds(matrix_, least.channels[c], most.channels[c], sources, !is_narrow, static_cast<int>(c),
               solution.channels[c]);
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
