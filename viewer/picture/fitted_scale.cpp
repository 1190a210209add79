#include "viewer/picture/fitted_scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace hottel {
namespace {

// As a title would have them.
bool are_told_apart(double lower, double upper) { return fmt::format("{:.6g}", lower) != fmt::format("{:.6g}", upper); }

// The least value beyond which lies this share of the area or less. REQUIRES ascending ones, and some.
double value_below(const std::vector<AreaValue>& ascending, double share) {
  double all = 0, beyond = 0;
  for (const AreaValue& each : ascending) all += each.area;
  for (std::size_t k = ascending.size(); k-- > 0;) {
    beyond += ascending[k].area;
    if (beyond > share * all) return ascending[k].value;
  }
  return ascending.front().value;
}

void sort_ascending(std::vector<AreaValue>& values) { std::ranges::stable_sort(values, {}, &AreaValue::value); }

// The same values on the other side of 0, ascending too.
std::vector<AreaValue> mirrored(const std::vector<AreaValue>& ascending) {
  std::vector<AreaValue> result(ascending.rbegin(), ascending.rend());
  for (AreaValue& each : result) each.value = -each.value;
  return result;
}

// The greatest value, or what the upper end is cut to. lower: where the values begin that are to keep their colours.
double upper_end(const std::vector<AreaValue>& ascending, double lower) {
  const double greatest = ascending.back().value;
  for (int k = 1; k <= kCuts; ++k) {
    const double cut = value_below(ascending, k * kCutShare);
    if (are_told_apart(lower, cut) && lower < cut && greatest - cut > k * (cut - lower)) return cut;
  }
  return greatest;
}

// Ends from the least to the greatest, cut where it is worth it.
void fit_ends(const std::vector<AreaValue>& ascending, ColourScale& scale) {
  const std::vector<AreaValue> descending = mirrored(ascending);
  scale.upper = upper_end(ascending, -value_below(descending, kCutShare));
  scale.lower = -upper_end(descending, -value_below(ascending, kCutShare));
  if (!are_told_apart(scale.lower, scale.upper)) scale.upper = scale.lower;
}

void fit_about_zero(std::vector<AreaValue> values, double noise, ColourScale& scale) {
  for (AreaValue& each : values) each.value = std::abs(each.value);
  sort_ascending(values);
  scale.upper = values.back().value <= noise ? 0 : upper_end(values, noise);
  scale.lower = scale.upper > 0 ? -scale.upper : 0;
}

// Without what a logarithm has no place for.
void drop_zeros(std::vector<AreaValue>& values, ColourScale& scale) {
  const std::size_t count = values.size();
  std::erase_if(values, [](const AreaValue& each) { return !(each.value > 0); });
  scale.has_zero = values.size() < count;
}

void take_asked(const AskedScale& asked, ColourScale& scale) {
  if (asked.lower) {
    scale.lower = *asked.lower;
    scale.upper = scale.about_zero && *asked.lower < 0 ? -*asked.lower : std::max(scale.upper, *asked.lower);
  }
  if (asked.upper) {
    scale.upper = *asked.upper;
    if (!asked.lower)
      scale.lower = scale.about_zero && *asked.upper > 0 ? -*asked.upper : std::min(scale.lower, *asked.upper);
  }
}

}  // namespace

FittedScale fitted_scale(std::vector<AreaValue> values, const AskedScale& asked, const ScaleSense& sense) {
  ColourScale scale{.lower = 0, .upper = 0, .logarithmic = asked.is_logarithmic, .about_zero = sense.has_sign};
  if (scale.logarithmic) drop_zeros(values, scale);
  if (values.empty()) values = {{scale.logarithmic ? 1.0 : 0.0, 1}};
  if (std::ranges::all_of(values, [](const AreaValue& each) { return each.area == 0; }))
    for (AreaValue& each : values) each.area = 1;
  sort_ascending(values);
  FittedScale result{{}, values.front().value, values.back().value};
  if (scale.about_zero && std::max(-result.least, result.greatest) <= sense.noise) result.least = result.greatest = 0;
  if (!are_told_apart(result.least, result.greatest)) result.greatest = result.least;
  scale.lower = result.least;
  scale.upper = result.greatest;
  if (scale.about_zero)
    fit_about_zero(values, sense.noise, scale);
  else if (!scale.logarithmic)
    fit_ends(values, scale);
  take_asked(asked, scale);
  scale.cuts_lower = result.least < scale.lower;
  scale.cuts_upper = result.greatest > scale.upper;
  result.scale = scale;
  return result;
}

}  // namespace hottel
