#include "geometry/space/check/finding.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace hottel {

void sort_findings(Findings3& findings) {
  const auto key = [](const Finding3& finding) {
    const std::uint32_t first =
        finding.surfaces.empty() ? std::numeric_limits<std::uint32_t>::max() : finding.surfaces.front();
    return std::pair(finding.severity, first);
  };
  std::stable_sort(findings.begin(), findings.end(),
                   [&](const Finding3& a, const Finding3& b) { return key(a) < key(b); });
}

bool has_error(const Findings3& findings) {
  return std::any_of(findings.begin(), findings.end(),
                     [](const Finding3& finding) { return finding.severity == Severity::kError; });
}

}  // namespace hottel
