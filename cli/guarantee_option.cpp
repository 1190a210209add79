#include "cli/guarantee_option.h"

#include "kernel/support/failure.h"

namespace hottel {

CLI::Option* GuaranteeOption::add_to(CLI::App& command, const std::string& what_for) {
  return command
      .add_option("--guarantee", asked,
                  "in space: estimated (default), or enclosed: " + what_for +
                      "a pair without proven bounds within T is refused")
      ->check(CLI::IsMember({"enclosed", "estimated"}));
}

void GuaranteeOption::refuse_in_plane() const {
  if (asked) throw UsageError("--guarantee is for scenes in space: in the plane every factor is correctly rounded");
}

void GuaranteeOption::refuse_of_method(const std::string& method) const {
  if (asked) throw UsageError("--guarantee is for the method exact only, not for " + method);
}

}  // namespace hottel
