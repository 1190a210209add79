#include "geometry/space/exchange/require_measured.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "geometry/space/contacts/near_contacts.h"
#include "geometry/space/exchange/pair_names.h"
#include "geometry/unmeasured_pairs.h"
#include "kernel/plain_functions.h"
#include "kernel/rational.h"

namespace hottel {
namespace {

bool is_reached(const FailedPair3& failure) {
  return !failure.is_undecided && failure.reached > 0 && std::isfinite(failure.reached);
}

// A tolerance of two digits, rounded up, so that it holds.
std::string rounded_up_text(double tolerance) {
  const double scale = same_bits::pow(10.0, std::floor(same_bits::log10(tolerance)) - 1);
  return fmt::format("{:.1e}", std::ceil(tolerance / scale) * scale);
}

std::string reached_text(const FailedPair3& failure) {
  return is_reached(failure) ? rounded_up_text(failure.reached) + " was reached: " + failure.problem : failure.problem;
}

// Advice where every pair reached some tolerance, `worst` at the most, that is still one.
std::string advice(double worst) {
  constexpr double kLargest = 1e-3;
  return worst < kLargest ? fmt::format(". Take a larger tolerance, such as {:.0e}",
                                        same_bits::pow(10.0, std::ceil(same_bits::log10(worst))))
                          : "";
}

}  // namespace

void require_measured(const PreparedScene3& prepared, const ElementTable3& table, double tolerance,
                      const std::vector<FailedPair3>& failures) {
  if (failures.empty()) return;
  std::string text =
      fmt::format("{} could not be measured within {} of the smaller area",
                  failures.size() == 1 ? "a pair" : fmt::format("{} pairs", failures.size()), shortest(tolerance));
  for (std::size_t k = 0; k < std::min(failures.size(), kNamedPairs); ++k)
    text += fmt::format("{} {} ({})", k == 0 ? ":" : ";", pair_text(table.elements(), failures[k].i, failures[k].j),
                        reached_text(failures[k]));
  const bool all_reached = std::ranges::all_of(failures, is_reached);
  const double worst = std::ranges::max_element(failures, {}, &FailedPair3::reached)->reached;
  if (failures.size() > kNamedPairs) text += fmt::format("; and {} more", failures.size() - kNamedPairs);
  if (failures.size() > kNamedPairs && all_reached) text += ", the worst of all " + rounded_up_text(worst);
  if (all_reached) text += advice(worst);
  if (!find_contacts(prepared.scene).near.empty())
    text += ". Some surfaces all but touch: 'hottel check' says where, and its --fix joins them";
  throw UnmeasuredPairs(text, failures.size());
}

}  // namespace hottel
