#include "viewer/edit/plane/scene_edits.h"

#include <algorithm>
#include <array>
#include <string>
#include <unordered_map>
#include <utility>

#include "geometry/name.h"
#include "geometry/plane/arrangement/point_index.h"
#include "geometry/plane/scene/patches.h"
#include "kernel/support/failure.h"
#include "viewer/edit/decimals.h"
#include "viewer/edit/free_names.h"
#include "viewer/edit/plane/file_order.h"
#include "viewer/edit/plane/rotation.h"
#include "viewer/edit/plane/surface_parts.h"

namespace hottel {
namespace {

// The scene to be changed.
Scene2 begin_edit(const Scene2& scene) {
  Scene2 edited = scene;
  edited.expect.clear();
  return edited;
}

Scene2 end_edit(Scene2 scene) {
  settle_bands(scene);
  settle_two_sided(scene);
  return in_file_order(std::move(scene)).scene;
}

// The same after edges moved.
Scene2 end_move(const Scene2& before, Scene2 scene) {
  carry_patches(before, scene);
  return end_edit(std::move(scene));
}

// Every end of these surfaces goes where `place` says.
template <class Place>
Scene2 moved(const Scene2& scene, std::span<const std::uint32_t> surfaces, const Place& place) {
  Scene2 edited = begin_edit(scene);
  for (const std::uint32_t s : surfaces_of(surface_parts(scene, surfaces)))
    for (Point2* end : {&edited.edges[s].from, &edited.edges[s].to}) *end = place(*end);
  return end_move(scene, std::move(edited));
}

// Some surfaces, and the patches that lie on them.
std::vector<std::uint32_t> with_patches(const Scene2& scene, std::span<const std::uint32_t> surfaces) {
  std::vector<std::uint32_t> all(surfaces.begin(), surfaces.end());
  const std::vector<std::uint32_t> patches = patches_on(scene, all);
  all.insert(all.end(), patches.begin(), patches.end());
  return all;
}

// Adds surfaces to a scene, and finds them again where a file keeps them.
class Adder {
 public:
  explicit Adder(const Scene2& scene) : before_(scene.surfaces.size()), edited_(begin_edit(scene)) {}

  // What is added from now on is of this group.
  void begin_group(Group group) { edited_.groups.push_back(std::move(group)); }
  void add(Surface surface, Edge2 edge) {
    surface.group = static_cast<std::uint32_t>(edited_.groups.size() - 1);
    edited_.add(std::move(surface), std::move(edge));
  }
  // Copies of patches lie on the copies of what those lie on; where that was not copied they slide along it.
  void lay_patches(const Scene2& before, const std::vector<std::optional<std::uint32_t>>& copies) {
    const PatchCarriers2 carriers_of(before);
    const PatchBases& bases = carriers_of.bases();
    for (std::uint32_t s = 0; s < copies.size(); ++s) {
      if (!copies[s] || !bases.is_patch(s)) continue;
      const std::vector<std::uint32_t> carriers = carriers_of.of(s);
      if (carriers.empty()) continue;
      if (const auto carrier = copies[carriers.front()])
        lay_on(*copies[s], {edited_.surfaces[*carrier].name, bases.is_on_backs(s)});
      else
        slide(before, s, *copies[s]);
    }
  }
  AddedSurfaces2 result() && {
    settle_two_sided(edited_);
    FileOrder2 ordered = in_file_order(std::move(edited_));
    AddedSurfaces2 result{std::move(ordered.scene), {ordered.place.begin() + before_, ordered.place.end()}};
    std::sort(result.surfaces.begin(), result.surfaces.end());
    return result;
  }

 private:
  void lay_on(std::uint32_t patch, const PatchBase& base) {
    edited_.surfaces[patch].on = static_cast<std::uint32_t>(edited_.bases.size());
    edited_.bases.push_back(base);
  }
  // As the patch itself would, moved there.
  void slide(const Scene2& before, std::uint32_t patch, std::uint32_t copy) {
    Scene2 moved = before;
    moved.edges[patch] = edited_.edges[copy];
    carry_patches(before, moved);
    edited_.edges[copy] = moved.edges[patch];
  }

