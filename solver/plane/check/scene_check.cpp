#include "solver/plane/check/scene_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "geometry/plane/arrangement/free_regions.h"
#include "geometry/plane/check/black_backs.h"
#include "geometry/plane/check/contact_findings.h"
#include "geometry/plane/check/gap_findings.h"
#include "geometry/plane/check/near_misses.h"
#include "geometry/plane/check/needles.h"
#include "geometry/plane/check/region_findings.h"
#include "geometry/plane/check/solid_findings.h"
#include "geometry/plane/check/visibility_findings.h"
#include "geometry/plane/check/wording.h"
#include "geometry/plane/visibility/point_location.h"
#include "geometry/plane/visibility/solid_around.h"
#include "kernel/support/failure.h"
#include "solver/check/kelvin_hint.h"
#include "solver/plane/check/light_findings.h"

namespace hottel {
namespace {

void append(Findings2& findings, Findings2 more) { std::move(more.begin(), more.end(), std::back_inserter(findings)); }

// Those that are not in a solid, where nothing is seen.
std::vector<NearMiss2> free_near_misses(const Scene2& scene, const Arrangement2& arrangement) {
  std::vector<NearMiss2> near_misses = find_near_misses(scene);
  if (near_misses.empty() || arrangement.solids().is_empty()) return near_misses;
  const PointLocation2 location(arrangement.vertices(), arrangement.triangulation());
  View2 view;
  std::erase_if(near_misses, [&](const NearMiss2& miss) {
    const Point2 between = middle(miss.tip, miss.foot);
    location.look_around(Eye2(arrangement.vertices(), arrangement.vertices().from_scene(between)), view);
    return solid_around(arrangement, view) != Solids2::kNone;
  });
  return near_misses;
}

FreeRegions2 cells_of(const PreparedScene2& prepared) {
  return {prepared.arrangement.triangulation(), prepared.arrangement.side_count()};
}

// Leaves out what follows from it that a solid holds the rest of the scene, or that a room is inside out.
void leave_out_consequences(const Scene2& scene, const FaceCover2& cover, const std::vector<char>& is_inside_out,
                            Findings2& findings) {
  std::vector<char> is_asked_about(scene.groups.size(), 0);
  bool holds_light = false;
  for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s) {
    const Surface& surface = scene.surfaces[s];
    const std::uint32_t holder = cover.holder[surface.group];
    if (holder == Solids2::kNone) continue;
    is_asked_about[holder] = is_asked_about[surface.group] = 1;
    holds_light |= !scene.materials[surface.material].emission.is_zero();
    holds_light |= surface.back && !scene.materials[*surface.back].emission.is_zero();
  }
  std::erase_if(findings, [&](const Finding2& finding) {
    if (finding.kind == "no-light") return holds_light;
    if (finding.kind != "sees-only-sky" && finding.kind != "dark") return false;
    return std::all_of(finding.surfaces.begin(), finding.surfaces.end(), [&](std::uint32_t s) {
      return is_inside_out[s] != 0 || is_asked_about[scene.surfaces[s].group] != 0;
    });
  });
}

// What needs the arrangement of a scene without conflicts, and perhaps view factors.
void check_light(const PreparedScene2& prepared, const FaceCover2& cover, const std::vector<NearMiss2>& near_misses,
                 const CheckSources2& sources, SceneCheck2& check) {
  const Scene2& scene = prepared.scene;
  append(check.findings, needle_findings(scene, prepared.arrangement));
  const FreeRegions2 regions = cells_of(prepared);
  RegionFindings2 rooms = region_findings(prepared, regions);
  append(check.findings, std::move(rooms.findings));
  try {
    check.factors = sources.factors();
  } catch (const RequestError& error) {
    check.findings.push_back({Severity::kNote,
                              "light-not-checked",
                              {},
                              {},
                              fmt::format("what needs view factors was not looked at: {}", error.what()),
                              "check a part of the scene"});
  }
  append(check.findings, gap_findings(scene, near_misses, check.factors != nullptr));
  if (!check.factors) return;
  BlackBacks2 black = black_backs(prepared, regions, *check.factors, rooms.is_inside_out);
  append(check.findings, std::move(black.findings));
  check.black_backs = std::move(black.surfaces);
  append(check.findings, visibility_findings(prepared, *check.factors));
  append(check.findings,
         light_findings(scene, *check.factors, sources.lights ? sources.lights() : std::vector<LightShares>(),
                        sources.progress));
  leave_out_consequences(scene, cover, rooms.is_inside_out, check.findings);
}

}  // namespace

SceneCheck2 check_scene(const Scene2& scene, const CheckSources2& sources) {
  SceneCheck2 check;
  const Arrangement2 arrangement(scene, Division2(scene.surfaces.size(), 1), Conflicts2::kFirstWins);
  const Contacts2 contacts = find_contacts(scene, arrangement);
  append(check.findings, contact_findings(scene, contacts));
  append(check.findings, solid_findings(scene, contacts.faces));
  const std::vector<NearMiss2> near_misses = free_near_misses(scene, arrangement);
  if (has_error(check.findings)) {
    append(check.findings, gap_findings(scene, near_misses, false));
    check.findings.push_back({Severity::kNote,
                              "light-not-checked",
                              {},
                              {},
                              "surfaces claim the same side with different materials: what needs view factors was not "
                              "looked at",
                              "mend that and check again"});
  } else {
    check_light(*sources.prepared(), contacts.faces, near_misses, sources, check);
  }
  if (const auto hint = kelvin_hint(scene, check.factors.get()))
    check.findings.push_back({Severity::kNote, "kelvin", {}, {}, *hint, kKelvinSuggestion});
  sort_findings(check.findings);
  return check;
}

Findings2 lost_light_warnings(const PreparedScene2& prepared, const ExchangeMatrix& matrix) {
  Findings2 findings;
  if (!prepared.arrangement.solids().is_empty())
    append(findings, solid_findings(prepared.scene, FaceCover2(prepared.scene, prepared.arrangement)));
  if (sees_black_backs_2(matrix)) {
    const FreeRegions2 regions = cells_of(prepared);
    RegionFindings2 rooms = region_findings(prepared, regions);
    std::erase_if(rooms.findings, [](const Finding2& finding) { return finding.kind != "inside-out"; });
    append(findings, std::move(rooms.findings));
    append(findings, black_backs(prepared, regions, matrix, rooms.is_inside_out).findings);
  }
  std::erase_if(findings, [](const Finding2& finding) { return finding.severity != Severity::kWarning; });
  sort_findings(findings);
  return findings;
}

}  // namespace hottel
