#include "geometry/space/check/repair.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "geometry/harmless_repair.h"
#include "geometry/space/check/contact_findings.h"
#include "geometry/space/check/gap_closer.h"
#include "geometry/space/check/mesh_findings.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

// What is found without any light.
Findings3 shape_and_contacts(const Scene3& scene) {
  Findings3 findings = contact_findings(scene, find_contacts(scene));
  for (Findings3 more : {shape_findings(scene), mesh_findings(scene, find_meshes(scene))})
    std::move(more.begin(), more.end(), std::back_inserter(findings));
  return findings;
}

}  // namespace

Repair3 unrepaired(const Scene3& scene) {
  Repair3 repair{scene, {}, {}};
  for (const Surface& surface : scene.surfaces) repair.former_names.push_back(surface.name);
  return repair;
}

std::string former_name(const Repair3& repair, const Element& element) {
  const std::size_t length = repair.scene.surfaces[element.surface].name.size();
  return repair.former_names[element.surface] + element.name.substr(length);
}

Repair3 close_gaps(const Scene3& scene, const Rational& distance) {
  HOTTEL_REQUIRE(distance > 0);
  const auto close = [&](const Scene3& some, const std::vector<char>& held) {
    return closed_gaps(some, distance, held);
  };
  return HarmlessRepair(scene, close, shape_and_contacts).repair();
}

void reverse_upside_down(Repair3& repair) {
  for (const std::uint32_t s : find_meshes(repair.scene).reversed) {
    const Surface& surface = repair.scene.surfaces[s];
    if (surface.back) continue;
    std::vector<Point3>& points = repair.scene.polygons[s].points;
    std::reverse(points.begin() + 1, points.end());
    repair.steps.push_back({"reversed", surface.name,
                            fmt::format("the points of {} go the other way round: its front was on the other side than "
                                        "those around it",
                                        quoted_name(surface.name))});
  }
}

}  // namespace hottel
