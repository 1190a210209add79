// A name on the command line that there is not.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/support/failure.h"

namespace hottel {

// A UsageError with hints below its line.                                                            (exit code 2)
class UnknownName : public UsageError {
 public:
  // Of the known names those near to `name` are offered.
  UnknownName(const std::string& text, std::string_view name, std::span<const std::string> known);
  const std::vector<std::string>& hints() const { return hints_; }

 private:
  std::vector<std::string> hints_;
};

}  // namespace hottel