  std::ptrdiff_t before_;
  Scene2 edited_;
};

AddedSurfaces2 add_named_polyline(const Scene2& scene, const std::string& noun, std::span<const Point2> points,
                                  bool closed, std::uint32_t material) {
  HOTTEL_REQUIRE(points.size() >= 2 && material < scene.materials.size());
  const std::string name = FreeNames(scene).numbered(noun);
  Adder adder(scene);
  adder.begin_group(name);
  for (std::size_t k = 0; k < points.size() - (closed ? 0 : 1); ++k)
    adder.add(Surface{.name = piece_name(name, k), .material = material, .back = {}},
              {points[k], points[(k + 1) % points.size()]});
  return std::move(adder).result();
}

// The material of lamps, added where there is none.
std::uint32_t lamp_material(Scene2& scene) {
  for (std::size_t number = 1;; ++number) {
    const std::string name = number == 1 ? "lamp" : "lamp " + std::to_string(number);
    const auto found = std::find_if(scene.materials.begin(), scene.materials.end(),
                                    [&](const Material& material) { return material.name == name; });
    const auto index = static_cast<std::uint32_t>(found - scene.materials.begin());
    if (found == scene.materials.end())
      scene.materials.push_back({name, Spectrum::scalar(0), Spectrum::scalar(1)});
    else if (found->emission.is_zero())
      continue;
    return index;
  }
}

}  // namespace

Scene2 move_points(const Scene2& scene, std::span<const PointMove2> moves) {
  std::unordered_map<Point2, const Point2*, PointHash2> to;
  for (const PointMove2& move : moves) to.try_emplace(move.from, &move.to);
  Scene2 edited = begin_edit(scene);
  for (Edge2& edge : edited.edges)
    for (Point2* end : {&edge.from, &edge.to})
      if (const auto found = to.find(*end); found != to.end()) *end = *found->second;
  return end_move(scene, std::move(edited));
}

Scene2 move_end(const Scene2& scene, std::uint32_t surface, bool is_last, const Point2& to) {
  HOTTEL_REQUIRE(surface < scene.edges.size());
  Scene2 edited = begin_edit(scene);
  Edge2& edge = edited.edges[surface];
  (is_last ? edge.to : edge.from) = to;
  return end_move(scene, std::move(edited));
}

Scene2 move_surfaces(const Scene2& scene, std::span<const std::uint32_t> surfaces, const Rational& dx,
                     const Rational& dy) {
  return moved(scene, surfaces, [&](const Point2& p) { return Point2{p.x + dx, p.y + dy}; });
}

Scene2 rotate_surfaces(const Scene2& scene, std::span<const std::uint32_t> surfaces, const Point2& centre,
                       const Rational& degrees, int decimals) {
  return moved(scene, surfaces, Rotation2(centre, degrees, decimals));
}

Scene2 reverse_surfaces(const Scene2& scene, std::span<const std::uint32_t> surfaces) {
  const SurfaceParts2 parts = surface_parts(scene, with_patches(scene, surfaces));
  Scene2 edited = begin_edit(scene);
  std::vector<std::optional<std::uint32_t>> place(scene.surfaces.size());
  for (std::uint32_t s = 0; s < place.size(); ++s) place[s] = s;
  for (const SurfaceRun2& run : parts.polylines) {
    std::reverse(edited.edges.begin() + run.begin, edited.edges.begin() + run.end);
    for (std::uint32_t s = run.begin; s < run.end; ++s)
      place[s] = static_cast<std::uint32_t>(run.begin + run.end) - 1 - s;
  }
  for (const std::uint32_t s : surfaces_of(parts)) std::swap(edited.edges[s].from, edited.edges[s].to);
  rename_bases(scene, place, edited);
  return end_edit(std::move(edited));
}

Scene2 erase_surfaces(const Scene2& scene, std::span<const std::uint32_t> surfaces) {
  const std::vector<std::uint32_t> erased = surfaces_of(surface_parts(scene, with_patches(scene, surfaces)));
  std::vector<std::uint32_t> kept;
  for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s)
    if (!std::binary_search(erased.begin(), erased.end(), s)) kept.push_back(s);
  Scene2 edited = begin_edit(scene);
  edited.keep(kept);
  return end_edit(std::move(edited));
}

