// What was found in a scene in space, as JSON and as text for people.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "geometry/space/check/finding.h"
#include "io/results/finding_report.h"

namespace hottel {

// As check_json, check_text and findings_text of io/results/finding_report.h. Coordinates are [x,y,z].
std::string check_json(const Scene3& scene, const Findings3& findings, const RepairReport* repair = nullptr);
std::string check_text(const Scene3& scene, const Findings3& findings, std::size_t most = kMostOfAKind);
std::string findings_text(const Scene3& scene, const Findings3& findings, std::size_t most = kMostOfAKind);

}  // namespace hottel
