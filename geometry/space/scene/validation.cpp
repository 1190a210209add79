#include "geometry/space/scene/validation.h"

#include <algorithm>
#include <string>

#include "geometry/grid_names.h"
#include "geometry/name.h"
#include "geometry/patch_bases.h"
#include "geometry/space/scene/light_place_problem.h"
#include "geometry/space/scene/patch_seats.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

// What is wrong with a mask and its base, as the end of a sentence; empty when nothing is.
std::string mask_problem(const Scene3& scene, const Mask3& mask) {
  const std::string base = quoted_name(scene.surfaces[mask.base].name);
  if (mask.surface == mask.base) return "masks itself";
  if (scene.surfaces[mask.surface].is_obstruction)
    return "masks " + base + " and is an obstruction; masks have a material";
  if (scene.surfaces[mask.base].is_obstruction) return "masks " + base + ", an obstruction, which exchanges nothing";
  for (const std::uint32_t s : {mask.surface, mask.base})
    if (scene.surfaces[s].on)
      return "masks " + base +
             (s == mask.base ? ", which lies on another surface: masks lie on whole ones"
                             : " and lies on another surface: it does one or the other");
  const auto is_base = [&](const Mask3& other) { return other.surface == mask.base; };
  if (std::any_of(scene.masks.begin(), scene.masks.end(), is_base)) return "masks " + base + ", which is a mask itself";
  const Polygon3 &polygon = scene.polygons[mask.surface], &under = scene.polygons[mask.base];
  const Vector3 normal = doubled_area(under);
  const std::vector<Point3> corners = corners_of(polygon);
  const bool is_in_plane = std::all_of(corners.begin(), corners.end(), [&](const Point3& point) {
    return dot(normal, point - under.points.front()) == 0;
  });
  if (!is_in_plane || polygon.is_nearly_plane || under.is_nearly_plane)
    return "is not exactly in the plane of " + base + ", which it masks";
  return dot(normal, doubled_area(polygon)) < 0 ? ""
                                                : "faces the same way as " + base + ", which it masks: masks face it";
}

void validate_masks(const Scene3& scene) {
  const Mask3* before = nullptr;
  for (const Mask3& mask : scene.masks) {
    HOTTEL_REQUIRE(mask.surface < scene.surfaces.size() && mask.base < scene.surfaces.size());
    HOTTEL_REQUIRE(before == nullptr || before->surface < mask.surface);
    before = &mask;
    if (const std::string problem = mask_problem(scene, mask); !problem.empty())
      throw InputError(place_of(scene, scene.surfaces[mask.surface]),
                       "polygon " + quoted_name(scene.surfaces[mask.surface].name) + " " + problem);
  }
}

// Nothing lies between a mask and what it masks.
void validate_masks_without_patches(const Scene3& scene) {
  const PatchBases patches(scene);
  if (patches.is_empty()) return;
  for (const Mask3& mask : scene.masks)
    for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s)
      if (const auto front = patches.face_under(s, mask.surface); front && (!front->is_back || scene.surfaces[s].back))
        refuse_patch(scene, s,
                     "lies on " + quoted_name(scene.surfaces[mask.surface].name) + ", which masks " +
                         quoted_name(scene.surfaces[mask.base].name) + ": nothing lies between the two",
                     "a mask sees what it masks alone: put the patch elsewhere, or leave out \"masks\"");
}

// (3) to (5), but for the table.
void validate_rest(const Scene3& scene) {
  validate_masks(scene);
  validate_masks_without_patches(scene);
  HOTTEL_REQUIRE(scene.light_places.size() == scene.lights.size());
  for (std::size_t k = 0; k < scene.lights.size(); ++k)
    if (const std::string problem = light_place_problem(scene, scene.lights[k], scene.light_places[k]);
        !problem.empty())
      throw InputError({scene.file, scene.lights[k].line},
                       "light " + quoted_name(scene.lights[k].name) + " " + problem);
  if (const std::string problem = scene.camera ? camera_problem(*scene.camera) : ""; !problem.empty())
    throw InputError({scene.file, 0}, "camera: " + problem);
  validate_grids(scene.grids, scene.file);
}

}  // namespace

void validate(const Scene3& scene) {
  HOTTEL_REQUIRE(scene.polygons.size() == scene.surfaces.size());
  validate_table(scene);
  for (std::size_t s = 0; s < scene.polygons.size(); ++s) {
    const auto& [problem, hint] = polygon_problem(scene.polygons[s]);
    if (!problem.empty())
      throw InputError(place_of(scene, scene.surfaces[s]),
                       "polygon " + quoted_name(scene.surfaces[s].name) + " " + problem,
                       hint.empty() ? std::vector<std::string>() : std::vector{hint});
  }
  validate_patches(scene);
  validate_rest(scene);
}

void validate_but_polygons(const Scene3& scene) {
  HOTTEL_REQUIRE(scene.polygons.size() == scene.surfaces.size());
  validate_table(scene);
  validate_rest(scene);
}

void ValidScene3::set_grids(std::vector<Grid3> grids) {
  validate_grids(grids, scene_.file);
  scene_.grids = std::move(grids);
}

}  // namespace hottel
