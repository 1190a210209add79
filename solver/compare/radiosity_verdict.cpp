#include "solver/compare/radiosity_verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "geometry/name.h"
#include "solver/compare/named_factors.h"

namespace hottel {
namespace {

constexpr std::size_t kMostNamed = 5;

// What another quantity would be in the place of a radiosity.
struct RadiosityHypothesis {
  std::string words;
  std::function<double(const JudgedRadiosity&)> value;
};

class RadiosityJudge {
 public:
  RadiosityJudge(const ExchangeMatrix& exact, const RadiositySolution& solution) : exact_(exact), solution_(solution) {}

  std::vector<RadiosityHypothesis> hypotheses() const {
    std::vector<RadiosityHypothesis> all;
    for (const NamedFactor& factor : kNamedFactors)
      all.push_back({fmt::format("radiosities times {}", factor.words),
                     [by = factor.value](const JudgedRadiosity& each) { return by * each.exact; }});
    all.push_back({"irradiances H", [this](const JudgedRadiosity& each) { return of(each).irradiance; }});
    all.push_back({"radiosities without the emission, B - E",
                   [this](const JudgedRadiosity& each) { return each.exact - of(each).emission; }});
    all.push_back({"net fluxes B - H", [this](const JudgedRadiosity& each) { return of(each).net(); }});
    all.push_back(
        {"emissions: nothing is reflected", [this](const JudgedRadiosity& each) { return of(each).emission; }});
    all.push_back({"radiosities after one reflection", [this](const JudgedRadiosity& each) { return once(each); }});
    return all;
  }

 private:
  const ElementRadiosity& of(const JudgedRadiosity& each) const {
    return solution_.channels[each.channel].elements[each.element];
  }
  // E + rho F E. What the sky sends is left out: the solution does not hold it.
  double once(const JudgedRadiosity& each) const {
    double irradiance = 0;
    for (const FactorEntry& entry : exact_.row(each.element))
      if (entry.to != exact_.sky())
        irradiance += entry.factor.value * solution_.channels[each.channel].elements[entry.to].emission;
    return of(each).emission + of(each).reflectivity * irradiance;
  }

