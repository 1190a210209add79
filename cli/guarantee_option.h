// The option --guarantee: whether every exact factor in space must have proven bounds.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

namespace hottel {

// Whether factors must be enclosed: a pair without proven bounds within the tolerance is then refused. By default, as
// by "estimated", each is what it is.
struct GuaranteeOption {
  std::optional<std::string> asked;

  // `what_for`: what follows of factors that are proven, for the help.
  CLI::Option* add_to(CLI::App& command, const std::string& what_for = "");
  bool must_be_enclosed() const { return asked == "enclosed"; }
  // Throw UsageError where the option is given.
  void refuse_in_plane() const;
  void refuse_of_method(const std::string& method) const;
};

}  // namespace hottel
