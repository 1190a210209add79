// Which of several repairs of a scene to take.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/harmless_repair.h"
#include "kernel/support/failure.h"

namespace hottel {

// Whether a scene is worse than another by their checks: more is found in it, as FindingCounts counts, more of its
// pairs cannot be measured, or its view factors cannot be had where those of the other can.
template <class Check>
bool is_worse(const Check& check, const Check& before) {
  if constexpr (requires { check.unmeasured; })
    if (check.unmeasured > before.unmeasured) return true;
  return counts_of(check.findings).is_more_than(counts_of(before.findings)) || (before.factors && !check.factors);
}

// Makes one repair after the other until a scene is no worse than before, and returns it; the last one, which leaves
// the scene as it is, whatever is found. What was done by those before it is told as undone (not-repaired), as it is
// where the scene that comes of it would be refused. `look` returns the check of what a repair returned, and is called
// with the one that is taken last. Throws what the last one does.
template <class Repair, class Check, class Look>
Repair chosen_repair(const Check& before, const std::vector<std::function<Repair()>>& ways, const Look& look) {
  std::vector<RepairStep> undone;
  for (std::size_t k = 0;; ++k) {
    const bool is_last = k + 1 == ways.size();
    std::optional<Repair> repair;
    const char* reason = nullptr;
    try {
      repair = ways[k]();
      if (is_worse(look(*repair), before)) reason = "undone, for more would be found than is now";
    } catch (const InputError&) {
      if (is_last) throw;
      reason = "undone, for the scene would be refused";
    }
    if (reason == nullptr || is_last) {
      repair->steps.insert(repair->steps.end(), undone.begin(), undone.end());
      return std::move(*repair);
    }
    if (!undone.empty()) continue;
    if (!repair) undone.push_back({"not-repaired", "", reason});
    for (const RepairStep& step : repair ? repair->steps : std::vector<RepairStep>())
      if (step.kind != "not-repaired")
        undone.push_back({"not-repaired", step.surface, std::string(reason) + ": " + step.message});
  }
}

}  // namespace hottel
