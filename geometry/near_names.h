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
//   (1) a name is near when few letters have to be inserted, dropped, replaced or swapped with their neighbour to turn
//       `name` into it: at most a third of its letters, but at least one and never all; case does not count
//   (2) after those of (1) come names that go on where `name` ends ("room[0]" for "room"), the shortest first
//   (3) equally near ones come in the order given
//   (4) nothing is near an empty name; names of more than 200 bytes are not compared
//   (5) a name is not near itself: who asks for it wants something else of that name, such as light of the sky
//
// COST: the product of the lengths for each known name of a similar length.
// SEE: the edit distance of Damerau, where no letter is changed twice.
std::vector<std::string> near_names(std::string_view name, std::span<const std::string> known);

// Returns the hint of a message about an unknown name, "did you mean 'wall', 'wall:back'?"; no hint where
// none is near.
std::vector<std::string> near_name_hints(std::string_view name, std::span<const std::string> known);

// A name was asked for that does not exist: a UsageError with hints below its line.
//
//   (1) what() is the text as it was given
//   (2) hints() are near_name_hints of the known names; where none is near, `there_is`
class UnknownName : public UsageError {
 public:
  // Of the known names those near to `name` are offered. `there_is`: "its surfaces are 'wall' and 'door'", or empty.
  UnknownName(const std::string& text, std::string_view name, std::span<const std::string> known,
              const std::string& there_is = "")
      : UsageError(text), hints_(near_name_hints(name, known)) {
    if (hints_.empty() && !there_is.empty()) hints_.push_back(there_is);
  }
  const std::vector<std::string>& hints() const { return hints_; }

 private:
  std::vector<std::string> hints_;
};

}  // namespace hottel