AddedSurfaces2 duplicate_surfaces(const Scene2& scene, std::span<const std::uint32_t> surfaces, const Rational& dx,
                                  const Rational& dy) {
  const SurfaceParts2 parts = surface_parts(scene, surfaces);
  Adder adder(scene);
  FreeNames names(scene);
  std::vector<std::optional<std::uint32_t>> copies(scene.surfaces.size());
  auto count = static_cast<std::uint32_t>(scene.surfaces.size());
  const auto copy = [&](std::uint32_t s, std::string name) {
    copies[s] = count++;
    Surface surface = scene.surfaces[s];
    surface.name = std::move(name);
    surface.line = 0;
    const auto& [from, to] = scene.edges[s];
    adder.add(std::move(surface), {{from.x + dx, from.y + dy}, {to.x + dx, to.y + dy}});
  };
  const std::vector<std::size_t> sizes = group_sizes(scene);
  for (const std::uint32_t s : parts.others) {
    const std::uint32_t group = scene.surfaces[s].group;
    const std::string name = names.copy_of(scene.surfaces[s].name);
    adder.begin_group({name, sizes[group] == 1 ? scene.groups[group].behind : Behind::kByOutline});
    copy(s, name);
  }
  for (const SurfaceRun2& run : parts.polylines) {
    const Group& group = scene.groups[scene.surfaces[run.begin].group];
    const std::string name = names.copy_of(group.name);
    adder.begin_group({name, group.behind});
    for (std::uint32_t s = run.begin; s < run.end; ++s) copy(s, piece_name(name, s - run.begin));
  }
  adder.lay_patches(scene, copies);
  return std::move(adder).result();
}

AddedSurfaces2 add_edge(const Scene2& scene, const Edge2& edge, std::uint32_t material) {
  HOTTEL_REQUIRE(material < scene.materials.size());
  const std::string name = FreeNames(scene).numbered("edge");
  Adder adder(scene);
  adder.begin_group(name);
  adder.add(Surface{.name = name, .material = material, .back = {}}, edge);
  return std::move(adder).result();
}

AddedSurfaces2 add_polyline(const Scene2& scene, std::span<const Point2> points, bool closed, std::uint32_t material) {
  return add_named_polyline(scene, "polyline", points, closed, material);
}

AddedSurfaces2 add_lamp(const Scene2& scene, const Point2& centre, const Rational& half_size) {
  HOTTEL_REQUIRE(half_size > 0);
  const Rational left = centre.x - half_size, right = centre.x + half_size, low = centre.y - half_size,
                 high = centre.y + half_size;
  const std::array<Point2, 4> corners{Point2{left, low}, {right, low}, {right, high}, {left, high}};
  Scene2 lit = scene;
  const std::uint32_t material = lamp_material(lit);
  settle_bands(lit);
  return add_named_polyline(lit, "lamp", corners, true, material);
}

std::optional<std::uint32_t> material_of(const Scene2& scene, const Face& face) {
  HOTTEL_REQUIRE(face.surface < scene.surfaces.size());
  return scene.surfaces[face.surface].material_of(face.is_back);
}

Scene2 set_material(const Scene2& scene, std::uint32_t material, const Material& values) {
  HOTTEL_REQUIRE(material < scene.materials.size());
  Scene2 edited = begin_edit(scene);
  edited.materials[material].reflectivity = values.reflectivity;
  edited.materials[material].emission = values.emission;
  return end_edit(std::move(edited));
}

std::optional<AddedMaterial2> copy_material(const Scene2& scene, const Face& face) {
  const std::optional<std::uint32_t> material = material_of(scene, face);
  if (!material) return std::nullopt;
  Scene2 edited = begin_edit(scene);
  const auto copy = static_cast<std::uint32_t>(edited.materials.size());
  edited.materials.push_back(scene.materials[*material]);
  edited.materials.back().name = free_copy_of_material(scene, scene.materials[*material].name);
  for (Surface& surface : edited.surfaces) {
    if (surface.group != scene.surfaces[face.surface].group) continue;
    if (!face.is_back && surface.material == *material) surface.material = copy;
    if (face.is_back && surface.back == material) surface.back = copy;
  }
  return AddedMaterial2{end_edit(std::move(edited)), copy};
}

}  // namespace hottel
