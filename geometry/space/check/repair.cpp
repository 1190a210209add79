#include "geometry/space/check/repair.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

#include "geometry/harmless_repair.h"
#include "geometry/space/check/contact_findings.h"
#include "geometry/space/check/gap_closer.h"
#include "geometry/space/check/mesh_findings.h"
#include "geometry/space/check/shells.h"
#include "geometry/space/scene/patches.h"
#include "geometry/space/scene/polygon_places.h"
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

bool precedes_in_space(const Point3& a, const Point3& b) { return precedes(a, b); }

struct LoopOrder {
  bool operator()(const std::vector<Point3>& a, const std::vector<Point3>& b) const {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), precedes_in_space);
  }
};

// The same loop, from its least corner on.
std::vector<Point3> loop_from_least(std::vector<Point3> loop) {
  std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end(), precedes_in_space), loop.end());
  return loop;
}

// Whether two polygons with the same outline are one but for their names.
bool is_alike(const Scene3& scene, std::uint32_t s, std::uint32_t t) {
  const Surface &a = scene.surfaces[s], &b = scene.surfaces[t];
  return scene.polygons[s].holes == scene.polygons[t].holes && a.is_obstruction == b.is_obstruction &&
         a.material == b.material && a.back == b.back && a.on == b.on;
}

// Takes away surfaces for which `keep` is false; those are no masks or bases.
template <class Keep>
void keep_if(Repair3& repair, const Keep& keep) {
  Scene3& scene = repair.scene;
  std::vector<std::uint32_t> place(scene.surfaces.size());
  std::uint32_t count = 0;
  for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s) {
    place[s] = count;
    if (!keep(s)) continue;
    if (count != s) {
      scene.surfaces[count] = std::move(scene.surfaces[s]);
      scene.polygons[count] = std::move(scene.polygons[s]);
      repair.former_names[count] = std::move(repair.former_names[s]);
      repair.origins[count] = repair.origins[s];
    }
    ++count;
  }
  scene.surfaces.resize(count);
  scene.polygons.resize(count);
  repair.former_names.resize(count);
  repair.origins.resize(count);
  for (Mask3& mask : scene.masks) mask = {place[mask.surface], place[mask.base]};
}

}  // namespace

Repair3 unrepaired(const Scene3& scene) {
  Repair3 repair{scene, {}, {}};
  for (const Surface& surface : scene.surfaces) {
    repair.origins.push_back(static_cast<std::uint32_t>(repair.former_names.size()));
    repair.former_names.push_back(surface.name);
  }
  return repair;
}

std::string former_name(const Repair3& repair, const Element& element) {
  const std::size_t length = repair.scene.surfaces[element.surface].name.size();
  return repair.former_names[element.surface] + element.name.substr(length);
}

Repair3 close_gaps(const Scene3& scene, const Rational& distance) {
  HOTTEL_REQUIRE(distance > 0);
  const auto close = [&](const Scene3& some, const std::vector<char>& held) {
    Repair3 repair = closed_gaps(some, distance, held);
    tidy(repair);
    return repair;
  };
  Repair3 tidied = unrepaired(scene);
  tidy(tidied);
  Repair3 closed = HarmlessRepair(tidied.scene, close, shape_and_contacts).repair();
  for (std::uint32_t& s : closed.origins) s = tidied.origins[s];
  for (std::vector<std::uint32_t>& together : closed.moved)
    for (std::uint32_t& s : together) s = tidied.origins[s];
  closed.steps.insert(closed.steps.begin(), tidied.steps.begin(), tidied.steps.end());
  return closed;
}

// What is reversed may be a double now.
void tidy(Repair3& repair) {
  constexpr int kMostRounds = 8;
  std::size_t before = 0;
  for (int round = 0; round == 0 || (round < kMostRounds && repair.steps.size() > before); ++round) {
    before = repair.steps.size();
    drop_doubles(repair);
    reverse_upside_down(repair);
    reverse_inside_out(repair);
  }
}

namespace {

// Reverses polygons and the patches on them.
void reverse(Scene3& scene, std::vector<std::uint32_t> surfaces) {
  const std::vector<std::uint32_t> patches = patches_on(scene, surfaces);
  surfaces.insert(surfaces.end(), patches.begin(), patches.end());
  for (const std::uint32_t s : surfaces)
    std::reverse(scene.polygons[s].points.begin() + 1, scene.polygons[s].points.end());
}

}  // namespace

void reverse_upside_down(Repair3& repair) {
  for (const std::uint32_t s : find_meshes(repair.scene).reversed) {
    const Surface& surface = repair.scene.surfaces[s];
    if (surface.back) continue;
    reverse(repair.scene, {s});
    repair.steps.push_back({"reversed", surface.name,
                            fmt::format("the points of {} go the other way round: its front was on the other side than "
                                        "those around it",
                                        quoted_name(surface.name))});
  }
}

void reverse_inside_out(Repair3& repair) {
  Scene3& scene = repair.scene;
  for (const Shell3& shell : inside_out_shells(scene)) {
    if (!shell.may_be_body) continue;
    reverse(scene, shell.surfaces);
    repair.steps.push_back({"reversed", scene.surfaces[shell.surfaces.front()].name,
                            fmt::format("the points of {} polygons of {} go the other way round: they were closed with "
                                        "their fronts inward, and nothing was in them",
                                        shell.surfaces.size(), quoted_name(scene.groups[shell.group].name))});
  }
}

// A face of a closed part of a mesh stays, for without it the part is open: of two such both do.
void drop_doubles(Repair3& repair) {
  Scene3& scene = repair.scene;
  std::vector<char> is_of_part(scene.surfaces.size(), 0);
  for (const std::vector<std::uint32_t>& part : closed_parts(scene))
    for (const std::uint32_t s : part) is_of_part[s] = 1;
  std::map<std::vector<Point3>, std::vector<std::uint32_t>, LoopOrder> first;
  std::vector<char> is_double(scene.surfaces.size(), 0);
  for (const Mask3& mask : scene.masks) is_double[mask.surface] = is_double[mask.base] = 2;  // never
  const PatchCarriers3 carriers(scene);
  for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s)
    if (carriers.bases().is_patch(s)) {
      is_double[s] = 2;
      for (const std::uint32_t carrier : carriers.of(s)) is_double[carrier] = 2;
    }
  for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s) {
    if (is_double[s] != 0) continue;
    std::vector<std::uint32_t>& same = first[loop_from_least(scene.polygons[s].points)];
    const auto before = std::find_if(same.begin(), same.end(), [&](std::uint32_t t) { return is_alike(scene, s, t); });
    if (before == same.end() || (is_of_part[s] != 0 && is_of_part[*before] != 0)) {
      same.push_back(s);
      continue;
    }
    const std::uint32_t dropped = is_of_part[s] != 0 ? *before : s, kept = is_of_part[s] != 0 ? s : *before;
    *before = kept;
    is_double[dropped] = 1;
    repair.steps.push_back({"dropped", scene.surfaces[dropped].name,
                            fmt::format("{} is dropped: {} is the same", quoted_name(scene.surfaces[dropped].name),
                                        quoted_name(scene.surfaces[kept].name))});
  }
  keep_if(repair, [&](std::uint32_t s) { return is_double[s] != 1; });
}

}  // namespace hottel
