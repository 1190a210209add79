#include "solver/plane/check/scene_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "geometry/name.h"
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
#include "kernel/plain_functions.h"
#include "kernel/support/failure.h"
#include "solver/check/dark_suns.h"
#include "solver/check/kelvin_hint.h"
#include "solver/check/light_errors.h"
#include "solver/check/light_fates.h"

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

// Iterations from which convergence is called slow: what jacobi needs for a relative residual of 1e-12.
constexpr double kManyIterations = 1000;
constexpr double kResidual = 1e-12;

// Of jacobi: the spectral radius is at least its Rayleigh quotient for equal irradiances.
double iterations(const LightFate& fate) {
  return fate.loss > 0 && fate.loss < 1 ? same_bits::log(kResidual) / same_bits::log1p(-fate.loss) : 0;
}

using Faces = std::vector<std::uint32_t>;  // elements of the matrix, ascending

class LightTeller {
 public:
  LightTeller(const Scene2& scene, const ExchangeMatrix& matrix, std::span<const LightShares> lights,
              const std::function<void(double)>& progress)
      : scene_(scene), matrix_(matrix), lights_(lights), progress_(progress) {}

  Findings2 tell() {
    const RadiositySources sources = given_sources();
    const LightFates fates = light_fates(scene_, matrix_, sources);
    for (const auto& [faces, fate] : fates.of) tell_component(faces, fate);
    for (LightError& error : light_errors(scene_, matrix_, sources, fates, "length", progress_))
      add(Severity::kError, std::move(error.kind), std::move(error.surfaces), std::move(error.message),
          std::move(error.suggestion));
    if (!scene_.surfaces.empty() && !has_source())
      add(Severity::kNote, "no-light", {}, "nothing emits: every radiosity is 0",
          "view factors do not need any light; to solve, give a material or the sky an emission");
    for (std::size_t k = 0; k < lights_.size(); ++k)
      if (!lights_[k].solid.empty())
        findings_.push_back({Severity::kWarning,
                             "light-in-solid",
                             {},
                             scene_.light_places[k].position,
                             lost_light_text(scene_.lights[k], lights_[k]),
                             "move it out, or turn the points of that solid around where a room was meant"});
    for (std::size_t k = 0; k < lights_.size(); ++k)
      if (scene_.light_places[k].rotation == 0)  // else it may come
        if (std::string text = dark_sun_text(scene_.lights[k], lights_[k], matrix_); !text.empty())
          add(Severity::kNote, "dark-sun", {}, std::move(text), kDarkSunSuggestion);
    tell_materials();
    return std::move(findings_);
  }

 private:
  // Those of the scene; without its lights, and an error, where these are too much for doubles or cannot be told.
  RadiositySources given_sources() {
    try {
      return sources_of(matrix_, scene_, lights_);
    } catch (const RequestError& error) {
      const LightError told = refused_light(scene_, error.what());
      add(Severity::kError, told.kind, {}, told.message, told.suggestion);
      return sources_of(matrix_, scene_.materials, scene_.sky_emission);
    }
  }

  void add(Severity severity, std::string kind, std::vector<std::uint32_t> surfaces, std::string message,
           std::string suggestion) {
    std::optional<Point2> at;
    if (!surfaces.empty()) at = middle(scene_.edges[surfaces.front()]);
    findings_.push_back(
        {severity, std::move(kind), std::move(surfaces), at, std::move(message), std::move(suggestion)});
  }

  void tell_component(const Faces& faces, const LightFate& fate) {
    const std::vector<std::uint32_t> surfaces = surfaces_of_elements(matrix_, faces);
    const std::string names = names_text(scene_, surfaces);
    if (fate.has_no_solution) return;  // an error
    if (fate.reflects_all)
      add(Severity::kNote, "all-reflecting", surfaces,
          fmt::format("all light that meets {} is reflected and none gets out, but none is emitted there either: "
                      "radiosity is 0, the limit",
                      names),
          "nothing to do where that is meant");
    else if (!fate.is_lit && has_source() && sees_material(faces.front()))
      add(Severity::kNote, "dark", surfaces, fmt::format("no light reaches {}: radiosity is exactly 0", names),
          "open a way for light, or let something there emit");
    else if (iterations(fate) >= kManyIterations)
      add(Severity::kNote, "slow-convergence", surfaces,
          fmt::format("light stays long between {}: jacobi needs about {:.2g} iterations or more for a residual of {}",
                      names, iterations(fate), shortest(kResidual)),
          "solve with cholesky or cg, as auto does; they do not mind");
  }

  // What sees nothing that could send light is told as that (visibility_findings).
  bool sees_material(std::uint32_t face) const {
    const auto row = matrix_.row(face);
    return std::any_of(row.begin(), row.end(), [this](const FactorEntry& entry) {
      return entry.to != matrix_.sky() && matrix_.elements()[entry.to].material;
    });
  }

  bool has_source() const {
    const auto shines = [](const Light& light) { return !light.power.is_zero(); };
    if (std::any_of(scene_.lights.begin(), scene_.lights.end(), shines)) return true;
    return !scene_.sky_emission.is_zero() || std::any_of(scene_.surfaces.begin(), scene_.surfaces.end(), [&](auto& s) {
      return !scene_.materials[s.material].emission.is_zero() ||
             (s.back && !scene_.materials[*s.back].emission.is_zero());
    });
  }

  void tell_materials() {
    std::vector<char> is_used(scene_.materials.size(), 0);
    for (const Surface& surface : scene_.surfaces) {
      is_used[surface.material] = 1;
      if (surface.back) is_used[*surface.back] = 1;
    }
    for (std::size_t m = 0; m < is_used.size(); ++m)
      if (!is_used[m])
        add(Severity::kNote, "unused-material", {},
            fmt::format("no surface has the material {}", quoted_name(scene_.materials[m].name)),
            "take it away, or look for a surface that should have it");
  }

  const Scene2& scene_;
  const ExchangeMatrix& matrix_;
  const std::span<const LightShares> lights_;
  const std::function<void(double)>& progress_;
  Findings2 findings_;
};

// What is worth telling about the light in a scene before it is solved for. Kinds: no-solution, beyond-doubles
// (errors), light-in-solid (a warning), dark-sun, all-reflecting, dark, slow-convergence, no-light, unused-material.
//
//   (1) errors are those of light_errors (solver/check)
//   (2) the iterations of slow-convergence are what a bound from below of the spectral radius asks for
// REQUIRES: the exact matrix of the scene, by faces or by elements, and for each light its shares of these.
// COST: that of light_errors, which reports to `progress`.
Findings2 light_findings(const Scene2& scene, const ExchangeMatrix& matrix, std::span<const LightShares> lights,
                         const std::function<void(double)>& progress) {
  return LightTeller(scene, matrix, lights, progress).tell();
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
