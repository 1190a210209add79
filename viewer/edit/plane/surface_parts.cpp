#include "viewer/edit/plane/surface_parts.h"

#include <algorithm>
#include <numeric>

#include "geometry/plane/scene/polyline_runs.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

SurfaceParts2 parts_where(const Scene2& scene, const std::vector<bool>& is_chosen) {
  const std::vector<std::size_t> sizes = group_sizes(scene);
  SurfaceParts2 parts;
  for (std::uint32_t s = 0; s < scene.surfaces.size();) {
    const auto end = static_cast<std::uint32_t>(end_of_polyline(scene, s));
    const bool is_whole = end - s == sizes[scene.surfaces[s].group] &&
                          std::find(is_chosen.begin() + s, is_chosen.begin() + end, false) == is_chosen.begin() + end;
    if (is_whole)
      parts.polylines.push_back({s, end});
    else if (is_chosen[s])
      parts.others.push_back(s);
    s = is_whole ? end : s + 1;
  }
  return parts;
}

}  // namespace

SurfaceParts2 surface_parts(const Scene2& scene) {
  return parts_where(scene, std::vector<bool>(scene.surfaces.size(), true));
}

SurfaceParts2 surface_parts(const Scene2& scene, std::span<const std::uint32_t> surfaces) {
  std::vector<bool> is_chosen(scene.surfaces.size());
  for (const std::uint32_t s : surfaces) {
    HOTTEL_REQUIRE(s < is_chosen.size());
    is_chosen[s] = true;
  }
  return parts_where(scene, is_chosen);
}

std::vector<std::uint32_t> surfaces_of(const SurfaceParts2& parts) {
  std::vector<std::uint32_t> surfaces = parts.others;
  for (const SurfaceRun2& run : parts.polylines)
    for (std::uint32_t s = run.begin; s < run.end; ++s) surfaces.push_back(s);
  std::sort(surfaces.begin(), surfaces.end());
  return surfaces;
}

}  // namespace hottel
