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

// Rounded up, so that it holds.
std::string reached_text(const FailedPair3& failure) {
  if (failure.is_undecided || !(failure.reached > 0 && std::isfinite(failure.reached))) return failure.problem;
  const double scale = same_bits::pow(10.0, std::floor(same_bits::log10(failure.reached)) - 1);
  return fmt::format("{:.1e} was reached: {}", std::ceil(failure.reached / scale) * scale, failure.problem);
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
  if (failures.size() > kNamedPairs) text += "; ...";
  if (!find_contacts(prepared.scene).near.empty())
    text += ". Some surfaces all but touch: 'hottel check' says where, and its --fix joins them";
  throw UnmeasuredPairs(text, failures.size());
}

}  // namespace hottel