  const ExchangeMatrix& exact_;
  const RadiositySolution& solution_;
};

// Radiosities of a channel, by the elements that have a row.
struct Listed {
  std::vector<std::uint32_t> elements;
  std::vector<double> found, exact;
};

// Whether two lists hold the same values, one for one.
bool agree(const std::vector<double>& found, const std::vector<double>& exact, double slack,
           const WrittenDigits& digits) {
  return std::equal(found.begin(), found.end(), exact.begin(), [&](double value, double right) {
    return std::abs(value - right) <= slack + digits.rounding(value);
  });
}

// How the values of a channel stand at the places of others, with an example; empty where they are not the same ones.
std::string order_words(const Listed& listed, const ExchangeMatrix& matrix, double slack, const WrittenDigits& digits) {
  std::vector<double> found = listed.found, exact = listed.exact;
  std::sort(found.begin(), found.end());
  std::sort(exact.begin(), exact.end());
  const std::size_t n = found.size();
  if (n < 2 || exact.back() - exact.front() <= 4 * slack || !agree(found, exact, slack, digits)) return "";
  constexpr std::size_t kMostShifted = 5000;
  std::size_t shift = 0;
  for (std::size_t by = 1; by < n && n <= kMostShifted && shift == 0; ++by) {
    std::vector<double> rotated = listed.exact;
    std::rotate(rotated.begin(), rotated.begin() + static_cast<std::ptrdiff_t>(by), rotated.end());
    if (agree(listed.found, rotated, slack, digits)) shift = by;
  }
  std::size_t worst = 0, of = 0;
  for (std::size_t k = 0; k < n; ++k)
    if (std::abs(listed.found[k] - listed.exact[k]) > std::abs(listed.found[worst] - listed.exact[worst])) worst = k;
  const auto distance = [&](std::size_t k) { return std::abs(listed.found[worst] - listed.exact[k]); };
  for (std::size_t k = 0; k < n; ++k)
    if (distance(k) < distance(of)) of = k;
  if (shift > 0) of = (worst + shift) % n;
  const std::string how = shift == 0      ? "in another order"
                          : shift > n / 2 ? fmt::format("shifted by {} the other way", n - shift)
                                          : fmt::format("shifted by {}", shift);
  return fmt::format("radiosities of other faces, {}: what stands for {} is that of {}", how,
                     quoted_name(matrix.elements()[listed.elements[worst]].name),
                     quoted_name(matrix.elements()[listed.elements[of]].name));
}

}  // namespace

RadiosityVerdict judge_radiosities(const ExchangeMatrix& exact, const RadiositySolution& solution,
                                   const std::vector<std::vector<double>>& by_channel, const WrittenDigits& digits,
                                   double beyond) {
  RadiosityVerdict verdict;
  std::vector<JudgedRadiosity> outside;
  double brightest = 0;
  for (std::uint32_t c = 0; c < solution.channels.size(); ++c)
    for (std::uint32_t i = 0; i < exact.size(); ++i) {
      if (!exact.has_row(i)) continue;
      const ElementRadiosity& right = solution.channels[c].elements[i];
      const JudgedRadiosity each{i, c, by_channel[c][i], right.radiosity, right.lower, right.upper};
      const double rounding = digits.rounding(each.value);
      ++verdict.count;
      brightest = std::max(brightest, each.exact);
      verdict.max_error = std::max(verdict.max_error, each.error());
      if (each.value + rounding < each.lower || each.value - rounding > each.upper) outside.push_back(each);
    }
  verdict.outside = outside.size();
  if (verdict.max_error > 0) verdict.max_error /= brightest;  // infinite in the dark
  const RadiosityJudge judge(exact, solution);
  for (const RadiosityHypothesis& hypothesis : judge.hypotheses()) {
    const auto explained =
        static_cast<std::uint64_t>(std::count_if(outside.begin(), outside.end(), [&](const JudgedRadiosity& each) {
          const double rest = std::abs(each.value - hypothesis.value(each));
          return rest <= beyond * brightest + digits.rounding(each.value) && rest <= each.error() / 2;
        }));
    if (explained <= verdict.explained || 2 * explained < outside.size()) continue;
    verdict.explained = explained;
    verdict.hypothesis = hypothesis.words;
  }
  std::string of_others;  // in every channel, or nothing
  for (std::size_t c = 0; c < solution.channels.size() && outside.size() > 1; ++c) {
    Listed listed;
    for (std::uint32_t i = 0; i < exact.size(); ++i) {
      if (!exact.has_row(i)) continue;
      listed.elements.push_back(i);
      listed.found.push_back(by_channel[c][i]);
      listed.exact.push_back(solution.channels[c].elements[i].radiosity);
    }
    of_others = order_words(listed, exact, beyond * brightest, digits);
    if (of_others.empty()) break;
  }
  if (!of_others.empty() && verdict.explained < verdict.outside) {
    verdict.hypothesis = of_others;
    verdict.explained = verdict.outside;
  }
  const auto count = static_cast<std::ptrdiff_t>(std::min(kMostNamed, outside.size()));
  std::partial_sort(outside.begin(), outside.begin() + count, outside.end(),
                    [](const JudgedRadiosity& a, const JudgedRadiosity& b) { return a.error() > b.error(); });
  verdict.worst.assign(outside.begin(), outside.begin() + count);
  return verdict;
}

std::vector<std::string> verdict_sentences(const RadiosityVerdict& verdict, const ExchangeMatrix& exact,
                                           const RadiositySolution& solution) {
  if (verdict.outside == 0)
    return {fmt::format("all {} radiosities lie within the proven bounds and the digits written", verdict.count)};
  std::string worst;
  for (const JudgedRadiosity& each : verdict.worst)
    worst += fmt::format(
        "{}{}{}: {:.6g} instead of {:.6g}", worst.empty() ? "" : "; ", quoted_name(exact.elements()[each.element].name),
        solution.channels.size() > 1 ? " (" + solution.channel_names[each.channel] + ")" : "", each.value, each.exact);
  std::vector<std::string> sentences = {
      fmt::format("{} of {} radiosities {} outside the proven bounds, whatever digits were left out; the largest error "
                  "is {:.3g} of the largest radiosity ({})",
                  verdict.outside, verdict.count, verdict.outside == 1 ? "lies" : "lie", verdict.max_error, worst)};
  if (!verdict.hypothesis.empty())
    sentences.push_back(fmt::format("these are {}: this explains {} of the {}", verdict.hypothesis, verdict.explained,
                                    verdict.outside));
  return sentences;
}

}  // namespace hottel
