#include "cli/sky_option.h"

#include "kernel/support/failure.h"

namespace hottel {

void SkyOption::add_to(CLI::App& command) {
  command
      .add_option("--sky", by,
                  "in space: integration (default), or closure: the sky's factor is 1 less the others of its row, "
                  "integrated in every 32nd row to compare")
      ->check(CLI::IsMember({"integration", "closure"}));
}

SkyBy SkyOption::in_space(const std::string& method) const {
  if (!by.empty() && method != "exact") throw UsageError("--sky is for the method exact only, not for " + method);
  return by == "closure" ? SkyBy::kClosure : SkyBy::kIntegral;
}

void SkyOption::refuse_in_plane() const {
  if (!by.empty())
    throw UsageError("--sky is for scenes in space: in the plane every factor is correctly rounded, the sky's too");
}

}  // namespace hottel
