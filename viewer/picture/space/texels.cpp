#include "viewer/picture/space/texels.h"

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "geometry/name.h"
#include "geometry/scene_names.h"
#include "kernel/support/failure.h"
#include "kernel/support/stopwatch.h"
#include "viewer/picture/space/seen_sides.h"

namespace hottel {
namespace {

// The side of a piece on which a face has a point of its plane.
std::optional<Face> side_at(const Arrangement3& arrangement, const Face& face, const Point3& point) {
  for (const PieceSide3& side : arrangement.sides(face)) {
    const Piece3& piece = arrangement.pieces()[side.piece];
    const Piece3::Side& own = piece.side(side.is_back);
    const auto holds = [&point](const Polygon3& polygon) { return contains(polygon, point); };
    const bool is_there =
        own.cover == Piece3::Cover::kFree ? holds(piece.polygon) : std::ranges::any_of(own.free, holds);
    if (is_there) return Face{side.piece, side.is_back};
  }
  return std::nullopt;
}

}  // namespace

Grid3 texel_grid_3(const Scene3& scene, const Face& face, std::uint32_t nu, std::uint32_t nv) {
  const Polygon3& polygon = scene.polygons[face.surface];
  if (!scene.surfaces[face.surface].material_of(face.is_back))
    throw UsageError("texels are for faces with light, and " + quoted_name(face_name(scene, face)) +
                     " has no material, and no light");
  if (polygon.is_nearly_plane)
    throw UsageError("texels are for faces that are plane, and " + quoted_name(scene.surfaces[face.surface].name) +
                     " is so only nearly");
  const Point3& first = polygon.points.front();
  return {first, polygon.points[1] - first, polygon.points.back() - first, nu, nv};
}

IlluminationGrid3 texels_3(const PreparedScene3& prepared, const GatheredSource3& source, const Face& face,
                           const Grid3& grid, const std::function<void(double)>& progress) {
  Stopwatch watch;
  const SceneLights3 lights(prepared);
  const std::vector<std::optional<std::uint32_t>> element = elements_of_sides_3(prepared, source.table());
  IlluminationGrid3 result = light_in_cells(
      grid, static_cast<std::uint32_t>(source.responses().channels),
      [&](const Point3& middle, std::span<double> light) {
        const auto side = side_at(prepared.arrangement(), face, middle);
        if (!side || !element[side->number()]) return;
        std::vector<double> irradiance(source.light().channels());
        source.light().irradiance(middle, *side, irradiance);
        lights.add(middle, normal_of_side_3(prepared.occluders(), *side), irradiance);
        source.responses().value(*element[side->number()], irradiance, light);
      },
      progress);
  result.seconds = watch.lap();
  return result;
}

}  // namespace hottel
