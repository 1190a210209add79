// What was found in a scene in the plane, as JSON and as text for people.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "geometry/plane/check/finding.h"
#include "geometry/plane/check/repair.h"
#include "io/results/finding_report.h"

namespace hottel {

// As check_json, check_text and findings_text of io/results/finding_report.h. Coordinates are [x,y].
std::string check_json(const Scene2& scene, const Findings2& findings, const RepairReport* repair = nullptr);
std::string check_text(const Scene2& scene, const Findings2& findings, std::size_t most = kMostOfAKind);
std::string findings_text(const Scene2& scene, const Findings2& findings, std::size_t most = kMostOfAKind);

}  // namespace hottel
