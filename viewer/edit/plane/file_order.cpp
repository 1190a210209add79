#include "viewer/edit/plane/file_order.h"

#include <numeric>
#include <string_view>
#include <unordered_set>
#include <utility>

#include "geometry/patch_bases.h"
#include "geometry/plane/scene/patches.h"
#include "geometry/plane/scene/polyline_runs.h"
#include "kernel/support/failure.h"
#include "viewer/edit/free_names.h"
#include "viewer/edit/plane/surface_parts.h"

namespace hottel {
namespace {

using Names = std::unordered_set<std::string_view>;

Names names_of_polylines(const Scene2& scene, const SurfaceParts2& parts) {
  Names names;
  for (const SurfaceRun2& run : parts.polylines) names.insert(scene.groups[scene.surfaces[run.begin].group].name);
  return names;
}

bool is_in_order(const Scene2& scene, const SurfaceParts2& parts, const Names& polylines) {
  if (scene.groups.size() != parts.others.size() + parts.polylines.size()) return false;
  for (std::uint32_t k = 0; k < parts.others.size(); ++k) {
    const Surface& surface = scene.surfaces[k];
    if (parts.others[k] != k || surface.group != k || scene.groups[k].name != surface.name) return false;
    if (polylines.contains(surface.name)) return false;
  }
  std::size_t group = parts.others.size();
  for (const SurfaceRun2& run : parts.polylines)
    if (scene.surfaces[run.begin].group != group++) return false;
  return true;
}

}  // namespace

Scene2 as_read(const Scene2& scene) {
  HOTTEL_REQUIRE(scene.edges.size() == scene.surfaces.size());
  Scene2 read = scene;
  read.groups.clear();
  const std::size_t first = first_of_polylines(scene);
  const auto behind = [&](std::size_t s) { return scene.groups[scene.surfaces[s].group].behind; };
  for (std::size_t s = 0; s < first; ++s) {
    read.surfaces[s].group = static_cast<std::uint32_t>(s);
    read.groups.emplace_back(scene.surfaces[s].name, behind(s));
  }
  for (std::size_t begin = first, end = first; begin < scene.surfaces.size(); begin = end) {
    end = end_of_polyline(scene, begin);
    for (std::size_t s = begin; s < end; ++s) read.surfaces[s].group = static_cast<std::uint32_t>(read.groups.size());
    read.groups.push_back(scene.groups[scene.surfaces[begin].group]);
  }
  return read;
}

FileOrder2 in_file_order(Scene2 scene) {
  HOTTEL_REQUIRE(scene.edges.size() == scene.surfaces.size());
  std::vector<std::uint32_t> place(scene.surfaces.size());
  std::iota(place.begin(), place.end(), 0u);
  const SurfaceParts2 parts = surface_parts(scene);
  const Names polylines = names_of_polylines(scene, parts);
  if (is_in_order(scene, parts, polylines)) {
    settle_bases(scene);
    return {std::move(scene), std::move(place)};
  }

  const Scene2 before = scene.bases.empty() ? Scene2() : scene;
  FreeNames names(scene);
  std::vector<Group> groups;
  Scene2 ordered;
  const auto put = [&](std::size_t s) {
    place[s] = static_cast<std::uint32_t>(ordered.surfaces.size());
    scene.surfaces[s].group = static_cast<std::uint32_t>(groups.size());
    ordered.add(std::move(scene.surfaces[s]), std::move(scene.edges[s]));
  };
  for (const std::uint32_t s : parts.others) {
    Surface& surface = scene.surfaces[s];
    const Behind behind = scene.groups[surface.group].behind;
    if (polylines.contains(surface.name)) surface.name = names.another(surface.name);
    Group group(surface.name, behind);
    put(s);
    groups.push_back(std::move(group));
  }
  for (const SurfaceRun2& run : parts.polylines) {
    const std::uint32_t group = scene.surfaces[run.begin].group;
    for (std::size_t s = run.begin; s < run.end; ++s) put(s);
    groups.push_back(scene.groups[group]);
  }
  scene.surfaces = std::move(ordered.surfaces);
  scene.edges = std::move(ordered.edges);
  scene.groups = std::move(groups);
  if (!scene.bases.empty()) rename_bases(before, {place.begin(), place.end()}, scene);
  settle_bases(scene);
  return {std::move(scene), std::move(place)};
}

}  // namespace hottel
