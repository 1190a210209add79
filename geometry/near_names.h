// Names that were perhaps meant.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/support/failure.h"

namespace hottel {

inline constexpr std::size_t kMostNearNames = 3;

// Returns up to kMostNearNames of the known names that are near `name`, the nearest first, each once.
//
//   (1) near is what some letters less than a third of the name, but at least one and never all of it, turn into the
//       name when each may be inserted, dropped, replaced or swapped with its neighbour; case does not count
//   (2) and what goes on where the name ends ("room[0]" for "room"), after those of (1), the shortest first
//   (3) equally near ones come in the order given
//
// COST: the product of the lengths for each known name of a similar length. Names of more than 200 bytes are not
// compared.
std::vector<std::string> near_names(std::string_view name, std::span<const std::string> known);

// Returns the hint of a message about a name that there is not, "did you mean 'wall', 'wall:back'?", or no hint.
std::vector<std::string> near_name_hints(std::string_view name, std::span<const std::string> known);

// A name was asked for that there is not: a UsageError with hints below its line.
class UnknownName : public UsageError {
 public:
  // Of the known names those near to `name` are offered.
  UnknownName(const std::string& text, std::string_view name, std::span<const std::string> known)
      : UsageError(text), hints_(near_name_hints(name, known)) {}
  const std::vector<std::string>& hints() const { return hints_; }

 private:
  std::vector<std::string> hints_;
};

}  // namespace hottel
